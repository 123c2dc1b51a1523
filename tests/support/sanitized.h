// SPDX-License-Identifier: MIT
#pragma once

namespace dermis::tests {

#ifdef __SANITIZE_ADDRESS__
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

/// Returns how often a test does what makes a figure exact, or goes through cases of one kind: `all` times,
/// but `some` under the sanitizers, which see the same code in each turn and take ten times as long.
template <class Count>
constexpr Count turns(Count all, Count some) {
  return sanitized ? some : all;
}

}  // namespace dermis::tests
