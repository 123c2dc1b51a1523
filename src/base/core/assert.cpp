// SPDX-License-Identifier: MIT
#include "base/core/assert.h"

#include "base/core/log.h"
#include "dermis/error.h"

namespace dermis {

void assertion_failed(std::string_view expression, std::string_view values, const char* file, int line) {
  throw InternalError(fmt::format("internal error: {}{}{} ({}:{})", expression, values.empty() ? "" : ": ",
                                  values, file, line));
}

bool mistake_noted(std::string_view expression, const char* file, int line) noexcept {
  try {
    warn("internal error: {} ({}:{})", expression, file, line);
  } catch (...) {
    // No memory for the line.
  }
  return false;
}

}  // namespace dermis
