// SPDX-License-Identifier: MIT
// The eyes. Measures: Bron, Tripathi, Tripathi: Wolff's Anatomy of the Eye and Orbit, 8th ed., 1997: globe 24
// mm wide, cornea 11.7 mm wide with a radius of curvature of 7.8 mm, limbus 1 to 1.5 mm broad.
#include <array>

#include "base/core/parallel.h"
#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/maps.h"
#include "head/builtin_head/noise.h"
#include "head/builtin_head/openings.h"
#include "head/builtin_head/parts.h"

namespace dermis::builtin_head {
namespace {

constexpr float limbus_mm = 5.85f, cornea_mm = 7.8f;
constexpr float last_angle = 1.75f;  // of the modelled part of the globe, from the pupil
constexpr float pupil_mm = 1.9f;

const vec3 sclera(0.53f, 0.475f, 0.42f), sclera_corner(0.42f, 0.28f, 0.235f), vessel(0.50f, 0.10f, 0.07f);

// Crooked vessels of the conjunctiva, from the corners of the eye towards the iris: points in the plane of
// the map, mm along the globe.
struct Vessel {
  vec2 from{0}, to{0};
  float width_mm = 0, strength = 0;
};

void grow(std::vector<Vessel>& out, vec2 at, float angle, float width_mm, int steps, std::uint32_t seed) {
  for (int k = 0; k < steps && width_mm > 0.03f; ++k) {
    const std::uint32_t h = lattice_hash(k, steps, static_cast<int>(seed), 371);
    angle += 0.9f * (unit(h) - 0.5f);
    const vec2 next = at + 0.55f * vec2(std::cos(angle), std::sin(angle));
    if (glm::length(next) < limbus_mm + 0.5f) return;
    out.push_back({at, next, width_mm, 0.35f + 0.4f * width_mm / 0.16f});
    at = next;
    width_mm *= 0.955f;
    if (unit(h * 2654435761u) < 0.14f)
      grow(out, at, angle + (unit(h * 40503u) < 0.5f ? 0.7f : -0.7f), width_mm * 0.7f, steps - k - 2, h);
  }
}

std::vector<Vessel> vessels() {
  std::vector<Vessel> out;
  for (int n = 0; n < 30; ++n) {
    const auto dice = [&](int k) { return unit(lattice_hash(n, k, 5, 977)); };
    const float side = n % 2 == 0 ? 1.0f : -1.0f;
    const float start = (side > 0 ? 0.0f : 3.14159265f) + 1.5f * (dice(0) - 0.5f);
    const vec2 at = (16.5f + 2.5f * dice(1)) * vec2(std::cos(start), std::sin(start));
    grow(out, at, start + 3.14159265f + 0.5f * (dice(2) - 0.5f), 0.08f + 0.09f * dice(3), 22,
         static_cast<std::uint32_t>(n));
  }
  return out;
}

// Returns the colour at a place of the map: `at` in mm along the globe from the pupil, `angle` around it.
vec3 eye_colour(const vec2& at, const Colouring& colours) {
  const float along = glm::length(at), angle = along > 1e-4f ? std::atan2(at.y, at.x) : 0.0f;
  const float r = eyeball_mm * std::sin(std::min(along / eyeball_mm, 1.57f));  // from the axis, mm

  // Sclera: yellowish white, redder towards the corners.
  const vec3 p(at * 0.25f, 3.0f);
  const float redness = smooth_step(8.0f, 17.0f, along) * (0.5f + 0.5f * std::abs(std::cos(angle)));
  vec3 white = colours.sclera * glm::mix(sclera, sclera_corner,
                                         std::clamp(redness + 0.12f * layered_noise(p, 2, 611), 0.0f, 1.0f));
  if (r > limbus_mm + 1.2f) return white;

  // Iris: fibres from the pupil to the rim, a paler ruff around the pupil, a dark rim.
  const vec2 turn(std::cos(angle), std::sin(angle));
  const float fibre = gradient_noise({11.0f * turn.x, 11.0f * turn.y, 0.35f * r}, 621) +
                      0.6f * gradient_noise({23.0f * turn.x, 23.0f * turn.y, 0.5f * r}, 622);
  const float crypt = gradient_noise({3.2f * turn.x, 3.2f * turn.y, 0.8f * r}, 623);
  const float ruff =
      smooth_step(pupil_mm, pupil_mm + 0.4f, r) * (1 - smooth_step(2.7f, 3.7f, r + 0.35f * crypt));
  const float light = std::clamp(0.34f + 0.36f * fibre + 0.18f * crypt + 0.38f * ruff, 0.0f, 1.0f);
  vec3 iris = glm::mix(colours.iris_dark, colours.iris_light, light);
  iris = glm::mix(iris, 0.6f * colours.iris_dark, 0.75f * smooth_step(4.6f, 5.7f, r + 0.15f * crypt));
  // The cornea gathers light from above on the lower part of the iris, and its rim shades the upper one.
  iris *= 1.0f + 0.45f * std::clamp(at.y / limbus_mm, -1.0f, 1.0f);
  iris *= smooth_step(pupil_mm - 0.12f, pupil_mm + 0.22f, r + 0.06f * fibre);
  iris = glm::max(iris, vec3(0.0025f));
  return glm::mix(iris, white, smooth_step(limbus_mm - 0.55f, limbus_mm + 0.65f, r));
}

image::Image8 paint_eye(int size, const Colouring& colours) {
  image::Image8 map;
  map.width = map.height = size;
  map.rgba.assign(static_cast<std::size_t>(size) * size * 4, 255);
  std::vector<float> blood(static_cast<std::size_t>(size) * size, 0.0f);
  const float reach = last_angle * eyeball_mm, per_texel = 2.0f * reach / static_cast<float>(size);

  // Vessels are drawn by their own boxes of texels; the strongest wins.
  for (const Vessel& v : vessels()) {
    const float edge = std::max(0.5f * v.width_mm, 0.75f * per_texel);
    const float strength = v.strength * std::min(1.0f, v.width_mm / (2 * edge) + 0.25f);
    const vec2 low = glm::min(v.from, v.to) - 2 * edge, high = glm::max(v.from, v.to) + 2 * edge;
    const auto texel = [&](float mm) {
      return std::clamp(static_cast<int>((mm + reach) / per_texel), 0, size - 1);
    };
    for (int y = texel(low.y); y <= texel(high.y); ++y) {
      for (int x = texel(low.x); x <= texel(high.x); ++x) {
        const vec2 at = (vec2(x, y) + 0.5f) * per_texel - reach, ab = v.to - v.from, ap = at - v.from;
        const float t = std::clamp(glm::dot(ap, ab) / glm::dot(ab, ab), 0.0f, 1.0f);
        const float d = glm::length(ap - t * ab) / edge;
        float& b = blood[static_cast<std::size_t>(y) * size + x];
        b = std::max(b, strength * falloff(0.35f * d * d));
      }
    }
  }

  parallel_for(static_cast<std::size_t>(size), [&](std::size_t row) {
    for (int x = 0; x < size; ++x) {
      const vec2 at = (vec2(x, static_cast<float>(row)) + 0.5f) * per_texel - reach;
      // The lids keep light from the rim of the gap, which no shadow map of this size resolves.
      const float y = -at.y;
      const float shade = (1 - 0.50f * smooth_step(1.5f, 6.5f, y)) *
                          (1 - 0.30f * smooth_step(3.0f, 7.0f, -y)) *
                          (1 - 0.30f * smooth_step(7.5f, 12.5f, std::abs(at.x)));
      const vec3 c = shade * glm::mix(eye_colour(at, colours), vessel,
                                      0.8f * blood[row * static_cast<std::size_t>(size) + x]);
      std::uint8_t* out = map.at(x, static_cast<int>(row));
      for (int k = 0; k < 3; ++k) out[k] = linear_to_srgb8(c[k]);
    }
  });
  return map;
}

// Share of its surroundings that a place of the eye sees between lids and lashes; brow and nose hide some,
// too.
image::Image8 paint_openness(int size) {
  image::Image8 map;
  map.width = map.height = size;
  map.rgba.assign(static_cast<std::size_t>(size) * size * 4, 255);
  const float reach = last_angle * eyeball_mm, per_texel = 2.0f * reach / static_cast<float>(size);
  for (int row = 0; row < size; ++row) {
    for (int x = 0; x < size; ++x) {
      const vec2 at = (vec2(x, row) + 0.5f) * per_texel - reach;
      const float below_upper = std::max(4.8f + at.y, 0.0f), above_lower = std::max(6.6f - at.y, 0.0f);
      const float open = 0.82f * (1 - std::exp(-below_upper / 2.6f)) *
                         (1 - 0.6f * std::exp(-above_lower / 1.6f)) *
                         (1 - 0.65f * smooth_step(6.0f, 14.0f, std::abs(at.x)));
      const auto byte = static_cast<std::uint8_t>(255.0f * open + 0.5f);
      std::fill_n(map.at(x, row), 3, byte);
    }
  }
  return map;
}

// Gaze: both eyes look at a point 1.2 m before the face.
vec3 gazed(const vec3& d, float side) {
  const float a = -side * 0.026f;
  return {d.x * std::cos(a) + d.z * std::sin(a), d.y, d.z * std::cos(a) - d.x * std::sin(a)};
}

void add_globe(PartMesh& mesh, float side) {
  constexpr std::array<float, 17> angles = {0,     0.08f, 0.16f, 0.25f, 0.34f, 0.42f, 0.48f, 0.53f,     0.58f,
                                            0.65f, 0.75f, 0.87f, 1.0f,  1.15f, 1.3f,  1.5f,  last_angle};
  constexpr int around = 24;
  const vec3 centre(side * eye_centre.x, eye_centre.y, eye_centre.z);
  const auto at = [](float angle, float turn) {
    const vec3 d(std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle));
    return d * eye_radius_mm(d);
  };

