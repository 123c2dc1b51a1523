// SPDX-License-Identifier: MIT
// Lips and neck from landmarks, and parts by their names.
#include "truth/regions/face_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dermis::regions {
namespace {

// A head whose lips are an ellipse of 50 x 20 mm in the plane z = 100 mm, and whose jaw line is a half circle
// of 70 mm about the y axis, from the height 40 mm at its ends down to -40 mm at the chin.
FacePlaces face() {
  std::vector<glm::dvec3> p(68, glm::dvec3(0, 0.04, 0.1));
  for (std::size_t i = 0; i <= 16; ++i) {
    const double a = std::numbers::pi * (static_cast<double>(i) / 16 - 0.5);
    p[i] = {0.07 * std::sin(a), 0.04 - 0.08 * std::cos(a), 0.07 * std::cos(a)};
  }
  const auto on_lips = [&](std::size_t first, std::size_t count, double across, double up) {
    for (std::size_t k = 0; k < count; ++k) {
      const double a = std::numbers::pi * (1 - 2 * static_cast<double>(k) / static_cast<double>(count));
      p[first + k] = {across * std::cos(a), up * std::sin(a), 0.1};
    }
  };
  on_lips(48, 12, 0.025, 0.01);
  on_lips(60, 8, 0.02, 0.001);
  return FacePlaces(p);
}

TEST(FaceParts, LipsAreWhatTheirOutlineHolds) {
  const FacePlaces f = face();
  EXPECT_GT(f.at({0, 0.005, 0.1}).lips, 0);
  EXPECT_GT(f.at({0, 0.005, 0.1}).above_parting, 0);
  EXPECT_GT(f.at({0.01, -0.005, 0.1}).lips, 0);
  EXPECT_LT(f.at({0.01, -0.005, 0.1}).above_parting, 0);
  EXPECT_LT(f.at({0, 0.012, 0.1}).lips, 0);
  EXPECT_LT(f.at({0.03, 0, 0.1}).lips, 0);
  EXPECT_NEAR(f.at({0, 0.008, 0.1}).lips, 0.002, 0.0003) << "the distance to the outline, metres";
  EXPECT_GT(f.at({0.02, 0.003, 0.1}).left, 0) << "+X is the person's left";
}

TEST(FaceParts, BehindTheLipsTheMouthBegins) {
  const FacePlaces f = face();
  const FacePlace deep = f.at({0, 0.004, 0.085}), near = f.at({0, 0.004, 0.097});
  EXPECT_LT(deep.lips, 0);
  EXPECT_GT(deep.behind_lips, 0);
  EXPECT_GT(near.lips, 0);
  EXPECT_LT(near.behind_lips, 0);
  EXPECT_LT(f.at({0.06, 0, 0.03}).behind_lips, 0) << "a cheek";
}

TEST(FaceParts, TheNeckIsBelowTheJawLine) {
  const FacePlaces f = face();
  EXPECT_LT(f.at({0, -0.035, 0.07}).below_jaw, 0) << "a chin";
  EXPECT_GT(f.at({0, -0.045, 0.05}).below_jaw, 0) << "under it";
  EXPECT_LT(f.at({0.068, 0.035, 0.012}).below_jaw, 0) << "a cheek";
  EXPECT_GT(f.at({0.06, -0.02, 0.01}).below_jaw, 0) << "below the ear";
  EXPECT_GT(f.at({0.01, -0.02, -0.09}).below_jaw, 0) << "a nape";
  EXPECT_LT(f.at({0.01, 0.08, -0.09}).below_jaw, 0) << "the back of the head";
}

TEST(FaceParts, NamesSayWhatAPartIs) {
  EXPECT_EQ(named_part("Eyes_left"), NamedPart::eye);
  EXPECT_EQ(named_part("eyelashes"), NamedPart::lashes);
  EXPECT_EQ(named_part("Eyebrow.001"), NamedPart::brow);
  EXPECT_EQ(named_part("gums and tongue"), NamedPart::mouth);
  EXPECT_EQ(named_part("tears"), NamedPart::eye);
  EXPECT_EQ(named_part("hair"), NamedPart::hair);
  EXPECT_EQ(named_part("collar"), NamedPart::none);
  EXPECT_EQ(named_part(""), NamedPart::none);
}

}  // namespace
}  // namespace dermis::regions
