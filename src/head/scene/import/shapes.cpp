// SPDX-License-Identifier: MIT
#include "head/scene/import/shapes.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "base/core/assert.h"
#include "head/scene/surface/tangents.h"

namespace dermis::scene {
namespace {

AssetData skin_scene(std::string name, Primitive primitive) {
  make_missing_normals(primitive);
  make_tangents(primitive);
  primitive.name = name;
  primitive.node = 0;
  primitive.has_uv = true;
  Material skin;
  skin.name = "skin";
  skin.skin = true;
  skin.metallic = 0;
  skin.roughness = 0.5f;
  skin.ior = 1.4f;
  AssetData scene;
  scene.name = std::move(name);
  scene.materials.push_back(skin);
  scene.primitives.push_back(std::move(primitive));
  return scene;
}

/// Appends two counter-clockwise triangles per cell of a grid whose rows of (n + 1) vertices start at `base`
/// and run downwards.
void append_grid(std::vector<std::uint32_t>& indices, std::uint32_t base, int n) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto at = [&](int x, int y) { return base + static_cast<std::uint32_t>(y * (n + 1) + x); };
      for (const std::uint32_t v :
           {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)})
        indices.push_back(v);
    }
  }
}

/// One side of the cube seen from outside: directions of u and v (down). right x up = outwards.
struct Side {
  glm::ivec3 right, up;
};
constexpr std::array<Side, 6> sides{{{{1, 0, 0}, {0, 1, 0}},    // +Z
                                     {{0, 0, -1}, {0, 1, 0}},   // +X
                                     {{-1, 0, 0}, {0, 1, 0}},   // -Z
                                     {{0, 0, 1}, {0, 1, 0}},    // -X
                                     {{1, 0, 0}, {0, 0, -1}},   // +Y
                                     {{1, 0, 0}, {0, 0, 1}}}};  // -Y

glm::ivec3 outwards(const Side& s) {
  return {s.right.y * s.up.z - s.right.z * s.up.y, s.right.z * s.up.x - s.right.x * s.up.z,
          s.right.x * s.up.y - s.right.y * s.up.x};
}

/// Returns a lattice point of the cube -n..n on the unit sphere. Depends on integers only, so sides agree to
/// the bit at their edges.
glm::dvec3 on_sphere(const glm::ivec3& lattice, int n) {
  const auto bend = [n](int i) {
    return std::abs(i) == n ? (i > 0 ? 1.0 : -1.0) : std::tan(0.25 * glm::pi<double>() * i / n);
  };
  return glm::normalize(glm::dvec3(bend(lattice.x), bend(lattice.y), bend(lattice.z)));
}

}  // namespace

AssetData plane(double size_m, const glm::dmat2& uv_transform, const glm::dvec2& uv_offset, int cells) {
  DERMIS_ASSERT_LT(0.0, size_m);
  DERMIS_ASSERT_LT(0, cells);
  Primitive primitive;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const glm::dvec2 s(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
      Vertex vertex;
      vertex.position_m = glm::vec3(glm::dvec3(size_m * (s.x - 0.5), size_m * (0.5 - s.y), 0));
      vertex.uv0 = glm::vec2(uv_transform * s + uv_offset);
      primitive.vertices.push_back(vertex);
    }
  }
  append_grid(primitive.indices, 0, cells);
  return skin_scene("plane", std::move(primitive));
}

AssetData ellipsoid(const glm::dvec3& radii_m, int subdivisions, double margin) {
  DERMIS_ASSERT_LT(0, subdivisions);
  DERMIS_ASSERT_LE(0.0, margin);
  DERMIS_ASSERT_LT(margin, 1.0 / 6);

  const int n = subdivisions;
  const double side = 1.0 / 3 - 2 * margin;
  Primitive primitive;

  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto base = static_cast<std::uint32_t>(primitive.vertices.size());
    const glm::dvec2 corner(static_cast<double>(s % 3) / 3 + margin, static_cast<double>(s / 3) / 2 + margin);
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        // Lattice points of -n..n in steps of 2, so that any n has its edges at +-n.
        const glm::ivec3 lattice =
            outwards(sides[s]) * n + sides[s].right * (2 * i - n) - sides[s].up * (2 * j - n);
        const glm::dvec3 unit = on_sphere(lattice, n);

        Vertex vertex;
        vertex.position_m = glm::vec3(unit * radii_m);
        vertex.normal = glm::vec3(glm::normalize(unit / radii_m));
        vertex.uv0 = glm::vec2(corner + side * glm::dvec2(i, j) / static_cast<double>(n));
        primitive.vertices.push_back(vertex);
      }
    }
    append_grid(primitive.indices, base, n);
  }
  return skin_scene("ellipsoid", std::move(primitive));
}

AssetData sphere(double radius_m, int subdivisions, double margin) {
  AssetData scene = ellipsoid(glm::dvec3(radius_m), subdivisions, margin);
  scene.name = scene.primitives[0].name = "sphere";
  return scene;
}

}  // namespace dermis::scene