  // The pole is one corner, and rings close on their first: the map has no seam here.
  const std::uint32_t pole = mesh.add(centre + gazed(at(0, 0), side), gazed({0, 0, 1}, side), vec2(0.5f));
  for (std::size_t j = 1; j < angles.size(); ++j) {
    for (int i = 0; i < around; ++i) {
      const float turn = 6.2831853f * static_cast<float>(i) / around, a = angles[j], h = 0.004f;
      const vec3 p = at(a, turn);
      const vec3 n = glm::cross(at(a, turn - h) - at(a, turn + h), at(a + h, turn) - at(a - h, turn));
      const vec2 uv = 0.5f + 0.5f * a / last_angle * vec2(side * std::cos(turn), -std::sin(turn));
      mesh.add(centre + gazed(p, side), gazed(glm::dot(n, p) < 0 ? -n : n, side), uv);
    }
  }

  for (int i = 0; i < around; ++i) {
    const auto ring = [&](std::size_t j, int k) {
      return pole + 1 + static_cast<std::uint32_t>(j - 1) * around + static_cast<std::uint32_t>(k % around);
    };
    mesh.triangle(pole, ring(1, i), ring(1, i + 1));
    for (std::size_t j = 1; j + 1 < angles.size(); ++j) {
      mesh.triangle(ring(j, i), ring(j + 1, i + 1), ring(j, i + 1));
      mesh.triangle(ring(j, i), ring(j + 1, i), ring(j + 1, i + 1));
    }
  }
}

// A film of tears in the corner between the lower lid's edge and the globe.
void add_tears(const Sculpture& bust, PartMesh& mesh, float side) {
  const std::vector<vec3> edge = smooth_curve(lower_lid, 4);
  const vec3 centre(side * eye_centre.x, eye_centre.y, eye_centre.z);
  std::uint32_t first = 0;
  constexpr int across = 4;
  const int along = static_cast<int>(edge.size()) - 8;

  for (int i = 0; i < along; ++i) {
    const vec3 e = edge[static_cast<std::size_t>(i + 3)];
    const vec3 lid = bust.onto_skin({side * e.x, e.y - 0.35f, e.z});
    const vec3 d = glm::normalize(lid - centre);
    const vec3 low = centre + d * (glm::distance(lid, centre) - 1.0f) + vec3(0, 0.13f, 0);
    const vec3 up = glm::normalize(d + vec3(0, 0.055f, 0));
    const vec3 high = centre + up * (std::max(eye_radius_mm(up), glm::distance(lid, centre) - 3.4f) + 0.05f);
    for (int k = 0; k < across; ++k) {
      // Concave, so that it catches a line of light.
      const float t = static_cast<float>(k) / (across - 1);
      const vec3 p = glm::mix(low, high, t) - 0.10f * d * std::sin(3.14159f * t);
      const vec3 n = glm::mix(vec3(0, 1.0f, 0.25f), d + vec3(0, 0.1f, 0), t);
      const std::uint32_t id = mesh.add(p, n, {static_cast<float>(i) / static_cast<float>(along), t});
      if (i == 0 && k == 0) first = id;
    }
  }
  mesh.grid(first, across, along, side > 0);
}

void add_caruncle(const Sculpture& bust, PartMesh& mesh, float side) {
  const vec3 corner = bust.onto_skin({side * upper_lid[0].x, upper_lid[0].y, upper_lid[0].z});
  const vec3 centre = corner + vec3(side * 2.0f, 0.15f, -2.4f), radii(2.6f, 1.75f, 1.9f);
  constexpr int columns = 10, rows = 7;
  std::uint32_t first = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float a = 6.2831853f * static_cast<float>(i) / (columns - 1),
                  b = 3.14159265f * (static_cast<float>(j) / (rows - 1) - 0.5f);
      const vec3 d(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
      const float bump = 1.0f + 0.07f * gradient_noise(d * 2.3f + vec3(side, 0, 0), 641);
      const std::uint32_t id = mesh.add(centre + d * radii * bump, d / radii,
                                        {static_cast<float>(i) / columns, static_cast<float>(j) / rows});
      if (i == 0 && j == 0) first = id;
    }
  }
  mesh.grid(first, columns, rows, false);
}

