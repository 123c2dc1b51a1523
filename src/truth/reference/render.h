// SPDX-License-Identifier: MIT
// Samples until a limit is reached, in passes of one sample per pixel, so that it can stop and continue at
// any time.
#pragma once

#include <functional>
#include <optional>

#include "truth/reference/film.h"

namespace dermis::reference {

struct Limits {
  std::uint32_t samples = 64;  ///< per pixel, >= 1
  /// ends sooner when Film::noise_percent() is at most this, but not before 32 samples
  std::optional<double> noise_percent;
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
};

/// Adds passes to the film until a limit is reached; calls after_pass after each. Returns true if the limit
/// was reached, false if the caller of the library has ended the work (base/core/hooks.h), or after_pass
/// throws Cancelled: then the current pass is discarded. Sample k of a pixel is the same for any number of
/// threads and stops. Each pass counts as one step of the enclosing work.
bool render(const Tracer& tracer, Film& film, const Limits& limits,
            const std::function<void(const Film&)>& after_pass = {});

}  // namespace dermis::reference
