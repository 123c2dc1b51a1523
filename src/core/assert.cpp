// SPDX-License-Identifier: MIT
#include "core/assert.h"

#include "dermis/error.h"

namespace dermis {

void assertion_failed(std::string_view expression, std::string_view values, const char* file, int line) {
  throw InternalError(fmt::format("internal error: {}{}{} ({}:{})", expression, values.empty() ? "" : ": ",
                                  values, file, line));
}

}  // namespace dermis