scene::Material wet(const char* name, const glm::vec4& colour, float roughness) {
  scene::Material m;
  m.name = name;
  m.base_colour = colour;
  m.metallic = 0;
  m.roughness = roughness;
  m.ior = 1.376f;
  return m;
}

}  // namespace

float eye_radius_mm(const vec3& d) {
  // Both spheres meet at the limbus, with a small fillet.
  const float z = std::sqrt(eyeball_mm * eyeball_mm - limbus_mm * limbus_mm) -
                  std::sqrt(cornea_mm * cornea_mm - limbus_mm * limbus_mm);
  const float rest = cornea_mm * cornea_mm - z * z * (1 - d.z * d.z);
  const float cap = d.z > 0 ? z * d.z + std::sqrt(std::max(rest, 0.0f)) : 0.0f;
  return soft_max(eyeball_mm, cap, 0.5f);
}

void add_eyes(const Sculpture& bust, scene::AssetData& scene, const Colouring& colours, int map_size) {
  const int eye = static_cast<int>(scene.materials.size());
  scene.materials.push_back(wet("eye", vec4(1), 0.09f));
  scene.materials.back().base_colour_map.image = static_cast<int>(scene.images.size());
  scene.materials.back().occlusion_map.image = static_cast<int>(scene.images.size()) + 1;
  scene.materials.push_back(wet("caruncle", {0.50f, 0.19f, 0.155f, 1}, 0.30f));
  scene.materials.push_back(wet("tears", {0.34f, 0.24f, 0.21f, 0.20f}, 0.10f));
  scene.materials.back().alpha_mode = AssetAlpha::blend;
  scene.images.push_back(
      {"built-in eye", std::make_shared<const image::Image8>(paint_eye(map_size, colours))});
  scene.images.push_back(
      {"built-in eye, openness", std::make_shared<const image::Image8>(paint_openness(64))});

  scene.materials[static_cast<std::size_t>(eye) + 1].occlusion_map.image =
      add_openness(scene, "built-in lids, openness", 0.45f);

  PartMesh globes("eyes", eye), caruncles("caruncles", eye + 1), tears("tears", eye + 2);
  for (const float side : {1.0f, -1.0f}) {
    add_globe(globes, side);
    add_caruncle(bust, caruncles, side);
    add_tears(bust, tears, side);
  }
  scene.primitives.push_back(globes.finish());
  scene.primitives.push_back(caruncles.finish());
  scene.primitives.push_back(tears.finish());
}

}  // namespace dermis::builtin_head
