// SPDX-License-Identifier: MIT
// Settings that many tests begin with.
#pragma once

#include <string>
#include <vector>

#include "dermis/settings.h"
#include "tissue/gaussians/sum.h"

namespace dermis::tests {

/// A square picture that is cheap on a software driver; `map_side` texels of a side of light and shadow maps.
RenderSettings small_settings(const std::string& technique = "texture-space", int side = 128,
                              int map_side = 256);

/// Returns the names of all techniques but `published`, which takes neither poses nor hosts, and has one way
/// to shade.
std::vector<std::string> other_than_published();

/// White light from everywhere and white skin: what is skin must be 1.
RenderSettings in_a_furnace(RenderSettings settings);

/// White skin under lamps alone, and nothing reflects: what is lit shows the irradiance over pi.
RenderSettings under_lamps_alone(RenderSettings settings);

/// small_settings() in a furnace.
RenderSettings furnace_settings(const std::string& technique, bool specular);

/// Nothing is left out because it is not seen.
RenderSettings unoptimised(RenderSettings settings);

/// Skin that scatters by these terms, under a name of their own among those of the program. Weights that do
/// not sum to 1 are divided by their sum.
RenderSettings with_profile(RenderSettings settings, const std::string& name,
                            const std::vector<Gaussian>& terms);

/// One sample per pixel of a picture so many times as wide and high; downsampled() takes it back.
RenderSettings super_sampled(RenderSettings settings, int times);

}  // namespace dermis::tests
