// SPDX-License-Identifier: MIT
// What a light costs with translucency and without, in one run, drawn alternately. translucency_bench [SCENE]
// [FRAMES] [MAP_SIZE] [WIDTH] Made for: ninja translucency_bench &&
// build/release/bench/translucency/translucency_bench assets/heads/lee-perry-smith.gltf
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "dermis/renderer.h"

namespace {

constexpr std::array light_counts{1, 2, 4, 8};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

// Milliseconds a light: the line of least squares through the frame times.
double slope(const std::array<double, light_counts.size()>& ms) {
  double mean_n = 0, mean_ms = 0, covariance = 0, variance = 0;
  for (std::size_t i = 0; i < ms.size(); ++i) mean_n += light_counts[i], mean_ms += ms[i];
  mean_n /= static_cast<double>(ms.size()), mean_ms /= static_cast<double>(ms.size());
  for (std::size_t i = 0; i < ms.size(); ++i) {
    covariance += (light_counts[i] - mean_n) * (ms[i] - mean_ms);
    variance += (light_counts[i] - mean_n) * (light_counts[i] - mean_n);
  }
  return covariance / variance;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const dermis::Scene scene = argc > 1 ? dermis::Scene::load(argv[1]) : dermis::Scene::built_in();
    const int frames = argc > 2 ? std::atoi(argv[2]) : 9;
    dermis::RenderSettings settings;
    settings.map_size = settings.shadow_size = argc > 3 ? std::atoi(argv[3]) : 1024;
    settings.width = argc > 4 ? std::atoi(argv[4]) : 1280;
    settings.height = settings.width * 9 / 16;
    dermis::Renderer renderer;
    std::array<double, light_counts.size()> with{}, without{};
    for (std::size_t i = 0; i < light_counts.size(); ++i) {
      settings.lights = light_counts[i];
      settings.translucency = true;
      dermis::PreparedFrame on = renderer.prepare(scene, settings);
      settings.translucency = false;
      dermis::PreparedFrame off = renderer.prepare(scene, settings);
      std::vector<double> on_ms, off_ms;
      for (int k = 0; k < frames; ++k) on_ms.push_back(on.draw()), off_ms.push_back(off.draw());
      with[i] = median(on_ms), without[i] = median(off_ms);
      if (i == 0)
        std::printf("%s, %s, %d x %d, maps of %d, %d frames each\n", scene.name().c_str(),
                    off.picture().statistics.device.c_str(), settings.width, settings.height,
                    settings.map_size, frames);
      std::printf("%d lights: %.2f ms with, %.2f ms without\n", light_counts[i], with[i], without[i]);
      std::fflush(stdout);
    }
    std::printf("a light: %.2f ms with, %.2f ms without, ratio %.3f\n", slope(with), slope(without),
                slope(with) / slope(without));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "translucency_bench: %s\n", error.what());
    return 1;
  }
}
