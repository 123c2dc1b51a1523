// SPDX-License-Identifier: MIT
// The metric of the unwrap: unwrap.h, from triangle_metric on.
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "base/core/assert.h"
#include "head/scene/surface/topology.h"
#include "head/scene/surface/unwrap.h"
#include "head/scene/surface/weld.h"

namespace dermis::scene {
namespace {

struct Eigenvalues {
  double small, large;
};

Eigenvalues eigenvalues(const glm::dvec3& g) {
  const double mean = 0.5 * (g.x + g.z), spread = std::hypot(0.5 * (g.x - g.z), g.y);
  const double large = mean + spread;
  // det / large, because mean - spread cancels for slivers.
  return {large > 0 ? (g.x * g.z - g.y * g.y) / large : 0, large};
}

struct TriangleMetric {
  glm::dvec3 g{0};
  double uv_area = 0;     ///< unit of unwrap squared
  double world_area = 0;  ///< mm^2
  bool valid = false;
};

std::vector<TriangleMetric> triangle_metrics(const SkinMesh& mesh, double mm_per_unit) {
  std::vector<TriangleMetric> metrics(mesh.indices.size() / 3);
  for (std::size_t t = 0; t < metrics.size(); ++t) {
    const std::uint32_t* corner = &mesh.indices[3 * t];
    const auto p = [&](int k) { return glm::dvec3(mesh.vertices[corner[k]].position_m) * mm_per_unit; };
    const auto uv = [&](int k) { return mesh.unwrap[corner[k]]; };
    TriangleMetric& m = metrics[t];
    m.g = triangle_metric(p(0), p(1), p(2), uv(0), uv(1), uv(2));
    m.valid = m.g.x > 0;
    m.uv_area = 0.5 * std::abs(uv_area2(uv(0), uv(1), uv(2)));
    m.world_area = 0.5 * glm::length(glm::cross(p(1) - p(0), p(2) - p(0)));
  }
  return metrics;
}

/// Drops slivers: they hold more noise than stretch, and g grows as 1 / thickness^2, so one would ruin the
/// mean at its corners.
void drop_outliers(std::vector<TriangleMetric>& metrics) {
  std::vector<double> scales;
  for (const TriangleMetric& m : metrics)
    if (m.valid) scales.push_back(std::pow(m.g.x * m.g.z - m.g.y * m.g.y, 0.25));
  if (scales.empty()) return;
  const auto middle = scales.begin() + static_cast<std::ptrdiff_t>(scales.size() / 2);
  std::nth_element(scales.begin(), middle, scales.end());
  for (TriangleMetric& m : metrics) {
    if (!m.valid) continue;
    const Eigenvalues e = eigenvalues(m.g);
    m.valid = std::sqrt(e.large) <= 32 * *middle && std::sqrt(std::max(e.small, 0.0)) >= 1e-3 * *middle;
  }
}

// Vertices share their mean if place, coordinates and chart agree. Each used vertex belongs to one chart.
std::vector<std::uint32_t> weld_for_metric(const SkinMesh& mesh) {
  const std::vector<std::uint32_t> place = weld_positions(mesh.vertices), coordinate = weld_uv(mesh.unwrap);
  std::vector<glm::dvec3> key;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) key.emplace_back(place[v], coordinate[v], 0);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) key[mesh.indices[i]].z = mesh.triangle_chart[i / 3];
  return weld_points(key, 1.0);
}

/// Raises the smaller eigenvalue to large / 300^2 by adding to the diagonal, and rescales where a float could
/// not hold the determinant. These are maps less than 1e-7 mm or more than 1,000 km wide.
glm::vec3 well_conditioned(const glm::dvec3& g) {
  constexpr double least = 1e-14, most = 1e18;  // mm^2
  const Eigenvalues e = eigenvalues(g);
  if (!(e.large > std::numeric_limits<double>::min() / least)) return {least, 0, least};

  const double lift = std::max(0.0, e.large / 9e4 - e.small);
  const double scale = std::clamp(e.large, least, most) / e.large;
  return glm::vec3((g + glm::dvec3(lift, 0, lift)) * scale);
}

/// Returns the value below which the fraction `share` of the weight lies; values are sorted.
double weighted_quantile(const std::vector<std::pair<double, double>>& sorted, double total, double share) {
  double sum = 0;
  for (const auto& [value, weight] : sorted) {
    sum += weight;
    if (sum >= share * total) return value;
  }
  return sorted.empty() ? 0 : sorted.back().first;
}

DensityStats density_stats(std::vector<std::pair<double, double>> value_and_weight) {
  if (value_and_weight.empty()) return {};
  std::sort(value_and_weight.begin(), value_and_weight.end());
  double total = 0, sum = 0;
  for (const auto& [value, weight] : value_and_weight) {
    total += weight;
    sum += value * weight;
  }
  return {sum / total,
          weighted_quantile(value_and_weight, total, 0.05),
          weighted_quantile(value_and_weight, total, 0.25),
          weighted_quantile(value_and_weight, total, 0.5),
          weighted_quantile(value_and_weight, total, 0.95),
          value_and_weight.back().first};
}

}  // namespace

