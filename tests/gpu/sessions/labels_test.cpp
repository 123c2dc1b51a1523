// SPDX-License-Identifier: MIT
// Labels say of each pixel what a ray through its middle meets first, as numbers of the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <string>
#include <vector>

#include "api/asset_state.h"
#include "dermis/reference.h"
#include "dermis/session.h"
#include "gpu/sessions/poses.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "rays/alpha_test.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// GPUs keep corners in steps of 1/256 of a pixel and interpolate from there: so much of a chart that some
// fifty pixels span. An NVIDIA H200 is 4.1e-5 off, and 2.1e-5 m deep in a ball.
double most_uv() { return on_software() ? 2e-5 : 1.0 / (256 * 50); }
double most_depth_m() { return on_software() ? 2e-5 : 4e-5; }

/// A camera as a host has it; depth from 0 to 1.
struct Eye {
  glm::dmat4 camera_from_world{1}, clip_from_camera{1};
};

Eye looking(const glm::dvec3& eye_m, const glm::dmat4& clip_from_camera) {
  return {glm::lookAt(eye_m, glm::dvec3(0), glm::dvec3(0, 1, 0)), clip_from_camera};
}

Eye perspective(const glm::dvec3& eye_m) {
  return looking(eye_m, glm::perspectiveRH_ZO(0.5, 1.0, 0.05, 9.0));
}
Eye off_axis() { return looking({0.1, 0.07, 0.4}, glm::frustumRH_ZO(-0.01, 0.03, -0.025, 0.01, 0.1, 9.0)); }
Eye orthographic() { return looking({0.1, 0.07, 0.4}, glm::orthoRH_ZO(-0.2, 0.1, -0.15, 0.12, 0.1, 9.0)); }

RenderSettings seen_by(const Eye& eye, int side = 96) {
  RenderSettings s = small_settings("lambert", side, 64);
  CameraMatrices matrices;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) {
      const auto at = static_cast<std::size_t>(4 * c + r);
      matrices.camera_from_world[at] = eye.camera_from_world[c][r];
      matrices.clip_from_camera[at] = eye.clip_from_camera[c][r];
    }
  s.camera.matrices = matrices;
  s.output.exposure_ev = 0;
  return s;
}

/// The ray through the middle of a pixel, from the near plane, in the world.
rays::Ray ray_of(const Eye& eye, int x, int y, int side) {
  const glm::dmat4 world_from_clip = glm::inverse(eye.clip_from_camera * eye.camera_from_world);
  const glm::dvec2 at(2 * (x + 0.5) / side - 1, 1 - 2 * (y + 0.5) / side);
  const glm::dvec4 from = world_from_clip * glm::dvec4(at, 0, 1), to = world_from_clip * glm::dvec4(at, 1, 1);
  const glm::dvec3 origin_m = glm::dvec3(from) / from.w;
  return {.origin_m = origin_m, .direction = glm::normalize(glm::dvec3(to) / to.w - origin_m)};
}

double depth_of(const Eye& eye, const glm::dvec3& position_m) {
  return -(eye.camera_from_world * glm::dvec4(position_m, 1)).z;
}

Results labels_of(const Scene& scene, const RenderSettings& settings) {
  Session session(renderer(), {.frames_in_flight = 1, .wanted = Outputs::all()});
  return session.results(session.draw(scene, settings));
}

/// Calls visit(pixel, x, y) for each.
void for_each_pixel(const Results& labels, const std::function<void(std::size_t, int, int)>& visit) {
  std::size_t i = 0;
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) visit(i++, x, y);
}

glm::dvec3 normal_at(const Results& l, std::size_t i) {
  return {l.normal[3 * i], l.normal[3 * i + 1], l.normal[3 * i + 2]};
}
glm::dvec2 uv_at(const Results& l, std::size_t i) { return {l.uv[2 * i], l.uv[2 * i + 1]}; }

