// SPDX-License-Identifier: MIT
// The part of a Monte-Carlo result that needs no chance: light that a perpendicular beam sends back after one
// scattering. Based on: [HCJ13] eq. 9, per ring instead of per radius and through layers
#pragma once

#include <vector>

#include "profile/photon.h"

namespace dermis::profile {

/// Perpendicular light and one refractive index throughout: then singly scattered light goes straight up, and
/// its rings are integrals.
bool single_is_exact(const std::vector<PhotonLayer>& layers, ScatterScene::Light light);

/// Energy by ring of the light that left upwards after one scattering, without having met a boundary before;
/// per unit that entered.
///   E = Int sigma_s e^{-tau(t)} Int 2 pi p_HG(mu) e^{-tau(t)/mu} (1 - F(mu)) dmu dt over the directions mu =
///   t / sqrt(t^2 + r^2) of the ring;
/// 1e-4 of the total.
std::vector<double> single_rings(const std::vector<PhotonLayer>& layers, const std::vector<double>& edges_mm);

}  // namespace dermis::profile
