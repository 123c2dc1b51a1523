// SPDX-License-Identifier: MIT
#include "unit/bench/made_up.h"

namespace dermis::tests {

using namespace cli::bench;

namespace {

Measured measured(const Variant& variant, double ms) {
  Measured m{.variant = variant, .rounds_ms = {ms + 1, ms - 1, ms}, .passes = {}, .counts = {}};
  m.passes = {{.name = "shadow", .ms = ms / 4, .calls = 2},
              {.name = "blur 0 u", .ms = ms / 2, .calls = 1},
              {.name = "tone map", .ms = ms / 4, .calls = 1}};
  m.counts.technique = variant.settings.technique;
  m.counts.irradiance_texels = 100, m.counts.convolved_texels = 600, m.counts.launched = 1300;
  m.counts.used_size = std::vector<int>(static_cast<std::size_t>(variant.settings.camera.heads),
                                        variant.settings.quality.depth ? 64 : 128);
  return m;
}

image::Image8 flat(int width, int height, std::uint8_t value) {
  return {.width = width,
          .height = height,
          .rgba = std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 4), value)};
}

}  // namespace

Run made_up_run() {
  Run run{.version = "1.2.3",
          .commit = "abcdef0",
          .command = "dermis bench <head>.glb",
          .scene = "<head>.glb",
          .device = "a device",
          .driver = "a driver",
          .api = "1.3.0",
          .timing = "submit"};
  run.cores = 2;
  run.lights = 2;
  run.gaussians = 6;
  run.rounds = 3;

  for (const int heads : {1, 3})
    for (const double distance : {2.5, 7.0}) {
      RenderSettings s = run.settings;
      s.camera.heads = heads;
      s.camera.distance = distance;
      Cell cell{.heads = heads, .distance = distance, .measured = {}, .differences = {}};

      // Let each variant take 2 ms less than the one before; the optimised one always takes 20 ms.
      double ms = 40.0 * heads;
      for (const Variant& variant : variants_of(s)) {
        cell.measured.push_back(measured(variant, variant.key == optimised_key ? 20 : ms));
        ms -= 2;
      }

      if (distance < 5)
        cell.differences[optimised_key] = {.psnr_db = 45.5, .flip_mean = 0.0125, .pixels = 321, .samples = 4};
      run.cells.push_back(std::move(cell));
    }

  return run;
}

Run made_up_run_with_pictures() {
  Run run = made_up_run();
  for (std::size_t i = 0; i < run.cells.size(); ++i)
    run.pictures.push_back({flat(12, 8, 50), flat(12, 8, 60)});
  run.maps = MapPictures{.heads = 1,
                         .distance = 2.5,
                         .irradiance = flat(8, 8, 90),
                         .visibility = flat(8, 8, 20),
                         .picture = flat(12, 8, 50)};
  return run;
}

}  // namespace dermis::tests
