// SPDX-License-Identifier: MIT
// Errors are one line, whatever the keys and names of a file hold that stand in them.
#pragma once

#include <string>
#include <string_view>

#include "dermis/error.h"

namespace dermis {

/// Returns the text with control characters as '?', cut after most_bytes.
std::string one_line(std::string_view text, std::size_t most_bytes = 2000);

/// Returns what body() returns; an InputError leaves it with one_line() of its message.
template <class Body>
auto with_one_line_errors(const Body& body) {
  try {
    return body();
  } catch (const InputError& error) { throw InputError("", one_line(error.what())); }
}

}  // namespace dermis
