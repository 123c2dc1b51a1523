// SPDX-License-Identifier: MIT
#include "reference/render.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

namespace dermis::reference {
namespace {

// Below this the noise estimate is not reliable.
constexpr std::uint32_t least_samples = 4 * samples_a_block;
constexpr std::size_t pixels_a_task = 256;

bool stopped(const Limits& limits) { return limits.stop && limits.stop->load(std::memory_order_relaxed); }

void trace_pass(const Tracer& tracer, std::uint32_t number, const Limits& limits,
                std::vector<Tracer::Sample>& pass) {
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, pass.size(), pixels_a_task),
                            [&](const auto& range) {
                              if (stopped(limits)) return;
                              std::vector<rays::Hit> scratch;
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                Random random = random_of(limits.seed, static_cast<std::uint32_t>(i), number);
                                const int x = static_cast<int>(i % static_cast<std::size_t>(tracer.width())),
                                          y = static_cast<int>(i / static_cast<std::size_t>(tracer.width()));
                                pass[i] = tracer.sample(x, y, random, scratch);
                              }
                            });
}

}  // namespace

bool render(const Tracer& tracer, Film& film, const Limits& limits,
            const std::function<void(const Film&)>& after_pass) {
  using Control = oneapi::tbb::global_control;  // TBB warns about an arena larger than this allows
  std::optional<Control> control;
  if (limits.threads > 0)
    control.emplace(Control::max_allowed_parallelism, static_cast<std::size_t>(limits.threads));

  oneapi::tbb::task_arena arena(limits.threads > 0 ? limits.threads : oneapi::tbb::task_arena::automatic);
  std::vector<Tracer::Sample> pass(static_cast<std::size_t>(tracer.width()) *
                                   static_cast<std::size_t>(tracer.height()));

  const auto enough = [&] {
    if (film.samples() >= limits.samples) return true;
    return limits.noise_percent && film.samples() >= least_samples &&
           film.noise_percent() <= *limits.noise_percent;
  };

  while (!enough()) {
    arena.execute([&] { trace_pass(tracer, film.samples(), limits, pass); });
    if (stopped(limits)) return false;
    film.add(pass);
    if (after_pass) after_pass(film);
  }
  return true;
}

}  // namespace dermis::reference
