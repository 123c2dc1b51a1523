// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/core/error.h"
#include "tissue/optics/presets.h"
#include "tissue/optics/radiative.h"
#include "tissue/profile/burley.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/slab.h"
#include "tissue/profile/thin_slab.h"

namespace dermis {
namespace {

using optics::Layer;
using profile::LayeredProfile;
using profile::Multipole;
using profile::SlabProfile;
using Side = profile::SlabProfile::Side;
constexpr double infinite = std::numeric_limits<double>::infinity();

// Image sums carried to convergence by an independent program.
TEST(Multipole, TotalsOfConvergedImageSums) {
  const profile::Spectra thick = Multipole({0.1, 1, 1.4, 4}, 1, 1).spectra(0);
  EXPECT_NEAR(thick.reflect_above / .296816, 1, 1e-4);
  EXPECT_NEAR(thick.transmit_above / .081897, 1, 1e-4);
  const profile::Spectra clear = Multipole({0.001, 1, 1.4, 2}, 1, 1).spectra(0);
  EXPECT_NEAR(clear.reflect_above / .495706, 1, 1e-4);
  EXPECT_NEAR(clear.transmit_above / .495390, 1, 1e-4);
  EXPECT_NEAR(clear.reflect_above + clear.transmit_above, .991096, 1e-5);
}

TEST(Multipole, ClosedFormAndImagesAgree) {
  for (const Layer& layer : {Layer{0.1, 1, 1.4, 4}, Layer{0.05, 2, 1.3, 1.5}, Layer{0.01, 1, 1.4, 10}}) {
    for (const Side side : {Side::reflected, Side::transmitted}) {
      const SlabProfile slab(layer, side, 1, 1.33);
      for (const double r : {0.2, 1.0, 3.0}) EXPECT_NEAR(inverse_hankel(slab, r) / slab.at(r), 1, 2e-4) << r;
    }
  }
}

TEST(Multipole, ThickSlabIsTheDipole) {
  for (const Layer& medium : {Layer{0.05, 1.2, 1.4}, Layer{0.5, 1, 1.4}, Layer{0.001, 3, 1.3},
                              Layer{2, 8, 1.5}, Layer{0.3, 0.2, 1}}) {
    const double diffuse_mm = medium.medium().diffuse_mean_free_path().mm,
                 mean_mm = medium.medium().mean_free_path().mm;
    const profile::Dipole dipole(medium.medium());

    double before = 1;
    for (const double lengths : {3.0, 6.0, 12.0, 25.0}) {  // thicknesses in diffuse mean free paths
      Layer layer = medium;
      layer.thickness_mm = lengths * diffuse_mm + 2 * mean_mm;
      const SlabProfile slab(layer, Side::reflected);
      const double deviation = std::abs(slab.total() - dipole.total());

      // light goes there and back
      EXPECT_LE(deviation, 2 * std::exp(-2 * lengths)) << medium.sigma_a_per_mm << " " << lengths;
      EXPECT_LE(deviation, before);
      EXPECT_LE(SlabProfile(layer, Side::transmitted).total(), 8 * std::exp(-lengths))
          << medium.sigma_a_per_mm << " " << lengths;
      before = deviation + 1e-12;

      if (lengths < 25) continue;
      for (const double r : {0.1, 1.0, 3.0})
        EXPECT_NEAR(slab.at(r * diffuse_mm) / dipole.at(r * diffuse_mm), 1, 1e-6) << r;
    }
  }
}

// Unequal layers with index steps, thin and thick: light is neither made nor, without absorption, lost.
TEST(Layers, RandomStacksKeepTheLight) {
  std::mt19937 random(3);
  const auto between = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };

