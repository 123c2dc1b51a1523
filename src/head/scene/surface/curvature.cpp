// SPDX-License-Identifier: MIT
#include "head/scene/surface/curvature.h"

#include <algorithm>
#include <cmath>

#include "base/core/parallel.h"
#include "head/scene/surface/weld.h"

namespace dermis::scene {
namespace {

constexpr double reach_in_scales = 2.5;       // 4 % of a Gaussian on a plane lies outside
constexpr std::size_t most_collected = 2048;  // of a neighbourhood, before the selection
constexpr float most_curvature_per_mm = 2;
constexpr std::size_t curvature_jobs = 16;

std::size_t first_of_job(std::size_t job, std::size_t count) { return job * count / curvature_jobs; }

/// The mesh with vertices of one place joined.
struct WeldedMesh {
  std::vector<std::uint32_t> id;           // per vertex
  std::vector<std::uint32_t> one;          // per place: the first of its vertices
  std::vector<std::uint32_t> first, next;  // per place, packed: the places at the other end of its edges
  std::vector<double> area_mm2;            // per place: a third of its triangles
};

void fill_edges(WeldedMesh& mesh, std::span<const std::uint32_t> indices) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(2 * indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const std::uint32_t a = mesh.id[indices[i]], b = mesh.id[indices[i % 3 == 2 ? i - 2 : i + 1]];
    if (a == b) continue;
    edges.emplace_back(a, b);
    edges.emplace_back(b, a);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  mesh.first.assign(mesh.one.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++mesh.first[from + 1];
    mesh.next.push_back(to);
  }
  for (std::size_t i = 1; i < mesh.first.size(); ++i) mesh.first[i] += mesh.first[i - 1];
}

WeldedMesh welded(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                  double mm_per_unit) {
  WeldedMesh mesh;
  mesh.id = weld_positions(vertices);
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (mesh.id[v] == mesh.one.size()) mesh.one.push_back(v);

  mesh.area_mm2.assign(mesh.one.size(), 0);
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const auto at = [&](std::size_t k) {
      return glm::dvec3(vertices[indices[t + k]].position_m) * mm_per_unit;
    };
    const double third = glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 6;
    for (std::size_t k = 0; k < 3; ++k) mesh.area_mm2[mesh.id[indices[t + k]]] += third;
  }
  fill_edges(mesh, indices);
  return mesh;
}

/// Collects neighbourhoods of one mesh; one per thread.
class Collector {
 public:
  Collector(const WeldedMesh& mesh, std::span<const Vertex> vertices, double mm_per_unit,
            const CurvatureScales& scales)
      : mesh_(mesh), vertices_(vertices), mm_(mm_per_unit), scales_(scales), seen_(mesh.one.size(), 0) {}

  /// Returns what counts for a place; it is among its own neighbours.
  std::vector<CurvatureNeighbour> of(std::uint32_t place) {
    collect(place);
    chosen_.clear();
    choose(place, scales_.narrow_mm);
    choose(place, scales_.wide_mm);

    double sum = 0;
    for (const auto& [other, weight] : chosen_) sum += weight;
    std::vector<CurvatureNeighbour> neighbours;
    for (const auto& [other, weight] : chosen_)
      neighbours.push_back({mesh_.one[other], sum > 0 ? static_cast<float>(weight / sum) : 0.0f});
    return neighbours;
  }

 private:
  double distance_mm(std::uint32_t a, std::uint32_t b) const {
    return mm_ * glm::length(glm::dvec3(vertices_[mesh_.one[a]].position_m) -
                             glm::dvec3(vertices_[mesh_.one[b]].position_m));
  }