glm::dvec3 triangle_metric(const glm::dvec3& a_mm, const glm::dvec3& b_mm, const glm::dvec3& c_mm,
                           const glm::vec2& uv_a, const glm::vec2& uv_b, const glm::vec2& uv_c) {
  const double det = uv_area2(uv_a, uv_b, uv_c);
  if (det == 0) return glm::dvec3(0);
  const glm::dvec3 e1 = b_mm - a_mm, e2 = c_mm - a_mm;
  const glm::dvec2 d1 = glm::dvec2(uv_b) - glm::dvec2(uv_a), d2 = glm::dvec2(uv_c) - glm::dvec2(uv_a);
  const glm::dvec3 dp_du = (d2.y * e1 - d1.y * e2) / det, dp_dv = (d1.x * e2 - d2.x * e1) / det;
  const glm::dvec3 g(glm::dot(dp_du, dp_du), glm::dot(dp_du, dp_dv), glm::dot(dp_dv, dp_dv));
  const bool valid = std::isfinite(g.x) && std::isfinite(g.y) && std::isfinite(g.z) &&
                     g.x * g.z - g.y * g.y > 1e-12 * g.x * g.z;
  return valid ? g : glm::dvec3(0);
}

void compute_metric(SkinMesh& mesh, double mm_per_unit) {
  DERMIS_ASSERT_EQ(mesh.unwrap.size(), mesh.vertices.size());
  std::vector<TriangleMetric> metrics = triangle_metrics(mesh, mm_per_unit);
  drop_outliers(metrics);

  const std::vector<std::uint32_t> weld = weld_for_metric(mesh);
  std::vector<glm::dvec4> sum(mesh.vertices.size(), glm::dvec4(0));  // weighted g, weight
  glm::dvec4 all(0);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const TriangleMetric& m = metrics[i / 3];
    if (!m.valid) continue;
    const glm::dvec4 weighted(m.g * m.uv_area, m.uv_area);
    sum[weld[mesh.indices[i]]] += weighted;
    all += weighted;
  }
  // A mesh without a valid triangle still needs a metric: a head of 0.3 m across the map.
  const glm::dvec3 mean = all.w > 0 ? glm::dvec3(all) / all.w : glm::dvec3(9e4, 0, 9e4);
  mesh.metric.clear();
  mesh.metric.reserve(mesh.vertices.size());
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const glm::dvec4& s = sum[weld[v]];
    mesh.metric.push_back(well_conditioned(s.w > 0 ? glm::dvec3(s) / s.w : mean));
  }
}

std::vector<std::uint32_t> metric_triangles(const SkinMesh& mesh, double mm_per_unit) {
  std::vector<TriangleMetric> metrics = triangle_metrics(mesh, mm_per_unit);
  drop_outliers(metrics);
  const std::vector<std::uint32_t> weld = weld_for_metric(mesh);
  std::vector<std::vector<std::uint32_t>> at_place(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    if (metrics[i / 3].valid) at_place[weld[mesh.indices[i]]].push_back(static_cast<std::uint32_t>(i / 3));

  std::vector<std::uint32_t> packed(mesh.vertices.size() + 1);
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    packed[v] = static_cast<std::uint32_t>(packed.size());
    // Real heads have a dozen; a hostile file must not cost the square of its size.
    const std::vector<std::uint32_t>& here = at_place[weld[v]];
    const std::size_t count = std::min<std::size_t>(here.size(), 64);
    packed.insert(packed.end(), here.begin(), here.begin() + static_cast<std::ptrdiff_t>(count));
  }
  packed[mesh.vertices.size()] = static_cast<std::uint32_t>(packed.size());
  return packed;
}

glm::dvec3 inverse_metric_cholesky(const glm::dvec3& g) {
  const double det = g.x * g.z - g.y * g.y;
  DERMIS_ASSERT_LT(0.0, det);
  const double a = std::sqrt(g.z / det);
  return {a, -g.y / (det * a), 1 / std::sqrt(g.z)};
}

UnwrapDensity unwrap_density(const SkinMesh& mesh, double mm_per_unit) {
  UnwrapDensity density;
  std::vector<std::pair<double, double>> mean, largest, least;
  for (const TriangleMetric& m : triangle_metrics(mesh, mm_per_unit)) {
    if (std::isfinite(m.world_area)) density.area_mm2 += m.world_area;
    if (!m.valid || !(m.world_area > 0)) continue;
    mean.emplace_back(std::pow(m.g.x * m.g.z - m.g.y * m.g.y, -0.25), m.world_area);
    const Eigenvalues e = eigenvalues(m.g);
    largest.emplace_back(1 / std::sqrt(e.small), m.world_area);
    least.emplace_back(1 / std::sqrt(e.large), m.world_area);
  }
  density.uv_per_mm = density_stats(std::move(mean));
  density.largest_uv_per_mm = density_stats(std::move(largest));
  density.least_uv_per_mm = density_stats(std::move(least));
  return density;
}

}  // namespace dermis::scene
