// SPDX-License-Identifier: MIT
// What the optimisations of texture-space change in a picture: views from all around a head, and a camera
// that moves away from it.
//   views_bench OUT.json [--dolly] SCENE...
// For each scene 64 views: 16 azimuths, elevations -30, 0, 30 and 60 degrees; PSNR and FLIP over the skin
// (super-sampled 4 x 4, exposed fairly), and texels that were read and never lit. With --dolly, of the first
// scene: 200 steps from 2.5 to 100 radii at 480 x 300, how much the picture changes from step to step with
// and without the optimisations.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dermis/renderer.h"
#include "image/compare_exposed.h"
#include "image/resize.h"

namespace {

using namespace dermis;
using Json = nlohmann::ordered_json;

constexpr int super = 4;  // samples per pixel, along each axis

RenderSettings without(RenderSettings s) {
  s.quality.cull = s.quality.depth = s.quality.clip = false;
  return s;
}

image::ImageF super_sampled(PreparedFrame& frame, RenderSettings s, double d_ref) {
  s.output.width *= super, s.output.height *= super;
  s.quality.samples = 1, s.output.bloom = 0, s.quality.d_ref = d_ref;
  frame.set(s);
  Picture fine = frame.picture();
  return image::downsample_box(
      {.width = fine.width, .height = fine.height, .channels = 4, .values = std::move(fine.linear_rgba)},
      super);
}

Json sweep(Renderer& renderer, const std::string& path, RenderSettings s) {
  const Scene scene = Scene::load(path);
  s.output.width = 192;
  s.output.height = 120;
  s.quality.map_size = 512;
  s.quality.shadow_size = 512;
  s.lighting.rig_lights = 2;

  PreparedFrame optimised = renderer.prepare(scene, s), baseline = renderer.prepare(scene, without(s));
  Json views = Json::array();
  double least_psnr = 1e9, largest_flip = 0;
  std::uint64_t unshaded = 0;

  for (int k = 0; k < 64; ++k) {
    s.camera.orbit_deg = {22.5 * (k % 16), -30.0 + 30 * (k / 16)};
    optimised.set(s);
    const Statistics st = optimised.picture().statistics;
    const auto d = image::compare_exposed(super_sampled(baseline, without(s), st.d_ref),
                                          super_sampled(optimised, s, st.d_ref), s.output.tone_map);

    Json view = {{"orbit_deg", s.camera.orbit_deg}, {"unshaded_reads", st.unshaded_reads}};
    unshaded += st.unshaded_reads;
    if (d) {
      view["psnr_db"] = d->psnr_db;
      view["flip_mean"] = d->flip_mean;
      view["mean_display"] = d->mean_display;
      view["pixels"] = d->pixels;
      least_psnr = std::min(least_psnr, d->psnr_db);
      largest_flip = std::max(largest_flip, d->flip_mean);
    }
    views.push_back(view);
    std::fprintf(stderr, "%s view %d: %s\n", path.c_str(), k, view.dump().c_str());
  }

  return {{"scene", std::filesystem::path(path).filename()},
          {"size", {s.output.width, s.output.height}},
          {"map_size", s.quality.map_size},
          {"least_psnr_db", least_psnr},
          {"largest_flip_mean", largest_flip},
          {"unshaded_reads", unshaded},
          {"views", views}};
}

Json dolly(Renderer& renderer, const std::string& path, RenderSettings s) {
  const Scene scene = Scene::load(path);
  s.output.width = 480;
  s.output.height = 300;
  s.quality.map_size = 512;
  s.quality.shadow_size = 512;
  s.lighting.rig_lights = 2;
  s.output.bloom = 0;

  PreparedFrame frames[2] = {renderer.prepare(scene, without(s)), renderer.prepare(scene, s)};
  std::vector<std::uint8_t> last[2];
  std::vector<float> last_alpha;
  Json changes[2] = {Json::array(), Json::array()}, distances = Json::array();
  double worst = 0;

  for (int i = 0; i < 200; ++i) {
    s.camera.distance = 2.5 * std::pow(40, i / 199.0);
    frames[0].set(without(s));
    frames[1].set(s);
    const Picture pictures[2] = {frames[0].picture(), frames[1].picture()};
    std::vector<float> alpha;
    for (std::size_t p = 3; p < pictures[0].linear_rgba.size(); p += 4)
      alpha.push_back(pictures[0].linear_rgba[p]);

    // Average how far display values of skin, 0 to 255, move from frame to frame.
    if (i > 0) {
      double change[2] = {}, values = 0;
      for (std::size_t p = 0; p < alpha.size(); ++p) {
        if (alpha[p] == 0 && last_alpha[p] == 0) continue;
        values += 3;
        for (std::size_t which = 0; which < 2; ++which)
          for (std::size_t c = 0; c < 3; ++c)
            change[which] +=
                std::abs(int{pictures[which].display_rgba[4 * p + c]} - int{last[which][4 * p + c]});
      }
      for (std::size_t which = 0; which < 2; ++which) changes[which].push_back(change[which] / values);
      distances.push_back(*s.camera.distance);
      worst = std::max(worst, change[1] / change[0]);
      std::fprintf(stderr, "dolly %d: %.3f %.3f\n", i, change[0] / values, change[1] / values);
    }

    for (std::size_t which = 0; which < 2; ++which) last[which] = pictures[which].display_rgba;
    last_alpha = std::move(alpha);
  }

  return {{"scene", std::filesystem::path(path).filename()},
          {"size", {s.output.width, s.output.height}},
          {"map_size", s.quality.map_size},
          {"largest_ratio", worst},
          {"distance", distances},
          {"mean_change_baseline", changes[0]},
          {"mean_change_optimised", changes[1]}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: views_bench OUT.json [--dolly] SCENE...\n");
    return 2;
  }

  try {
    Renderer renderer;
    Json result;
    std::vector<std::string> scenes(argv + 2, argv + argc);
    result["command"] = "views_bench";
    for (const std::string& scene : scenes)
      result["command"] =
          result["command"].get<std::string>() + " " + std::filesystem::path(scene).filename().string();

    const bool moves = std::erase(scenes, "--dolly") > 0;
    const RenderSettings settings;

    // Render a tiny picture: its statistics name the device.
    RenderSettings tiny;
    tiny.output.width = tiny.output.height = 8;
    tiny.quality.map_size = tiny.quality.shadow_size = 32;
    const Statistics st = renderer.render(Scene::built_in(), tiny).statistics;
    result["tone_map"] = tiny.output.tone_map;
    result["device"] = st.device;
    result["driver"] = st.driver;

    result["sweeps"] = Json::array();
    if (moves && !scenes.empty()) result["dolly"] = dolly(renderer, scenes.front(), settings);
    for (const std::string& scene : scenes) result["sweeps"].push_back(sweep(renderer, scene, settings));
    std::ofstream(argv[1]) << result.dump(1) << "\n";
  } catch (const std::exception& error) {
    std::fprintf(stderr, "views_bench: %s\n", error.what());
    return 1;
  }
}
