// SPDX-License-Identifier: MIT
// Light on simple bodies as real-time techniques compute it: the profile of a
// half-space, blurred over the surface, and the laws of shape on top. In closed form, for errors against
// truth/reference/shapes.h.
#pragma once

#include "tissue/gaussians/sum.h"
#include "truth/reference/shapes.h"

namespace dermis::reference {

/// Returns the exitance at the point of the body that shapes.h looks at, for a light as in ShapeLight: the
/// irradiance blurred over the surface, each Gaussian as the heat kernel of its variance. Of a slab and a
/// wedge, whose surface is flat there, the irradiance itself; of a saddle, too.
optics::Rgb blurred(const Body& body, const ScatterProfile& profile, double light_deg);

/// Returns what the laws of the profile multiply it by, without the angle of exit. A slab lit from behind has
/// what slab_backs() says. Throws InputError if the profile has none.
optics::Rgb shape_factor(const Body& body, const ScatterProfile& profile, double light_deg);

}  // namespace dermis::reference
