// SPDX-License-Identifier: MIT
#include "cli/output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/error.h"
#include "core/file.h"

namespace dermis::cli {

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") {
    if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
      throw input_error("standard output", "cannot be written: {}", std::strerror(errno));
    return;
  }
  write_file(path, text);
}

}  // namespace dermis::cli
