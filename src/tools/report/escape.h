// SPDX-License-Identifier: MIT
// Text within HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace dermis::report {

/// Returns text that stands for itself in an element or in a quoted attribute, of HTML and of XML. Bytes that
/// are no UTF-8 become U+FFFD, control characters spaces: names of files may hold anything.
std::string escape(std::string_view text);

}  // namespace dermis::report
