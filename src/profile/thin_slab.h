// SPDX-License-Identifier: MIT
// Slabs too thin for diffusion: two fluxes, up and down, through a core that is cut from a thicker slab, with
// mirrors for its boundaries. Based on: [DJ05] Donner, Jensen: Light Diffusion in Multi-Layered Translucent
// Materials. SIGGRAPH 2005 (the thicker slab)
//           [K48]  Kubelka: New Contributions to the Optics of Intensely Light-Scattering Materials. J. Opt.
//           Soc. Am. 38, 1948
// Lengths here are in mean free paths, k in inverse ones.
#pragma once

#include "profile/slab.h"

namespace dermis::profile {

/// The thickness [mean free paths] under which the multipole is left, for extrapolation lengths z_b [mean
/// free paths] at the two boundaries: 3.3 less both of them, within 1.1 to 2. Between equal indices (z_b =
/// 2/3 each) the multipole is wrong first.
double thin_limit(double z_b_above, double z_b_below);

/// The part x (0 < x <= 1) of the thickness of a layer of R, T > 0, R + T <= 1, by the hyperbolic solution of
/// [K48]: with a = (1 + R^2 - T^2) / 2R, b = sqrt(a^2 - 1), S d from T, R_x = sinh y / (a sinh y + b cosh y),
/// T_x = b / (a sinh y + b cosh y), y = b S d x. n such parts, added, are the layer again.
TwoFlux part_of(const TwoFlux& layer, double x);

/// Ours. The core is the multipole between equal indices, 2 mean free paths thick, cut by part_of() at every
/// frequency; its boundaries reflect diffuse light by rho = (A-1)/(A+1). Of a beam, e^{-1.5 d} meets the far
/// boundary unturned and is let through. What the multipole at thin_limit() differs from that is added with
/// weight (d / thin_limit())^1.5, so the two join there. R + T <= 1, = 1 without absorption; R -> 0 and T ->
/// 1 for a beam as d -> 0.
class ThinSlab {
 public:
  struct Medium {
    double reduced_albedo;  // 0..1
    double sigma_tr;        // per mean free path
  };
  ThinSlab(const Medium& medium, double z_b_above, double z_b_below);

  /// 0 < thickness < thin_limit(); `at_limit`: the multipole of that thickness at the same k.
  Spectra spectra(double k, double thickness, const Spectra& at_limit) const;

 private:
  struct Frequency {
    TwoFlux reference;  // the core before it is cut
    double beyond;      // how far k is past where that is known
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
