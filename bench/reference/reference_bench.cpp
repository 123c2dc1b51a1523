// SPDX-License-Identifier: MIT
// How long the reference takes to a stated noise. reference_bench [SCENE] [NOISE_PERCENT] [MODEL] [SIZE]
// Made for: ninja reference_bench && build/release/bench/reference/reference_bench
// assets/heads/lee-perry-smith.gltf
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <thread>

#include "dermis/reference.h"

int main(int argc, char** argv) {
  try {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point from) {
      return std::chrono::duration<double>(Clock::now() - from).count();
    };

    const auto load_start = Clock::now();
    const dermis::Scene scene = argc > 1 ? dermis::Scene::load(argv[1]) : dermis::Scene::built_in();
    const double load_s = seconds(load_start);

    dermis::RenderSettings settings;
    settings.output.width = settings.output.height = argc > 4 ? std::atoi(argv[4]) : 512;
    dermis::ReferenceSettings reference;
    reference.noise_percent = argc > 2 ? std::atof(argv[2]) : 2;
    reference.model = argc > 3 ? argv[3] : "bssrdf";
    if (reference.model == "volume") reference.medium = "skin2";

    const auto start = Clock::now();
    const std::clock_t cpu_start = std::clock();
    const dermis::ReferencePicture out = dermis::render_reference(scene, settings, reference);
    const double cpu_s = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;

    std::printf("%s, %s, %dx%d: noise %.3f %% after %d samples per pixel\n", scene.name().c_str(),
                reference.model.c_str(), settings.output.width, settings.output.height, out.noise_percent,
                out.samples);
    std::printf("loading %.1f s, rendering %.1f s, %.1f s of processor time, %u cores\n", load_s,
                seconds(start), cpu_s, std::thread::hardware_concurrency());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "reference_bench: %s\n", error.what());
    return 1;
  }
}
