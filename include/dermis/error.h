// SPDX-License-Identifier: MIT
/// Errors of dermis. Three kinds, so that a caller knows whose fault it is:
///   bad input             -> InputError: a file or a parameter, with the place in it and what was expected
///   trouble with a device -> DeviceError: what was needed, what there is, what to try
///   a mistake of dermis   -> InternalError: what should hold, with both values
/// Work that its caller has ended is none of these: Cancelled, dermis/cancelled.h.
/// An absence that is expected is a std::optional, never an error.
#pragma once

#include <stdexcept>
#include <string>

namespace dermis {

/// Something that came from outside (a file, an option, a name) cannot be used. what() is one line: "where:
/// message".
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& where, const std::string& message)
      : std::runtime_error(where.empty() ? message : where + ": " + message) {}
};

/// The device, its driver or its memory cannot do what is asked. what() is one line.
class DeviceError : public std::runtime_error {
 public:
  explicit DeviceError(const std::string& message) : std::runtime_error(message) {}
};

/// dermis has made a mistake. what() is one line: the condition that should hold, both values, and the place
/// in the source. A renderer whose call threw it may only be destroyed; other renderers are not concerned.
class InternalError : public std::logic_error {
 public:
  explicit InternalError(const std::string& message) : std::logic_error(message) {}
};

}  // namespace dermis
