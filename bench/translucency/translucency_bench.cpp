// SPDX-License-Identifier: MIT
// What a light costs with translucency and without, for light maps and shadow maps of several sizes, drawn
// alternately in one run. translucency_bench [SCENE] [ROUNDS] [MAP_SIZE SHADOW_SIZE]: all pairs of sizes, or
// one. Made for:
// ninja translucency_bench &&
// build/release/bench/translucency/translucency_bench assets/heads/lee-perry-smith.gltf
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include "dermis/renderer.h"

namespace {

constexpr std::array light_counts{1, 9};  // lamps are most of the frame
constexpr std::array map_sizes{512, 1024, 2048};
constexpr std::array shadow_sizes{512, 1024, 2048, 4096};

// A software device computes in threads of this process: what else runs on the machine hardly shows in their
// time. Elsewhere it is the device's own time that counts.
double draw_ms(dermis::PreparedFrame& frame, bool software) {
  const std::clock_t before = std::clock();
  const double frame_ms = frame.draw();
  return software ? 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC : frame_ms;
}

struct Cost {
  double with_ms = 0, without_ms = 0;  // of one light more
};

// Least times: whatever disturbs a frame makes it longer. Few frames are alive at a time, for large maps.
Cost cost_of_a_light(dermis::Renderer& renderer, const dermis::Scene& scene, dermis::RenderSettings settings,
                     int rounds) {
  std::array<Cost, light_counts.size()> least;
  for (std::size_t i = 0; i < least.size(); ++i) {
    settings.lighting.rig_lights = light_counts[i];
    settings.skin.translucency = true;
    dermis::PreparedFrame with = renderer.prepare(scene, settings);
    settings.skin.translucency = false;
    dermis::PreparedFrame without = renderer.prepare(scene, settings);
    with.draw();
    without.draw();
    const bool software = without.picture().statistics.timing == "submit";

    least[i] = {1e30, 1e30};
    for (int round = 0; round < rounds; ++round) {
      least[i].with_ms = std::min(least[i].with_ms, draw_ms(with, software));
      least[i].without_ms = std::min(least[i].without_ms, draw_ms(without, software));
    }
  }
  constexpr double more = light_counts[1] - light_counts[0];
  return {(least[1].with_ms - least[0].with_ms) / more, (least[1].without_ms - least[0].without_ms) / more};
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const dermis::Scene scene = argc > 1 ? dermis::Scene::load(argv[1]) : dermis::Scene::built_in();
    const int rounds = argc > 2 ? std::max(std::atoi(argv[2]), 1) : 9;
    dermis::RenderSettings settings;
    settings.output.width = 480;
    settings.output.height = 270;
    const int only_map = argc > 4 ? std::atoi(argv[3]) : 0, only_shadow = argc > 4 ? std::atoi(argv[4]) : 0;

    dermis::Renderer renderer;
    std::printf("%s, %d x %d, least of %d rounds; ms per light\n", scene.name().c_str(),
                settings.output.width, settings.output.height, rounds);
    std::printf("maps  shadows     with  without  ratio\n");

    for (const int map_size : map_sizes)
      for (const int shadow_size : shadow_sizes) {
        if (only_map > 0 && (only_map != map_size || only_shadow != shadow_size)) continue;
        settings.quality.map_size = map_size;
        settings.quality.shadow_size = shadow_size;
        settings.quality.keep_shadows = false;  // its maps are a part of what a light costs
        const Cost cost = cost_of_a_light(renderer, scene, settings, rounds);
        std::printf("%4d     %4d  %7.2f  %7.2f  %5.3f\n", map_size, shadow_size, cost.with_ms,
                    cost.without_ms, cost.with_ms / cost.without_ms);
        std::fflush(stdout);
      }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "translucency_bench: %s\n", error.what());
    return 1;
  }
}
