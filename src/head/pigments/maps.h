// SPDX-License-Identifier: MIT
// Melanin and haemoglobin maps of a head, and its colour with other pigments.
// Based on:
// [JSB10] Jimenez et al.: A Practical Appearance Model for Dynamic Facial Color. ACM TOG 29(6), 2010
// [TOS03] Tsumura et al.: Image-Based Skin Color and Texture Analysis/Synthesis by Extracting Hemoglobin and
// Melanin Information in the Skin. SIGGRAPH 2003 (what is neither of them is kept as it is)
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "head/scene/asset_data.h"
#include "image/image.h"
#include "tissue/optics/skin_table.h"

namespace dermis::pigments {

/// Over texels of skin.
struct Spread {
  double mean = 0, p95 = 0;
};

struct Maps {
  image::Image8 melanin,
      haemoglobin;         ///< as large as the colour map; red, green and blue: head/pigments/coding.h
  std::string material;    ///< the first that has the colour map
  std::size_t texels = 0;  ///< of skin
  double exposure = 1;     ///< of the colour map: Fit
  optics::Pigments mean;   ///< over the skin, geometric
  /// CIE76 of the colour map from the colour of the two pigments alone, and from what repaint() makes of
  /// these maps.
  Spread model_delta_e, colour_delta_e;
};

/// Finds the pigments of the head's skin. Throws InputError unless its skin has one colour map. About a
/// second for 2048 x 2048 texels.
Maps maps_of(const scene::AssetData& scene);

/// The pigments that skin is to have.
struct Wanted {
  std::filesystem::path melanin_map, haemoglobin_map;  ///< empty: as in the colour map
  double melanin = 1, haemoglobin = 1;                 ///< multiply what the maps say
};

/// Gives skin other pigments. Each texel of its colour maps is multiplied by the model's albedo of the wanted
/// pigments over that of its own. So all that is not pigment stays (exposure, make-up, hair). Throws
/// InputError: skin without a colour map; with maps, skin with several; a map that cannot be read or is no
/// picture.
void repaint(scene::AssetData& scene, const Wanted& wanted);

}  // namespace dermis::pigments
