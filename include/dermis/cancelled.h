// SPDX-License-Identifier: MIT
/// Long work that its caller has ended.
#pragma once

#include <stdexcept>
#include <string>

namespace dermis {

/// The caller has ended the work (dermis/hooks.h): no error (see error.h), but there is no result, and
/// nothing is left behind. what() is one line that says what was under way.
class Cancelled : public std::runtime_error {
 public:
  explicit Cancelled(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace dermis