  /// Fills found_: the place, its ring, and all that edges reach within the wide scale, in order of rings;
  /// and how far each is.
  void collect(std::uint32_t place) {
    ++round_;
    found_.assign(1, place);
    distances_mm_.assign(1, 0.0);
    seen_[place] = round_;
    const double reach_mm = reach_in_scales * scales_.wide_mm;
    for (std::size_t at = 0; at < found_.size() && found_.size() < most_collected; ++at)
      for (std::uint32_t e = mesh_.first[found_[at]]; e < mesh_.first[found_[at] + 1]; ++e) {
        const std::uint32_t other = mesh_.next[e];
        if (seen_[other] == round_) continue;
        const double far_mm = distance_mm(place, other);
        if (at > 0 && far_mm > reach_mm) continue;
        seen_[other] = round_;
        found_.push_back(other);
        distances_mm_.push_back(far_mm);
      }
  }

  /// Where edges are longer than the scale, the neighbourhood is as wide as they are.
  double scale_at(std::uint32_t place, double scale_mm) const {
    const std::size_t ring = mesh_.first[place + 1] - mesh_.first[place];
    if (ring == 0) return scale_mm;
    double mean_mm = 0;
    for (std::size_t i = 1; i <= ring; ++i) mean_mm += distances_mm_[i];
    return std::max(scale_mm, 0.7 * mean_mm / static_cast<double>(ring));
  }

  /// Adds the neighbours of one Gaussian to chosen_. The change of normals that fits all neighbours best is
  /// the mean of those of both Gaussians, weighted by the squares of the distances that each spans. Dividing
  /// by the squared scale makes it their plain mean.
  void choose(std::uint32_t place, double scale_given_mm) {
    constexpr std::size_t most = most_curvature_neighbours / 2;
    const double scale_mm = scale_at(place, scale_given_mm);
    const auto distance = [&](std::size_t i) { return distances_mm_[i] / scale_mm; };
    weights_.clear();
    double sum = 0;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const double d = distance(i);
      weights_.push_back(mesh_.area_mm2[found_[i]] * std::exp(-0.5 * d * d));
      sum += weights_.back();
    }
    if (!(sum > 0)) return;

    const double part = 1 / (scale_mm * scale_mm);
    if (found_.size() <= most) {
      for (std::size_t i = 0; i < found_.size(); ++i)
        chosen_.emplace_back(found_[i], part * weights_[i] / sum);
      return;
    }

    // Of many, `most` in proportion to what they add to the fit: its sums are over squared distances, so far
    // neighbours decide. A neighbour that is chosen more often weighs less.
    const auto more_often = [&](std::size_t i) { return 1 + distance(i) * distance(i); };
    double all = 0, reached = 0, weight = 0;
    for (std::size_t i = 0; i < found_.size(); ++i) all += weights_[i] * more_often(i);
    const std::size_t before = chosen_.size();
    std::size_t step = 0;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      reached += weights_[i] * more_often(i);
      std::size_t count = 0;
      for (; step < most && (static_cast<double>(step) + 0.5) * all <= reached * most; ++step) ++count;
      if (count == 0) continue;
      chosen_.emplace_back(found_[i], static_cast<double>(count) / more_often(i));
      weight += chosen_.back().second;
    }
    for (std::size_t i = before; i < chosen_.size(); ++i) chosen_[i].second *= part / weight;
  }

  const WeldedMesh& mesh_;
  std::span<const Vertex> vertices_;
  double mm_;
  CurvatureScales scales_;
  std::vector<std::uint32_t> seen_, found_;
  std::vector<double> distances_mm_, weights_;            // of found_; the weights for one Gaussian
  std::vector<std::pair<std::uint32_t, double>> chosen_;  // places and their weights
  std::uint32_t round_ = 0;
};

/// The best symmetric 2 x 2 matrix S with m = S x + const, from weighted sums about the means, as mean and
/// half difference of its eigenvalues.
Curvature eigenvalues(double xx, double xy, double yy, double b0, double b1, double b2) {
  // Normal equations of sum w |m - S x|^2 for S = [[a, b], [b, c]]:
  //   a xx + b xy = b0,  a xy + b (xx + yy) + c xy = b1,  b xy + c yy = b2
  const double determinant = (xx + yy) * (xx * yy - xy * xy);
  if (!(determinant > 1e-9 * (xx + yy) * (xx + yy) * (xx + yy))) return {};
  const double b = (xx * yy * b1 - xy * (yy * b0 + xx * b2)) / determinant;
  const double a = (b0 - b * xy) / xx, c = (b2 - b * xy) / yy;

  const auto cut = [](double x, float least) {
    return std::clamp(static_cast<float>(x), least, most_curvature_per_mm);
  };
  return {cut(0.5 * (a + c), -most_curvature_per_mm), cut(std::hypot(0.5 * (a - c), b), 0)};
}

