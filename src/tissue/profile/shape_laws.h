// SPDX-License-Identifier: MIT
// Light that leaves curved and thin bodies of a medium, relative to a flat
// half-space. Laws with few constants, fitted to the walks of bench/shapes; docs/theory.md ("Shapes") derives
// them and lists their errors. Based on: [K48] Kubelka: New Contributions to the Optics of Intensely
// Light-Scattering Materials. J. Opt. Soc. Am. 38,
//       1948 (two fluxes)
// [C60] Chandrasekhar: Radiative Transfer. Dover 1960 (reciprocity; the attenuation deep in a medium)
#pragma once

#include <span>
#include <vector>

#include "tissue/optics/media.h"

namespace dermis::profile {

/// Returns the laws of a medium, from the reduced albedo, the reduced mean free path and the index of each
/// channel. Fitted for reduced albedos of 0.2 to 0.997 and indices of 1.3 to 1.5; beyond, that of the
/// nearest. Throws InputError if check() of tissue/optics/media.h does.
ShapeLaws shape_laws(const optics::RgbMedium& medium);

/// Returns the total, relative to a half-space, of channel c where the skin has these curvatures:
/// head/scene/surface/curvature.h. 0.3 to 2.5.
double curved_total(const ShapeLaws& laws, std::size_t c, double mean_per_mm, double difference_per_mm);

/// Returns the light that leaves the lit side of a slab, relative to a half-space.
double slab_front(const ShapeLaws& laws, std::size_t c, double thickness_mm);

/// Returns the light that leaves the far side of slabs of this medium, relative to what a half-space returns,
/// for each thickness >= 0. (It needs more of the medium than ShapeLaws hold.)
std::vector<double> slab_backs(const optics::Medium& medium, std::span<const double> thicknesses_mm);

}  // namespace dermis::profile
