// SPDX-License-Identifier: MIT
// Numbers that depend on a key and a counter alone: no order, no state.
// [SMDS11] Salmon, Moraes, Dror, Shaw: Parallel Random Numbers: As Easy as 1, 2, 3. SC 2011 (Philox4x32-10)
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace dermis::dataset {

using Counter = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

/// Returns four words of Philox4x32-10 [SMDS11].
Counter philox(Counter counter, Key key);

/// FNV-1a, 64 bits: by which a path becomes part of a key.
std::uint64_t hash_of(std::string_view path);

/// The numbers of one parameter: its path and the recipe's seed name the stream, `number` (of the sample or
/// of the identity) the place in it.
class Stream {
 public:
  Stream(std::uint32_t seed, std::string_view path, std::uint64_t number);

  /// Returns the next number in 0 <= u < 1, a multiple of 2^-53.
  double next();

 private:
  Key key_;
  Counter counter_;  ///< number, attempt, upper half of the hash
};

}  // namespace dermis::dataset
