// SPDX-License-Identifier: MIT
// Random numbers of one sample of one pixel: they depend only on (seed, pixel, sample) and on how many were
// drawn, so that results do not depend on threads.
// Based on:
// [MBC79] McKay, Beckman, Conover: A Comparison of Three Methods for Selecting Values of Input Variables in
//         the Analysis of Output from a Computer Code. Technometrics 21, 1979 (Latin hypercubes)
// [K13]   Kensler: Correlated Multi-Jittered Sampling. Pixar, 2013 (permutations without a table)
#pragma once

#include <cstdint>

#include "tissue/profile/photon.h"

namespace dermis::reference {

inline constexpr std::uint32_t samples_a_block = 8;

/// The n-th numbers of the 8 samples of a block lie in different eighths of 0..1 [MBC79], in an order that
/// differs for each n. So what depends on one number (which Gaussian is sampled, how far) is stratified
/// within a block. Each number is uniform and those of one sample are independent, so every mean stays
/// unbiased. Samples of one block depend on each other; blocks do not. On the scan this divides the variance
/// by 2.4 (by 2.7 with blocks of 16, by 3.1 with 64; small blocks give an estimate of the variance sooner).
class Random {
 public:
  Random(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample)
      : block_(seed, static_cast<std::uint64_t>(pixel) << 32 | sample / samples_a_block),
        number_(sample % samples_a_block) {}

  /// Returns a number in (0, 1).
  double next() {
    const double u = block_.next() + permuted(number_, static_cast<std::uint32_t>(block_.next() * 0x1p32)) /
                                         double{samples_a_block};
    return u < 1 ? u : u - 1 + 0x1p-54;
  }

 private:
  /// Returns a permutation of i that depends on `p`, [K13] listing 3 for a power of two.
  static std::uint32_t permuted(std::uint32_t i, std::uint32_t p) {
    constexpr std::uint32_t w = samples_a_block - 1;
    i ^= p;
    i *= 0xe170893du;
    i ^= p >> 16;
    i ^= (i & w) >> 4;
    i ^= p >> 8;
    i *= 0x0929eb3fu;
    i ^= p >> 23;
    i ^= (i & w) >> 1;
    i *= 1 | p >> 27;
    i *= 0x6935fa69u;
    i ^= (i & w) >> 11;
    i *= 0x74dcb303u;
    i ^= (i & w) >> 2;
    i *= 0x9e501cc3u;
    i ^= (i & w) >> 2;
    i *= 0xc860a3dfu;
    i &= w;
    i ^= i >> 5;
    return (i + p) & w;
  }

  profile::PhotonRandom block_;
  std::uint32_t number_;
};

inline Random random_of(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample) {
  return {seed, pixel, sample};
}

}  // namespace dermis::reference