void expect_nothing(const Results& l, std::size_t i) {
  EXPECT_EQ(l.instance[i], 0u) << i;
  EXPECT_EQ(l.material[i], 0u) << i;
  EXPECT_EQ(l.depth_m[i], infinite) << i;
  EXPECT_EQ(normal_at(l, i), glm::dvec3(0)) << i;
  EXPECT_EQ(uv_at(l, i), glm::dvec2(0)) << i;
  EXPECT_EQ(l.region[i], Results::no_region) << i;
}

void expect_same_but(Outputs but, const Results& wanted, const Results& found) {
  EXPECT_EQ(wanted.width, found.width);
  EXPECT_EQ(wanted.height, found.height);
  for (const OutputRow& row : output_rows())
    if (!but.has(row.output) && Outputs::labels().has(row.output)) {
      EXPECT_TRUE(std::ranges::equal(wanted.bytes(row.output), found.bytes(row.output))) << row.name;
    }
}

void expect_same(const Results& wanted, const Results& found) {
  expect_same_but({Output::motion}, wanted, found);
}

std::size_t count(std::span<const std::uint32_t> labels, std::uint32_t label) {
  return static_cast<std::size_t>(std::count(labels.begin(), labels.end(), label));
}

Asset asset_of(scene::AssetData data) { return Asset::State::make(scene::measured(std::move(data))); }

/// Made once.
const Asset& head() {
  static const Asset made = Asset::built_in();
  return made;
}

// A square of 200 mm, turned, shifted and 1.25 times as large. Its triangles reach far out of the picture,
// which costs a device some ten roundings when it interpolates.
void expect_the_plane(const Eye& eye) {
  constexpr double side_m = 0.2, scale = 1.25, shift_m = 0.01, angle_rad = 0.5;
  std::array<double, 16> pose = turned(angle_rad, shift_m);
  for (std::size_t i = 0; i < 12; ++i) pose[i] *= scale;
  Scene scene;
  scene.add({.asset = asset_of(scene::plane(side_m)), .world_from_asset = pose});
  const Results l = labels_of(scene, seen_by(eye));
  ASSERT_EQ(l.width, 96);
  ASSERT_EQ(l.height, 96);

  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const glm::dvec3 normal(s, 0, c), across(c, 0, -s), origin_m(shift_m, 0, 0);
  std::size_t inside = 0, outside = 0;
  for_each_pixel(l, [&](std::size_t i, int x, int y) {
    const rays::Ray ray = ray_of(eye, x, y, l.width);
    const double t_m = glm::dot(origin_m - ray.origin_m, normal) / glm::dot(ray.direction, normal);
    const glm::dvec3 hit_m = ray.origin_m + t_m * ray.direction;
    const glm::dvec2 at = glm::dvec2(glm::dot(hit_m - origin_m, across), hit_m.y) / (side_m * scale);
    const double in = 0.5 - std::max(std::abs(at.x), std::abs(at.y));
    if (std::abs(in) < 1e-5) return;  // the border runs through the middle of the pixel
    if (in < 0) {
      ++outside;
      return expect_nothing(l, i);
    }
    ++inside;
    ASSERT_EQ(l.instance[i], 1u) << x << ' ' << y;
    EXPECT_EQ(l.material[i], 1u);
    EXPECT_NEAR(l.depth_m[i], depth_of(eye, hit_m), 3e-6);  // 2.3e-6 at 0.7 m on a GPU that interpolates
    EXPECT_LT(glm::distance(normal_at(l, i), normal), 2e-6);
    EXPECT_LT(glm::distance(uv_at(l, i), glm::dvec2(0.5 + at.x, 0.5 - at.y)), most_uv());
    EXPECT_EQ(l.region[i], Results::other_skin) << "a plane has neither nose nor ears";
  });
  EXPECT_GT(inside, 1000u);
  EXPECT_GT(outside, 200u);
}

TEST(Labels, OfAPlaneInClosedForm) { expect_the_plane(perspective({0.1, 0.07, 0.7})); }
TEST(Labels, OfAPlaneOffTheAxis) { expect_the_plane(off_axis()); }
TEST(Labels, OfAPlaneWithoutPerspective) { expect_the_plane(orthographic()); }

