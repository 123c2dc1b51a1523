// SPDX-License-Identifier: MIT
// Pores, furrows and wrinkles: as many, as deep and in the directions that are published; oil, drought and
// wetness where they belong; shortcuts that change nothing.
#include "head/builtin_head/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "head/builtin_head/skin.h"

namespace dermis::builtin_head {
namespace {

constexpr float pi = 3.14159265f;

// The relief of a flat square of one kind of skin, away from the axes of the noise.
struct Plate {
  static constexpr int side = 800;
  static constexpr float step_mm = 0.025f;
  std::vector<Relief> at;

  explicit Plate(const Region& where) {
    ReliefWalk walk;
    const vec3 across = glm::normalize(vec3(0.9f, 0.1f, -0.3f)),
               up = glm::normalize(glm::cross(vec3(0.3f, 0, 1), across));
    Region here = where;
    here.line = where.line.x * across + where.line.y * up;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        at.push_back(walk.at(step_mm * (static_cast<float>(i) * across + static_cast<float>(j) * up), here));
  }
  const Relief& operator()(int i, int j) const {
    return at[static_cast<std::size_t>(j) * side + static_cast<std::size_t>(i)];
  }

  // Local maxima over `least`, each the largest within 0.2 mm.
  double pores_per_cm2(float least) const {
    int count = 0;
    for (int j = 8; j < side - 8; ++j) {
      for (int i = 8; i < side - 8; ++i) {
        const float here = (*this)(i, j).pore;
        bool largest = here > least;
        for (int n = 0; n < 17 * 17 && largest; ++n) {
          const float other = (*this)(i + n % 17 - 8, j + n / 17 - 8).pore;
          largest = n < 17 * 8 + 8 ? other < here : other <= here;
        }
        count += largest;
      }
    }
    const double cm = 0.1 * double{step_mm} * (side - 16);
    return count / (cm * cm);
  }
  // Mean squared difference of the heights of points so many steps apart.
  double difference2(int di, int dj) const {
    double sum = 0;
    for (int j = 0; j + dj < side; ++j)
      for (int i = 0; i + di < side; ++i) {
        const double d = double{(*this)(i + di, j + dj).pore} - double{(*this)(i, j).pore};
        sum += d * d;
      }
    return sum / static_cast<double>((side - di) * (side - dj));
  }
  float deepest_mm() const {
    return -std::min_element(at.begin(), at.end(), [](const Relief& a, const Relief& b) {
              return a.height_mm < b.height_mm;
            })->height_mm;
  }
};

Region nose() {
  Region r;
  r.nose = 1;
  return r;
}

TEST(Relief, PoresOfNoseAndCheekAre100To200PerSquareCentimetreAndTensOfMicrometresDeep) {
  Region cheek;
  cheek.cheek = 1;
  for (const Region& where : {nose(), cheek}) {
    const Plate plate(where);
    const double density = plate.pores_per_cm2(0.25f);
    std::printf("%.0f pores per cm^2, the deepest point %.0f micrometres\n", density,
                1e3 * double{plate.deepest_mm()});
    EXPECT_GT(density, 100);
    EXPECT_LT(density, 200);
    EXPECT_GT(plate.deepest_mm(), 0.05f);
    EXPECT_LT(plate.deepest_mm(), 0.15f);
  }
  Region lips = nose();
  lips.lips = 1;
  EXPECT_EQ(Plate(lips).pores_per_cm2(0.01f), 0);
}

TEST(Relief, PoresAreDrawnOutAlongTheTensionLines) {
  Region across = nose(), up = nose();
  across.line = {1, 0, 0};
  up.line = {0, 1, 0};
  const Plate a(across), b(up), even(nose());
  EXPECT_GT(a.difference2(0, 6), 1.2 * a.difference2(6, 0));
  EXPECT_GT(b.difference2(6, 0), 1.2 * b.difference2(0, 6));
  EXPECT_NEAR(even.difference2(6, 0) / even.difference2(0, 6), 1, 0.1);
}

TEST(Relief, TensionLinesCrossForeheadAndNeckAndSlantOverTheCheek) {
  const Sculpture bust;
  const Skin skin(bust, complexion(Tone::medium));
  // Angle of the line against the horizontal, degrees, 0 to 180; up and to the left is over 0 on the left
  // side.
  const auto angle = [&](const vec3& at) {
    const vec3 line = skin.region(at).line;
    EXPECT_GT(glm::length(line), 0.5f);
    const float side = at.x < 0 ? -1.0f : 1.0f;
    const float degrees = std::atan2(line.y, side * (line.x - side * line.z)) * 180 / pi;
    return std::fmod(degrees + 360.0f, 180.0f);
  };
  for (const float side : {1.0f, -1.0f}) {
    SCOPED_TRACE(side);
    EXPECT_LT(std::abs(angle({side * 15, 45, 90}) - 90), 95.0f);
    EXPECT_GT(std::abs(angle({side * 15, 45, 90}) - 90), 75.0f) << "forehead";
    EXPECT_GT(std::abs(angle({side * 20, -150, 15}) - 90), 75.0f) << "neck";
    EXPECT_NEAR(angle({side * 42, -35, 76}), 125, 20) << "cheek, down and outwards";
    EXPECT_NEAR(angle({side * 2, -60, 100}), 90, 25) << "upper lip";
  }
}

TEST(Relief, WrinklesLieWhereSkinFolds) {
  const Sculpture bust;
  const Skin skin(bust, complexion(Tone::medium));
  // Standard deviation of the height over a stretch of skin, of what a region adds to the rest.
  const auto adds = [&](const vec3& centre, const vec3& along, float Region::*member) {
    ReliefWalk with, without;
    double sum = 0, sum2 = 0;
    constexpr int n = 400;
    for (int k = 0; k < n; ++k) {
      const vec3 p = centre + (static_cast<float>(k) / n - 0.5f) * along;
      Region r = skin.region(p), bare = r;
      bare.*member = 0;
      const double d = double{with.at(p, r).height_mm} - double{without.at(p, bare).height_mm};
      sum += d;
      sum2 += d * d;
    }
    return std::sqrt(sum2 / n - sum * sum / n / n);
  };
  EXPECT_GT(adds({5, 48, 92}, {0, 30, 0}, &Region::forehead), 0.005);
  EXPECT_GT(adds({57, -3, 58}, {0, 16, 0}, &Region::crow), 0.005);
  EXPECT_GT(adds({10, -145, 20}, {0, 50, 0}, &Region::neck), 0.005);
  EXPECT_GT(adds({0, -73, 100}, {24, 0, 0}, &Region::lips), 0.005);
  EXPECT_EQ(adds({40, 60, 60}, {0, 8, 0}, &Region::crow), 0);
}

TEST(Relief, TheNoseIsOilyTheCheekDryTheLipsAreWet) {
  const Sculpture bust;
  const Skin skin(bust, complexion(Tone::medium));
  struct Gloss {
    float specular = 0, roughness = 0;
  };
  const auto mean = [&](vec3 at) {
    Gloss sum;
    SkinWalk walk;
    constexpr int n = 900;
    for (int k = 0; k < n; ++k) {
      const vec3 p = at + 0.15f * vec3(k % 30 - 15, k / 30 - 15, 0);
      const SkinPoint s = skin.paint(p, skin.region(p), walk);
      sum.specular += s.specular / n;
      sum.roughness += s.roughness / n;
    }
    return sum;
  };
  const Gloss tip = mean({0, -36, 116}), cheek = mean({42, -35, 76}), lip = mean({4, -73, 100});
  EXPECT_GT(tip.specular, cheek.specular + 0.1f);
  EXPECT_LT(tip.roughness, cheek.roughness - 0.05f);
  EXPECT_GT(lip.specular, tip.specular);
  EXPECT_LT(lip.roughness, tip.roughness);
}

TEST(Relief, AWalkGivesTheBitsOfEachPointAlone) {
  NoiseWalk noise(7);
  CellWalk cell(8);
  for (int k = 0; k < 3000; ++k) {
    // Back and forth over borders of cells.
    const vec3 p = 0.37f * vec3(std::sin(0.1f * static_cast<float>(k)) * 9, 0.01f * static_cast<float>(k),
                                static_cast<float>(k % 7) - 3);
    ASSERT_EQ(noise(p), gradient_noise(p, 7));
    const Cell a = cell(p), b = cells(p, 8);
    ASSERT_EQ(a.id, b.id);
    ASSERT_EQ(a.nearest, b.nearest);
    ASSERT_EQ(a.second, b.second);
    ASSERT_LE(a.nearest, a.second);
  }
}

TEST(Relief, TintsAreThoseOfTheSpectralTable) {
  const optics::Pigments mean = complexion(Tone::medium).skin;
  const Tints tints(mean);
  double worst = 0;
  for (int k = 0; k < 2000; ++k) {
    const float melanin = -0.65f + 0.00131f * static_cast<float>(k),
                blood = -1.1f + 2.0f * unit(lattice_hash(k, 1, 2, 3)),
                less = 0.5f * unit(lattice_hash(k, 4, 5, 6));
    const vec3 got = tints.at(melanin, blood, less);
    const std::array<float, 3> wanted =
        skin_table().at({.melanin = mean.melanin * std::exp(double{melanin}),
                         .haemoglobin = mean.haemoglobin * std::exp(double{blood}),
                         .oxygenation = mean.oxygenation - double{less}});
    for (int c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(double{got[c]} / double{wanted[static_cast<std::size_t>(c)]} - 1));
  }
  EXPECT_LT(worst, 0.004) << "half a step of 8 bits, sRGB";
}

}  // namespace
}  // namespace dermis::builtin_head