  double worst = 0;
  for (int i = 0; i < 300; ++i) {
    // Draw 2 to 5 layers, without and with absorption, equally many mean free paths deep.
    optics::Layers clear, absorbing;
    for (int layer = 0; layer < 2 + i % 4; ++layer) {
      const double sigma_s = std::exp(between(std::log(0.1), std::log(30))),
                   depth = std::exp(between(std::log(0.02), std::log(20)));
      const double eta = between(1, 1.6), sigma_a = sigma_s * std::exp(between(std::log(1e-4), std::log(10)));
      clear.push_back({0, sigma_s, eta, depth / sigma_s});
      absorbing.push_back({sigma_a, sigma_s, eta, depth / (sigma_s + sigma_a)});
    }

    const profile::Spectra kept = LayeredProfile(clear, Side::reflected).spectra(0),
                           less = LayeredProfile(absorbing, Side::reflected).spectra(0);
    for (const double all : {kept.beam.reflect + kept.beam.transmit, kept.reflect_above + kept.transmit_above,
                             kept.reflect_below + kept.transmit_below})
      worst = std::max(worst, std::abs(all - 1));
    for (const double all : {less.beam.reflect + less.beam.transmit, less.reflect_above + less.transmit_above,
                             less.reflect_below + less.transmit_below}) {
      EXPECT_LE(all, 1) << "stack " << i;
      EXPECT_GT(all, 0) << "stack " << i;
    }
  }

