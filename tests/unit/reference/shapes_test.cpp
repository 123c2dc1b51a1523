// SPDX-License-Identifier: MIT
// Simple bodies: pictures of the volume model against the walks that laws are fitted to, and the laws against
// those walks, on bodies and media that the fit has not seen.
#include "truth/reference/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "support/sanitized.h"
#include "support/thrown.h"
#include "tissue/gaussians/fit.h"
#include "tissue/optics/presets.h"
#include "tissue/profile/model.h"
#include "tissue/profile/shape_laws.h"
#include "truth/reference/shape_prediction.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

optics::RgbMedium skin2() { return optics::find_material("skin2")->medium(); }

/// Radiance times pi, in a picture of the volume model of the point that shapes.h looks at.
struct Seen {
  glm::dvec3 radiance{0}, error{0};
};

/// eye_deg: from the normal, in the plane of the light and to its side.
Seen seen(const Body& body, const optics::RgbMedium& medium, double light_deg, std::uint32_t samples,
          double eye_deg = 0) {
  const scene::AssetData scene = mesh_of(body, 30);
  Job job;
  job.model = ReferenceModel::volume;
  job.medium = medium;
  job.setup.camera = tests::camera_from_aside(0.1e-3, eye_deg);
  job.setup.width = job.setup.height = 8;
  job.setup.specular = false;
  job.setup.white_albedo = true;
  const double angle = light_deg * pi / 180;
  job.setup.lights = {tests::directional_light(
      {static_cast<float>(-std::sin(angle)), 0, static_cast<float>(-std::cos(angle))})};

  const image::ImageF picture = tests::rendered(Tracer(scene, job), samples).picture();
  Seen out;
  const double pixels = picture.width * picture.height;
  glm::dvec3 squares(0);
  for (std::size_t i = 0; i < picture.values.size(); i += 4) {
    const glm::dvec3 value = pi * glm::dvec3(picture.values[i], picture.values[i + 1], picture.values[i + 2]);
    out.radiance += value / pixels;
    squares += value * value / pixels;
  }
  out.error = glm::sqrt((squares - out.radiance * out.radiance) / (pixels - 1));
  return out;
}

// The walks have the mean over cosines of 0.8 to 1, 0.9 in the middle, where the picture has 1: that changes
// the radiance by 1 to 2 % (tissue/profile/shape_laws.h).
TEST(Shapes, PicturesOfTheVolumeModelShowWhatWalksSay) {
  const struct {
    Body body;
    double light_deg;
  } cases[] = {{{.shape = Shape::sphere, .size_mm = 8}, 40},
               {{.shape = Shape::cylinder, .size_mm = 5}, 70},
               {{.shape = Shape::saddle, .size_mm = 12}, 0},
               {{.shape = Shape::slab, .size_mm = 3}, 180},
               {{.shape = Shape::wedge, .size_mm = 3, .angle_deg = 50}, 0}};
  for (const auto& [body, light_deg] : cases) {
    const std::string_view name = shape_names()[static_cast<std::size_t>(body.shape)];
    const std::vector<ShapeLight> walks =
        follow(body, skin2(), {.walks = tests::turns(40'000, 4'000), .seed = 7, .lights_deg = {light_deg}});
    const Seen picture = seen(body, skin2(), light_deg, tests::turns(256, 32));
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const double wanted = walks[0].radiance[exit_bins - 1][k],
                   error = walks[0].radiance_error[exit_bins - 1][k];
      EXPECT_NEAR(picture.radiance[c], wanted, 4 * std::hypot(error, picture.error[c]) + 0.02 * wanted)
          << name << " " << c;
    }
  }
}

TEST(Shapes, APlaneShowsTheCosine) {
  // A slab that nothing passes is a half-space.
  const std::vector<ShapeLight> walks =
      follow({.shape = Shape::slab, .size_mm = 100}, skin2(), {.walks = 40'000, .lights_deg = {0, 60, 180}});
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(walks[0].exitance[c], 1, 4 * walks[0].exitance_error[c] + 0.003) << c;
    EXPECT_NEAR(walks[1].exitance[c], 0.5, 4 * walks[1].exitance_error[c] + 0.002) << c;
    EXPECT_LT(walks[2].exitance[c], 1e-12) << c;
  }
}

TEST(Shapes, AreTheSameToTheBitAndRefuseWhatTheyCannotFollow) {
  const Body ball{.shape = Shape::sphere, .size_mm = 5};
  const ShapeWalks few{.walks = 640, .lights_deg = {0, 90}};
  EXPECT_EQ(follow(ball, skin2(), few)[1].exitance, follow(ball, skin2(), few)[1].exitance);

  const auto refused = [](const Body& body, const ShapeWalks& walks) {
    return tests::thrown<InputError>([&] { follow(body, skin2(), walks); });
  };
  EXPECT_EQ(refused({.size_mm = 0}, few), "size_mm must be 0.001 to 10000, got 0");
  EXPECT_EQ(refused({.shape = Shape::wedge, .angle_deg = 180}, few), "angle_deg must be 10 to 170, got 180");
  EXPECT_EQ(refused(ball, {.walks = 1}), "walks must be at least 64, got 1");
}

/// Root of the mean squared error over that of the truth, per cent, over light from all sides.
optics::Rgb rms_percent(const Body& body, const ScatterProfile& profile, bool with_laws,
                        std::uint64_t walks) {
  std::vector<double> degrees;
  for (int i = 0; i <= 18; ++i) degrees.push_back(10 * i);
  const std::vector<ShapeLight> lights =
      follow(body, optics::rgb_medium(*profile.medium), {.walks = walks, .seed = 3, .lights_deg = degrees});
  optics::Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    double error = 0, truth = 0;
    for (const ShapeLight& light : lights) {
      const double share = body.shape == Shape::sphere ? std::sin(light.light_deg * pi / 180) : 1;
      const double factor = with_laws ? shape_factor(body, profile, light.light_deg)[c] : 1;
      error += share * std::pow(blurred(body, profile, light.light_deg)[c] * factor - light.exitance[c], 2);
      truth += share * light.exitance[c] * light.exitance[c];
    }
    out[c] = 100 * std::sqrt(error / truth);
  }
  return out;
}

