// SPDX-License-Identifier: MIT
// Skin that knows its shape: pictures against the laws in double, on bodies whose curvature and thickness are
// known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "api/asset_state.h"
#include "dermis/profile.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "image/metrics.h"
#include "render/passes/light_map/transmission.h"
#include "support/files.h"
#include "support/rigs.h"
#include "support/thrown.h"
#include "tissue/gaussians/scatter_profile.h"
#include "tissue/profile/shape_laws.h"

namespace dermis::tests {
namespace {

constexpr double pi = 3.14159265358979;

const ScatterProfile& skin2() {
  static const ScatterProfile made = profile_of_preset("skin2");
  return made;
}

/// The profile as a file, in a folder of the program.
const std::string& skin2_file() {
  static const std::string path = [] {
    const std::string file = (program_folder() / "skin2.json").string();
    write_profile(skin2(), file);
    return file;
  }();
  return path;
}

RenderSettings settings(bool shape_aware, int side = 48, int map_side = 256) {
  RenderSettings s = small_settings("texture-space", side, map_side);
  s.quality.samples = s.quality.light_samples = 1;
  s.lighting.ambient = 1;
  s.lighting.rig_lights = 0;
  s.lighting.specular = false;
  s.lighting.white_albedo = true;
  s.output.bloom = 0;
  s.skin.profile = skin2_file();
  s.skin.shape_aware = shape_aware;
  return s;
}

/// A sphere in a furnace, where the blur shows 1, seen without perspective.
scene::AssetData ball(double radius_mm) {
  scene::AssetData made = scene::sphere(radius_mm / 1000, 24);
  made.materials.front().skin_settings.mix = 0;
  made.cameras = {camera_from_above(radius_mm / 1000, {0, 0, 0.1f})};
  return made;
}

/// Radiance over exitance / pi for the cosine of the angle of exit.
double exit_factor(const ShapeLaws& laws, std::size_t c, double cosine) {
  return laws.exit_grazing[c] + (laws.exit_normal[c] - laws.exit_grazing[c]) * cosine * cosine;
}

/// What the laws say of a sphere at a pixel; its thickness is that of rays into a cone: 2 R cos^2, 1.5 R on
/// average.
double wanted(const ScatterProfile& profile, std::size_t c, double radius_mm, double cosine) {
  return profile::curved_total(*profile.shape, c, 1 / radius_mm, 0) *
         profile::slab_front(*profile.shape, c, 1.5 * radius_mm) * exit_factor(*profile.shape, c, cosine);
}

/// Calls body(cosine of the angle of exit, pixel) well inside the disc of the sphere.
template <class Body>
void for_each_on_ball(const Picture& picture, const Body& body) {
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const double u = (x + 0.5) / picture.width * 2 - 1, v = (y + 0.5) / picture.height * 2 - 1;
      if (u * u + v * v > 0.9) continue;
      body(std::sqrt(1 - u * u - v * v), static_cast<std::size_t>(4 * (y * picture.width + x)));
    }
}

TEST(ShapeAware, ASphereShowsItsLaws) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  for (const double radius_mm : {6.0, 15.0}) {
    const Scene scene = wrap(ball(radius_mm));
    const Picture off = renderer().render(scene, settings(false)),
                  on = renderer().render(scene, settings(true));
    EXPECT_FALSE(off.statistics.shape_aware);
    EXPECT_TRUE(on.statistics.shape_aware);
    for_each_on_ball(on, [&](double cosine, std::size_t i) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(off.linear_rgba[i + c], 1, 0.005);
        EXPECT_NEAR(on.linear_rgba[i + c], wanted(profile, c, radius_mm, cosine), 0.015)
            << radius_mm << " mm, " << c << ", cosine " << cosine;
      }
    });
  }
}

// A flat sheet that ends nowhere near is a half-space: its light changes with the angle of exit alone.
TEST(ShapeAware, FlatSkinKeepsItsTotal) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  for (const double angle_deg : {0.0, 60.0}) {
    scene::AssetData made = scene::plane(0.2, glm::dmat2(1), {}, 8);
    made.materials.front().skin_settings.mix = 0;
    made.cameras = {camera_from_aside(0.004, angle_deg)};
    const Scene scene = wrap(std::move(made));
    const auto off = mean_colour(renderer().render(scene, settings(false, 16))),
               on = mean_colour(renderer().render(scene, settings(true, 16)));
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(on[c] / off[c], exit_factor(*profile.shape, c, std::cos(angle_deg * pi / 180)), 0.005)
          << angle_deg << ", " << c;
  }
}

