// SPDX-License-Identifier: MIT
#include "base/core/one_line.h"

#include <algorithm>

namespace dermis {

std::string one_line(std::string_view text, std::size_t most_bytes) {
  std::string line(text.substr(0, most_bytes));
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, '?');
  return line;
}

}  // namespace dermis
