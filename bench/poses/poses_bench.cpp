// SPDX-License-Identifier: MIT
// What it costs that heads move: 16 instances of the given files in a square, each playing its first clip out
// of phase with the others, against the same heads as they were loaded.
//   poses_bench OUT.json FRAMES HEAD...
// Frames of both take turns in one run: median of each, and the ratio, of elapsed time and of processor time,
// which other work on the machine hardly changes. 480 x 540 pixels, light maps of 512, every optimisation.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/session.h"
#include "support/median.h"

namespace {

using namespace dermis;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
constexpr int instances = 16;

// Their heads at the height of the camera, side by side in a square.
Scene crowd(const std::vector<Asset>& heads) {
  Scene scene;
  for (int i = 0; i < instances; ++i) {
    const Asset& head = heads[static_cast<std::size_t>(i) % heads.size()];
    const AssetBounds bounds = head.bounds();
    const double x_m = 0.3 * (i % 4 - 1.5), y_m = 0.4 * (1.5 - i / 4);
    scene.add({.asset = head,
               .world_from_asset = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0,  //
                                    x_m - (bounds.low_m[0] + bounds.high_m[0]) / 2,
                                    y_m - (bounds.low_m[1] + bounds.high_m[1]) / 2, 0, 1}});
  }
  scene.add_light({.light = {.colour = {2, 1.9, 1.8}, .direction = {-1, -0.5, -1}}});
  return scene;
}

struct Run {
  Scene scene;
  bool moves = false;
  std::vector<double> pose_ms, host_ms, frame_ms, processor_ms;
};

void pose_all(Scene& scene, const std::vector<Asset>& heads, int frame) {
  const std::vector<InstanceId> ids = scene.instances();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::string clip = heads[i % heads.size()].clips().front();
    const double end_s = heads[i % heads.size()].clip_end_s(clip);
    const double phase = frame / 24.0 / end_s + static_cast<double>(i) / instances;
    scene.pose(ids[i], clip, end_s * (phase - static_cast<int>(phase)));
  }
}

void draw(Run& run, Session& session, const std::vector<Asset>& heads, const RenderSettings& s, int frame) {
  const auto start = Clock::now();
  const std::clock_t worked = std::clock();  // of all threads, those of a software driver too
  if (run.moves) pose_all(run.scene, heads, frame);
  const auto posed = Clock::now();
  const Ticket ticket = session.draw(run.scene, s);
  const auto submitted = Clock::now();
  const Picture picture = session.picture(ticket);
  const auto done = Clock::now();
  if (frame < 2) return;
  run.pose_ms.push_back(std::chrono::duration<double, std::milli>(posed - start).count());
  run.host_ms.push_back(std::chrono::duration<double, std::milli>(submitted - posed).count());
  run.frame_ms.push_back(std::chrono::duration<double, std::milli>(done - start).count());
  run.processor_ms.push_back(1000.0 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: poses_bench OUT.json FRAMES HEAD...\n");
    return 2;
  }
  try {
    const int frames = std::max(std::atoi(argv[2]), 1);
    std::vector<Asset> heads;
    for (int i = 3; i < argc; ++i) heads.push_back(Asset::load(argv[i]));

    RenderSettings s{.quality = {.map_size = 512, .shadow_size = 512},
                     .output = {.width = 480, .height = 540}};
    s.camera.eye_m = {0, 0, 3.6};
    s.camera.target_m = {0, 0, 0};
    s.output.exposure_ev = 0;

    Renderer renderer;
    Session still(renderer, {.frames_in_flight = 1}), moving(renderer, {.frames_in_flight = 1});
    Run rest{.scene = crowd(heads), .moves = false}, clips{.scene = crowd(heads), .moves = true};
    for (int frame = 0; frame < frames + 2; ++frame) {
      draw(rest, still, heads, s, frame);
      draw(clips, moving, heads, s, frame);
    }

    const double rest_ms = median(rest.frame_ms), clips_ms = median(clips.frame_ms);
    fmt::print(
        "{} instances of {} files: at rest {:.1f} ms (draw() {:.2f}), clips {:.1f} ms (draw() {:.2f}, pose() "
        "of all {:.2f}), ratio {:.3f}\n",
        instances, heads.size(), rest_ms, median(rest.host_ms), clips_ms, median(clips.host_ms),
        median(clips.pose_ms), clips_ms / rest_ms);
    const double rest_worked = median(rest.processor_ms), clips_worked = median(clips.processor_ms);
    fmt::print("processor time: at rest {:.1f} ms, clips {:.1f} ms, ratio {:.3f}\n", rest_worked,
               clips_worked, clips_worked / rest_worked);

    // What the passes of one frame take.
    const Statistics cost = renderer.render(clips.scene, s).statistics;
    Json passes = Json::object();
    for (const PassStatistics& pass : cost.passes)
      if (pass.name == "pose" || pass.name.starts_with("stretch")) {
        passes[pass.name] = pass.ms;
        fmt::print("  {:<24} {:8.2f} ms\n", pass.name, pass.ms);
      }
    std::ofstream(argv[1]) << Json{{"device", cost.device},
                                   {"instances", instances},
                                   {"frames", frames},
                                   {"rest_ms", rest_ms},
                                   {"clips_ms", clips_ms},
                                   {"pose_ms", median(clips.pose_ms)},
                                   {"ratio", clips_ms / rest_ms},
                                   {"rest_processor_ms", rest_worked},
                                   {"clips_processor_ms", clips_worked},
                                   {"passes_ms", passes}}
                                  .dump(2)
                           << '\n';
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "poses_bench: {}\n", error.what());
    return 1;
  }
}
