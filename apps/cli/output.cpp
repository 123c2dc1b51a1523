// SPDX-License-Identifier: MIT
#include "cli/output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "base/core/error.h"
#include "base/core/file.h"

namespace dermis::cli {

void finish_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw input_error("standard output", "cannot be written: {}", std::strerror(errno == 0 ? EIO : errno));
}

void write_text(const std::string& path, const std::string& text) {
  if (path == "-") {
    std::fputs(text.c_str(), stdout);
    return finish_output();
  }
  write_file(path, text);
}

}  // namespace dermis::cli
