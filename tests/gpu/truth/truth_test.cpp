// SPDX-License-Identifier: MIT
// Real time against ground truth: how much nearer the techniques come than no scattering at all, and that
// they do not drift away. docs/accuracy.md has the same at full size.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "dermis/reference.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "image/codec.h"
#include "image/colour.h"
#include "image/compare_flip.h"
#include "image/metrics.h"
#include "image/tone_map.h"
#include "support/files.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

constexpr int fine = 4;  // pictures are rendered so many times as wide and high, and averaged

struct Error {
  double flip = 0;  // HDR-FLIP unless told
  double rel_mse = 0;
};

/// A scene, its reference, its skin.
class Truth {
 public:
  Truth(Scene scene, const RenderSettings& settings, int samples)
      : scene_(std::move(scene)), settings_(settings) {
    const ReferencePicture picture = render_reference(scene_, settings_, {.samples = samples});
    reference_ = linear(picture.picture);
    variance_rgba_ = picture.variance_rgba;
    regions_ = picture_regions(scene_, settings_);
    std::printf("reference: %d samples per pixel, noise %.2f %%\n", picture.samples, picture.noise_percent);
  }

  const image::ImageF& reference() const { return reference_; }

  image::ImageF rendered(const std::string& technique, bool optimised) const {
    RenderSettings s = optimised ? settings_ : unoptimised(settings_);
    s.technique = technique;
    return averaged(s);
  }

  /// Error over the skin of a picture with a mistake in it.
  Error error_of(const std::string& name, const std::function<void(RenderSettings&)>& mistake) const {
    RenderSettings s = settings_;
    mistake(s);
    const image::ImageF picture = averaged(s);
    const std::vector<std::uint8_t>& skin = regions_.front().mask;
    const Error e{.flip = image::summarise_flip(image::hdr_flip(reference_, picture).map, skin).mean,
                  .rel_mse = image::rel_mse(reference_, picture, skin) - noise(skin)};
    std::printf("%s: HDR-FLIP %.4f, relative MSE %.3g\n", name.c_str(), e.flip, e.rel_mse);
    return e;
  }

  /// Error over skin: FLIP of what a display shows, and of light the relative squared error less noise.
  Error shown_error(const std::string& technique) const {
    const std::vector<std::uint8_t>& skin = regions_.front().mask;
    const image::ImageF picture = rendered(technique, true);
    const image::ImageF map =
        image::flip_map(shown(reference_, ToneMap::natural), shown(picture, ToneMap::natural));
    const Error e{.flip = image::summarise_flip(map, skin).mean,
                  .rel_mse = image::rel_mse(reference_, picture, skin) - noise(skin)};
    std::printf("%s, shown: FLIP %.4f, relative MSE %.3g\n", technique.c_str(), e.flip, e.rel_mse);
    return e;
  }

  /// Over each region that is not empty, by name.
  std::map<std::string, Error> errors(const std::string& technique, bool optimised) const {
    const image::ImageF picture = rendered(technique, optimised);
    const image::ImageF flip = image::hdr_flip(reference_, picture).map;
    std::printf("%s%s\n", technique.c_str(), optimised ? ", optimised" : "");
    std::map<std::string, Error> all;
    for (const PictureRegion& region : regions_) {
      if (region.pixels == 0) continue;
      const Error e{.flip = image::summarise_flip(flip, region.mask).mean,
                    .rel_mse = image::rel_mse(reference_, picture, region.mask) - noise(region.mask)};
      std::printf("  %-14s HDR-FLIP %.4f, relative MSE %.3g\n", region.name.c_str(), e.flip, e.rel_mse);
      all[region.name] = e;
    }
    return all;
  }

 private:
  image::ImageF averaged(const RenderSettings& s) const {
    return downsampled(renderer().render(scene_, super_sampled(s, fine)), fine);
  }

  double noise(const std::vector<std::uint8_t>& mask) const {
    double total = 0, count = 0;
    for (std::size_t i = 0; i < reference_.values.size(); ++i) {
      if (!mask[i / 4] || i % 4 == 3) continue;
      total += variance_rgba_[i] / (std::pow(reference_.values[i], 2) + 0.01);
      ++count;
    }
    return total / count;
  }

  Scene scene_;
  RenderSettings settings_;
  image::ImageF reference_;
  std::vector<float> variance_rgba_;
  std::vector<PictureRegion> regions_;
};

