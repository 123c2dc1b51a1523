// SPDX-License-Identifier: MIT
// Frames of a session in C++, for python_frames.py, which draws the same in turns with this:
//   frames_bench [SIZE]
// Reads how many frames to draw from each line of its input, and answers with a line of JSON: the time of
// each frame, and that of all processors for all of them, ms.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/session.h"

namespace {

using namespace dermis;
using Clock = std::chrono::steady_clock;

// The number of a frame says where its camera stands; python_frames.py has the same.
double azimuth_deg(int frame) { return 40 * std::sin(0.1 * frame); }

void serve(int size) {
  const Scene scene(Asset::built_in());
  Renderer renderer;
  Session session(renderer, {.wanted = Outputs{Output::display}});
  RenderSettings settings{.quality = {.map_size = 256, .shadow_size = 256},
                          .output = {.width = size, .height = size, .exposure_ev = 0.0}};
  int frame = 0;
  std::uint64_t sum = 0;
  for (std::string line; std::getline(std::cin, line);) {
    std::vector<double> ms;
    const std::clock_t cpu = std::clock();
    for (int left = std::atoi(line.c_str()); left > 0; --left, ++frame) {
      const auto start = Clock::now();
      settings.camera.orbit_deg = {azimuth_deg(frame), 0};
      const Ticket ticket = session.draw(scene, settings);
      const Results results = session.results(ticket);
      sum += static_cast<std::uint64_t>(results.bytes(Output::display)[0]);
      ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
    const double cpu_ms = 1000.0 * static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
    fmt::print("{{\"ms\": [{:.4f}], \"cpu_ms\": {:.3f}}}\n", fmt::join(ms, ", "), cpu_ms);
    std::fflush(stdout);
  }
  fmt::print(stderr, "{} frames, sum {}\n", frame, sum);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    serve(argc > 1 ? std::atoi(argv[1]) : 64);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "frames_bench: {}\n", error.what());
    return 1;
  }
}
