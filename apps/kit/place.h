// SPDX-License-Identifier: MIT
// Where the kit was unpacked. Shared with the launcher, which may use nothing but the C library.
#pragma once

#include <sys/auxv.h>

#include <climits>
#include <cstdlib>
#include <string>

namespace dermis::kit {

/// Returns the folder of the running program, without links; empty if it cannot be found. Needs no /proc.
inline std::string program_folder() {
  // The kernel notes the path that the program was started by, relative to the folder it was started in:
  // call this before that changes.
  const auto* name = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  char real[PATH_MAX];
  if (name == nullptr || ::realpath(name, real) == nullptr) return {};

  const std::string path(real);
  const std::size_t slash = path.rfind('/');
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace dermis::kit
