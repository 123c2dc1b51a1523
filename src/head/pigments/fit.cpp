// SPDX-License-Identifier: MIT
#include "head/pigments/fit.h"

#include <algorithm>
#include <cmath>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/parallel.h"
#include "head/scene/surface/coverage.h"
#include "image/colour.h"
#include "tissue/optics/skin_colour.h"

namespace dermis::pigments {
namespace {

// Marks the texels that triangles of these materials show.
std::vector<std::uint8_t> shown_texels(const scene::AssetData& scene, const SkinMap& map) {
  const image::Image8& pixels = *scene.images[static_cast<std::size_t>(map.image)].pixels;
  std::vector<std::uint8_t> shown(static_cast<std::size_t>(pixels.width) * pixels.height);

  for (const scene::Primitive& primitive : scene.primitives) {
    if (std::find(map.materials.begin(), map.materials.end(), primitive.material) == map.materials.end())
      continue;
    const scene::MapRef& ref = scene.materials[static_cast<std::size_t>(primitive.material)].base_colour_map;
    const auto uv_of = [&](std::uint32_t vertex) {
      const scene::Vertex& v = primitive.vertices[vertex];
      return ref.transform * glm::vec3(ref.uv_set == 0 ? v.uv0 : v.uv1, 1);
    };
    for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
      std::array<glm::vec2, 3> uv;
      for (std::size_t k = 0; k < 3; ++k) uv[k] = uv_of(primitive.indices[t + k]);
      // Maps repeat; a triangle over the border of the square counts for what lies inside.
      const glm::vec2 origin = glm::floor((uv[0] + uv[1] + uv[2]) / 3.0f);
      if (!(std::abs(origin.x) < 1e6f && std::abs(origin.y) < 1e6f)) continue;
      for (glm::vec2& corner : uv) corner = glm::clamp(corner - origin, glm::vec2(0), glm::vec2(1));
      scene::for_each_texel(uv, pixels.width, [&](int x, int y) {
        const auto row =
            static_cast<std::size_t>(static_cast<std::int64_t>(y) * pixels.height / pixels.width);
        shown[row * static_cast<std::size_t>(pixels.width) + static_cast<std::size_t>(x)] = 1;
      });
    }
  }
  return shown;
}

// The colours of a map, and by how many texels of skin each is shown.
std::vector<Fit::Entry> colours_of(const image::Image8& pixels, const std::vector<std::uint8_t>& shown) {
  std::vector<std::uint64_t> all(shown.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = std::uint64_t{colour_at(&pixels.rgba[4 * i])} << 1 | shown[i];
  std::sort(all.begin(), all.end());

  std::vector<Fit::Entry> entries;
  for (const std::uint64_t value : all) {
    const auto colour = static_cast<Colour>(value >> 1);
    if (entries.empty() || entries.back().colour != colour) entries.push_back({.colour = colour});
    entries.back().texels += value & 1;
  }
  return entries;
}

optics::Rgb divided(optics::Rgb colour, double by) {
  for (double& value : colour) value /= by;
  return colour;
}

// Returns the exposure with the least mean error over some two thousand colours, spread over all that skin
// shows.
double best_exposure(const std::vector<Fit::Entry>& entries, const optics::SkinTable& table) {
  std::vector<const Fit::Entry*> sample;
  for (const Fit::Entry& entry : entries)
    if (entry.texels > 0) sample.push_back(&entry);
  const std::size_t step = std::max<std::size_t>(sample.size() / 2000, 1);

  constexpr int most_thirds = 9;
  std::vector<double> errors(2 * most_thirds + 1);
  parallel_for(errors.size(), [&](std::size_t k) {
    const double exposure = std::exp2((static_cast<double>(k) - most_thirds) / 3);
    double sum = 0, weight = 0;
    for (std::size_t i = 0; i < sample.size(); i += step) {
      const optics::Rgb wanted = linear_of(sample[i]->colour);
      const optics::Pigments found = table.nearest(divided(wanted, exposure)).pigments;
      const std::array<float, 3> albedo = table.at(found);
      const optics::Rgb shown{exposure * albedo[0], exposure * albedo[1], exposure * albedo[2]};
      sum += static_cast<double>(sample[i]->texels) *
             optics::delta_e76(optics::lab_from_linear(shown), optics::lab_from_linear(wanted));
      weight += static_cast<double>(sample[i]->texels);
    }
    errors[k] = weight > 0 ? sum / weight : std::abs(static_cast<double>(k) - most_thirds);
  });
  const auto best = std::min_element(errors.begin(), errors.end()) - errors.begin();
  return std::exp2((static_cast<double>(best) - most_thirds) / 3);
}

}  // namespace

std::vector<SkinMap> skin_maps(const scene::AssetData& scene, std::size_t most) {
  std::vector<SkinMap> maps;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const scene::Material& material = scene.materials[m];
    if (!material.skin || !material.base_colour_map.present()) continue;
    const int image = material.base_colour_map.image;
    auto same =
        std::find_if(maps.begin(), maps.end(), [&](const SkinMap& map) { return map.image == image; });
    if (same == maps.end()) same = maps.insert(maps.end(), SkinMap{.image = image, .materials = {}});
    same->materials.push_back(static_cast<int>(m));
  }

  if (maps.empty())
    throw input_error(scene.name, "its skin has no colour map, in which pigments could be found");
  if (maps.size() > most)
    throw input_error(
        scene.name,
        "its skin has {} colour maps, and maps of pigments are of one; skin_material can name one "
        "of its materials",
        maps.size());
  return maps;
}

optics::Rgb linear_of(Colour colour) {
  optics::Rgb linear{};
  for (int c = 0; c < 3; ++c)
    linear[c] = double{image::srgb8_to_linear(static_cast<std::uint8_t>(colour >> (16 - 8 * c)))};
  return linear;
}

Fit::Fit(const scene::AssetData& scene, const SkinMap& map, const optics::SkinTable& table) {
  const image::Image8& pixels = *scene.images[static_cast<std::size_t>(map.image)].pixels;
  entries_ = colours_of(pixels, shown_texels(scene, map));
  exposure_ = best_exposure(entries_, table);

  constexpr std::size_t block = 256;
  parallel_for((entries_.size() + block - 1) / block, [&](std::size_t b) {
    for (std::size_t i = b * block; i < std::min((b + 1) * block, entries_.size()); ++i) {
      Entry& entry = entries_[i];
      const optics::Rgb wanted = linear_of(entry.colour);
      entry.pigments = table.nearest(divided(wanted, exposure_)).pigments;
      const std::array<float, 3> albedo = table.at(entry.pigments);
      const optics::Rgb shown{exposure_ * albedo[0], exposure_ * albedo[1], exposure_ * albedo[2]};
      entry.delta_e = optics::delta_e76(optics::lab_from_linear(shown), optics::lab_from_linear(wanted));
    }
  });
  for (const Entry& entry : entries_) texels_ += entry.texels;
}

std::size_t Fit::number(Colour colour) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), colour,
                                   [](const Entry& entry, Colour wanted) { return entry.colour < wanted; });
  DERMIS_ASSERT_EQ(at != entries_.end() && at->colour == colour, true);
  return static_cast<std::size_t>(at - entries_.begin());
}

const optics::SkinTable& table_of_maps() {
  static const optics::SkinTable table(optics::measured_skin());
  return table;
}

}  // namespace dermis::pigments
