// SPDX-License-Identifier: MIT
#include "head/pigments/maps.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "head/pigments/coding.h"
#include "head/pigments/fit.h"
#include "head/pigments/repaint.h"

namespace dermis::pigments {
namespace {

// A value of each entry, and how many texels have it.
Spread spread_of(std::vector<std::pair<double, std::size_t>> values) {
  std::sort(values.begin(), values.end());
  double sum = 0;
  std::size_t count = 0;
  for (const auto& [value, texels] : values) {
    sum += value * static_cast<double>(texels);
    count += texels;
  }
  if (count == 0) return {};

  Spread spread{.mean = sum / static_cast<double>(count)};
  std::size_t below = 0;
  for (const auto& [value, texels] : values) {
    below += texels;
    spread.p95 = value;
    if (static_cast<double>(below) >= 0.95 * static_cast<double>(count)) break;
  }
  return spread;
}

image::Image8 grey_map(const image::Image8& like) {
  return {
      .width = like.width, .height = like.height, .rgba = std::vector<std::uint8_t>(like.rgba.size(), 255)};
}

}  // namespace

Maps maps_of(const scene::AssetData& scene) {
  const SkinMap map = skin_maps(scene, 1).front();
  const image::Image8& pixels = *scene.images[static_cast<std::size_t>(map.image)].pixels;
  const optics::SkinTable& table = table_of_maps();
  const Fit fit(scene, map, table);

  Maps maps{.melanin = grey_map(pixels), .haemoglobin = grey_map(pixels)};
  maps.material = scene.materials[static_cast<std::size_t>(map.materials.front())].name;
  maps.texels = fit.texels();
  maps.exposure = fit.exposure();

  // Pigments in 8 bits, and the distance of their colour.
  std::vector<std::array<std::uint8_t, 2>> codes;
  std::vector<std::pair<double, std::size_t>> model, colour;
  double log_melanin = 0, log_blood = 0;
  for (const Fit::Entry& entry : fit.entries()) {
    const std::uint8_t melanin = melanin_coding.code(entry.pigments.melanin),
                       blood = haemoglobin_coding.code(entry.pigments.haemoglobin);
    codes.push_back({melanin, blood});
    if (entry.texels == 0) continue;

    const optics::Pigments kept{.melanin = melanin_coding.fraction(melanin),
                                .haemoglobin = haemoglobin_coding.fraction(blood),
                                .oxygenation = entry.pigments.oxygenation};
    const std::array<std::uint8_t, 3> made = recoloured(entry.colour, entry.pigments, kept, table);
    const Colour made_colour = static_cast<Colour>(made[0] << 16 | made[1] << 8 | made[2]);
    model.emplace_back(entry.delta_e, entry.texels);
    colour.emplace_back(optics::delta_e76(optics::lab_from_linear(linear_of(entry.colour)),
                                          optics::lab_from_linear(linear_of(made_colour))),
                        entry.texels);
    log_melanin += std::log(entry.pigments.melanin) * static_cast<double>(entry.texels);
    log_blood += std::log(entry.pigments.haemoglobin) * static_cast<double>(entry.texels);
  }
  maps.model_delta_e = spread_of(std::move(model));
  maps.colour_delta_e = spread_of(std::move(colour));
  if (const auto count = static_cast<double>(maps.texels); count > 0)
    maps.mean = {.melanin = std::exp(log_melanin / count),
                 .haemoglobin = std::exp(log_blood / count),
                 .oxygenation = table.fixed().oxygenation};

  for (std::size_t i = 0; i < pixels.rgba.size(); i += 4) {
    const std::array<std::uint8_t, 2>& code = codes[fit.number(colour_at(&pixels.rgba[i]))];
    std::fill_n(&maps.melanin.rgba[i], 3, code[0]);
    std::fill_n(&maps.haemoglobin.rgba[i], 3, code[1]);
  }
  return maps;
}

}  // namespace dermis::pigments
