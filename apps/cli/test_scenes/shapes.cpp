// SPDX-License-Identifier: MIT
#include "cli/test_scenes/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "head/scene/import/shapes.h"
#include "head/scene/surface/tangents.h"

namespace dermis::cli::test_scenes {
namespace {

using std::numbers::pi;

/// A piece of a surface over 0..1 x 0..1, seen from the side on which its second direction lies to the left
/// of its first, and its rectangle of the unwrap.
struct Patch {
  int across = 1, down = 1;  ///< cells
  glm::dvec2 corner{0}, size{1};
  std::function<glm::dvec3(double, double)> point_m;
};

scene::Material skin(float grey) {
  scene::Material material;
  material.name = grey > 0 ? "skin" : "dark skin";
  material.skin = true;
  material.metallic = 0;
  material.roughness = 0.5f;
  material.ior = 1.4f;
  material.base_colour = glm::vec4(glm::vec3(grey), 1);
  return material;
}

// Where a side of a patch shrinks to a point, triangles have none.
bool has_area(const scene::Primitive& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto at = [&](std::size_t k) { return mesh.vertices[triangle[k]].position_m; };
  return at(0) != at(1) && at(1) != at(2) && at(2) != at(0);
}

void append(scene::Primitive& to, const Patch& patch) {
  const auto base = static_cast<std::uint32_t>(to.vertices.size());
  for (int j = 0; j <= patch.down; ++j)
    for (int i = 0; i <= patch.across; ++i) {
      const glm::dvec2 at(double(i) / patch.across, double(j) / patch.down);
      scene::Vertex vertex;
      vertex.position_m = glm::vec3(patch.point_m(at.x, at.y));
      vertex.normal = glm::vec3(0);  // computed, smooth
      vertex.uv0 = glm::vec2(patch.corner + at * patch.size);
      to.vertices.push_back(vertex);
    }

  const auto row = static_cast<std::uint32_t>(patch.across + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(patch.down); ++j)
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = base + j * row + i, b = a + 1, c = a + row, d = c + 1;
      for (const std::array<std::uint32_t, 3>& triangle : {std::array{a, b, d}, std::array{a, d, c}})
        if (has_area(to, triangle)) to.indices.insert(to.indices.end(), triangle.begin(), triangle.end());
    }
}

/// One head of one mesh.
scene::AssetData of(const std::string& name, const std::vector<Patch>& patches) {
  scene::AssetData made;
  made.name = name;
  made.materials.push_back(skin(0.8f));
  scene::Primitive mesh{.name = name, .node = 0, .has_uv = true};
  for (const Patch& patch : patches) append(mesh, patch);
  scene::make_missing_normals(mesh);
  scene::make_tangents(mesh);
  made.primitives.push_back(std::move(mesh));
  return made;
}

/// A map of one black texel: skin that reflects nothing at its surface.
int add_matt_map(scene::AssetData& made) {
  made.images.push_back({"matt", std::make_shared<const image::Image8>(
                                     image::Image8{.width = 1, .height = 1, .rgba = {0, 0, 0, 255}})});
  return static_cast<int>(made.images.size()) - 1;
}

/// 1 in the middle of -1..1, falling smoothly to 0 at both ends.
double bump(double x) { return std::abs(x) < 1 ? std::pow(std::cos(pi / 2 * x), 2) : 0; }

}  // namespace

scene::AssetData lit_half_plane(LitHalf lit, double edge_m) {
  constexpr double half_m = 0.15;
  constexpr int cells = 16;
  scene::AssetData made;
  made.name = "lit edge";
  const int matt = add_matt_map(made);
  const double edge = (edge_m + half_m) / (2 * half_m);

  for (const bool is_lit : {true, false}) {
    const double from = is_lit ? 0 : edge, to = is_lit ? edge : 1;
    // Along the axis that the edge cuts, and beside it.
    const auto place = [=](double along, double beside) {
      const double a = 2 * half_m * (from + along * (to - from)) - half_m, b = 2 * half_m * beside - half_m;
      return lit == LitHalf::below_x ? glm::dvec3(a, b, 0) : glm::dvec3(-b, a, 0);
    };
    Patch patch{
        .across = cells, .down = cells, .corner = {from, 0}, .size = {to - from, 1}, .point_m = place};

    scene::Primitive mesh{.name = is_lit ? "lit" : "dark", .node = 0, .has_uv = true};
    mesh.material = static_cast<int>(made.materials.size());
    append(mesh, patch);
    scene::make_missing_normals(mesh);
    scene::make_tangents(mesh);
    made.materials.push_back(skin(is_lit ? 1 : 0));
    made.materials.back().skin_settings.mix = 1.0f;
    made.materials.back().skin_settings.specular.image = matt;
    made.primitives.push_back(std::move(mesh));
  }
  return made;
}

