// SPDX-License-Identifier: MIT
#include "tissue/optics/presets.h"

#include <limits>

#include "base/core/error.h"
#include "base/core/known_names.h"

namespace dermis::optics {
namespace {

// [JMLH01] fig. 5: sigma_s', sigma_a [1/mm] and diffuse reflectance, R G B.
constexpr Material materials[] = {
    {"apple", {2.29, 2.39, 1.97}, {0.0030, 0.0034, 0.046}, 1.3, {0.85, 0.84, 0.53}},
    {"chicken1", {0.15, 0.21, 0.38}, {0.015, 0.077, 0.19}, 1.3, {0.31, 0.15, 0.10}},
    {"chicken2", {0.19, 0.25, 0.32}, {0.018, 0.088, 0.20}, 1.3, {0.32, 0.16, 0.10}},
    {"cream", {7.38, 5.47, 3.15}, {0.0002, 0.0028, 0.0163}, 1.3, {0.98, 0.90, 0.73}},
    {"ketchup", {0.18, 0.07, 0.03}, {0.061, 0.97, 1.45}, 1.3, {0.16, 0.01, 0.00}},
    {"marble", {2.19, 2.62, 3.00}, {0.0021, 0.0041, 0.0071}, 1.5, {0.83, 0.79, 0.75}},
    {"potato", {0.68, 0.70, 0.55}, {0.0024, 0.0090, 0.12}, 1.3, {0.77, 0.62, 0.21}},
    {"skimmilk", {0.70, 1.22, 1.90}, {0.0014, 0.0025, 0.0142}, 1.3, {0.81, 0.81, 0.69}},
    {"skin1", {0.74, 0.88, 1.01}, {0.032, 0.17, 0.48}, 1.3, {0.44, 0.22, 0.13}},
    {"skin2", {1.09, 1.59, 1.79}, {0.013, 0.070, 0.145}, 1.3, {0.63, 0.44, 0.34}},
    {"spectralon", {11.6, 20.4, 14.9}, {0, 0, 0}, 1.3, {1.00, 1.00, 1.00}},
    {"wholemilk", {2.55, 3.21, 3.77}, {0.0011, 0.0024, 0.014}, 1.3, {0.91, 0.88, 0.76}},
};

}  // namespace

RgbMedium Material::medium() const {
  RgbMedium medium;
  for (int c = 0; c < 3; ++c)
    medium[c] = {
        .sigma_a_per_mm = sigma_a_per_mm[c], .sigma_s_per_mm = sigma_s_reduced_per_mm[c], .g = 0, .eta = eta};
  return medium;
}

std::span<const Material> jensen_materials() { return materials; }

RgbLayers donner_jensen_skin() {
  constexpr double per_mm = 0.1;  // from 1/cm
  const auto layer = [](Rgb sigma_a, Rgb sigma_s, double thickness_mm) {
    for (int c = 0; c < 3; ++c) {
      sigma_a[c] *= per_mm;
      sigma_s[c] *= per_mm;
    }
    return RgbLayer{.sigma_a_per_mm = sigma_a,
                    .sigma_s_reduced_per_mm = sigma_s,
                    .eta = 1.4,
                    .thickness_mm = thickness_mm};
  };
  return {layer({2.1, 2.1, 5.0}, {48, 60, 65}, 0.25), layer({0.16, 0.19, 0.30}, {32, 40, 46}, 0.35),
          layer({0.085, 1.0, 25}, {4.5, 4.7, 4.8}, std::numeric_limits<double>::infinity())};
}

std::vector<std::string_view> preset_names() {
  std::vector<std::string_view> names;
  for (const Material& material : materials) names.push_back(material.name);
  names.emplace_back("skin-layers");
  return names;
}

const Material* find_material(std::string_view name) {
  for (const Material& material : materials)
    if (material.name == name) return &material;
  return nullptr;
}

void unknown_preset(std::string_view name) {
  throw input_error("preset", "{}", unknown_name(name, preset_names()));
}

}  // namespace dermis::optics
