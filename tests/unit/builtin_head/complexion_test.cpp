// SPDX-License-Identifier: MIT
// The skins: their pigments are those of measured groups, and cheek, forehead and lips have those
// colours.
#include "head/builtin_head/complexion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include "base/core/cache.h"
#include "head/builtin_head/kept.h"
#include "head/builtin_head/maps.h"
#include "head/builtin_head/parts.h"
#include "head/builtin_head/skin.h"
#include "image/colour.h"
#include "support/built_in.h"
#include "support/sanitized.h"
#include "tissue/optics/skin_colour.h"

namespace dermis::builtin_head {
namespace {

using optics::Lab;

// Of whom: complexion.cpp. Cheek and forehead are one where the arm stands for both.
struct Measured {
  const char* name;
  Tone tone;
  Lab skin, cheek, forehead, lips;
};
constexpr Measured groups[] = {
    {"light", Tone::light, {59.4, 11.7, 14.85}, {59.6, 11.8, 14.6}, {59.2, 11.6, 15.1}, {49.4, 22.0, 12.3}},
    {"medium",
     Tone::medium,
     {50.42, 12.69, 19.58},
     {50.42, 12.69, 19.58},
     {50.42, 12.69, 19.58},
     {37.7, 17.2, 14.7}},
    {"dark",
     Tone::dark,
     {38.14, 12.66, 15.04},
     {38.14, 12.66, 15.04},
     {38.14, 12.66, 15.04},
     {37.7, 17.2, 14.7}}};

// One skin in each class, and the bounds of its typology angle in degrees.
struct OfClass {
  Tone tone;
  Lab skin;
  double over_deg, to_deg;
};
constexpr OfClass classes[] = {
    {Tone::ita_very_light, {68.5, 5.6, 11.1}, 55, 90},   {Tone::ita_light, {65.0, 7.1, 13.3}, 41, 55},
    {Tone::ita_intermediate, {62.1, 8.4, 16.3}, 28, 41}, {Tone::ita_tan, {56.4, 11.7, 16.3}, 10, 28},
    {Tone::ita_brown, {43.71, 12.89, 17.15}, -30, 10},   {Tone::ita_dark, {38.14, 12.66, 15.04}, -90, -30}};

double typology_angle_deg(const Lab& lab) { return std::atan2(lab.l - 50, lab.b) * 180 / std::numbers::pi; }

void expect_pigments(const optics::Pigments& found, const Lab& measured) {
  SpectralSkin fixed = optics::measured_skin();
  fixed.oxygenation = found.oxygenation;
  const SpectralSkin nearest = optics::nearest_skin(measured, fixed).skin;
  EXPECT_NEAR(found.melanin / nearest.melanin, 1, 0.02);
  EXPECT_NEAR(found.haemoglobin / nearest.haemoglobin, 1, 0.02);
}

TEST(Complexion, IsTheNearestSkinOfAMeasuredGroup) {
  for (const Measured& group : std::span(groups).first(tests::turns(std::size(groups), std::size_t{1}))) {
    SCOPED_TRACE(group.name);
    expect_pigments(complexion(group.tone).skin, group.skin);
    expect_pigments(complexion(group.tone).lips, group.lips);
  }
}

TEST(Complexion, EachClassOfTypologyAnglesHasASkin) {
  for (const OfClass& one : std::span(classes).first(tests::turns(std::size(classes), std::size_t{1}))) {
    SCOPED_TRACE(tone_names[static_cast<std::size_t>(one.tone)]);
    expect_pigments(complexion(one.tone).skin, one.skin);

    SpectralSkin skin = optics::measured_skin();
    skin.melanin = complexion(one.tone).skin.melanin;
    skin.haemoglobin = complexion(one.tone).skin.haemoglobin;
    skin.oxygenation = complexion(one.tone).skin.oxygenation;
    const double angle_deg = typology_angle_deg(optics::lab_from_linear(optics::skin_colour(skin)));
    std::printf("%s: %.1f degrees\n", tone_names[static_cast<std::size_t>(one.tone)], angle_deg);
    EXPECT_GT(angle_deg, one.over_deg);
    EXPECT_LE(angle_deg, one.to_deg);
  }
}

struct Mean {
  std::array<double, 3> sum{};
  int count = 0;
  void add(const std::uint8_t* rgb) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += double{image::srgb8_to_linear(rgb[c])};
    ++count;
  }
  // As an instrument sees it, without gloss: less than the albedo by what the surface keeps out.
  Lab lab() const {
    const double enters = optics::entering_part() / count;
    return optics::lab_from_linear({sum[0] * enters, sum[1] * enters, sum[2] * enters});
  }
};

// Faces of a class have its colour on the forehead, not only as pigments.
TEST(Complexion, ForeheadsHaveTheAngleOfTheirClass) {
  constexpr int side = tests::turns(256, 128);
  const Sculpture bust;
  const scene::Primitive& mesh = tests::built_in_head().primitives.front();
  const std::optional<Baked> head = kept(kept_file(cache::default_folder(), Settings{}.tone, 64), 64);
  ASSERT_TRUE(head);

  for (const OfClass& one : std::span(classes).first(tests::turns(std::size(classes), std::size_t{2}))) {
    SCOPED_TRACE(tone_names[static_cast<std::size_t>(one.tone)]);
    const image::Image8 colour = bake(bust, head->net, mesh, side, complexion(one.tone)).colour;
    const Skin skin(bust, complexion(one.tone));
    Mean forehead;
    for (const scene::Vertex& v : mesh.vertices) {
      const vec3 mm = 1000.0f * v.position_m - vec3(0, Sculpture::eyes_over_origin_mm, 0);
      const Region r = skin.region(mm);
      if (r.forehead > 0.9f && r.scalp < 0.02f)
        forehead.add(colour.at(std::min(side - 1, static_cast<int>(side * v.uv0.x)),
                               std::min(side - 1, static_cast<int>(side * v.uv0.y))));
    }
    ASSERT_GT(forehead.count, 20);
    const double angle_deg = typology_angle_deg(forehead.lab());
    std::printf("%s: forehead %.1f degrees\n", tone_names[static_cast<std::size_t>(one.tone)], angle_deg);
    EXPECT_GT(angle_deg, one.over_deg);
    EXPECT_LE(angle_deg, one.to_deg);
  }
}

TEST(Complexion, CheekForeheadAndLipsAreWithin4OfTheMeasuredColours) {
  constexpr int side = tests::turns(512, 128);
  const Sculpture bust;
  const scene::Primitive& mesh = tests::built_in_head().primitives.front();
  // Made with the mesh just now, or by a test before.
  const std::optional<Baked> head = kept(kept_file(cache::default_folder(), Settings{}.tone, 64), 64);
  ASSERT_TRUE(head);

  for (const Measured& group : groups) {
    SCOPED_TRACE(group.name);
    const image::Image8 colour = bake(bust, head->net, mesh, side, complexion(group.tone)).colour;
    const Skin skin(bust, complexion(group.tone));

    Mean cheek, forehead, lips;
    for (const scene::Vertex& v : mesh.vertices) {
      const vec3 mm = 1000.0f * v.position_m - vec3(0, Sculpture::eyes_over_origin_mm, 0);
      const Region r = skin.region(mm);
      const std::uint8_t* const texel = colour.at(std::min(side - 1, static_cast<int>(side * v.uv0.x)),
                                                  std::min(side - 1, static_cast<int>(side * v.uv0.y)));
      if (r.cheek > 0.5f && r.beard < 0.1f) cheek.add(texel);
      if (r.forehead > 0.9f && r.scalp < 0.02f) forehead.add(texel);
      if (r.lips > 0.95f && mm.z > 92) lips.add(texel);
    }
    ASSERT_GT(std::min({cheek.count, forehead.count, lips.count}), 20);

    const auto expect_near = [&](const char* name, const Mean& mean, const Lab& wanted) {
      const Lab found = mean.lab();
      std::printf("%-7s %-9s L*a*b* %.1f %.1f %.1f, measured %.1f %.1f %.1f: %.1f dE (%d vertices)\n",
                  group.name, name, found.l, found.a, found.b, wanted.l, wanted.a, wanted.b,
                  optics::delta_e76(found, wanted), mean.count);
      EXPECT_LT(optics::delta_e76(found, wanted), 4) << name;
    };
    expect_near("cheek", cheek, group.cheek);
    expect_near("forehead", forehead, group.forehead);
    expect_near("lips", lips, group.lips);

    EXPECT_GT(lips.lab().a, cheek.lab().a + 2);
    // Much blood below much melanin is hardly seen.
    if (group.tone == Tone::dark) continue;
    EXPECT_GT(cheek.lab().a, forehead.lab().a) << "by blood";
  }
}

}  // namespace
}  // namespace dermis::builtin_head
