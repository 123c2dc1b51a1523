// SPDX-License-Identifier: MIT
// Computes coefficients from what artists and instruments give: a reflectance and a length.
// Based on:
// [JMLH01] sec. 2.4
// [JB02]   Jensen, Buhler: A Rapid Hierarchical Rendering Technique for Translucent Materials. SIGGRAPH 2002
#pragma once

#include <string>

#include "tissue/optics/media.h"

namespace dermis::optics {

/// Returns the total diffuse reflectance of the classical dipole, 0 to 1, for a reduced albedo 0..1 and
/// relative index eta >= 1.
double dipole_total_reflectance(double reduced_albedo, double eta);

/// Returns the reduced albedo whose dipole reflects `total_reflectance` (0 to 1, inclusive), to 1e-12. [JB02]
/// eq. 1. Throws InputError (place `where`) outside 0..1.
double reduced_albedo_from_reflectance(double total_reflectance, double eta, const std::string& where);

/// Returns coefficients from reflectance and mean free path: sigma_t' = 1/l_u, sigma_s' = alpha' sigma_t',
/// sigma_a is the rest; g = 0. Throws InputError for a reflectance outside 0..1, a length that is not > 0 and
/// finite, eta outside 1..3.
Medium medium_from_reflectance(double total_reflectance, MeanFreePath length, double eta,
                               const std::string& where);
/// Returns the same from the diffuse mean free path: sigma_t' = 1 / (l_d sqrt(3 (1 - alpha'))) [JB02] sec. 2.
/// Throws InputError also for reflectance 1: without absorption the diffuse mean free path is infinite.
Medium medium_from_reflectance(double total_reflectance, DiffuseMeanFreePath length, double eta,
                               const std::string& where);

}  // namespace dermis::optics