Curvature curvature_at(std::span<const Vertex> vertices, std::uint32_t v,
                       std::span<const CurvatureNeighbour> neighbours, double mm_per_unit) {
  if (neighbours.size() < 3) return {};
  const glm::dvec3 n(vertices[v].normal), p(vertices[v].position_m);
  const glm::dvec3 side = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 t = glm::normalize(glm::cross(side, n)), u = glm::cross(n, t);

  // Weighted means of positions x and normals m on the tangent plane.
  double weight = 0;
  glm::dvec2 mean_x(0), mean_m(0);
  const auto on_plane = [&](const glm::dvec3& d) { return glm::dvec2(glm::dot(d, t), glm::dot(d, u)); };
  const auto for_each = [&](const auto& body) {
    for (const CurvatureNeighbour& one : neighbours) {
      const Vertex& other = vertices[one.vertex];
      if (glm::dot(glm::dvec3(other.normal), n) <= 0) continue;  // the other side of a rim
      body(double{one.weight}, on_plane((glm::dvec3(other.position_m) - p) * mm_per_unit),
           on_plane(glm::dvec3(other.normal)));
    }
  };
  for_each([&](double w, const glm::dvec2& x, const glm::dvec2& m) {
    weight += w;
    mean_x += w * x;
    mean_m += w * m;
  });
  if (!(weight > 0)) return {};
  mean_x /= weight;
  mean_m /= weight;

  double xx = 0, xy = 0, yy = 0, b0 = 0, b1 = 0, b2 = 0;
  for_each([&](double w, const glm::dvec2& x0, const glm::dvec2& m0) {
    const glm::dvec2 x = x0 - mean_x, m = m0 - mean_m;
    xx += w * x.x * x.x;
    xy += w * x.x * x.y;
    yy += w * x.y * x.y;
    b0 += w * m.x * x.x;
    b1 += w * (m.x * x.y + m.y * x.x);
    b2 += w * m.y * x.y;
  });
  return eigenvalues(xx, xy, yy, b0, b1, b2);
}

}  // namespace

CurvatureStencil curvature_stencil(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                                   double mm_per_unit, const CurvatureScales& scales) {
  const WeldedMesh mesh = welded(vertices, indices, mm_per_unit);
  const std::size_t places = mesh.one.size();
  std::vector<std::vector<CurvatureNeighbour>> of_place(places);
  parallel_for(curvature_jobs, [&](std::size_t job) {
    Collector collector(mesh, vertices, mm_per_unit, scales);
    for (std::size_t i = first_of_job(job, places); i < first_of_job(job + 1, places); ++i)
      of_place[i] = collector.of(static_cast<std::uint32_t>(i));
  });

  CurvatureStencil stencil;
  stencil.first.push_back(0);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::vector<CurvatureNeighbour>& of = of_place[mesh.id[v]];
    stencil.neighbours.insert(stencil.neighbours.end(), of.begin(), of.end());
    stencil.first.push_back(static_cast<std::uint32_t>(stencil.neighbours.size()));
  }
  return stencil;
}

std::vector<Curvature> curvatures(std::span<const Vertex> vertices, const CurvatureStencil& stencil,
                                  double mm_per_unit) {
  std::vector<Curvature> all(vertices.size());
  parallel_for(curvature_jobs, [&](std::size_t job) {
    for (std::size_t v = first_of_job(job, all.size()); v < first_of_job(job + 1, all.size()); ++v)
      all[v] = curvature_at(
          vertices, static_cast<std::uint32_t>(v),
          std::span(stencil.neighbours).subspan(stencil.first[v], stencil.first[v + 1] - stencil.first[v]),
          mm_per_unit);
  });
  return all;
}

}  // namespace dermis::scene