  EXPECT_LE(worst, 0.005);
  EXPECT_LE(worst, 1e-6);
}

TEST(Multipole, NeverMoreLightThanEntered) {
  for (const double sigma_a : {0.0, 1e-5, 0.01, 0.3, 3.0, 1000.0})
    for (const double d : {1e-6, 0.001, 0.05, 0.3, 0.5, 0.8, 1.0, 1.05, 1.5, 2.0, 10.0, 50.0})
      for (const double eta : {1.0, 1.33, 1.5, 3.0})
        for (const double below : {1.0, 1.4, 2.0}) {
          const Multipole slab({sigma_a, 1, eta, d / (1 + sigma_a)}, 1, below);
          const profile::Spectra s = slab.spectra(0);

          for (const double all : {s.beam.reflect + s.beam.transmit, s.reflect_above + s.transmit_above,
                                   s.reflect_below + s.transmit_below}) {
            EXPECT_LE(all, 1 + 1e-9) << sigma_a << " " << d << " " << eta << " " << below;
            if (sigma_a == 0) { EXPECT_NEAR(all, 1, 0.005) << d; }
          }

          for (const double k : {0.0, 0.7, 20.0, 400.0, 1e5}) {
            const profile::Spectra at = slab.spectra(k);
            for (const double part :
                 {at.reflect_above, at.transmit_above, at.reflect_below, at.transmit_below, at.beam.reflect,
                  at.beam.transmit - at.beam.straight, at.beam.straight})
              EXPECT_GE(part, -1e-12) << sigma_a << " " << d << " " << k;
          }
        }
}

TEST(Multipole, PartsAddUpToTheLayer) {
  for (const profile::TwoFlux& layer :
       {profile::TwoFlux{.5, .5}, {.4, .41}, {.1, .6}, {.3, 1e-6}, {1e-9, .2}, {0, .3}, {1e-100, 1e-100}}) {
    const auto doubled = [](const profile::TwoFlux& half) {
      const double bounces = 1 / (1 - half.reflect * half.reflect);
      return profile::TwoFlux{half.reflect * (1 + half.transmit * half.transmit * bounces),
                              half.transmit * half.transmit * bounces};
    };
    const profile::TwoFlux again = doubled(doubled(profile::part_of(layer, 0.25)));
    EXPECT_NEAR(again.reflect, layer.reflect, 1e-9) << layer.transmit;
    EXPECT_NEAR(again.transmit, layer.transmit, 1e-9) << layer.reflect;
    const profile::TwoFlux nothing = profile::part_of(layer, 1e-9);
    EXPECT_NEAR(nothing.reflect, 0, 1e-6);
    EXPECT_NEAR(nothing.transmit, 1, 1e-6);
  }
}

TEST(Multipole, ThinSlabJoinsTheMultipole) {
  for (const double sigma_a : {0.0, 0.1, 2.0})
    for (const double eta : {1.0, 1.1, 1.4})
      for (const double below : {1.0, 1.4}) {
        const auto at = [&](double d) { return Multipole({sigma_a, 1, eta, d / (1 + sigma_a)}, 1, below); };
        double limit = 1;
        while (at(limit).thin()) limit += 1e-4;
        EXPECT_GE(limit, 1.1 - 1e-3);
        EXPECT_LE(limit, 2 + 1e-3);
        for (const double k : {0.0, 1.0, 5.0}) {
          const profile::Spectra thin = at(limit - 2e-4).spectra(k), thick = at(limit).spectra(k);
          EXPECT_NEAR(thin.beam.reflect, thick.beam.reflect, 1e-3);
          EXPECT_NEAR(thin.beam.transmit, thick.beam.transmit, 1e-3);
          EXPECT_NEAR(thin.reflect_below, thick.reflect_below, 1e-3);
        }
      }
}

// Against the transport equation, where the multipole is 0.07 off: a film, and a thin layer on its own kind,
// which is a half-space.
TEST(Multipole, ThinSlabIsNearTheTruth) {
  for (const double eta : {1.0, 1.4})
    for (const double sigma_a : {0.0, 0.05})
      for (const double d : {0.001, 0.02, 0.1, 0.3, 0.5, 0.7, 1.0}) {
        const Layer film{sigma_a, 1, eta, d / (1 + sigma_a)};
        const optics::Totals truth = optics::adding_doubling({film});
        const profile::Spectra ours = Multipole(film, 1, 1).spectra(0);
        EXPECT_NEAR(ours.beam.reflect, truth.reflectance, eta == 1 ? 0.016 : 0.065) << eta << " " << d;
        EXPECT_NEAR(ours.beam.transmit, truth.transmittance, eta == 1 ? 0.016 : 0.07) << eta << " " << d;
        if (sigma_a == 0) continue;
        const Layer rest{sigma_a, 1, eta, infinite};
        EXPECT_NEAR(LayeredProfile({film, rest}, Side::reflected).total(),
                    optics::adding_doubling({rest}).reflectance, 0.06)
            << eta << d;
      }
}

// No scattering: what enters a thin layer goes through, less what is absorbed.
TEST(Multipole, VanishingLayersVanish) {
  for (const double sigma_s : {0.0, 1.0, 100.0})
    for (const double eta : {1.0, 1.4}) {
      const profile::Spectra s = Multipole({0.1, sigma_s, eta, 1e-6}, 1, 1).spectra(0);
      EXPECT_NEAR(s.beam.reflect, 0, 1e-3);
      EXPECT_NEAR(s.beam.transmit, 1, 1e-3);
      EXPECT_NEAR(s.beam.straight, 1, 1e-3);
    }
}

TEST(Multipole, ThinProfileIntegratesToItsTotal) {
  for (const Side side : {Side::reflected, Side::transmitted}) {
    const SlabProfile slab({0.05, 1, 1.4, 0.1}, side, 1, 1.4);
    EXPECT_NEAR(slab.within(1e3), slab.total(), 5e-3 * slab.total());
  }
}

/// Largest deviation in R or T of two halves of `half` mean free paths each from the whole.
double halves_against_whole(double half, double eta) {
  double worst = 0;
  for (const double sigma_a : {0.0, 0.001, 0.01, 0.03, 0.05, 0.1, 0.2, 0.35, 0.5, 1.0, 3.0, 10.0, 100.0}) {
    const double d = half / (1 + sigma_a);
    const auto two =
        LayeredProfile({{sigma_a, 1, eta, d}, {sigma_a, 1, eta, d}}, Side::reflected).spectra(0).beam;
    const auto one = LayeredProfile({{sigma_a, 1, eta, 2 * d}}, Side::reflected).spectra(0).beam;
    EXPECT_LE(two.reflect + two.transmit, 1 + 1e-9);
    if (sigma_a == 0) { EXPECT_NEAR(two.reflect + two.transmit, 1, 1e-6); }
    worst = std::max({worst, std::abs(two.reflect - one.reflect), std::abs(two.transmit - one.transmit)});
  }
  return worst;
}

TEST(Layers, TwoHalvesAgainstTheWhole) {
  for (const double eta : {1.0, 1.05, 1.1, 1.2, 1.3, 1.33, 1.4, 1.5, 1.6}) {
    double worst = 0, where = 0;
    for (double half = 0.02; half < 12; half *= 1.06) {
      const double deviation = halves_against_whole(half, eta);
      EXPECT_LE(deviation, 0.04) << "halves of " << half << " mean free paths, index " << eta;
      if (deviation > worst) {
        worst = deviation;
        where = half;
      }
    }

    std::printf("| %.2f | %.3f at %.2f |", eta, worst, where);  // a row of docs/theory.md
    for (const double half : {0.05, 0.2, 0.6, 1.0, 1.5, 2.0, 4.0, 8.0})
      std::printf(" %.3f |", halves_against_whole(half, eta));
    std::printf("\n");
  }

  double no_tissue = 0;
  for (const double eta : {2.0, 3.0})
    for (double half = 0.02; half < 12; half *= 1.06)
      no_tissue = std::max(no_tissue, halves_against_whole(half, eta));
  std::printf("indices 2 and 3: %.3f\n", no_tissue);
  EXPECT_LE(no_tissue, 0.1);
}

// Spectral skin of the 2006 sketch [DJ06] at 450, 550, 650 nm; closed forms computed independently.
TEST(Layers, TotalsOfTwoLayeredSkin) {
  struct Row {
    double sa_epi, sa_derm, ss_epi, ss_derm, total;
  };
  for (const Row& row :
       {Row{0.5675, 0.3166, 9.2091, 4.6046, 0.35521}, Row{0.2606, 0.1678, 6.0823, 3.0411, 0.38925},
        Row{0.1472, 0.0323, 4.7778, 2.3889, 0.52088}, Row{10.9611, 0.5113, 9.2091, 4.6046, 0.06393},
        Row{4.2247, 0.2897, 6.0823, 3.0411, 0.09884}, Row{1.9178, 0.0354, 4.7778, 2.3889, 0.16853},
        Row{44.6794, 2.0686, 9.2091, 4.6046, 0.01767}, Row{21.5149, 1.2649, 6.0823, 3.0411, 0.02391},
        Row{11.8298, 0.0602, 4.7778, 2.3889, 0.03340}}) {
    const optics::Layers skin{{row.sa_epi, row.ss_epi, 1.4, 0.25}, {row.sa_derm, row.ss_derm, 1.4, infinite}};
    EXPECT_NEAR(LayeredProfile(skin, Side::reflected).total(), row.total,
                4e-4 * row.total + 5e-6);  // the inputs are printed to four digits
  }
}

// The multipole as light sent onto a surface sees it, times 1 - F(0) of n = 1.4: independent closed forms,
// printed to five digits.
TEST(Layers, TotalsPerFluxSent) {
  const double into = 1 - (0.4 / 2.4) * (0.4 / 2.4);
  const auto slab = LayeredProfile({{.1, 1, 1.4, 4}}, Side::reflected).spectra(0);
  EXPECT_NEAR(into * slab.reflect_above, .28857, 1e-4 * .28857);
  EXPECT_NEAR(into * slab.transmit_above, .07962, 1e-4 * .07962);
  EXPECT_NEAR(into * LayeredProfile({{.5, 4, 1.4, .25}, {.05, 2, 1.4, infinite}}, Side::reflected).total(),
              .33910, 1e-4 * .33910);
  const auto thin = LayeredProfile({{.1, 1, 1.4, 1.01}}, Side::reflected).spectra(0);
  EXPECT_NEAR(into * thin.reflect_above, .26350, 1e-4 * .26350);
  EXPECT_NEAR(into * thin.transmit_above, .44506, 1e-4 * .44506);
}

TEST(Layers, OneLayerIsItsSlab) {
  const Layer layer{0.1, 1, 1.4, 4};
  const LayeredProfile stack({layer}, Side::reflected);
  const SlabProfile slab(layer, Side::reflected);
  for (const double k : {0.0, 0.5, 3.0}) EXPECT_NEAR(stack.hankel(k), slab.hankel(k), 1e-12);
  EXPECT_NEAR(stack.at(1.0) / slab.at(1.0), 1, 1e-4);
  EXPECT_NEAR(stack.within(stack.quantile(0.5)), 0.5 * stack.total(), 2e-3 * stack.total());
}

TEST(Burley, TotalQuantilesAndTransform) {
  const profile::Burley burley(0.7, 0.5, "test");
  EXPECT_NEAR(burley.within(1e6), 0.7, 1e-12);
  EXPECT_NEAR(burley.hankel(0), 0.7, 1e-12);
  for (const double p : {0.01, 0.3, 0.7, 0.99}) EXPECT_NEAR(burley.within(burley.quantile(p)), 0.7 * p, 1e-9);
  class Numeric final : public profile::RadialProfile {
   public:
    explicit Numeric(const profile::Burley& b) : b_(b) {}
    double at(double r) const override { return b_.at(r); }
    double inner_mm() const override { return b_.inner_mm(); }
    double outer_mm() const override { return b_.outer_mm(); }
    bool has_pole() const override { return true; }
    std::string name() const override { return "numeric"; }

   private:
    const profile::Burley& b_;
  } numeric(burley);
  for (const double k : {0.0, 0.5, 2.0, 10.0})
    EXPECT_NEAR(numeric.hankel(k), burley.hankel(k), 1e-3 * 0.7) << k;
  EXPECT_NEAR(numeric.quantile(0.9), burley.quantile(0.9), 2e-3);
}

// The published fits by hand, A = 0.7: s = 1.157 (perpendicular), 1.235 (from everywhere), 5.374161 (diffuse
// mean free path).
TEST(Burley, ShapesFromLengths) {
  using profile::Burley;
  EXPECT_NEAR(Burley::shape_mm(0.7, optics::MeanFreePath(2)), 2 / 1.157, 1e-12);
  EXPECT_NEAR(Burley::shape_all_angles_mm(0.7, optics::MeanFreePath(2)), 2 / 1.235, 1e-12);
  EXPECT_NEAR(Burley::shape_mm(0.7, optics::DiffuseMeanFreePath(2)), 2 / 5.374161, 1e-7);
  EXPECT_NEAR(Burley::shape_mm(0.33, optics::DiffuseMeanFreePath(1)), 1 / 3.5, 1e-12);
  EXPECT_NEAR(Burley::shape_mm(0.4, optics::MeanFreePath(1)), 1 / 1.898, 1e-12);
  EXPECT_NEAR(Burley::shape_all_angles_mm(0.4, optics::MeanFreePath(1)), 1 / 2.06, 1e-12);
  // One curve by either length: l_dmfp = l_mfp s_dmfp / s_mfp = 1 mm 5.374161 / 1.157
  const auto by_mean = profile::parse_burley("reflectance=0.7 mfp_mm=1", "x"),
             by_diffuse = profile::parse_burley("reflectance=0.7 dmfp_mm=4.644911", "x");
  EXPECT_NEAR(by_mean.shape_mm[0], 0.8643042, 1e-7);
  EXPECT_NEAR(by_diffuse.shape_mm[2], by_mean.shape_mm[2], 1e-6);
}

TEST(Burley, MistakesAreNamed) {
  for (const char* key : {"mfp_mm", "dmfp_mm", "shape_mm"}) {
    try {
      profile::parse_burley(fmt::format("reflectance=0.5 {}=1,-1,1", key), "--burley");
      FAIL() << key;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), fmt::format("--burley: {} must be above 0, got -1", key));
    }
  }
  EXPECT_THROW(profile::Burley(1.5, 1, "x"), InputError);
  EXPECT_THROW(profile::Burley(0.5, 0, "x"), InputError);
  EXPECT_THROW(profile::Burley(0.5, 1e-300, "x"), InputError);
  EXPECT_THROW(profile::Burley(0.5, 1e7, "x"), InputError);
}

}  // namespace
}  // namespace dermis
