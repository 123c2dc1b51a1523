// SPDX-License-Identifier: MIT
#include "environment/body_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "base/core/cache.h"
#include "base/core/hash.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "head/scene/surface/open_border.h"
#include "rays/surface_point.h"

namespace dermis::environment {
namespace {

constexpr int shape_rays = 16;
constexpr double widest_sine2 = 0.5;  // of the cone: 45 degrees
constexpr double open_sine2 = 0.75;   // of the cone outwards: 60 degrees
constexpr double open_mm = 6;
constexpr double start_mm = 0.02;  // off the surface: past its own triangles
constexpr std::size_t shape_jobs = 64;
constexpr std::uint32_t shape_version = 3;  // of body_shape() and of the file
constexpr std::uint64_t most_shape_bytes = std::uint64_t{1} << 30;

/// Directions around +z: evenly over the squared sine, turned by the golden angle.
std::array<glm::dvec3, shape_rays> cone(double most_sine2) {
  std::array<glm::dvec3, shape_rays> rays;
  for (int i = 0; i < shape_rays; ++i) {
    const double sine2 = most_sine2 * (i + 0.5) / shape_rays;
    const double phi = i * std::numbers::pi * (3 - std::sqrt(5.0));
    rays[static_cast<std::size_t>(i)] = {std::sqrt(sine2) * std::cos(phi), std::sqrt(sine2) * std::sin(phi),
                                         std::sqrt(1 - sine2)};
  }
  return rays;
}

/// The axes at a vertex: two on its tangent plane, and its normal.
glm::dmat3 axes_at(const scene::Vertex& v) {
  const glm::dvec3 n(v.normal), side = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 t = glm::normalize(glm::cross(side, n));
  return {t, glm::cross(n, t), n};
}

/// Returns the mean depth along the normal at which rays leave the body: on a slab each ray has its
/// thickness.
float thickness_at(const rays::RayScene& rays, const scene::Vertex& v, double mm) {
  static const std::array<glm::dvec3, shape_rays> directions = cone(widest_sine2);
  const glm::dmat3 axes = axes_at(v);
  const glm::dvec3 start = glm::dvec3(v.position_m) - axes[2] * (start_mm / mm);

  double sum = 0;
  for (const glm::dvec3& d : directions) {
    const glm::dvec3 direction = axes * glm::dvec3(d.x, d.y, -d.z);
    const auto hit = rays.nearest_skin(
        {.origin_m = start, .direction = direction, .t_min_m = 0, .t_max_m = most_thickness_mm / mm / d.z});
    // A front side is met where skin is folded into itself: the body goes on there.
    const bool leaves = hit && glm::dot(rays::surface_point(rays.scene(), *hit).face_normal, direction) > 0;
    sum += leaves ? hit->t_m * mm * d.z : double{most_thickness_mm};
  }
  return static_cast<float>(std::min(sum / shape_rays + start_mm, double{most_thickness_mm}));
}

/// Returns the share of the directions around the normal that are open.
float openness_at(const rays::RayScene& rays, const scene::Vertex& v, double mm) {
  static const std::array<glm::dvec3, shape_rays> directions = cone(open_sine2);
  const glm::dmat3 axes = axes_at(v);
  const glm::dvec3 start = glm::dvec3(v.position_m) + axes[2] * (start_mm / mm);
  const auto open = std::count_if(directions.begin(), directions.end(), [&](const glm::dvec3& d) {
    return !rays.nearest_skin(
        {.origin_m = start, .direction = axes * d, .t_min_m = 0, .t_max_m = open_mm / mm});
  });
  return static_cast<float>(open) / shape_rays;
}

/// Without its distance from the border.
scene::VertexShape shape_at(const rays::RayScene& rays, const scene::Vertex& v, scene::Curvature curvature,
                            double mm) {
  if (curvature.mean_per_mm > 0) {
    const float open = openness_at(rays, v, mm);
    curvature.mean_per_mm *= open;
    curvature.difference_per_mm *= open;
  }
  return {.curvature = curvature, .thickness_mm = thickness_at(rays, v, mm)};
}

std::uint64_t shape_hash(const scene::AssetData& scene, const scene::SkinMesh& mesh) {
  dermis::Hash hash;
  hash.add(shape_version);
  hash.add(curvature_scales.narrow_mm);
  hash.add(curvature_scales.wide_mm);
  hash.add(scene.mm_per_unit);
  for (const scene::Vertex& v : mesh.vertices) {
    hash.bytes(&v.position_m, sizeof v.position_m);
    hash.bytes(&v.normal, sizeof v.normal);
  }
  hash.bytes(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
  for (const scene::Primitive& p : scene.primitives) {
    if (!rays::is_skin(scene, p)) continue;
    for (const scene::Vertex& v : p.vertices) hash.bytes(&v.position_m, sizeof v.position_m);
    hash.bytes(p.indices.data(), p.indices.size() * sizeof(std::uint32_t));
  }
  return hash.value();
}

/// Returns what is kept there, if it is as long as the mesh and every value is one that body_shape() can
/// give.
std::vector<scene::VertexShape> read_shape(const std::filesystem::path& file, std::size_t count) {
  const auto bytes = cache::read(file, most_shape_bytes);
  if (!bytes || bytes->size() != count * sizeof(scene::VertexShape)) return {};
  std::vector<scene::VertexShape> shape(count);
  std::memcpy(shape.data(), bytes->data(), bytes->size());
  for (const scene::VertexShape& v : shape)
    if (!(std::abs(v.curvature.mean_per_mm) <= 2 && v.curvature.difference_per_mm >= 0 &&
          v.curvature.difference_per_mm <= 2 && v.thickness_mm >= 0 && v.thickness_mm <= most_thickness_mm &&
          v.border_mm >= 0 && v.border_mm <= most_border_mm))
      return {};
  return shape;
}

}  // namespace

std::vector<scene::VertexShape> body_shape(const scene::AssetData& scene, const scene::SkinMesh& mesh) {
  Steps steps("the shape of the body", shape_jobs + 2);
  const scene::CurvatureStencil stencil =
      scene::curvature_stencil(mesh.vertices, mesh.indices, scene.mm_per_unit, curvature_scales);
  const std::vector<scene::Curvature> curvature =
      scene::curvatures(mesh.vertices, stencil, scene.mm_per_unit);
  steps.done();
  const std::vector<float> border_mm = scene::border_distances_mm(mesh, scene.mm_per_unit, most_border_mm);
  const rays::RayScene rays(scene);
  steps.done();

  std::vector<scene::VertexShape> shape(mesh.vertices.size());
  parallel_for(shape_jobs, [&](std::size_t job) {
    for (std::size_t v = job * shape.size() / shape_jobs; v < (job + 1) * shape.size() / shape_jobs; ++v) {
      shape[v] = shape_at(rays, mesh.vertices[v], curvature[v], scene.mm_per_unit);
      shape[v].border_mm = border_mm[v];
    }
    steps.done();
  });
  return shape;
}

std::vector<scene::VertexShape> cached_body_shape(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                                                  const std::filesystem::path& folder) {
  const std::filesystem::path file =
      folder.empty() ? folder : folder / fmt::format("occlusion-shape-{:016x}.bin", shape_hash(scene, mesh));
  if (std::vector<scene::VertexShape> found = read_shape(file, mesh.vertices.size()); !found.empty())
    return found;

  std::vector<scene::VertexShape> made = body_shape(scene, mesh);
  if (!file.empty()) {
    const auto* bytes = reinterpret_cast<const std::byte*>(made.data());
    cache::write(file, {bytes, bytes + made.size() * sizeof(scene::VertexShape)});
  }
  return made;
}

}  // namespace dermis::environment
