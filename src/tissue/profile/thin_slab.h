// SPDX-License-Identifier: MIT
// Slabs too thin for diffusion: two fluxes, up and down, through a core that is cut from a thicker slab, with
// mirrors as boundaries. Lengths here are in mean free paths, k in inverse mean free paths.
// Based on:
// [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent Materials. SIGGRAPH 2005
//        (the thicker slab)
// [K48]  Kubelka: New Contributions to the Optics of Intensely Light-Scattering Materials.
//        J. Opt. Soc. Am. 38, 1948
#pragma once

#include "tissue/profile/slab.h"

namespace dermis::profile {

/// Returns the thickness [mean free paths] below which the multipole is not used, for extrapolation lengths
/// z_b [mean free paths] of the two boundaries: 3.3 minus both, clamped to 1.1 .. 2. The multipole fails at
/// the largest thickness between equal indices (z_b = 2/3 each).
double thin_limit(double z_b_above, double z_b_below);

/// Returns a layer of the fraction x (0 < x <= 1) of the thickness of one with R, T > 0, R + T <= 1. n such
/// layers, added, reproduce a layer n times as thick. By the hyperbolic solution of [K48].
TwoFlux part_of(const TwoFlux& layer, double x);

/// Our own model. The core is the multipole between equal indices, 2 mean free paths thick, cut by part_of()
/// at every frequency; its boundaries reflect diffuse light by rho = (A-1)/(A+1). The fraction e^{-1.5 d} of
/// a beam reaches the far boundary unscattered and passes it. The difference to the multipole at thin_limit()
/// is added with weight (d / thin_limit())^1.5, so that the two models join there. R + T <= 1, = 1 without
/// absorption; R -> 0 and T -> 1 for a beam as d -> 0.
class ThinSlab {
 public:
  struct Medium {
    double reduced_albedo;  // 0..1
    double sigma_tr;        // per mean free path
  };
  ThinSlab(const Medium& medium, double z_b_above, double z_b_below);

  /// Returns the slab of 0 < thickness < thin_limit(); `at_limit` is the multipole of that limit at the same
  /// k.
  Spectra spectra(double k, double thickness, const Spectra& at_limit) const;

 private:
  struct Frequency {
    TwoFlux reference;  // the core before it is cut
    double beyond;      // distance of k past the largest k with a known reference
  };
  Spectra cut(const Frequency& at, double thickness) const;
  Spectra between_mirrors(const TwoFlux& core, double unturned) const;
  TwoFlux reference(double k) const;

  Medium medium_;
  double limit_;
  double rho_above_, rho_below_;
  TwoFlux total_;  // the reference at k = 0
};

}  // namespace dermis::profile
