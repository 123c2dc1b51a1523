// SPDX-License-Identifier: MIT
// The pigments of each colour of a map.
#pragma once

#include <cstdint>
#include <vector>

#include "head/scene/asset_data.h"
#include "image/image.h"
#include "tissue/optics/skin_table.h"

namespace dermis::pigments {

/// The colour map of skin and the materials that have it.
struct SkinMap {
  int image = -1;              ///< index into AssetData::images
  std::vector<int> materials;  ///< indices into AssetData::materials
};
/// Returns each colour map of skin once. Throws InputError if there is none, or more than `most`.
std::vector<SkinMap> skin_maps(const scene::AssetData& scene, std::size_t most = ~std::size_t{0});

/// 8 bits of red, green and blue: 0xRRGGBB.
using Colour = std::uint32_t;
inline Colour colour_at(const std::uint8_t* rgba) {
  return static_cast<Colour>(rgba[0] << 16 | rgba[1] << 8 | rgba[2]);
}
optics::Rgb linear_of(Colour colour);

/// Pigments of the colours of a map.
class Fit {
 public:
  struct Entry {
    Colour colour = 0;
    std::size_t texels = 0;  ///< of skin that have it; 0: only texels that nothing shows
    optics::Pigments pigments;
    double delta_e = 0;  ///< CIE76 between the colour and that of the pigments, times the exposure
  };

  /// Finds the pigments of every colour of the map, for the skin that `table` holds. A photograph does not
  /// know how bright the light was. So colours are divided by one exposure, that of -3 to 3 EV, in thirds, at
  /// which the mean error over the skin is least. Deterministic. Some 10 us per colour and core.
  Fit(const scene::AssetData& scene, const SkinMap& map, const optics::SkinTable& table);

  double exposure() const { return exposure_; }
  const std::vector<Entry>& entries() const { return entries_; }  ///< by rising colour
  std::size_t texels() const { return texels_; }                  ///< of skin
  /// Returns the entry of a colour of the map.
  std::size_t number(Colour colour) const;

 private:
  double exposure_ = 1;
  std::size_t texels_ = 0;
  std::vector<Entry> entries_;
};

/// Returns the table that maps are made with: of optics::measured_skin().
const optics::SkinTable& table_of_maps();

}  // namespace dermis::pigments
