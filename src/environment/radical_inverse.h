// SPDX-License-Identifier: MIT
/// Points that fill an interval evenly, however many are taken.
#pragma once

namespace dermis::environment {

/// Returns the radical inverse of i in base 2 (van der Corput), in [0, 1).
inline double radical_inverse(unsigned i) {
  double value = 0, digit = 0.5;
  for (; i > 0; i >>= 1, digit /= 2)
    if (i & 1) value += digit;
  return value;
}

}  // namespace dermis::environment
