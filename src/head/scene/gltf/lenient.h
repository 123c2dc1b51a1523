// SPDX-License-Identifier: MIT
// Files that differ from the specification in something that the picture does
// not need are drawn, with a warning. docs/assets.md lists what, and what is refused.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/core/error.h"
#include "head/scene/gltf/value.h"

namespace dermis::scene::gltf {

/// Warns of one object of a file; those of one kind become one line. `what`: "a rotation is not of length 1
/// and is normalised".
/// (Grouped, so that an error that follows is the only line.)
void warn_line(const std::string& file, const std::string& place, const std::string& what);
void warn_at(const std::string& file, const std::string& place, std::string_view what);
void warn_at(const Value& where, std::string_view what);

/// Warns of a file as a whole.
template <class... Args>
void warn_in(const std::string& file, fmt::format_string<Args...> format, Args&&... args) {
  warn_line(file, "", fmt::format(format, std::forward<Args>(args)...));
}

/// Returns why `read` throws InputError, which whoever uses what it reads throws again; empty if it does not.
template <class Read>
std::string fault_of(const Read& read) {
  try {
    read();
    return {};
  } catch (const InputError& error) { return error.what(); }
}
/// Throws InputError if there is a fault.
void check_fault(const std::string& fault);
/// Warns of something that has a fault and is left out. `kind`: "pictures that cannot be read are left out";
/// `end`: what is left out of the picture with it.
void warn_of_fault(const std::string& file, std::string_view kind, const std::string& name,
                   const std::string& fault, std::string_view end);

/// Return a member, or `otherwise` with a warning if it is of another type. A number out of its range becomes
/// the nearest one in it.
double number_near(const Value& value, const char* key, double otherwise, double least = -json::max_number,
                   double most = json::max_number);
bool boolean_near(const Value& value, const char* key, bool otherwise);
std::string text_near(const Value& value, const char* key, const std::string& otherwise);
/// Returns `size` numbers, each as number_near() has them; empty if there are none, or another count.
std::vector<double> numbers_near(const Value& value, const char* key, std::size_t size,
                                 double least = -json::max_number, double most = json::max_number);
/// Returns the number of an element, -1 with a warning if there is none.
int index_near(const Value& value, const char* key, std::size_t size, const char* what);

}  // namespace dermis::scene::gltf