scene::AssetData nose_on_cheek() {
  const auto point = [](double s, double t) {
    const double x = 0.2 * (s - 0.5), y = 0.2 * (t - 0.5);
    return glm::dvec3(x, y, 0.028 * bump(x / 0.016) * bump(y / 0.045));
  };
  return of("nose before a cheek", {{.across = 160, .down = 96, .point_m = point}});
}

scene::AssetData thin_lens() {
  scene::AssetData lens = scene::ellipsoid({0.02, 0.032, 0.0015}, 48);
  lens.name = "thin ear";
  return lens;
}

scene::AssetData open_curl() {
  constexpr double inner_m = 0.006, thickness_m = 0.003, half_length_m = 0.025, rim_m = thickness_m / 2,
                   middle_m = inner_m + rim_m, outer_m = inner_m + thickness_m, first = 0.25 * pi,
                   last = 1.75 * pi;
  constexpr int around = 192;
  const auto at = [](double radius, double angle) {
    return radius * glm::dvec2(std::cos(angle), std::sin(angle));
  };

  // Half of the section, from the middle of the first rim to that of the last: along the outer arc or along
  // the inner one.
  const auto half = [=](double s, double arc_m, double outwards) {
    const double arc = arc_m * (last - first), rim = pi / 2 * rim_m, length = s * (arc + 2 * rim) - rim;
    if (length >= 0 && length <= arc) return at(arc_m, first + length / arc_m);
    const bool at_first = length < 0;
    const double angle = at_first ? first : last, turn = (at_first ? -length : length - arc) / rim_m;
    return at(middle_m + outwards * rim_m * std::cos(turn), angle) +
           at(rim_m * std::sin(turn), angle + (at_first ? -pi / 2 : pi / 2));
  };
  // The whole of it, seen from outside. Cells of walls and lids meet to the bit.
  const auto section = [=](double s) {
    const int i = static_cast<int>(std::lround(s * around)) % around;
    return 2 * i <= around ? half(2.0 * i / around, outer_m, 1)
                           : half(2.0 * (around - i) / around, inner_m, -1);
  };

  const auto wall = [=](double s, double t) {
    const glm::dvec2 p = section(s);
    return glm::dvec3(p.x, half_length_m * (1 - 2 * t), p.y);
  };
  const auto lid = [=](double side) {
    return [=](double s, double t) {
      const bool outer = (t > 0.5) == (side > 0);
      const glm::dvec2 p = section(outer ? s / 2 : 1 - s / 2);
      return glm::dvec3(p.x, side * half_length_m, p.y);
    };
  };
  const auto strip = [&](double side, double v) {
    return Patch{
        .across = around / 2, .down = 1, .corner = {0.02, v}, .size = {0.5, 0.04}, .point_m = lid(side)};
  };
  return of("open curl",
            {{.across = around, .down = 48, .corner = {0.02, 0.02}, .size = {0.96, 0.8}, .point_m = wall},
             strip(1, 0.86),
             strip(-1, 0.94)});
}

scene::AssetData fringe() {
  constexpr int fingers = 9;
  constexpr double height_m = 0.06, between_m = 0.008, width = 1.0 / fingers;
  std::vector<Patch> patches;
  for (int k = 0; k < fingers; ++k) {
    const double radius_m = (0.4 + 1.1 * k / (fingers - 1)) / 1000, lean = std::tan(0.06 * k),
                 x_m = between_m * (k - (fingers - 1) / 2.0);
    const auto point = [=](double s, double t) {
      // A spindle: round, and closed at both ends.
      const double y = height_m * (0.5 - t),
                   r = radius_m * std::sqrt(std::max(0.0, 1 - std::pow(2 * t - 1, 8)));
      const double angle = -2 * pi * std::fmod(s, 1.0);
      return glm::dvec3(x_m + lean * y + r * std::sin(angle), y, r * std::cos(angle));
    };
    patches.push_back({.across = 24,
                       .down = 48,
                       .corner = {(k + 0.1) * width, 0.02},
                       .size = {0.8 * width, 0.96},
                       .point_m = point});
  }
  return of("fringe", patches);
}

}  // namespace dermis::cli::test_scenes