// A place at the end of a small sheet reads no light from beyond it.
TEST(ShapeAware, SkinThatEndsStaysLit) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  constexpr double angle_deg = 60;
  scene::AssetData made = scene::plane(0.006, glm::dmat2(1), {}, 8);
  made.materials.front().skin_settings.mix = 0;
  made.cameras = {camera_from_aside(0.0035, angle_deg)};
  const Scene scene = wrap(std::move(made));
  for (const int map_side : {64, 1024}) {
    const Picture off = renderer().render(scene, settings(false, 64, map_side)),
                  on = renderer().render(scene, settings(true, 64, map_side));
    EXPECT_EQ(on.statistics.unshaded_reads, 0u);
    int seen = 0;
    for (std::size_t i = 0; i < on.linear_rgba.size(); i += 4) {
      if (off.linear_rgba[i] < 0.9f) continue;
      ++seen;
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(on.linear_rgba[i + c] / off.linear_rgba[i + c],
                    exit_factor(*profile.shape, c, std::cos(angle_deg * pi / 180)), 0.01)
            << map_side << " texels, pixel " << i / 4;
    }
    EXPECT_GT(seen, 500);
  }
}

// Under light from the side the radiance of a sphere is that of a place further from the eye: the picture
// without laws, read there. Narrow terms that are lit at the pixel leave where they have entered.
TEST(ShapeAware, LightComesFromFurtherFromTheEye) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  const std::array<double, 3>& rgb_mm = profile.shape->exit_offset_mm;
  const double offset_mm = (rgb_mm[0] + rgb_mm[1] + rgb_mm[2]) / 3;
  constexpr double radius_mm = 10;
  scene::AssetData made = ball(radius_mm);
  made.lights = {directional_light({-1, 0, 0}, glm::vec3(static_cast<float>(pi)))};
  const Scene scene = wrap(std::move(made));
  RenderSettings s = settings(false, 96, 1024);
  s.lighting.rig_lights.reset();
  s.lighting.ambient = 0;
  s.skin.translucency = false;
  const Picture off = renderer().render(scene, s);
  s.skin.shape_aware = true;
  const Picture on = renderer().render(scene, s);

  double moved = 0;
  for_each_on_ball(on, [&](double cosine, std::size_t i) {
    const auto x = static_cast<int>(i / 4 % static_cast<std::size_t>(on.width));
    const auto y = static_cast<int>(i / 4 / static_cast<std::size_t>(on.width));
    const double u = (x + 0.5) / on.width * 2 - 1;
    if (u < 0.2 || y != on.height / 2) return;
    // On the great circle through the light, the angle from the eye grows by the way over the surface.
    const double angle = std::asin(u) + offset_mm / radius_mm * std::sin(std::asin(u));
    const double at = (std::sin(angle) + 1) / 2 * on.width - 0.5;
    const auto left = static_cast<std::size_t>(at);
    const std::size_t row = i - 4 * static_cast<std::size_t>(x);
    for (std::size_t c = 0; c < 3; ++c) {
      const double there = std::lerp(double{off.linear_rgba[row + 4 * left + c]},
                                     double{off.linear_rgba[row + 4 * left + 4 + c]}, at - std::floor(at));
      EXPECT_NEAR(on.linear_rgba[i + c], wanted(profile, c, radius_mm, cosine) * there, 0.02)
          << u << " " << c;
      moved = std::max(moved, std::abs(there - double{off.linear_rgba[i + c]}));
    }
  });
  EXPECT_GT(moved, 0.03) << "what the law is for is there";
}

// Over a head no place returns more than the light that enters, and on average it is that of a half-space.
TEST(ShapeAware, AHeadReturnsNoMoreThanEnters) {
  const Scene head = Scene::built_in();
  RenderSettings s = settings(false, 96, 512);
  const Picture off = renderer().render(head, s);
  s.skin.shape_aware = true;
  const Picture on = renderer().render(head, s);
  for (std::size_t c = 0; c < 3; ++c) {
    double before = 0, after = 0, most = 0;
    for (std::size_t i = c; i < on.linear_rgba.size(); i += 4) {
      if (off.linear_rgba[i] < 0.2f) continue;
      before += off.linear_rgba[i];
      after += on.linear_rgba[i];
      most = std::max(most, double{on.linear_rgba[i]} / double{off.linear_rgba[i]});
    }
    EXPECT_NEAR(after / before, 1, 0.1) << c;
    EXPECT_LE(most * skin2().total_reflectance[c], 1) << c;
  }
}

TEST(ShapeAware, TwoRunsAreEqualToTheBit) {
  const Scene scene = wrap(ball(8));
  expect_equal_bits(renderer().render(scene, settings(true)), renderer().render(scene, settings(true)));
}

// A head that is far away is lit at the pixel: its light is multiplied as well.
TEST(ShapeAware, HoldsFarAway) {
  const Scene scene = wrap(ball(12));
  RenderSettings s = settings(true, 64, 512);
  s.camera.distance = 25;
  RenderSettings whole = unoptimised(s);
  EXPECT_GE(image::psnr_db(shown(renderer().render(scene, whole)), shown(renderer().render(scene, s))), 40);
}

