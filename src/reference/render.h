// SPDX-License-Identifier: MIT
// Samples until there are enough: in passes of one sample per pixel, so that it can stop and go on at any
// time.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "reference/film.h"

namespace dermis::reference {

struct Limits {
  std::uint32_t samples = 64;  ///< a pixel, >= 1
  /// end before that when Film::noise_percent() is at most this; not before 32 samples
  std::optional<double> noise_percent;
  std::uint64_t seed = 1;
  int threads = 0;                          ///< 0: all cores
  const std::atomic<bool>* stop = nullptr;  ///< set: the pass that runs is given up, those before it stay
};

/// Adds passes to the film until a limit is reached. after_pass is called after each. True if the limit was
/// reached, false if stopped. Sample k of a pixel is the same whichever threads there are and however often
/// it was stopped before.
bool render(const Tracer& tracer, Film& film, const Limits& limits,
            const std::function<void(const Film&)>& after_pass = {});

}  // namespace dermis::reference
