// SPDX-License-Identifier: MIT
// Tone maps: the default against measured skin, the published ones against their specifications, all of them
// for values that are no colours.
//
// Colours above 1 are compared as they are: CIELAB of the linear colour, not clamped to what a display can
// show. Its hue is that of the skin at any exposure.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/core/error.h"
#include "base/settings/names.h"
#include "image/colour.h"
#include "image/tone_map.h"
#include "unit/optics/measured_skin.h"

namespace dermis::image {
namespace {

constexpr ToneMap all[] = {ToneMap::natural, ToneMap::neutral, ToneMap::agx,
                           ToneMap::filmic,  ToneMap::srgb,    ToneMap::linear};

Colour colour_of(const optics::Lab& lab, double ev) {
  const optics::Rgb rgb = optics::linear_from_lab(lab);
  Colour out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<float>(rgb[c] * std::exp2(ev));
  return out;
}

float greatest(const Colour& c) { return std::max({c[0], c[1], c[2]}); }

struct Appearance {
  double hue_deg, chroma;
};

Appearance appearance(const Colour& c) {
  const optics::Lab lab = optics::lab_from_linear({c[0], c[1], c[2]});
  return {std::atan2(lab.b, lab.a) * 180 / std::numbers::pi, std::hypot(lab.a, lab.b)};
}

// How a tone map changes measured skin: the largest turn of hue, the least and greatest factor of chroma.
struct Change {
  double hue_deg = 0, least = 1e9, greatest = 0;
};

Change change_of(ToneMap tone_map, double ev, float brightest = std::numeric_limits<float>::infinity()) {
  Change change;
  for (const MeasuredSkin& skin : measured_skins) {
    const Colour colour = colour_of(skin.lab, ev);
    if (greatest(colour) > brightest) continue;
    const Appearance was = appearance(colour), is = appearance(tone_mapped(tone_map, colour));
    change.hue_deg = std::max(change.hue_deg, std::abs(is.hue_deg - was.hue_deg));
    change.least = std::min(change.least, is.chroma / was.chroma);
    change.greatest = std::max(change.greatest, is.chroma / was.chroma);
  }
  return change;
}

TEST(ToneMap, NaturalKeepsMeasuredSkin) {
  for (const double ev : {-1, 0, 1}) {
    const Change below = change_of(ToneMap::natural, ev, 0.8f);
    EXPECT_LE(below.hue_deg, 1e-3) << ev;
    EXPECT_NEAR(below.least, 1, 1e-6) << ev;
    EXPECT_NEAR(below.greatest, 1, 1e-6) << ev;

    const Change anywhere = change_of(ToneMap::natural, ev);
    EXPECT_LE(anywhere.hue_deg, 2) << ev;
    EXPECT_GE(anywhere.least, 0.9) << ev;
    EXPECT_LE(anywhere.greatest, 1.1) << ev;
  }
}

TEST(ToneMap, NaturalKeepsTheHueOfBrightSkin) {
  double turned_deg = 0;
  for (double ev = 0; ev < 7; ev += 0.05)
    turned_deg = std::max(turned_deg, change_of(ToneMap::natural, ev, 16).hue_deg);
  EXPECT_LE(turned_deg, 5);
  EXPECT_GT(turned_deg, 1) << "nothing bright was looked at";
}

TEST(ToneMap, NaturalRisesAndStaysBelowWhite) {
  EXPECT_LT(greatest(tone_mapped(ToneMap::natural, {16, 16, 16})), 1);
  for (const MeasuredSkin& skin : measured_skins) {
    Colour last{};
    double last_l = -1;
    for (double ev = -8; ev < 10; ev += 0.01) {
      const Colour shown = tone_mapped(ToneMap::natural, colour_of(skin.lab, ev));
      for (std::size_t c = 0; c < 3; ++c) ASSERT_GT(shown[c], last[c]) << skin.name << " " << ev;
      const double l = optics::lab_from_linear({shown[0], shown[1], shown[2]}).l;
      ASSERT_GT(l, last_l);
      ASSERT_LT(greatest(shown), 1);
      last = shown, last_l = l;
    }
  }
}

// What the choice was made from; the figures of docs/techniques.md.
TEST(ToneMap, WhatEachDoesToMeasuredSkin) {
  for (const ToneMap tone_map : all) {
    for (const double ev : {-1, 0, 1}) {
      const Change change = change_of(tone_map, ev);
      std::printf("%-8s %+.0f EV: hue turned by up to %.1f degrees, chroma times %.2f to %.2f\n",
                  std::string(name_of(tone_map)).c_str(), ev, change.hue_deg, change.least, change.greatest);
    }
  }
  EXPECT_GT(change_of(ToneMap::filmic, -1).greatest, 1.5) << "the reason why it is not the default";
}

// The sample implementation of the specification, which writes the same function in another way.
TEST(ToneMap, NeutralIsTheSpecification) {
  const auto published = [](std::array<double, 3> c) {
    const double x = std::min({c[0], c[1], c[2]});
    const double offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    for (double& v : c) v -= offset;

    const double peak = std::max({c[0], c[1], c[2]});
    if (peak < 0.76) return c;

    // Compress the peak, then fade towards white by how much it was compressed.
    const double d = 1 - 0.76, new_peak = 1 - d * d / (peak + d - 0.76);
    const double g = 1 - 1 / (0.15 * (peak - new_peak) + 1);
    for (double& v : c) v = v * new_peak / peak * (1 - g) + new_peak * g;
    return c;
  };

  for (const float r : {0.0f, 0.01f, 0.08f, 0.3f, 0.8f, 0.81f, 1.5f, 16.0f, 3000.0f})
    for (const float g : {0.0f, 0.03f, 0.5f, 0.9f, 4.0f})
      for (const float b : {0.0f, 0.02f, 0.4f, 1.1f, 100.0f}) {
        const Colour found = tone_mapped(ToneMap::neutral, {r, g, b});
        const std::array<double, 3> wanted = published({r, g, b});
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], wanted[c], 2e-6);
      }
}

