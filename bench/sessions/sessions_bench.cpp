// SPDX-License-Identifier: MIT
// What a frame of a session costs the host, and what it asks of the device: an orbit around a head, and the
// same with 16 and with 256 instances of it, each of which turns.
//   sessions_bench OUT.json HEAD [FRAMES [INSTANCES...]]
// 480 x 540 pixels, light maps of 512; 1, 16 and 256 instances unless told. Ends with 1 if a frame after the
// third allocates memory, makes a buffer, an image or a pipeline, or waits for all that was submitted.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/session.h"
#include "support/median.h"

namespace {

using namespace dermis;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

std::array<double, 16> turned(double angle_rad, double x_m, double y_m) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, x_m, y_m, 0, 1};
}

// Side by side in a square.
void place(Scene& scene, const std::vector<InstanceId>& heads, double angle_rad) {
  const int side = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(heads.size()))));
  for (int i = 0; i < static_cast<int>(heads.size()); ++i) {
    const double x_m = 0.5 * (i % side - (side - 1) / 2.0), y_m = 0.5 * (i / side - (side - 1) / 2.0);
    scene.set_transform(heads[static_cast<std::size_t>(i)], turned(angle_rad + i, x_m, y_m));
  }
}

Json counters_json(const DeviceCounters& before, const DeviceCounters& after) {
  return {{"allocations", after.allocations - before.allocations},
          {"buffers", after.buffers - before.buffers},
          {"images", after.images - before.images},
          {"pipelines", after.pipelines - before.pipelines},
          {"submissions", after.submissions - before.submissions},
          {"idle_waits", after.idle_waits - before.idle_waits}};
}

bool is_steady(const Json& counters, int frames) {
  for (const char* name : {"allocations", "buffers", "images", "pipelines", "idle_waits"})
    if (counters.at(name) != 0) return false;
  return counters.at("submissions") == frames;
}

// Host time is that of draw() without its wait for the frame before those in flight: what the calls before
// the submission take, seen where the device is idle.
Json orbit(Renderer& renderer, const Asset& head, int instances, int frames) {
  Scene scene;
  std::vector<InstanceId> heads;
  for (int i = 0; i < instances; ++i) heads.push_back(scene.add({.asset = head}));
  scene.add_light({.light = {.colour = {2, 1.9, 1.8}, .direction = {-1, -0.5, -1}}});
  const double distance_m = 1.2 * std::sqrt(static_cast<double>(instances));

  RenderSettings s{.quality = {.map_size = 512, .shadow_size = 512}, .output = {.width = 480, .height = 540}};
  s.camera.target_m = {0, 0, 0};
  Session session(renderer, {.frames_in_flight = 2});
  std::vector<double> host_ms, frame_ms;
  DeviceCounters before;

  for (int i = 0; i < frames; ++i) {
    if (i == 3) before = renderer.counters();
    const double angle = 2 * std::numbers::pi * i / frames;
    const auto start = Clock::now();
    place(scene, heads, angle);
    s.camera.eye_m = {distance_m * std::sin(angle), 0, distance_m * std::cos(angle)};
    const Ticket ticket = session.draw(scene, s);
    const auto submitted = Clock::now();
    session.results(ticket);
    const auto done = Clock::now();
    if (i < 3) continue;
    host_ms.push_back(std::chrono::duration<double, std::milli>(submitted - start).count());
    frame_ms.push_back(std::chrono::duration<double, std::milli>(done - start).count());
  }

  // The picture above is waited for in every frame; without that nothing may be.
  const DeviceCounters until_here = renderer.counters();
  Json counters = counters_json(before, until_here);
  counters["idle_waits"] = 0;
  const DeviceCounters running = renderer.counters();
  for (int i = 0; i < frames; ++i) {
    place(scene, heads, 0.1 * i);
    session.draw(scene, s);
  }
  const Json unwatched = counters_json(running, renderer.counters());
  fmt::print("{:>4} instances: host {:.2f} ms per frame, frame {:.1f} ms; after the third: {}\n", instances,
             median(host_ms), median(frame_ms), unwatched.dump());
  return {{"instances", instances},
          {"host_ms", median(host_ms)},
          {"frame_ms", median(frame_ms)},
          {"counters", unwatched},
          {"steady", is_steady(unwatched, frames) && is_steady(counters, frames - 3)}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: sessions_bench OUT.json HEAD [FRAMES [INSTANCES...]]\n");
    return 2;
  }
  try {
    const int frames = argc > 3 ? std::atoi(argv[3]) : 300;
    std::vector<int> counts;
    for (int i = 4; i < argc; ++i) counts.push_back(std::max(std::atoi(argv[i]), 1));
    if (counts.empty()) counts = {1, 16, 256};

    const Asset head = std::string(argv[2]) == "built-in" ? Asset::built_in() : Asset::load(argv[2]);
    Renderer renderer;
    Json runs = Json::array();
    bool steady = true;
    for (const int instances : counts) {
      // Fewer frames of more heads take about as long.
      runs.push_back(orbit(renderer, head, instances, std::max(8, frames / instances)));
      steady = steady && runs.back().at("steady");
    }
    std::ofstream(argv[1]) << runs.dump(2) << '\n';
    return steady ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "sessions_bench: {}\n", error.what());
    return 1;
  }
}