// An instance of another size has its own curvature: twice as large, half as curved.
TEST(ShapeAware, FollowsTheSizeOfAnInstance) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  scene::AssetData made = ball(5);
  made.cameras = {camera_from_above(0.010, {0, 0, 0.1f})};
  Scene scene;
  scene.add({.asset = Asset::State::make(scene::measured(made)),
             .world_from_asset = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1}});
  const Picture picture = renderer().render(scene, settings(true));
  const std::size_t middle =
      4 * static_cast<std::size_t>(picture.width * (picture.height / 2) + picture.width / 2);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(picture.linear_rgba[middle + c], wanted(profile, c, 10, 1), 0.015) << c;
}

// Published sets know no medium: nothing changes to the bit, and asking for it is refused.
TEST(ShapeAware, PublishedProfilesHaveNone) {
  const Scene scene = wrap(ball(8));
  RenderSettings published = settings(false);
  published.skin.profile = "skin";
  const Picture off = renderer().render(scene, published);
  published.skin.shape_aware.reset();
  expect_equal_bits(off, renderer().render(scene, published));
  EXPECT_FALSE(off.statistics.shape_aware);

  published.skin.shape_aware = true;
  EXPECT_NE(thrown<InputError>([&] {
              renderer().render(scene, published);
            }).find("skin.shape_aware: profile 'skin' does not say what medium it is of"),
            std::string::npos);
  published.technique = "lambert";  // does not scatter
  EXPECT_FALSE(renderer().render(scene, published).statistics.shape_aware);

  RenderSettings by_itself = settings(true);
  by_itself.skin.shape_aware.reset();
  EXPECT_TRUE(renderer().render(scene, by_itself).statistics.shape_aware);
}

// A sphere whose morph target makes it larger: curvature is found again, on the device.
TEST(ShapeAware, FollowsAPose) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  scene::AssetData made = ball(5);
  made.cameras = {camera_from_above(0.010, {0, 0, 0.1f})};

  // The camera stands at a node of its own.
  auto rig = std::make_shared<scene::Rig>(*morphing(made, [](const glm::vec3& p) { return 2.0f * p; }));
  rig->camera_nodes = {static_cast<int>(rig->nodes.size())};
  rig->order.push_back(rig->camera_nodes.front());
  rig->nodes.emplace_back();
  rig->rest.push_back({.transform = {.translation = {0, 0, 0.1}}, .weights = {}});
  rig->first_weight.push_back(rig->first_weight.back());
  made.rig = rig;

  Scene scene;
  const InstanceId id = scene.add({.asset = Asset::State::make(scene::measured(made))});
  scene.set_pose(id, RigPose{.weights = {{.name = "0", .weight = 1}}});
  const Picture picture = renderer().render(scene, settings(true));

  const std::size_t middle =
      4 * static_cast<std::size_t>(picture.width * (picture.height / 2) + picture.width / 2);
  for (std::size_t c = 0; c < 3; ++c) {
    // Its thickness stays that of the asset.
    const double front =
        profile::slab_front(*profile.shape, c, 1.5 * 5) / profile::slab_front(*profile.shape, c, 1.5 * 10);
    EXPECT_NEAR(picture.linear_rgba[middle + c], front * wanted(profile, c, 10, 1), 0.02) << c;
  }
}

// A slab that is lit from behind lets through what the medium says, where its Gaussians say less.
TEST(ShapeAware, SlabsLetThroughWhatTheirMediumDoes) {
  const ScatterProfile profile = gaussians::checked_profile(skin2());
  const optics::RgbMedium medium = optics::rgb_medium(*profile.medium);
  for (const double thickness_mm : {2.0, 4.0}) {
    scene::AssetData made = two_planes(0.06, 12, [&](scene::Vertex& v) {
      v.position_m = {-v.position_m.x, v.position_m.y, -static_cast<float>(thickness_mm / 1000)};
      v.normal = {-v.normal.x, v.normal.y, -v.normal.z};
      v.tangent = {-v.tangent.x, v.tangent.y, -v.tangent.z, v.tangent.w};
    });
    made.cameras = {camera_from_above(0.001, {0, 0, 0.1f})};
    made.lights = {directional_light({0, 0, 1}, glm::vec3(static_cast<float>(pi)))};
    const Scene scene = wrap(std::move(made));
    RenderSettings s = settings(true, 8, 512);
    s.lighting.rig_lights.reset();
    s.lighting.ambient = 0;
    const auto seen = mean_colour(renderer().render(scene, s));
    for (std::size_t c = 0; c < 3; ++c) {
      const double back = profile::slab_backs(medium[c], std::span(&thickness_mm, 1)).front() *
                          exit_factor(*profile.shape, c, 1);
      double gaussians = 0;
      for (const Gaussian& term : profile.terms)
        gaussians += term.weight[c] * std::exp(-thickness_mm * thickness_mm / (2 * term.variance_mm2));
      if (gaussians < 0.01) continue;  // held back by the most that a gain may be
      EXPECT_NEAR(seen[c], back, 0.05 * back) << thickness_mm << " mm, " << c;
    }
  }
}

}  // namespace
}  // namespace dermis::tests