TEST(Labels, OfABallInClosedForm) {
  constexpr double radius_m = 0.06;
  const Eye eye = perspective({0.1, 0.07, 0.4});
  Scene scene;
  scene.add({.asset = asset_of(scene::sphere(radius_m, 64))});
  const Results l = labels_of(scene, seen_by(eye));

  std::size_t inside = 0;
  for_each_pixel(l, [&](std::size_t i, int x, int y) {
    const rays::Ray ray = ray_of(eye, x, y, l.width);
    const double along_m = -glm::dot(ray.origin_m, ray.direction);
    const double off_m = glm::length(ray.origin_m + along_m * ray.direction);
    if (off_m > radius_m) return expect_nothing(l, i);
    // Triangles lie up to 5 um inside the ball: where it is seen edge-on, a ray meets it far from them.
    if (off_m > 0.9 * radius_m) return;
    ++inside;
    const glm::dvec3 hit_m =
        ray.origin_m + (along_m - std::sqrt(radius_m * radius_m - off_m * off_m)) * ray.direction;
    EXPECT_NEAR(l.depth_m[i], depth_of(eye, hit_m), most_depth_m());
    EXPECT_LT(glm::distance(normal_at(l, i), hit_m / radius_m), 1e-3);
  });
  EXPECT_GT(inside, 500u);
}

/// What a ray shows: the first surface that is neither culled, blended nor cut out.
std::optional<rays::SurfacePoint> first_seen(const rays::RayScene& rays, rays::Ray ray) {
  while (const auto hit = rays.nearest(ray)) {
    rays::SurfacePoint point = rays::surface_point(rays.scene(), *hit);
    const scene::Material& material = rays.scene().materials[point.material];
    const bool culled = !material.double_sided && glm::dot(point.face_normal, ray.direction) > 0;
    if (!culled && material.alpha_mode != AssetAlpha::blend && !rays::is_cut_away(rays.scene(), point))
      return point;
    ray.t_min_m = std::nextafter(static_cast<float>(hit->t_m), infinite);
  }
  return {};
}

// A head, and two copies of a sheet before it, one mirrored, by rays that share nothing with the renderer.
// Positions that round differ most where the surface is seen edge-on, and middles of pixels that lie within a
// rounding of an edge may show the other side of it.
TEST(Labels, OfAHeadByRays) {
  scene::AssetData data = *Asset::State::of(head());
  add_sheet(data, 0.03f, 0.0f);
  for (scene::Vertex& v : data.primitives.back().vertices) v.uv0 = glm::vec2(v.position_m);
  data.primitives.back().placements = {
      {.world_from_mesh = glm::dmat4x3(1, 0, 0, 0, 1, 0.3, 0, 0, 1, 0.05, 0.01, 0.2)},
      {.world_from_mesh = glm::dmat4x3(-1, 0, 0.5, 0, 1, 0, 0, 0, 1, -0.02, 0.01, 0.2), .mirrored = true}};
  const rays::RayScene rays(data);
  const Eye eye = perspective({0.3, 0.1, 0.6});
  const Results l = labels_of(wrap(data), seen_by(eye, 160));

  std::size_t seen = 0, wrong = 0;
  std::vector<std::size_t> of_material(data.materials.size() + 1);
  for_each_pixel(l, [&](std::size_t i, int x, int y) {
    const auto point = first_seen(rays, ray_of(eye, x, y, l.width));
    seen += point.has_value();
    const std::uint32_t material = point ? static_cast<std::uint32_t>(point->material) + 1 : 0;
    ++of_material[material];
    const bool right =
        l.material[i] == material && l.instance[i] == (point ? 1u : 0u) &&
        (!point || (std::abs(l.depth_m[i] - depth_of(eye, point->position_m)) < most_depth_m() &&
                    glm::distance(normal_at(l, i), point->normal) < 2e-3 &&
                    glm::distance(uv_at(l, i), point->uv[0]) < most_uv()));
    wrong += !right;
  });
  EXPECT_GT(seen, 5000u);
  EXPECT_GT(of_material.back(), 500u) << "of the sheets";
  // Where triangles are a pixel wide, such a step is another triangle.
  EXPECT_LE(wrong, seen / (on_software() ? 1000 : 50)) << "of " << seen;
}

