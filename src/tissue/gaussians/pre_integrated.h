// SPDX-License-Identifier: MIT
// Scattering integrated beforehand over simple shapes: what skin that is bent like a ball shows of one light,
// and what it shows beside the edge of a shadow. Based on: [Pen11] Penner: Pre-Integrated Skin Shading. GPU
// Pro 2, 2011, and the SIGGRAPH 2011 course on advances in
//         real-time rendering
// [FW14]  NVIDIA: FaceWorks, 2014, with its slides (the integral over an arc with Gaussians of one dimension,
//         blurred normals per channel, wide shadows)
#pragma once

#include <vector>

#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// Returns the share of a light that skin on a circle of this curvature shows where its normal has this
/// cosine with the light, white light 1. The profile is taken as its line spread over the length of the arc
/// [FW14]. It goes up to half the circle and four sigma of the widest Gaussian, and is divided by its
/// integral. Of a flat plane (curvature 0) it is the cosine where that is positive. cosine: -1..1;
/// curvature_per_mm >= 0.
Rgb lit_arc(const ScatterProfile& profile, double cosine, double curvature_per_mm);

/// The same as published in [Pen11]: the profile itself over the chord of the ring, integrated along the
/// ring. Far too dark beside the terminator: it takes a profile of two dimensions for one of one.
Rgb lit_ring(const ScatterProfile& profile, double cosine, double curvature_per_mm);

/// Returns the light at x mm inside a lit half-plane (negative: outside), the peak 1.
Rgb lit_edge(const ScatterProfile& profile, double x_mm);

/// Returns the distance of a straight edge of light from the middle of a disc, in radii of the disc: -1..1,
/// positive where more than half is lit. The disc is lit in this share of its area, 0..1.
double edge_in_disc(double lit_share);

/// Returns the width of the filter of shadows of a profile, four sigma of its widest Gaussian: 10.9 mm for
/// the published six. A wider one finds more shadows that are none, in hollows of the skin.
double shadow_filter_mm(const ScatterProfile& profile);

/// A table of two variables, row by row.
struct LightTable {
  int columns = 0, rows = 0;
  std::vector<Rgb> light;
  const Rgb& at(int column, int row) const { return light[static_cast<std::size_t>(row * columns + column)]; }
};

inline constexpr double most_curvature_per_mm = 1;  ///< of the last row: a ball of 1 mm

/// Returns what lit_arc() (or lit_ring()) has more than the positive cosine. Column i of n: the cosine
/// -1 + 2 i / (n - 1). Row j of m: the curvature most_curvature_per_mm (j / (m - 1))^2. Both sides > 1.
LightTable lit_table(const ScatterProfile& profile, int columns, int rows, bool ring = false);

/// Returns lit_edge(), stretched to end at 0 and 1, one row. Column i of n: with t = -1 + 2 i / (n - 1), x is
/// t |t| times half of shadow_filter_mm().
LightTable edge_table(const ScatterProfile& profile, int columns);

/// Returns the light beside the edge of a shadow, for who filters shadows over a disc of diameter
/// shadow_filter_mm() that faces the light. Column i of n: the filtered shadow i / (n - 1), 1 lit. Row j of
/// m: the cosine of the surface and the light, (j + 1) / m.
LightTable shadow_table(const ScatterProfile& profile, int columns, int rows);

}  // namespace dermis::gaussians
