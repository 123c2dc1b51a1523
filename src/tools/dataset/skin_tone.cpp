// SPDX-License-Identifier: MIT
#include "tools/dataset/skin_tone.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "api/asset_state.h"
#include "image/colour.h"
#include "tissue/optics/skin_colour.h"

namespace dermis::dataset {
namespace {

constexpr std::array least_deg{55.0, 41.0, 28.0, 10.0, -30.0};  // of all classes but the last [CCH91]

int texel(float coordinate, int side) {
  const float within = coordinate - std::floor(coordinate);
  return std::clamp(static_cast<int>(within * static_cast<float>(side)), 0, side - 1);
}

// Linear Rec.709 of the material in the middle of a triangle.
glm::dvec3 albedo(const scene::AssetData& scene, const scene::Material& material,
                  const std::array<const scene::Vertex*, 3>& corners) {
  glm::dvec3 colour(material.base_colour);
  glm::vec2 uv(0);
  glm::vec4 vertices(0);
  for (const scene::Vertex* corner : corners) {
    uv += (material.base_colour_map.uv_set == 1 ? corner->uv1 : corner->uv0) / 3.0f;
    vertices += corner->colour / 3.0f;
  }
  colour *= glm::dvec3(vertices);
  if (!material.base_colour_map.present()) return colour;

  const image::Image8& map = *scene.images[static_cast<std::size_t>(material.base_colour_map.image)].pixels;
  const glm::vec2 at = material.base_colour_map.transform * glm::vec3(uv, 1);
  const std::uint8_t* rgb = map.at(texel(at.x, map.width), texel(at.y, map.height));
  for (int c = 0; c < 3; ++c) colour[c] *= double{image::srgb8_to_linear(rgb[c])};
  return colour;
}

double ita_deg(const glm::dvec3& albedo) {
  // A map holds light that leaves per light that entered; the surface lets a part of it in.
  static const double entering = optics::entering_part();
  const optics::Lab lab =
      optics::lab_from_linear({entering * albedo.x, entering * albedo.y, entering * albedo.z});
  return std::atan2(lab.l - 50, lab.b) * 180 / std::numbers::pi;
}

}  // namespace

const char* ita_class(double ita_deg) {
  std::size_t number = 0;
  while (number < least_deg.size() && !(ita_deg > least_deg[number])) ++number;
  return ita_classes[number];
}

std::optional<double> ita_deg_of(const Asset& asset) {
  const auto scene = Asset::State::of(asset);
  std::vector<std::pair<double, double>> angles;  // and area
  double whole = 0;
  for (const scene::Primitive& primitive : scene->primitives) {
    const scene::Material& material = scene->materials[static_cast<std::size_t>(primitive.material)];
    if (!material.skin) continue;
    for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
      std::array<const scene::Vertex*, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c) corners[c] = &primitive.vertices[primitive.indices[i + c]];
      const glm::dvec3 a(corners[0]->position_m), b(corners[1]->position_m), c(corners[2]->position_m);
      const double area = glm::length(glm::cross(b - a, c - a)) / 2;
      angles.emplace_back(ita_deg(albedo(*scene, material, corners)), area);
      whole += area;
    }
  }
  if (!(whole > 0)) return std::nullopt;

  std::ranges::sort(angles);
  double sum = 0;
  for (const auto& [angle, area] : angles) {
    sum += area;
    if (sum >= whole / 2) return angle;
  }
  return angles.back().first;
}

}  // namespace dermis::dataset