// A hidden ball in front of all, a square, and a ball before its middle.
TEST(Labels, NumbersAreThoseOfTheScene) {
  scene::AssetData square = scene::plane(0.2);
  add_sheet(square, 0.2f, 0.001f);  // over its right half
  Scene scene;
  const InstanceId hidden =
      scene.add({.asset = asset_of(scene::sphere(0.05)), .world_from_asset = moved({-0.05, 0, 0.2})});
  scene.add({.asset = asset_of(square)});
  scene.add({.asset = asset_of(scene::sphere(0.03)), .world_from_asset = moved({0, 0, 0.1})});
  const auto label_at = [](const Results& l, double x, double y) {
    const auto i = static_cast<std::size_t>(y * l.height) * static_cast<std::size_t>(l.width) +
                   static_cast<std::size_t>(x * l.width);
    return std::pair(l.instance[i], l.material[i]);
  };
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  const RenderSettings s = seen_by(perspective({0, 0, 1}));
  const Results all = labels_of(scene, s);
  EXPECT_EQ(label_at(all, 0.4, 0.5), Pair(1, 1)) << "before it is hidden";
  EXPECT_GT(count(all.instance, 1), 300u);

  scene.set_visible(hidden, false);
  const Results l = labels_of(scene, s);
  EXPECT_EQ(count(l.instance, 1), 0u);
  EXPECT_EQ(label_at(l, 0.5, 0.5), Pair(3, 1));
  EXPECT_EQ(label_at(l, 0.35, 0.4), Pair(2, 1));
  EXPECT_EQ(label_at(l, 0.65, 0.4), Pair(2, 2));
  EXPECT_EQ(label_at(l, 0.05, 0.05), Pair(0, 0));
  EXPECT_EQ(scene.instance(scene.instances()[1]).asset.materials()[1], "sheet");
  for_each_pixel(l, [&](std::size_t i, int, int) {
    EXPECT_EQ(l.region[i],
              l.instance[i] > 0 && l.material[i] == 1 ? Results::other_skin : Results::no_region);
  });
}

