// SPDX-License-Identifier: MIT
// Keeps errors to one line, whatever text of a file they quote.
#pragma once

#include <string>
#include <string_view>

#include "dermis/error.h"

namespace dermis {

/// Returns the text with control characters as '?', cut after most_bytes.
std::string one_line(std::string_view text, std::size_t most_bytes = 2000);

/// Returns what body() returns; replaces the message of an InputError by one_line() of it.
template <class Body>
auto with_one_line_errors(const Body& body) {
  try {
    return body();
  } catch (const InputError& error) { throw InputError("", one_line(error.what())); }
}

}  // namespace dermis
