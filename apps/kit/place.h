// SPDX-License-Identifier: MIT
// Where the kit was unpacked. Shared with the launcher, which may use nothing but the C library.
#pragma once

#include <sys/auxv.h>

#include <climits>
#include <cstdlib>
#include <cstring>

namespace dermis::kit {

/// Writes the folder of the running program, without links, to `folder` (PATH_MAX bytes). Returns whether it
/// was found. Needs no /proc.
inline bool find_program_folder(char* folder) {
  // The kernel notes the path that the program was started by, relative to the folder it was started in:
  // call this before that changes.
  const auto* name = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  if (name == nullptr || ::realpath(name, folder) == nullptr) return false;
  *std::strrchr(folder, '/') = '\0';
  return true;
}

}  // namespace dermis::kit
