// SPDX-License-Identifier: MIT
// The part of a Monte-Carlo result that needs no sampling: light of a perpendicular beam that leaves after
// one scattering.
// Based on: [HCJ13] eq. 9 (see tissue/profile/beam.h), per ring instead of per radius, and through layers
#pragma once

#include <vector>

#include "tissue/profile/photon.h"

namespace dermis::profile {

/// Returns whether single_rings() applies: perpendicular light and one refractive index throughout, so that
/// singly scattered light leaves on a straight line.
bool single_is_exact(const std::vector<PhotonLayer>& layers, ScatterScene::Light light);

/// Returns, per ring, the energy of the light that leaves upwards after one scattering without having met a
/// boundary before, per unit that entered; within 1e-4 of the total.
std::vector<double> single_rings(const std::vector<PhotonLayer>& layers, const std::vector<double>& edges_mm);

}  // namespace dermis::profile
