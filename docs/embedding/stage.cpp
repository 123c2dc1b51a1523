// SPDX-License-Identifier: MIT
#include "stage.h"

#include <dermis/asset_arrays.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace stage {
namespace {

constexpr int cells = 128;  // of a side of the mesh

// Returns the surface in a direction, m: an egg with something of a face, which looks along +z.
glm::dvec3 surface_m(const glm::dvec3& direction) {
  struct Feature {
    glm::dvec3 towards;
    double width, height_m;
  };
  constexpr std::array features{Feature{{0, -0.05, 1}, 0.14, 0.024},       // nose
                                Feature{{0, 0.14, 1}, 0.1, 0.006},         // its bridge
                                Feature{{0.33, 0.17, 0.9}, 0.17, -0.012},  // eyes
                                Feature{{-0.33, 0.17, 0.9}, 0.17, -0.012},
                                Feature{{0, 0.45, 0.9}, 0.4, 0.006},     // forehead
                                Feature{{0, -0.42, 0.9}, 0.12, 0.006},   // lips
                                Feature{{0, -0.75, 0.75}, 0.22, 0.01}};  // chin
  const glm::dvec3 d = glm::normalize(direction);
  double more_m = 0;
  for (const Feature& f : features) {
    const double off = glm::distance(d, glm::normalize(f.towards)) / f.width;
    more_m += f.height_m * std::exp(-off * off);
  }
  return d * (1 / glm::length(d / glm::dvec3(0.075, 0.11, 0.088)) + more_m);
}

// Octahedral coordinates, -1 to 1: the face is in the middle of the map, and the seam behind.
glm::dvec3 direction_of(double x, double y) {
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z >= 0) return {x, y, z};
  return {std::copysign(1 - std::abs(y), x), std::copysign(1 - std::abs(x), y), z};
}

glm::dvec3 normal_of(const glm::dvec3& direction) {
  const glm::dvec3 d = glm::normalize(direction),
                   other = std::abs(d.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0),
                   right = glm::normalize(glm::cross(other, d)), up = glm::cross(d, right);
  constexpr double step = 1e-4;
  return glm::normalize(glm::cross(surface_m(d + right * step) - surface_m(d - right * step),
                                   surface_m(d + up * step) - surface_m(d - up * step)));
}

std::array<float, 3> floats(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Head make_head() {
  Head head;
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column) {
      const double u = double(column) / cells, v = double(row) / cells;
      const glm::dvec3 d = direction_of(2 * u - 1, 1 - 2 * v);
      head.positions_m.push_back(floats(surface_m(d)));
      head.normals.push_back(floats(normal_of(d)));
      head.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    }

  // The diagonal of a cell lies along the fold of the octahedron, which differs by quarter.
  for (std::uint32_t row = 0; row < cells; ++row)
    for (std::uint32_t column = 0; column < cells; ++column) {
      const std::uint32_t a = row * (cells + 1) + column, b = a + 1, c = a + cells + 1, d = c + 1;
      const bool falls = (row < cells / 2) != (column < cells / 2);
      const std::array<std::uint32_t, 6> two = falls ? std::array<std::uint32_t, 6>{a, c, d, a, d, b}
                                                     : std::array<std::uint32_t, 6>{a, c, b, b, c, d};
      head.indices.insert(head.indices.end(), two.begin(), two.end());
    }
  return head;
}

dermis::Asset asset_of(const Head& head) {
  dermis::AssetArrays arrays;
  arrays.name = "egg";
  arrays.materials.resize(1);
  dermis::AssetMaterial& skin = arrays.materials.front();
  skin.name = "skin";
  skin.skin = true;
  skin.base_colour = {skin_albedo.r, skin_albedo.g, skin_albedo.b, 1};
  skin.metallic = 0;
  skin.roughness = skin_roughness;
  arrays.meshes = {{.name = "egg",
                    .material = 0,
                    .positions_m = head.positions_m,
                    .normals = head.normals,
                    .uv0 = head.uvs,
                    .indices = head.indices}};
  return dermis::Asset::from_arrays(arrays);
}

}  // namespace

std::array<double, 16> columns_of(const glm::dmat4& m) {
  std::array<double, 16> out{};
  std::copy_n(&m[0][0], 16, out.begin());
  return out;
}

Stage::Stage() : head(make_head()) {
  const dermis::Asset asset = asset_of(head);
  left = scene.add({.asset = asset, .name = "drawn by dermis"});
  right = scene.add({.asset = asset, .name = "drawn by the host"});
  scene.add_light({.light = {.colour = {lamp_irradiance.r, lamp_irradiance.g, lamp_irradiance.b},
                             .direction = {lamp_direction.x, lamp_direction.y, lamp_direction.z}}});
  turn(0);
}

void Stage::turn(std::uint64_t frame) {
  const double angle = 0.3 * std::sin(0.1 * static_cast<double>(frame));
  const auto place = [&](double x_m, double turned) {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(x_m, 0, 0));
    return columns_of(glm::rotate(moved, turned, glm::dvec3(0, 1, 0)));
  };
  scene.set_transform(left, place(-0.11, 0.2 + angle));
  scene.set_transform(right, place(0.11, -0.2 - angle));
}

dermis::RenderSettings settings() {
  dermis::RenderSettings s;
  s.lighting.ambient = 0;  // the lamp alone, so that the host's shading stays short
  s.quality.map_size = 256;
  s.quality.shadow_size = 512;
  s.quality.samples = 1;
  s.output.exposure_ev = 0;
  s.output.bloom = 0;
  return s;
}

glm::vec3 eye_m(std::uint64_t frame) {
  const double angle = -0.5 + 0.02 * static_cast<double>(frame);
  return {0.75 * std::sin(angle), 0.1, 0.75 * std::cos(angle)};
}

dermis::CameraMatrices camera(std::uint64_t frame, std::uint32_t width, std::uint32_t height) {
  const double near_m = 0.05, scale = 1 / std::tan(glm::radians(15.0));
  glm::dmat4 clip_from_camera(0);
  clip_from_camera[0][0] = scale * height / width;
  clip_from_camera[1][1] = -scale;
  clip_from_camera[2][3] = -1;
  clip_from_camera[3][2] = near_m;
  return {.camera_from_world =
              columns_of(glm::lookAt(glm::dvec3(eye_m(frame)), glm::dvec3(0, -0.01, 0), glm::dvec3(0, 1, 0))),
          .clip_from_camera = columns_of(clip_from_camera)};
}

glm::dmat4 shadow_from_world() {
  const glm::dvec3 travels = glm::normalize(glm::dvec3(lamp_direction));
  glm::dmat4 clip_from_lamp = glm::orthoRH_ZO(-0.3, 0.3, -0.3, 0.3, 0.5, 1.5);  // m
  for (int column = 0; column < 4; ++column) clip_from_lamp[column][1] = -clip_from_lamp[column][1];
  return clip_from_lamp * glm::lookAtRH(-travels, glm::dvec3(0), glm::dvec3(0, 1, 0));
}

glm::mat4 matrix_of(const std::array<double, 16>& columns) {
  glm::dmat4 m;
  std::copy(columns.begin(), columns.end(), &m[0][0]);
  return glm::mat4(m);
}

}  // namespace stage
