// SPDX-License-Identifier: MIT
#include "cli/bench/contest.h"

#include <chrono>
#include <utility>

#include "cli/bench/passes.h"

namespace dermis::cli::bench {
namespace {

// A device that was idle needs a while to come up to its clocks: rounds are drawn and thrown away until this
// much has gone by.
constexpr double warm_up_ms = 1000;

}  // namespace

Contest::Contest(Renderer& renderer, const Scene& scene, std::vector<Variant> variants,
                 const std::function<std::uint64_t(const std::string&)>& most_bytes)
    : frames_(renderer, most_bytes) {
  for (Variant& variant : variants) {
    frames_.add(scene, variant.settings);
    entries_.push_back(
        {.measured = {.variant = std::move(variant), .rounds_ms = {}, .passes = {}, .counts = {}},
         .passes = {}});
  }
}

Picture Contest::warm_up(std::size_t i) {
  Picture picture = frames_.warm_up(i);
  entries_[i].measured.counts = picture.statistics;
  return picture;
}

void Contest::wake_the_device(const std::function<bool()>& stopped) {
  const auto start = std::chrono::steady_clock::now();
  const auto is_awake = [&] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() >
           warm_up_ms;
  };
  while (!is_awake() && !stopped())
    for (std::size_t i = 0; i < size() && !is_awake() && !stopped(); ++i) frames_.draw(i);
}

void Contest::draw(std::size_t i) {
  std::vector<PassStatistics> passes;
  entries_[i].measured.rounds_ms.push_back(frames_.draw(i, &passes));
  entries_[i].passes.push_back(merge_passes(passes));
}

std::vector<Measured> Contest::finish() {
  std::vector<Measured> all;
  for (Entry& entry : entries_) {
    entry.measured.passes = median_passes(entry.passes);
    all.push_back(std::move(entry.measured));
  }
  return all;
}

}  // namespace dermis::cli::bench