ScatterProfile profile_of(const optics::RgbMedium& medium) {
  ScatterProfile sum = gaussians::fit_shared(
      profile::make_profiles(medium, profile::Model::automatic, {}, "test").profiles, 6, "test");
  sum.medium = optics::coefficients_of(medium);
  sum.shape = profile::shape_laws(medium);
  return sum;
}

const ScatterProfile& profile_of_skin2() {
  static const ScatterProfile profile = profile_of(skin2());
  return profile;
}

// Skin shows, to an eye on the side of the light, the light of a place that faces it less.
TEST(Shapes, LightComesFromFurtherFromTheEye) {
  const ScatterProfile& profile = profile_of_skin2();
  const Body sphere{.shape = Shape::sphere, .size_mm = 8};
  constexpr double light_deg = 55, eye_deg = 60;
  constexpr std::uint32_t samples = tests::turns(1024, 64);
  const Seen near = seen(sphere, skin2(), light_deg, samples, eye_deg),
             far = seen(sphere, skin2(), light_deg, samples, -eye_deg);
  for (std::size_t c = 0; c < 3; ++c) {
    const double moved_deg =
        profile.shape->exit_offset_mm[c] / sphere.size_mm * std::sin(eye_deg * pi / 180) * 180 / pi;
    const double law = blurred(sphere, profile, light_deg + moved_deg)[c] /
                       blurred(sphere, profile, light_deg - moved_deg)[c];
    const auto k = static_cast<int>(c);
    const double truth = near.radiance[k] / far.radiance[k],
                 noise = std::hypot(near.error[k] / near.radiance[k], far.error[k] / far.radiance[k]);
    std::printf("near over far, channel %zu: %.3f +- %.3f, law %.3f\n", c, truth, noise, law);
    EXPECT_NEAR(truth, law, 0.03 + 3 * noise) << c;
    EXPECT_LT(law, 0.92) << c;
  }
}

// 40,000 walks have a noise of about 0.5 % of the light.
TEST(Shapes, LawsHoldOnSpheresAndCylinders) {
  const ScatterProfile& profile = profile_of_skin2();
  for (const double radius : {10.0, 20.0}) {
    const Body sphere{.shape = Shape::sphere, .size_mm = radius};
    const optics::Rgb plain = rms_percent(sphere, profile, false, 40'000),
                      laws = rms_percent(sphere, profile, true, 40'000);
    std::printf("sphere %g mm: %.1f %.1f %.1f -> %.1f %.1f %.1f %%\n", radius, plain[0], plain[1], plain[2],
                laws[0], laws[1], laws[2]);
    EXPECT_LT(laws[0], 6) << radius;
    EXPECT_LT(laws[1], 2) << radius;
    EXPECT_LT(laws[2], 2) << radius;
    for (const double error : plain) EXPECT_GT(error, 4) << "what the laws are for is there";
  }

  const optics::Rgb cylinder = rms_percent({.shape = Shape::cylinder, .size_mm = 4}, profile, true, 40'000);
  std::printf("cylinder 4 mm: %.1f %.1f %.1f %%\n", cylinder[0], cylinder[1], cylinder[2]);
  EXPECT_LT(cylinder[1], 5);
  EXPECT_LT(cylinder[2], 5);
}

TEST(Shapes, LawsHoldOnSlabs) {
  const optics::RgbMedium dark =
      optics::parse_coefficients("sigma_a=0.1,0.35,0.8 sigma_s=2.2,2.8,3.4", "dark");
  std::vector profiles{profile_of_skin2()};
  if (!tests::sanitized) profiles.push_back(profile_of(dark));  // to fit it takes them a quarter of a minute
  for (const ScatterProfile& profile : profiles) {
    const optics::RgbMedium medium = optics::rgb_medium(*profile.medium);
    for (const double thickness : {2.0, 4.0}) {
      const Body slab{.shape = Shape::slab, .size_mm = thickness};
      const std::vector<ShapeLight> lights =
          follow(slab, medium, {.walks = tests::turns(100'000, 10'000), .seed = 5, .lights_deg = {0, 180}});
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          const double truth = lights[i].exitance[c],
                       law = shape_factor(slab, profile, lights[i].light_deg)[c];
          if (truth < 0.01) continue;  // too little light to see
          EXPECT_NEAR(law, truth, 0.1 * truth + 3 * lights[i].exitance_error[c])
              << thickness << " mm, " << (i == 0 ? "front " : "back ") << c;
        }
    }
  }
}

}  // namespace
}  // namespace dermis::reference
