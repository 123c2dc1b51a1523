// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <numbers>

#include "truth/reference/shapes.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

/// Adds a sheet of (columns x rows) squares; `at` gives its points over 0..1 x 0..1, in mm, and normals.
/// Counter- clockwise as seen from where the normals point, if at(u, v) turns from u to v like that.
void add_sheet(scene::Primitive& p, int columns, int rows,
               const std::function<void(double u, double v, glm::dvec3& at_mm, glm::dvec3& normal)>& at) {
  const auto first = static_cast<std::uint32_t>(p.vertices.size());
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      glm::dvec3 mm(0), normal(0, 0, 1);
      at(double(i) / columns, double(j) / rows, mm, normal);
      scene::Vertex v;
      v.position_m = glm::vec3(mm * 1e-3);
      v.normal = glm::vec3(normal);
      p.vertices.push_back(v);
    }

  const auto width = static_cast<std::uint32_t>(columns + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t a = first + j * width + i, b = a + 1, c = a + width, d = c + 1;
      p.indices.insert(p.indices.end(), {a, b, d, a, d, c});
    }
}

/// A flat sheet from `corner` along two edges; its normal is their cross product.
void add_plane(scene::Primitive& p, const glm::dvec3& corner, const glm::dvec3& along_u,
               const glm::dvec3& along_v) {
  const glm::dvec3 normal = glm::normalize(glm::cross(along_u, along_v));
  add_sheet(p, 1, 1, [&](double u, double v, glm::dvec3& at, glm::dvec3& n) {
    at = corner + u * along_u + v * along_v;
    n = normal;
  });
}

/// The six sides of a box; inwards: as seen from inside.
void add_box(scene::Primitive& p, const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 x(high.x - low.x, 0, 0), y(0, high.y - low.y, 0), z(0, 0, high.z - low.z);
  add_plane(p, low, y, x);
  add_plane(p, low, z, y);
  add_plane(p, low, x, z);
  add_plane(p, low + z, x, y);
  add_plane(p, low + x, y, z);
  add_plane(p, low + y, z, x);
}

/// side: +1 outside, -1 inside, which is seen from its centre.
void add_sphere(scene::Primitive& p, const glm::dvec3& centre, double radius, double side) {
  add_sheet(p, 192, 96, [&](double u, double v, glm::dvec3& at, glm::dvec3& n) {
    const double phi = 2 * pi * u * side, theta = pi * (1 - v);
    const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    at = centre + radius * d;
    n = side * d;
  });
}

/// Along y, closed at both ends.
void add_cylinder(scene::Primitive& p, const glm::dvec3& centre, double radius, double half, double side) {
  constexpr int around = 192;
  const auto edge = [&](double u) {
    const double phi = -2 * pi * u * side;
    return glm::dvec3(std::cos(phi), 0, std::sin(phi));
  };
  add_sheet(p, around, 16, [&](double u, double v, glm::dvec3& at, glm::dvec3& n) {
    n = side * edge(u);
    at = centre + radius * edge(u) + glm::dvec3(0, half * (2 * v - 1), 0);
  });
  for (const double end : {-1.0, 1.0})
    add_sheet(p, around, 1, [&](double u, double v, glm::dvec3& at, glm::dvec3& n) {
      n = glm::dvec3(0, side * end, 0);
      at = centre + radius * (end < 0 ? v : 1 - v) * edge(u) + glm::dvec3(0, half * end, 0);
    });
}

void add_saddle(scene::Primitive& p, double radius, double reach) {
  const double half = std::min(reach, 1.5 * radius), low = -half * half / (2 * radius) - reach;
  const auto height = [&](double x, double y) { return (y * y - x * x) / (2 * radius); };
  add_sheet(p, 96, 96, [&](double u, double v, glm::dvec3& at, glm::dvec3& n) {
    const double x = half * (2 * u - 1), y = half * (2 * v - 1);
    at = {x, y, height(x, y)};
    n = glm::normalize(glm::dvec3(x / radius, -y / radius, 1));
  });

  // Walls from the rim down, and the bottom.
  const glm::dvec2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  for (int k = 0; k < 4; ++k) {
    const glm::dvec2 a = corners[k], b = corners[(k + 1) % 4];
    add_sheet(p, 96, 1, [&](double u, double v, glm::dvec3& at, glm::dvec3& n) {
      const glm::dvec2 xy = glm::mix(a, b, u);
      at = {xy, glm::mix(low, height(xy.x, xy.y), v)};
      n = glm::dvec3((b - a).y, -(b - a).x, 0) / (2 * half);
    });
  }
  add_plane(p, {-half, -half, low}, {0, 2 * half, 0}, {2 * half, 0, 0});
}

/// The edge lies along y at x = distance, z = 0; the upper plane is z = 0.
void add_wedge(scene::Primitive& p, double distance, double angle_deg, double reach) {
  const double angle = angle_deg * pi / 180, length = distance + reach;
  const glm::dvec3 edge(distance, -reach, 0), along(0, 2 * reach, 0);
  const glm::dvec3 top(-length, 0, 0), below(-length * std::cos(angle), 0, -length * std::sin(angle));
  add_plane(p, edge, along, top);
  add_plane(p, edge, below, along);
  add_plane(p, edge + top, along, below - top);
  for (const double end : {0.0, 1.0}) {
    const auto a = static_cast<std::uint32_t>(p.vertices.size());
    for (const glm::dvec3& at : {edge, edge + top, edge + below}) {
      scene::Vertex v;
      v.position_m = glm::vec3((at + end * along) * 1e-3);
      v.normal = {0, end > 0 ? 1.0f : -1.0f, 0};
      p.vertices.push_back(v);
    }
    if (end > 0)
      p.indices.insert(p.indices.end(), {a, a + 2, a + 1});
    else
      p.indices.insert(p.indices.end(), {a, a + 1, a + 2});
  }
}

}  // namespace

scene::AssetData mesh_of(const Body& body, double reach) {
  scene::AssetData made;
  made.name = std::string(shape_names()[static_cast<std::size_t>(body.shape)]);
  made.materials.push_back({.name = "skin", .skin = true});
  scene::Primitive p{.name = made.name, .has_uv = true};

  const double size = body.size_mm, wide = size + reach;
  switch (body.shape) {
    case Shape::sphere: add_sphere(p, {0, 0, -size}, size, 1); break;
    case Shape::cylinder: add_cylinder(p, {0, 0, -size}, size, wide, 1); break;
    case Shape::bowl:
      add_sphere(p, {0, 0, size}, size, -1);
      add_box(p, {-wide, -wide, size - wide}, {wide, wide, size + wide});
      break;
    case Shape::groove:
      add_cylinder(p, {0, 0, size}, size, wide, -1);
      add_box(p, {-wide, -wide - reach, size - wide}, {wide, wide + reach, size + wide});
      break;
    case Shape::saddle: add_saddle(p, size, reach); break;
    case Shape::slab: add_box(p, {-reach, -reach, -size}, {reach, reach, 0}); break;
    case Shape::wedge: add_wedge(p, size, body.angle_deg, reach); break;
  }
  made.primitives.push_back(std::move(p));
  return made;
}

}  // namespace dermis::reference
