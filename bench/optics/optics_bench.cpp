// SPDX-License-Identifier: MIT
// How long the left half of the chain takes: run with --benchmark_out=FILE.json for machine-readable figures.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tissue/gaussians/fit.h"
#include "tissue/optics/presets.h"
#include "tissue/optics/radiative.h"
#include "tissue/optics/skin_colour.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/slab.h"

namespace {

using namespace dermis;

/// A slider moves: three channels, shared variances.
void fit_shared_dipole(benchmark::State& state) {
  const auto medium = optics::find_material("skin1")->medium();
  for (auto _ : state) {
    std::array<profile::ProfilePtr, 3> profiles;
    for (int c = 0; c < 3; ++c) profiles[c] = std::make_shared<profile::Dipole>(medium[c]);
    benchmark::DoNotOptimize(gaussians::fit_shared(profiles, static_cast<int>(state.range(0)), "skin1"));
  }
}
BENCHMARK(fit_shared_dipole)->Arg(4)->Arg(6)->Unit(benchmark::kMillisecond);

void fit_shared_layers(benchmark::State& state) {
  const auto layers = optics::donner_jensen_skin();
  for (auto _ : state) {
    std::array<profile::ProfilePtr, 3> profiles;
    for (int c = 0; c < 3; ++c)
      profiles[c] = std::make_shared<profile::LayeredProfile>(optics::channel(layers, c),
                                                              profile::SlabProfile::Side::reflected);
    benchmark::DoNotOptimize(gaussians::fit_shared(profiles, 6, "layers"));
  }
}
BENCHMARK(fit_shared_layers)->Unit(benchmark::kMillisecond);

/// Photons until the profile's noise (profile::MonteCarloResult::noise_percent) is 1 %; doubles them until it
/// is.
void monte_carlo_to_one_percent(benchmark::State& state) {
  const auto medium = optics::find_material("skin1")->medium()[static_cast<std::size_t>(state.range(0))];
  static std::uint64_t seed = 1;  // new for every run: one that is kept would cost nothing
  std::uint64_t photons = 50'000;
  double noise = 100;

  while (noise > 1) {  // how many it takes, outside the clock
    noise = profile::monte_carlo(profile::scene_of(medium), {.photons = photons, .seed = seed++, .cache = {}})
                ->noise_percent();
    if (noise > 1)
      photons =
          static_cast<std::uint64_t>(static_cast<double>(photons) * std::min(8.0, 1.05 * noise * noise) + 1);
  }

  for (auto _ : state) {
    const auto result =
        profile::monte_carlo(profile::scene_of(medium), {.photons = photons, .seed = seed++, .cache = {}});
    noise = result->noise_percent();
  }

  state.counters["photons"] = static_cast<double>(photons);
  state.counters["noise_percent"] = noise;
}
BENCHMARK(monte_carlo_to_one_percent)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

void adding_doubling_one_wavelength(benchmark::State& state) {
  const auto layers = optics::skin_layers({}, 550);
  for (auto _ : state) benchmark::DoNotOptimize(optics::adding_doubling(layers));
}
BENCHMARK(adding_doubling_one_wavelength)->Unit(benchmark::kMicrosecond);

void skin_from_a_colour(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(optics::nearest_skin({55, 12, 17}));
}
BENCHMARK(skin_from_a_colour)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
