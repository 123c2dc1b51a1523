// SPDX-License-Identifier: MIT
// How transmitted light is shared out over the chain of convolutions: whatever the groups, each term counts
// by its weight.
#include <gtest/gtest.h>

#include "render/passes/light_map/transmission.h"
#include "tissue/gaussians/known.h"

namespace dermis::passes {
namespace {

using Firsts = std::vector<std::size_t>;

TEST(TransmissionShares, GroupsTakeTheNarrowTermsTogether) {
  EXPECT_EQ(transmission_groups(0), Firsts{});
  EXPECT_EQ(transmission_groups(1), Firsts{0});
  EXPECT_EQ(transmission_groups(2), (Firsts{0, 1}));
  EXPECT_EQ(transmission_groups(4), (Firsts{0, 2, 3}));
  EXPECT_EQ(transmission_groups(6), (Firsts{0, 2, 4}));
  EXPECT_EQ(transmission_groups(8), (Firsts{0, 3, 6}));
}

// Terms that are lit at the pixel are a group of their own, so that no mean holds a part of each.
TEST(TransmissionShares, TermsAtThePixelAreNotMixedWithThoseOnMaps) {
  EXPECT_EQ(transmission_groups(6, 4), (Firsts{0, 4}));
  EXPECT_EQ(transmission_groups(6, 3), (Firsts{0, 3, 5}));
  EXPECT_EQ(transmission_groups(8, 2), (Firsts{0, 2, 5}));
  EXPECT_EQ(mapped_groups(6, 4), (Firsts{0}));
  EXPECT_EQ(mapped_groups(8, 2), (Firsts{0, 3}));
  EXPECT_EQ(mapped_groups(6, 0), (Firsts{0, 2, 4}));

  // Maps and pixels share the light of each term out alike.
  const ScatterProfile profile = gaussians::skin_six();
  const io::TransmissionIo all = transmission_io(profile, 1000, 3),
                           maps = mapped_transmission_io(profile, 1000, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(all.group[3 + i], maps.group[i] + 1);
    EXPECT_EQ(all.falloff_per_m2[3 + i], maps.falloff_per_m2[i]);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(all.group_weight[1][c], maps.group_weight[0][c]);
    EXPECT_EQ(all.gain[5][c], maps.gain[5][c]);
  }
}

// The final sum weighs what term i has gathered: everything that joined at groups that begin at or before it.
void expect_exact(const ScatterProfile& profile) {
  const io::TransmissionIo io = transmission_io(profile, 1000);
  const Firsts first = transmission_groups(profile.terms.size());
  for (std::size_t j = 0; j < profile.terms.size(); ++j)
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (std::size_t i = 0; i < profile.terms.size(); ++i)
        for (std::size_t g = 0; g < first.size(); ++g)
          if (first[g] <= i)
            sum += profile.terms[i].weight[static_cast<std::size_t>(c)] *
                   double{io.share[g * MOST_TERMS + j][c]};
      EXPECT_NEAR(sum, profile.terms[j].weight[static_cast<std::size_t>(c)], 1e-6)
          << "term " << j << ", channel " << c;
    }
}

// Blue has no weight in the third, the fifth and the sixth term of skin.
TEST(TransmissionShares, EachTermCountsByItsWeight) {
  expect_exact(gaussians::skin_six());
  for (std::size_t terms = 1; terms <= 8; ++terms) {
    ScatterProfile made;
    for (std::size_t i = 0; i < terms; ++i) {
      const double x = static_cast<double>(i);
      made.terms.push_back({.variance_mm2 = 0.01 * (1 + x * x),
                            .weight = {0.1 + 0.02 * x, i % 2 ? 0.3 : 0.0, i + 1 == terms ? 1.0 : 0.0}});
    }
    expect_exact(made);
  }
}

// exp(-d^2 / 2v) grows with v, so what joins is never negative: half floats hold it, and nothing is taken
// away.
TEST(TransmissionShares, NothingIsTakenAway) {
  const ScatterProfile profile = gaussians::skin_six();
  const io::TransmissionIo io = transmission_io(profile, 1000);
  for (const double d_m : {0.0, 0.0002, 0.0005, 0.001, 0.003, 0.01})
    for (std::size_t g = 0; g < TRANSMISSION_GROUPS; ++g)
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < profile.terms.size(); ++i)
          sum +=
              double{io.share[g * MOST_TERMS + i][c]} * std::exp(-d_m * d_m * double{io.falloff_per_m2[i]});
        EXPECT_GE(sum, -1e-6) << d_m;
      }
}

}  // namespace
}  // namespace dermis::passes
