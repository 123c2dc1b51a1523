// SPDX-License-Identifier: MIT
// Teeth, gums and tongue. Crowns: Nelson: Wheeler's Dental Anatomy, Physiology and Occlusion, 10th ed., 2015,
// tables of measurements (width x height, mm): upper 8.5 x 10.5, 6.5 x 9, 7.5 x 10, 7 x 8.5; lower 5 x 9,
// 5.5 x 9.5, 7 x 11, 7 x 8.5.
#include <array>
#include <numbers>

#include "head/builtin_head/parts.h"

namespace dermis::builtin_head {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

struct Crown {
  float width_mm, height_mm, depth_mm;
};
constexpr std::array<Crown, 5> upper = {
    {{8.5f, 10.5f, 6.5f}, {6.5f, 9.0f, 6.0f}, {7.5f, 10.0f, 7.5f}, {7.0f, 8.5f, 9.0f}, {6.8f, 8.0f, 9.0f}}};
constexpr std::array<Crown, 5> lower = {
    {{5.0f, 9.0f, 5.5f}, {5.5f, 9.5f, 6.0f}, {7.0f, 10.5f, 7.5f}, {7.0f, 8.5f, 8.0f}, {7.0f, 8.0f, 8.5f}}};

// An arch: an ellipse in the x, z plane, and the height of the line along the crowns' edges.
struct Arch {
  float half_width, length, front_z, edge_y, up;  // up: direction from the edge to the gum
  vec3 at(float angle) const {
    return {half_width * std::sin(angle), edge_y, front_z - length * (1 - std::cos(angle))};
  }
};
constexpr Arch upper_arch{27.0f, 34.0f, 86.5f, -70.5f, 1.0f}, lower_arch{25.0f, 33.0f, 83.6f, -70.4f, -1.0f};

float signed_power(float x, float power) { return std::copysign(std::pow(std::abs(x), power), x); }

// A rounded block, broader at the edge than at the gum.
void add_crown(PartMesh& mesh, const Arch& arch, float angle, const Crown& c) {
  constexpr int columns = 9, rows = 6;
  const vec3 edge = arch.at(angle), ahead = arch.at(angle + 0.01f) - arch.at(angle - 0.01f);
  const vec3 x = glm::normalize(ahead), y(0, arch.up, 0), z = glm::normalize(vec3(-x.z, 0, x.x));
  const vec3 out = z.z < 0 && std::abs(angle) < 1 ? -z : z;
  const vec3 centre = edge + y * (0.5f * c.height_mm) - out * (0.5f * c.depth_mm);

  std::uint32_t first = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float a = 2 * pi * static_cast<float>(i) / (columns - 1),
                  b = pi * (static_cast<float>(j) / (rows - 1) - 0.5f);
      const vec3 d(signed_power(std::sin(a), 0.6f) * signed_power(std::cos(b), 0.5f),
                   signed_power(std::sin(b), 0.6f),
                   signed_power(std::cos(a), 0.6f) * signed_power(std::cos(b), 0.5f));
      const vec3 n(signed_power(std::sin(a), 1.4f) * signed_power(std::cos(b), 1.5f),
                   signed_power(std::sin(b), 1.4f),
                   signed_power(std::cos(a), 1.4f) * signed_power(std::cos(b), 1.5f));
      // Narrower at the gum; thin at the edge.
      const float taper = 1.0f - 0.13f * (0.5f + 0.5f * d.y),
                  thin = 0.55f + 0.45f * smooth_step(-1.0f, 0.4f, d.y);
      const vec3 p =
          centre + 0.5f * (x * (d.x * c.width_mm * 0.98f * taper) + y * (d.y * c.height_mm) +
                           out * ((d.z > 0 ? 1.0f - 0.25f * (1 - thin) : thin) * d.z * c.depth_mm));
      const std::uint32_t id = mesh.add(p, x * n.x + y * n.y + out * n.z,
                                        {static_cast<float>(i) / columns, static_cast<float>(j) / rows});
      if (i == 0 && j == 0) first = id;
    }
  }
  mesh.grid(first, columns, rows, glm::dot(glm::cross(x, y), out) < 0);
}