TEST(ToneMap, AgxHasItsLandmarks) {
  // A grey of 0.18 is the pivot: it shows as 0.18^(1/2.4), the rest of [AgX] being a fit within 0.01.
  const float grey = to_display(ToneMap::agx, {0.18f, 0.18f, 0.18f})[0];
  EXPECT_NEAR(grey, std::pow(0.18, 1 / 2.4), 0.02);
  EXPECT_LE(to_display8(ToneMap::agx, {0, 0, 0})[0], 1);
  EXPECT_GE(to_display8(ToneMap::agx, {16.3f, 16.3f, 16.3f})[0], 253);
  // Grey stays grey, and a bright primary goes to white.
  for (const float v : {0.001f, 0.18f, 1.0f, 9.0f}) {
    const Colour shown = to_display(ToneMap::agx, {v, v, v});
    EXPECT_NEAR(shown[0], shown[1], 1e-3);
    EXPECT_NEAR(shown[2], shown[1], 1e-3);
  }
  EXPECT_GT(to_display(ToneMap::agx, {0, 0, 300})[0], 0.7);
}

TEST(ToneMap, Filmic) {
  const auto filmic = [](float x) { return tone_mapped(ToneMap::filmic, {x, x, x})[1]; };
  EXPECT_NEAR(filmic(1), 2.54 / 3.16, 1e-6);
  EXPECT_NEAR(filmic(0.18f), 0.18 * 0.4818 / (0.18 * 1.0274 + 0.14), 1e-6);
  EXPECT_EQ(filmic(50), 1.0f);
}

TEST(ToneMap, DisplayValues) {
  using Bytes = std::array<std::uint8_t, 3>;
  const Colour half{0.5f, 0.5f, 0.5f};
  EXPECT_EQ(to_display8(ToneMap::linear, half), (Bytes{128, 128, 128}));
  EXPECT_EQ(to_display8(ToneMap::srgb, half), (Bytes{188, 188, 188}));
  EXPECT_EQ(to_display8(ToneMap::natural, half), (Bytes{188, 188, 188}));
  EXPECT_EQ(to_display8(ToneMap::filmic, {1, 0, 1}), (Bytes{232, 0, 232}));  // 0.8038, as sRGB 0.9082
}

TEST(ToneMap, WhatIsNoColourStaysInRange) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr float values[] = {nan, -infinity, -1, 0, 0.3f, 65504, 1e30f, infinity};
  for (const ToneMap tone_map : all)
    for (const float r : values)
      for (const float g : values)
        for (const float b : values) {
          for (const float v : to_display(tone_map, {r, g, b}))
            ASSERT_TRUE(v >= 0 && v <= 1) << name_of(tone_map) << " " << r << " " << g << " " << b;
          const Colour clean{r > 0 ? r : 0, g > 0 ? g : 0, b > 0 ? b : 0};
          ASSERT_EQ(to_display8(tone_map, {r, g, b}), to_display8(tone_map, clean));
        }
  EXPECT_EQ(to_display8(ToneMap::natural, {infinity, infinity, infinity})[2], 255);
}

// No step and no fold along greys and along a dark brown: neither at the shoulder nor at the toe.
TEST(ToneMap, IsContinuousAndRises) {
  for (const ToneMap tone_map : all)
    for (const Colour& direction : {Colour{1, 1, 1}, Colour{1, 0.35f, 0.2f}}) {
      Colour last = to_display(tone_map, {0, 0, 0});
      for (double ev = -14; ev < 6; ev += 0.001) {
        const auto light = static_cast<float>(std::exp2(ev));
        Colour colour = direction;
        for (float& v : colour) v *= light;
        const Colour shown = to_display(tone_map, colour);
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_GE(shown[c], last[c] - 1e-5f) << name_of(tone_map) << " " << ev << " " << c;
          ASSERT_LE(std::abs(shown[c] - last[c]), 2e-3f) << name_of(tone_map) << " " << ev << " " << c;
        }
        last = shown;
      }
    }
}

TEST(ToneMap, Names) {
  for (const ToneMap tone_map : all) EXPECT_EQ(find_name<ToneMap>("tone map", name_of(tone_map)), tone_map);
  try {
    find_name<ToneMap>("tone map", "sepia");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("natural, neutral, agx, filmic, srgb, linear"),
              std::string::npos)
        << error.what();
  }
}

TEST(ToneMap, Pictures) {
  const ImageF rgba{.width = 2, .height = 1, .channels = 4, .values = {1, 0.5f, 0, 0.5f, 9, -1, 0.5f, 2}};
  EXPECT_EQ(to_display(rgba, ToneMap::srgb).rgba,
            (std::vector<std::uint8_t>{255, 188, 0, 128, 255, 0, 188, 255}));
  const ImageF grey{.width = 1, .height = 2, .channels = 1, .values = {0.5f, 1}};
  EXPECT_EQ(to_display(grey, ToneMap::linear).rgba,
            (std::vector<std::uint8_t>{128, 128, 128, 255, 255, 255, 255, 255}));
}

}  // namespace
}  // namespace dermis::image
