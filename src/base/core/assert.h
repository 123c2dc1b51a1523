// SPDX-License-Identifier: MIT
// Assertions for our own mistakes: they throw InternalError with both values, in release too. Keep them out
// of inner loops.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace dermis {

[[noreturn]] void assertion_failed(std::string_view expression, std::string_view values, const char* file,
                                   int line);

/// Warns of a mistake of ours, and returns false.
bool mistake_noted(std::string_view expression, const char* file, int line) noexcept;

}  // namespace dermis

/// Returns the condition, and warns if it does not hold: for destructors, which cannot throw.
#define DERMIS_HOLDS(condition) ((condition) || ::dermis::mistake_noted(#condition, __FILE__, __LINE__))

#define DERMIS_ASSERT(condition)                                                      \
  do {                                                                                \
    if (!(condition)) ::dermis::assertion_failed(#condition, "", __FILE__, __LINE__); \
  } while (false)

#define DERMIS_ASSERT_OP_(a, op, b)                                                                          \
  do {                                                                                                       \
    const auto& dermis_a_ = (a);                                                                             \
    const auto& dermis_b_ = (b);                                                                             \
    if (!(dermis_a_ op dermis_b_))                                                                           \
      ::dermis::assertion_failed(#a " " #op " " #b, fmt::format("{} vs {}", dermis_a_, dermis_b_), __FILE__, \
                                 __LINE__);                                                                  \
  } while (false)

#define DERMIS_ASSERT_EQ(a, b) DERMIS_ASSERT_OP_(a, ==, b)
#define DERMIS_ASSERT_LT(a, b) DERMIS_ASSERT_OP_(a, <, b)
#define DERMIS_ASSERT_LE(a, b) DERMIS_ASSERT_OP_(a, <=, b)
