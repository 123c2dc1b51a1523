// SPDX-License-Identifier: MIT
#include "head/pigments/repaint.h"

#include <memory>
#include <optional>
#include <utility>

#include "base/core/parallel.h"
#include "head/pigments/coding.h"
#include "head/pigments/maps.h"
#include "image/codec.h"
#include "image/colour.h"

namespace dermis::pigments {
namespace {

// Reads a map of pigments at texels of a picture of another size, too.
class WantedMap {
 public:
  WantedMap(const std::filesystem::path& path, const Coding& coding) : coding_(coding) {
    if (!path.empty()) pixels_ = image::load_image8(path);
  }
  bool is_given() const { return pixels_.has_value(); }
  double at(int x, int y, const image::Image8& of) const {
    const auto column = static_cast<int>((2 * std::int64_t{x} + 1) * pixels_->width / (2 * of.width)),
               row = static_cast<int>((2 * std::int64_t{y} + 1) * pixels_->height / (2 * of.height));
    return coding_.fraction(pixels_->at(column, row)[0]);
  }

 private:
  const Coding& coding_;
  std::optional<image::Image8> pixels_;
};

image::Image8 repainted(const scene::AssetData& scene, const SkinMap& map, const Wanted& wanted) {
  const image::Image8& pixels = *scene.images[static_cast<std::size_t>(map.image)].pixels;
  const optics::SkinTable& table = table_of_maps();
  const Fit fit(scene, map, table);
  const WantedMap melanin(wanted.melanin_map, melanin_coding),
      haemoglobin(wanted.haemoglobin_map, haemoglobin_coding);

  image::Image8 made = pixels;
  parallel_for(static_cast<std::size_t>(pixels.height), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    std::pair<Colour, std::size_t> last{~Colour{0}, 0};
    for (int x = 0; x < pixels.width; ++x) {
      const Colour colour = colour_at(pixels.at(x, y));
      if (colour != last.first) last = {colour, fit.number(colour)};
      const optics::Pigments& own = fit.entries()[last.second].pigments;
      optics::Pigments other = own;
      if (melanin.is_given()) other.melanin = melanin.at(x, y, pixels);
      if (haemoglobin.is_given()) other.haemoglobin = haemoglobin.at(x, y, pixels);
      other.melanin *= wanted.melanin;
      other.haemoglobin *= wanted.haemoglobin;

      const std::array<std::uint8_t, 3> rgb = recoloured(colour, own, other, table);
      for (std::size_t c = 0; c < 3; ++c) made.at(x, y)[c] = rgb[c];
    }
  });
  return made;
}

}  // namespace

std::array<std::uint8_t, 3> recoloured(Colour colour, const optics::Pigments& own,
                                       const optics::Pigments& wanted, const optics::SkinTable& table) {
  const std::array<float, 3> before = table.at(own), after = table.at(wanted);
  const optics::Rgb linear = linear_of(colour);
  std::array<std::uint8_t, 3> made{};
  for (std::size_t c = 0; c < 3; ++c)
    made[c] = image::linear_to_srgb8(static_cast<float>(linear[c]) * (after[c] / before[c]));
  return made;
}

void repaint(scene::AssetData& scene, const Wanted& wanted) {
  const bool has_maps = !wanted.melanin_map.empty() || !wanted.haemoglobin_map.empty();
  for (const SkinMap& map : has_maps ? skin_maps(scene, 1) : skin_maps(scene)) {
    auto pixels = std::make_shared<const image::Image8>(repainted(scene, map, wanted));
    const int image = static_cast<int>(scene.images.size());
    // Others may use the picture, too: it stays.
    scene.images.push_back(
        {scene.images[static_cast<std::size_t>(map.image)].name + ", other pigments", std::move(pixels)});
    for (const int material : map.materials)
      scene.materials[static_cast<std::size_t>(material)].base_colour_map.image = image;
  }
}

}  // namespace dermis::pigments