void add_row(PartMesh& mesh, const Arch& arch, const std::array<Crown, 5>& crowns) {
  for (const float side : {1.0f, -1.0f}) {
    float angle = 0;
    for (const Crown& c : crowns) {
      // The crown's middle is half its width further along the arch.
      const auto per_radian = [&](float a) { return glm::length(arch.at(a + 0.01f) - arch.at(a)) / 0.01f; };
      const float half_angle = 0.5f * c.width_mm / per_radian(angle);
      add_crown(mesh, arch, side * (angle + half_angle), c);
      angle += 2 * half_angle;
    }
  }
}

// A ridge along the arch that the crowns stand in.
void add_gum(PartMesh& mesh, const Arch& arch) {
  constexpr int along = 21, around = 9;
  std::uint32_t first = 0;
  for (int j = 0; j < along; ++j) {
    const float angle = 1.25f * (2.0f * static_cast<float>(j) / (along - 1) - 1.0f);
    const vec3 p = arch.at(angle), ahead = arch.at(angle + 0.01f) - p;
    const vec3 out = glm::normalize(vec3(-ahead.z, 0, ahead.x)) * (ahead.x > 0 ? 1.0f : -1.0f);
    for (int i = 0; i < around; ++i) {
      const float a = 2 * pi * static_cast<float>(i) / (around - 1);
      const vec3 d = out * std::cos(a) + vec3(0, std::sin(a), 0);
      const vec3 centre = p + vec3(0, 11.5f * arch.up, 0) - 4.0f * out;
      const std::uint32_t id = mesh.add(centre + out * (4.4f * std::cos(a)) + vec3(0, 4.2f * std::sin(a), 0),
                                        d, {static_cast<float>(i) / around, static_cast<float>(j) / along});
      if (i == 0 && j == 0) first = id;
    }
  }
  mesh.grid(first, around, along, true);
}

void add_tongue(PartMesh& mesh) {
  constexpr int columns = 13, rows = 9;
  const vec3 centre(0, -82, 56), radii(17.5f, 9.0f, 22.0f);
  std::uint32_t first = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float a = 2 * pi * static_cast<float>(i) / (columns - 1),
                  b = pi * (static_cast<float>(j) / (rows - 1) - 0.5f);
      const vec3 d(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
      vec3 p = centre + d * radii;
      p.y -= 2.0f * std::exp(-p.x * p.x / 12.0f) * std::max(d.y, 0.0f);  // the furrow
      const std::uint32_t id =
          mesh.add(p, d / radii, {static_cast<float>(i) / columns, static_cast<float>(j) / rows});
      if (i == 0 && j == 0) first = id;
    }
  }
  mesh.grid(first, columns, rows, false);
}

scene::Material wet(const char* name, const vec4& colour, float roughness, float ior) {
  scene::Material m;
  m.name = name;
  m.base_colour = colour;
  m.metallic = 0;
  m.roughness = roughness;
  m.ior = ior;
  return m;
}

}  // namespace

void add_teeth(scene::AssetData& scene) {
  const int enamel = static_cast<int>(scene.materials.size());
  scene.materials.push_back(wet("teeth", {0.68f, 0.55f, 0.40f, 1}, 0.16f, 1.62f));
  scene.materials.push_back(wet("gums and tongue", {0.36f, 0.115f, 0.10f, 1}, 0.30f, 1.4f));

  // The lips and what they open onto keep most of the surroundings away.
  const int openness = add_openness(scene, "built-in mouth, openness", 0.35f);
  for (const int material : {enamel, enamel + 1})
    scene.materials[static_cast<std::size_t>(material)].occlusion_map.image = openness;

  PartMesh upper_teeth("upper teeth", enamel), lower_teeth("lower teeth", enamel);
  add_row(upper_teeth, upper_arch, upper);
  add_row(lower_teeth, lower_arch, lower);
  PartMesh palate("upper gum", enamel + 1), floor("lower gum and tongue", enamel + 1);
  add_gum(palate, upper_arch);
  add_gum(floor, lower_arch);
  add_tongue(floor);
  for (PartMesh* part : {&upper_teeth, &lower_teeth, &palate, &floor})
    scene.primitives.push_back(part->finish());
}

}  // namespace dermis::builtin_head
