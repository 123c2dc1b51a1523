// SPDX-License-Identifier: MIT
#include "truth/reference/render.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>

#include "base/core/hooks.h"

namespace dermis::reference {
namespace {

// Below this the noise estimate is not reliable.
constexpr std::uint32_t least_samples = 4 * samples_a_block;
constexpr std::size_t pixels_a_task = 256;
// Of a pass, so that the progress of large pictures is seen too.
constexpr std::size_t parts_told = 16;

/// Counts the parts of a pass, by its pixels.
class PassProgress {
 public:
  explicit PassProgress(std::size_t pixels) : pixels_(pixels), steps_("pass", parts_told) {}

  void done(std::size_t pixels) {
    const std::size_t before = done_.fetch_add(pixels), after = before + pixels;
    const std::size_t parts = after * parts_told / pixels_ - before * parts_told / pixels_;
    if (parts == 0) return;
    // A hook that computes something may wait: then this thread must not begin another part of the pass,
    // which would wait for the hook.
    oneapi::tbb::this_task_arena::isolate([&] { steps_.done(parts); });
  }

 private:
  std::size_t pixels_;
  Steps steps_;
  std::atomic<std::size_t> done_{0};
};

void trace_pass(const Tracer& tracer, std::uint32_t number, const Limits& limits,
                std::vector<Tracer::Sample>& pass) {
  const CallContext context = current_context();
  PassProgress progress(pass.size());
  const auto trace = [&](const oneapi::tbb::blocked_range<std::size_t>& range) {
    stop_if_cancelled(context);
    std::vector<rays::Hit> scratch;
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      Random random = random_of(limits.seed, static_cast<std::uint32_t>(i), number);
      const int x = static_cast<int>(i % static_cast<std::size_t>(tracer.width())),
                y = static_cast<int>(i / static_cast<std::size_t>(tracer.width()));
      pass[i] = tracer.sample(x, y, random, scratch);
    }
    progress.done(range.size());
  };
  oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, pass.size(), pixels_a_task), trace);
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

  const CallContext context = current_context();
  try {
    while (!enough()) {
      arena.execute([&] {
        const HookScope same_call(context);
        trace_pass(tracer, film.samples(), limits, pass);
      });
      film.add(pass);
      if (after_pass) after_pass(film);
    }
  } catch (const Cancelled&) { return enough(); }
  return true;
}

}  // namespace dermis::reference
