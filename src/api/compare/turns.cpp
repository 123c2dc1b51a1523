// SPDX-License-Identifier: MIT
#include "api/compare/turns.h"

#include <map>

#include "api/compare/held_frames.h"
#include "base/core/hooks.h"
#include "dermis/cancelled.h"

namespace dermis::api {

std::vector<std::vector<double>> draw_in_turns(Renderer& renderer, const std::vector<Turn>& turns, int rounds,
                                               const std::atomic<bool>* stop) {
  const auto most_bytes = [half = std::map<std::string, std::uint64_t>()](const std::string& device) mutable {
    const auto [found, is_new] = half.try_emplace(device, 0);
    if (is_new) found->second = half_of_device(device);
    return found->second;
  };
  const std::function<std::uint64_t(const std::string&)> budget = most_bytes;
  HeldFrames frames(renderer, budget);
  for (const Turn& turn : turns) {
    RenderSettings one = turn.settings;
    one.output.frames = 1;
    one.quality.keep_shadows = false;  // a frame in which everything moves
    frames.add(turn.scene, one);
  }

  Steps steps("frames in turns", turns.size() * static_cast<std::size_t>(rounds + 1));
  std::vector<std::vector<double>> ms(turns.size());
  for (int round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < turns.size(); ++i) {
      if (stop && *stop) throw Cancelled("stopped before all frames were timed");
      if (round == 0)
        frames.warm_up(i);
      else
        ms[i].push_back(frames.draw(i));
      steps.done();
    }
  return ms;
}

}  // namespace dermis::api