TEST(Labels, OfARowAreItsHeads) {
  Scene scene;
  scene.add({.asset = asset_of(scene::sphere(0.05))});
  RenderSettings s = small_settings("texture-space", 90, 64);
  s.camera.heads = 3;
  s.output.exposure_ev = 0;
  const Results l = labels_of(scene, s);
  std::vector<std::uint32_t> order;
  for (int x = 0; x < l.width; ++x) {
    const std::uint32_t label = l.instance[static_cast<std::size_t>(45 * l.width + x)];
    if (label > 0 && (order.empty() || order.back() != label)) order.push_back(label);
  }
  EXPECT_EQ(order, (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST(Labels, OfABackOnlyWhereItIsSeen) {
  scene::AssetData square = scene::plane(0.2);
  const Eye behind = perspective({0.1, 0, -0.7});
  EXPECT_EQ(count(labels_of(wrap(square), seen_by(behind)).instance, 1), 0u) << "culled";

  square.materials[0].double_sided = true;
  const Results l = labels_of(wrap(square), seen_by(behind));
  EXPECT_GT(count(l.instance, 1), 1000u);
  for_each_pixel(l, [&](std::size_t i, int, int) {
    if (l.instance[i] > 0) { EXPECT_EQ(normal_at(l, i), glm::dvec3(0, 0, -1)); }
  });
}

/// A map whose alpha rises from left to right, in steps that a filter smooths.
int add_alpha_ramp(scene::AssetData& scene) {
  image::Image8 ramp{.width = 64, .height = 64, .rgba = std::vector<std::uint8_t>(64 * 64 * 4, 200)};
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) ramp.at(x, y)[3] = static_cast<std::uint8_t>((x * 37 + y * 11) % 256);
  scene.images.push_back({.name = "ramp", .pixels = std::make_shared<const image::Image8>(std::move(ramp))});
  return static_cast<int>(scene.images.size()) - 1;
}

// With one sample per pixel, the alpha of a picture is 1 where skin is seen, and else 0.
TEST(Labels, AreCutOutAsThePictureIs) {
  for (const bool skin : {true, false}) {
    SCOPED_TRACE(skin ? "skin" : "surface");
    scene::AssetData made = scene::plane(0.2);
    add_sheet(made, 0.1f, 0.01f);
    for (scene::Vertex& v : made.primitives[1].vertices) v.uv0 = glm::vec2(v.position_m) * 16.0f;
    scene::Material& cut = made.materials[skin ? 0 : 1];
    if (skin) made.primitives.pop_back();
    cut.alpha_mode = AssetAlpha::mask;
    cut.base_colour_map.image = add_alpha_ramp(made);
    const Scene scene = wrap(made);

    RenderSettings s = seen_by(perspective({0.1, 0.07, 0.7}));
    s.quality.samples = 1;
    const Picture picture = renderer().render(scene, s);
    const Results l = labels_of(scene, s);
    std::size_t of_skin = 0, others = 0;
    for_each_pixel(l, [&](std::size_t i, int x, int y) {
      const bool shows_skin = picture.linear_rgba[4 * i + 3] > 0.5f;
      EXPECT_EQ(l.material[i] == 1, shows_skin) << x << ' ' << y;
      of_skin += shows_skin;
      others += l.material[i] != 1 && x > 30 && x < 66 && y > 30 && y < 66;
    });
    EXPECT_GT(of_skin, 500u);
    EXPECT_GT(others, 100u) << "holes, or what is left of the sheet";
  }
}

TEST(Labels, AreOfWhatLiesBehindBlendedParts) {
  scene::AssetData made = scene::plane(0.2);
  const RenderSettings s = seen_by(perspective({0, 0, 0.7}));
  const Results bare = labels_of(wrap(made), s);
  const Picture before = renderer().render(wrap(made), s);
  add_sheet(made, 0.1f, 0.01f);
  made.materials[1].alpha_mode = AssetAlpha::blend;
  made.materials[1].base_colour.a = 0.9f;
  EXPECT_NE(renderer().render(wrap(made), s).display_rgba, before.display_rgba);
  expect_same_but({Output::motion, Output::front, Output::front_part}, bare, labels_of(wrap(made), s));
}

TEST(Labels, DependOnGeometryAlone) {
  Scene scene(head());
  scene.add({.asset = asset_of(scene::sphere(0.06)), .world_from_asset = turned(0.3, 0.16)});
  RenderSettings s = small_settings("texture-space", 80, 128);
  s.camera.eye_m = {0.2, 0.1, 0.7};
  s.camera.target_m = {0, 0, 0};
  s.output.exposure_ev = 0;
  s.quality.samples = 4;
  const Results wanted = labels_of(scene, s);
  EXPECT_GT(count(wanted.instance, 1), 500u);
  EXPECT_GT(count(wanted.instance, 2), 100u);
  expect_same(wanted, labels_of(scene, s));

  for (const std::string& technique : technique_names())
    for (const int samples : {1, 4}) {
      SCOPED_TRACE(technique + " " + std::to_string(samples));
      RenderSettings other = s;
      other.technique = technique;
      other.quality.samples = samples;
      other.output.exposure_ev = 2;
      other.lighting.ambient = 0.5;
      expect_same(wanted, labels_of(scene, other));
    }
}

TEST(Labels, AreOfTheirFrameWithThreeInFlight) {
  Scene scene;
  const InstanceId id = scene.add({.asset = head()});
  RenderSettings s = seen_by(perspective({0.1, 0, 0.8}), 64);
  Session session(renderer(), {.frames_in_flight = 3, .wanted = Outputs::all()});
  std::vector<Ticket> tickets;
  std::vector<Scene> scenes;
  std::vector<Results> found;
  for (std::size_t i = 0; i < 7; ++i) {
    scene.set_transform(id, turned(0.3 * static_cast<double>(i), 0.01));
    scenes.push_back(scene);
    tickets.push_back(session.draw(scene, s));
    if (i >= 2) found.push_back(session.results(tickets[i - 2]));
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    SCOPED_TRACE(i);
    expect_same(labels_of(scenes[i], s), found[i]);
    if (i > 0) { EXPECT_FALSE(std::ranges::equal(found[i].depth_m, found[i - 1].depth_m)); }
  }
  // Nor do they change the picture.
  expect_equal_bits(renderer().render(scenes[6], s), session.picture(tickets[6]));
}

TEST(Labels, AreForThoseWhoAsk) {
  const Scene scene = sphere(0.06);
  const RenderSettings s = seen_by(perspective({0, 0, 0.5}), 16);
  Session without(renderer());
  const Ticket ticket = without.draw(scene, s);
  const Results picture = without.results(ticket);
  EXPECT_EQ(picture.display.size(), std::size_t{4 * 16 * 16});
  for (const OutputRow& row : output_rows())
    EXPECT_NE(picture.bytes(row.output).empty(), Outputs::picture().has(row.output)) << row.name;

  Session session(renderer(), {.frames_in_flight = 1, .wanted = Outputs::all()});
  const Ticket first = session.draw(scene, s);
  session.draw(scene, s);
  EXPECT_EQ(thrown<InputError>([&] { session.results(first); }),
            "ticket 1 is not of the last 1 frames of this session");
}

/// Of the pixels of a region: those that have the label, and those that a label has beside them.
struct Overlap {
  double found = 0, more = 0;
};

Overlap overlap(const Results& l, Results::Region label, const std::vector<PictureRegion>& all,
                const std::string& name) {
  const auto region =
      std::find_if(all.begin(), all.end(), [&](const PictureRegion& r) { return r.name == name; });
  EXPECT_GT(region->pixels, 100u) << name;
  Overlap overlap;
  for (std::size_t i = 0; i < l.region.size(); ++i)
    if (l.region[i] == label) ++(region->mask[i] ? overlap.found : overlap.more);
  const auto pixels = static_cast<double>(region->pixels);
  return {overlap.found / pixels, overlap.more / pixels};
}

// Ears also hold thin skin that a picture sees edge-on or not at all, and what is near that.
void expect_the_regions_of(const Scene& scene) {
  for (const double azimuth_deg : {0.0, 70.0}) {
    SCOPED_TRACE(azimuth_deg);
    RenderSettings s = small_settings("lambert", 200, 64);
    s.camera.orbit_deg = {azimuth_deg, 0};
    s.output.exposure_ev = 0;
    const Results l = labels_of(scene, s);
    const std::vector<PictureRegion> all = picture_regions(scene, s);

    const Overlap nose = overlap(l, Results::nose, all, "nose");
    EXPECT_GT(nose.found, 0.98);
    EXPECT_LT(nose.more, 0.02);
    const Overlap ears = overlap(l, Results::ear, all, "ears");
    EXPECT_GT(ears.found, 0.97);
    EXPECT_LT(ears.more, 0.45);
  }
}

TEST(Labels, HaveTheNoseAndEarsOfPictureRegions) { expect_the_regions_of(Scene(head())); }

using ScanLabels = WithScan;
TEST_F(ScanLabels, HaveTheNoseAndEarsOfPictureRegions) { expect_the_regions_of(scan()); }

// Regions are of the asset: a head that looks away has no nose in picture_regions(), but has one here.
TEST(Labels, RegionsMoveWithTheHead) {
  Scene scene;
  const InstanceId id = scene.add({.asset = head()});
  const RenderSettings front = seen_by(perspective({0, 0, 0.8})), left = seen_by(perspective({0.8, 0, 0}));
  const auto pixels = [&](const RenderSettings& s, Results::Region region) {
    const Results l = labels_of(scene, s);
    return std::count(l.region.begin(), l.region.end(), region);
  };
  const auto nose = pixels(front, Results::nose), ear = pixels(left, Results::ear);
  EXPECT_GT(nose, 50);
  EXPECT_GT(ear, 50);
  scene.set_transform(id, turned(std::acos(-1.0) / 2, 0));
  EXPECT_NEAR(static_cast<double>(pixels(left, Results::nose)), static_cast<double>(nose), 2);
}

}  // namespace
}  // namespace dermis::tests
