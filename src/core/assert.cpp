// SPDX-License-Identifier: MIT
#include "core/assert.h"

#include <cstdio>
#include <cstdlib>

namespace dermis {

void assertion_failed(std::string_view expression, std::string_view values, const char* file, int line) {
  std::fputs(fmt::format("dermis: internal error: {}{}{} ({}:{})\n", expression, values.empty() ? "" : ": ",
                         values, file, line)
                 .c_str(),
             stderr);
  std::abort();
}

}  // namespace dermis