// One lamp from the side. Shadow maps are fine: their filter must not be what is measured.
RenderSettings small(int width, int height) {
  RenderSettings s;
  s.output.width = width, s.output.height = height;
  s.quality.map_size = 1024;
  s.quality.shadow_size = 8192;
  s.output.bloom = 0;
  s.lighting.placed_lights = {{.azimuth_deg = 90, .elevation_deg = 10}};
  return s;
}

using TruthOfTheScan = WithScan;

TEST_F(TruthOfTheScan, UnderALightFromTheSide) {
  const Truth truth(scan(), small(96, 108), 128);
  auto lambert = truth.errors("lambert", false), scattered = truth.errors("texture-space", false),
       optimised = truth.errors("texture-space", true);
  EXPECT_LT(2.5 * scattered["skin"].rel_mse, lambert["skin"].rel_mse);
  EXPECT_LT(1.2 * scattered["skin"].flip, lambert["skin"].flip) << "most of the skin is the same in both";
  EXPECT_LT(3 * scattered["terminator"].rel_mse, lambert["terminator"].rel_mse);
  EXPECT_LT(1.7 * scattered["terminator"].flip, lambert["terminator"].flip);
  EXPECT_LT(optimised["skin"].flip, 1.05 * scattered["skin"].flip);
}

// Sculpted once for all that look at it.
const Scene& built_in_head() {
  static const Scene head = Scene::built_in();
  return head;
}

/// No theory says how near a technique comes: a bound stands between what it does and what mistakes do that a
/// change could make, each of which it has to see.
struct Bound {
  double flip, rel_mse;
  bool holds(const Error& e) const { return e.flip < flip && e.rel_mse < rel_mse; }
};

TEST(Truth, TheBuiltInHeadDoesNotDriftAway) {
  const Bound bound{.flip = 0.033, .rel_mse = 1.5e-4};
  const Truth truth(built_in_head(), small(96, 96), 128);
  const Error scattered = truth.errors("texture-space", true)["skin"];
  EXPECT_LT(scattered.flip, bound.flip);
  EXPECT_LT(scattered.rel_mse, bound.rel_mse);

  const auto is_seen = [&](const char* name, const std::function<void(RenderSettings&)>& mistake) {
    EXPECT_FALSE(bound.holds(truth.error_of(name, mistake))) << name;
  };
  is_seen("no scattering", [](RenderSettings& s) { s.technique = "lambert"; });
  is_seen("a lamp 2 degrees off", [](RenderSettings& s) { s.lighting.placed_lights[0].azimuth_deg += 2; });
  is_seen("2 % less light", [](RenderSettings& s) { s.lighting.placed_lights[0].irradiance *= 0.98; });
  is_seen("no reflection", [](RenderSettings& s) { s.lighting.specular = false; });
}

// Surroundings alone: what a head hides of them, and what it sends on. Their light is so smooth that missing
// scattering would not show here. Between lids and lips, which the surroundings hardly reach, half a texel of
// what is hidden is a large share: folds have a FLIP of 0.31, the rest 0.056.
TEST(Truth, TheBuiltInHeadInAStudio) {
  RenderSettings s = small(96, 96);
  s.lighting.placed_lights.clear();
  s.lighting.rig_lights = 0;
  s.lighting.environment = "studio";
  const Truth truth(built_in_head(), s, 128);
  const Bound bound{.flip = 0.063, .rel_mse = 3.2e-3};
  const Error scattered = truth.errors("texture-space", true)["skin"];
  EXPECT_LT(scattered.flip, bound.flip);
  EXPECT_LT(scattered.rel_mse, bound.rel_mse);

  const auto is_seen = [&](const char* name, const std::function<void(RenderSettings&)>& mistake) {
    EXPECT_FALSE(bound.holds(truth.error_of(name, mistake))) << name;
  };
  is_seen("surroundings turned by 10 degrees",
          [](RenderSettings& wrong) { wrong.lighting.environment_rotation_deg = 10; });
  is_seen("5 % less light", [](RenderSettings& wrong) { wrong.lighting.environment_intensity = 0.95; });
  is_seen("no reflection", [](RenderSettings& wrong) { wrong.lighting.specular = false; });
}

/// A blue gradient over a ground, with a sun of so many pixels where `azimuth_deg` says, from the front
/// towards the head's left, and a window behind the head if wanted.
std::string sky_with_sun(int pixels, double azimuth_deg, double elevation_deg, bool window) {
  constexpr int width = 512, height = 256;
  image::ImageF sky{.width = width, .height = height, .channels = 3, .values = {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float up = static_cast<float>(std::cos(3.14159265 * (y + 0.5) / height));
      const bool in_window = window && x > 300 && x < 330 && y > 90 && y < 120;
      for (const float zenith : {0.15f, 0.35f, 0.75f})
        sky.values.push_back(in_window ? 20 : up < 0 ? 0.13f : 0.9f - (0.9f - zenith) * up);
    }

  // A square of pixels, as near as it goes.
  const int side = static_cast<int>(std::lround(std::sqrt(pixels)));
  const int left = static_cast<int>(width * (0.5 + (180 - azimuth_deg) / 360)),
            top = static_cast<int>(height * (90 - elevation_deg) / 180);
  for (int i = 0; i < pixels; ++i) {
    float* rgb = sky.at((left + i % side) % width, top + i / side);
    rgb[0] = 110000, rgb[1] = 102000, rgb[2] = 90000;
  }
  const fs::path path = program_folder() / "sky-with-sun.exr";
  image::save_exr(path, sky);
  return path.string();
}

// A sun in the sky costs no more error than soft boxes do. Beside and behind the head harmonics alone would
// ring: black and blue blotches.
TEST(Truth, ASunIsNoWorseThanAStudio) {
  RenderSettings s = small(40, 40);
  s.quality.map_size = 512;
  s.quality.shadow_size = 2048;
  s.lighting.placed_lights.clear();
  s.lighting.rig_lights = 0;
  s.lighting.environment = "studio";
  const Scene& head = built_in_head();
  const Error studio = Truth(head, s, 64).shown_error("texture-space");

  const struct {
    int pixels;
    double azimuth_deg, elevation_deg;
    bool window;
  } cells[] = {{1, 90, 35, false}, {4, 180, 10, false}, {16, 45, 65, false}, {4, -120, 35, true}};
  for (const auto& cell : cells) {
    SCOPED_TRACE(testing::Message() << cell.pixels << " pixels at " << cell.azimuth_deg << " degrees");
    s.lighting.environment = sky_with_sun(cell.pixels, cell.azimuth_deg, cell.elevation_deg, cell.window);
    // A pixel of the sun brings an irradiance of some 14, the sky of 1: white shows as white.
    s.output.exposure_ev = -std::log2((14 * cell.pixels + 1) / 3.14);
    const Error sun = Truth(head, s, 64).shown_error("texture-space");
    EXPECT_LT(sun.flip, studio.flip);
    EXPECT_LT(sun.rel_mse, studio.rel_mse);
  }
}

/// A plane of skin under a light from straight above, half of it in the shadow of a sheet; a camera between
/// both sees 12 mm of it.
Scene knife_edge() {
  scene::AssetData made = scene::plane(0.06, glm::dmat2(1), {}, 1);
  add_sheet(made, 0.05f, 0.02f);
  made.lights.push_back({.name = "sun", .colour = glm::vec3(3.14159265f)});
  made.cameras = {camera_from_above(0.002, {0, 0, 0.01f})};
  return wrap(std::move(made));
}

// The edge of a shadow against the reference instead of the closed form: 1 % of the peak on average, 3 % in
// each column of a quarter of a millimetre, where the narrowest Gaussians are smaller than a texel (17 a mm).
TEST(Truth, AKnifeEdge) {
  RenderSettings s = small(48, 16);
  s.lighting.placed_lights.clear();
  s.lighting.ambient = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;

  const Scene scene = knife_edge();
  const Truth truth(scene, s, 1024);
  const image::ImageF picture = truth.rendered("texture-space", false), &reference = truth.reference();

  double mean = 0, worst = 0;
  for (int x = 0; x < s.output.width; ++x)
    for (int c = 0; c < 3; ++c) {
      double difference = 0;
      for (int y = 0; y < s.output.height; ++y)
        difference += (double(picture.at(x, y)[c]) - reference.at(x, y)[c]) / s.output.height;
      mean += std::abs(difference) / (3 * s.output.width);
      worst = std::max(worst, std::abs(difference));
    }

  std::printf("mean %.4f, worst %.4f of the peak\n", mean, worst);
  EXPECT_GT(reference.at(0, 8)[0], 0.95) << "lit";
  EXPECT_LT(reference.at(47, 8)[0], 0.05) << "in the shadow";
  EXPECT_LT(mean, 0.01);
  EXPECT_LT(worst, 0.03);
}

}  // namespace
}  // namespace dermis::tests
