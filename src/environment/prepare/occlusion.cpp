// SPDX-License-Identifier: MIT
#include "environment/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/core/assert.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "environment/prepare/sky_rays.h"
#include "environment/texel_grid.h"
#include "head/scene/surface/coverage.h"
#include "image/colour.h"
#include "rays/ray_scene.h"

namespace dermis::environment {
namespace {

// Shares of the work, measured: the scan of 512 texels.
constexpr std::size_t ray_steps = 14, bounce_steps = 3, all_steps = 1 + ray_steps + 1 + bounce_steps + 1;

constexpr double least_open = 0.002;  // the same value as in the shaders

// Returns two numbers in 0..1 that differ from texel to texel, so that the noise has no pattern.
glm::dvec2 shift_of(std::uint32_t x, std::uint32_t y) {
  std::uint32_t h = x * 0x9E3779B1u ^ (y * 0x85EBCA77u + 0x165667B1u);
  h = (h ^ h >> 15) * 0x2C1B3C6Du;
  h = (h ^ h >> 12) * 0x297A2D39u;
  h ^= h >> 15;
  return glm::dvec2(h & 0xFFFFu, h >> 16) / 65536.0;
}

// Per texel: the four `values` of Occlusion, then its transfer.
using Seen = std::array<float, 4 + harmonic_terms>;
// Per texel: transfer of light from occluders over their mean visible share, then that share
// (Occlusion::bounced).
using Hidden = std::array<float, bounced_terms>;
constexpr std::size_t blockers_open = bounced_terms - 1;
const Seen all_of_it = [] {  // no occluder: pi times the mean radiance
  Seen made{0, 0, 0, 1};
  made[4] = static_cast<float>(std::sqrt(std::numbers::pi) / 2);
  return made;
}();

template <std::size_t n>
void add(std::array<float, n>& sum, float weight, const std::array<float, n>& more) {
  for (std::size_t i = 0; i < n; ++i) sum[i] += weight * more[i];
}
template <std::size_t n>
std::array<float, n> divided(std::array<float, n> sum, float by) {
  for (float& value : sum) value /= by;
  return sum;
}

// The texels that the blocked rays of a texel hit; `itself` stands for hits on anything but the front of this
// mesh.
constexpr std::uint32_t itself = ~0u;
using Blockers = std::vector<std::uint32_t>;

// Returns values and transfer of a point from the sums over its rays.
Seen seen_by(const SkySums& sums, const glm::dvec3& n) {
  Seen out = all_of_it;
  const Harmonics lobe = cosine_lobe(n);
  for (std::size_t k = 0; k < lobe.size(); ++k) out[4 + k] = static_cast<float>(lobe[k]);
  if (sums.unoccluded_count() == sums.ray_count()) return out;

  // Transfer Int V cos Y = pi / N Sum V Y over N cosine-weighted rays. The control variate is the same
  // integral without V, whose exact value is the cosine lobe. Its error is subtracted with the visible share
  // as weight. So no noise is left where nothing occludes, and none is added where all is occluded.
  const double share = static_cast<double>(sums.unoccluded_count()) / sums.ray_count(),
               each = std::numbers::pi / sums.ray_count();
  Harmonics all, open;
  sums.harmonics(all, open);
  for (std::size_t k = 0; k < lobe.size(); ++k)
    out[4 + k] = static_cast<float>(each * open[k] + share * (lobe[k] - each * all[k]));
  out[3] = static_cast<float>(share);
  if (sums.unoccluded_count() == 0) return out;

  // Bent normal minus normal. The mean of all rays replaces the normal, so that noise and the tilt of the
  // triangle cancel.
  const glm::dvec3 turned = glm::normalize(sums.open()) - glm::normalize(sums.all());
  for (glm::length_t i = 0; i < 3; ++i) out[static_cast<std::size_t>(i)] = static_cast<float>(turned[i]);
  return out;
}

// Returns the texel that a ray hits, or `itself`.
std::uint32_t texel_of(const scene::AssetData& scene, const scene::SkinMesh& mesh, const rays::Hit& hit,
                       const glm::dvec3& direction, int side) {
  const scene::Primitive& primitive = scene.primitives[hit.primitive];
  const auto found =
      std::ranges::lower_bound(mesh.primitives, hit.primitive, {}, &scene::PrimitiveTriangles::primitive);
  if (found == mesh.primitives.end() || found->primitive != hit.primitive) return itself;
  const std::size_t triangle = found->first_triangle + std::size_t{hit.triangle};
  if (mesh.triangle_chart[triangle] == scene::no_chart) return itself;

  // Hits on the back of the skin come from inside.
  const std::uint32_t* index = &primitive.indices[3 * std::size_t{hit.triangle}];
  const scene::Vertex &a = primitive.vertices[index[0]], &b = primitive.vertices[index[1]],
                      &c = primitive.vertices[index[2]];
  const glm::dvec3 pa(a.position_m), pb(b.position_m), pc(c.position_m);
  if (glm::dot(glm::cross(pb - pa, pc - pa), direction) > 0) return itself;

  const std::array<glm::vec2, 3> uv = scene::triangle_uv(mesh, triangle);
  const glm::dvec2 there =
      (1 - hit.u - hit.v) * glm::dvec2(uv[0]) + hit.u * glm::dvec2(uv[1]) + hit.v * glm::dvec2(uv[2]);
  const glm::ivec2 at(glm::floor(there * static_cast<double>(side)));
  if (at.x < 0 || at.y < 0 || at.x >= side || at.y >= side) return itself;
  return static_cast<std::uint32_t>(at.y * side + at.x);
}

struct Place {
  glm::dvec3 position_m, normal, face;  // the latter two unit, on one side
};

struct Around {
  Seen seen = all_of_it;
  Blockers blockers;
  int ray_count = 0;
};

// Traces the rays of a point. Skips directions below the flat triangle, else a coarse mesh would darken
// itself.
Around look_around(const rays::RayScene& rays, const scene::SkinMesh& mesh, const Place& place,
                   const RaySet& set, const RaySet::Shift& shift, int side_texels) {
  const glm::vec3 n(place.normal), face(place.face);
  const glm::vec3 side =
      glm::normalize(glm::cross(std::abs(n.x) < 0.9f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), n));
  const glm::vec3 up = glm::cross(n, side);
  const glm::dvec3 origin = place.position_m + place.face * (4 * rays::stand_off_m(place.position_m));

  SkySums sums;
  Around out;
  for (int i = 0; i < set.size(); ++i) {
    const glm::vec3 local = set.direction(i, shift);
    const glm::vec3 d = side * local.x + up * local.y + n * local.z;
    if (glm::dot(d, face) <= 1e-3f) continue;
    const std::optional<rays::Hit> hit = rays.nearest_solid({.origin_m = origin, .direction = d});
    sums.add(d, !hit);
    if (hit) out.blockers.push_back(texel_of(rays.scene(), mesh, *hit, d, side_texels));
  }
  out.seen = seen_by(sums, place.normal);
  out.ray_count = sums.ray_count();
  return out;
}

// Returns the light of one bounce, [SKS02]'s interreflected transfer: a blocked ray gathers the transfer of
// the texel that it hits. Occluders are white, so E of a texel is radiance E / pi, and irradiance is (1 / N)
// Sum E over the blocked rays. `all`: of all texels, smoothed.
Hidden bounced(const Around& around, const Seen& own, const std::vector<Seen>& all) {
  Hidden out{};
  out[blockers_open] = 1;
  if (around.blockers.empty()) return out;

  double open = 0;
  std::array<double, blockers_open> sum{};
  for (const std::uint32_t blocker : around.blockers) {
    const Seen& seen = blocker == itself ? own : all[blocker];
    // A hole without a way out counts as least_open, with light from all directions.
    const double missing = std::max(0.0, least_open - double{seen[3]});
    open += double{seen[3]} + missing;
    for (std::size_t k = 0; k < sum.size(); ++k)
      sum[k] += double{seen[4 + k]} + missing * double{all_of_it[4 + k]};
  }
  for (std::size_t k = 0; k < sum.size(); ++k)
    out[k] =
        static_cast<float>(sum[k] / open * static_cast<double>(around.blockers.size()) / around.ray_count);
  out[blockers_open] = static_cast<float>(open / static_cast<double>(around.blockers.size()));
  return out;
}

// Returns a 3 x 3 tent filter over texels of the same chart, against the remaining noise.
template <class Values>
std::vector<Values> smoothed(const scene::SkinMesh& mesh, const TexelGrid& grid,
                             const std::vector<Values>& values) {
  std::vector<Values> out(values.size(), Values{});
  parallel_for(static_cast<std::size_t>(grid.side), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < grid.side; ++x) {
      const GridTexel& own = grid.texels[grid.at(x, y)];
      if (!own.covered()) continue;

      Values sum{};
      float total = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (x + dx < 0 || y + dy < 0 || x + dx >= grid.side || y + dy >= grid.side) continue;
          const GridTexel& other = grid.texels[grid.at(x + dx, y + dy)];
          if (!other.covered() || mesh.triangle_chart[other.triangle] != mesh.triangle_chart[own.triangle])
            continue;
          const float weight = static_cast<float>((2 - std::abs(dx)) * (2 - std::abs(dy)));
          add(sum, weight, values[grid.at(x + dx, y + dy)]);
          total += weight;
        }

      out[grid.at(x, y)] = divided(sum, total);
    }
  });
  return out;
}

// Fills texels off the mesh from their neighbours, ring by ring, and all others with `rest`.
template <class Values>
void dilate(const TexelGrid& grid, std::vector<Values>& values, const Values& rest) {
  std::vector<bool> filled(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) filled[i] = grid.texels[i].covered();

  for (int ring = 0; ring < dilation; ++ring) {
    std::vector<std::pair<std::size_t, Values>> added;
    for (int y = 0; y < grid.side; ++y)
      for (int x = 0; x < grid.side; ++x) {
        if (filled[grid.at(x, y)]) continue;

        Values sum{};
        float total = 0;
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            if (x + dx < 0 || y + dy < 0 || x + dx >= grid.side || y + dy >= grid.side ||
                !filled[grid.at(x + dx, y + dy)])
              continue;
            add(sum, 1, values[grid.at(x + dx, y + dy)]);
            ++total;
          }
        if (total > 0) added.emplace_back(grid.at(x, y), divided(sum, total));
      }

    // Writes a ring only when all of it is known, so that the order of texels makes no difference.
    for (const auto& [i, value] : added) {
      values[i] = value;
      filled[i] = true;
    }
  }

  for (std::size_t i = 0; i < values.size(); ++i)
    if (!filled[i]) values[i] = rest;
}

// Returns the place of a texel; none if its triangle has no area or no normal.
std::optional<Place> place_of_texel(const scene::SkinMesh& mesh, const GridTexel& texel) {
  const scene::Vertex* corners[3];
  for (std::size_t k = 0; k < 3; ++k)
    corners[k] = &mesh.vertices[mesh.indices[3 * std::size_t{texel.triangle} + k]];
  const glm::dvec3 a(corners[0]->position_m), b(corners[1]->position_m), c(corners[2]->position_m);

  const double u = double{texel.u}, v = double{texel.v}, w = 1.0 - texel.u - texel.v;
  glm::dvec3 face = glm::cross(b - a, c - a);
  const glm::dvec3 normal = glm::dvec3(corners[0]->normal) * w + glm::dvec3(corners[1]->normal) * u +
                            glm::dvec3(corners[2]->normal) * v;

  if (glm::length(face) < 1e-30 || glm::length(normal) < 1e-6) return std::nullopt;
  face = glm::normalize(face);
  const glm::dvec3 n = glm::normalize(normal);
  if (glm::dot(face, n) < 0) face = -face;
  return Place{a * w + b * u + c * v, n, face};
}

}  // namespace

Occlusion bake_occlusion(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                         const OcclusionSettings& settings) {
  DERMIS_ASSERT_LE(16, settings.side);
  DERMIS_ASSERT_LE(settings.side, 4096);
  DERMIS_ASSERT_LE(1, settings.rays);

  const auto side = static_cast<std::size_t>(settings.side);
  Steps steps("occlusion of the surroundings", all_steps);
  const rays::RayScene rays(scene);
  const TexelGrid grid = rasterise(mesh, settings.side);
  const RaySet set(settings.rays);
  steps.done();

  // First pass: rays from each texel, then noise filter and dilation.
  std::vector<Around> around(grid.texels.size());
  std::vector<Seen> seen(grid.texels.size(), all_of_it);
  std::optional<Steps> rows(std::in_place, "rays", side, ray_steps);
  parallel_for(side, [&](std::size_t row) {
    for (int x = 0; x < grid.side; ++x) {
      const std::size_t i = grid.at(x, static_cast<int>(row));
      if (!grid.texels[i].covered()) continue;
      const std::optional<Place> place = place_of_texel(mesh, grid.texels[i]);
      if (!place) continue;
      const glm::dvec2 shift = shift_of(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(row));
      around[i] = look_around(rays, mesh, *place, set, RaySet::shift_of(shift), settings.side);
      seen[i] = around[i].seen;
    }
    rows->done();
  });
  rows.reset();
  steps.done(ray_steps);

  seen = smoothed(mesh, grid, seen);
  dilate(grid, seen, all_of_it);
  steps.done();

  // Second pass: one bounce from the texels that blocked rays hit.
  std::vector<Hidden> hidden(grid.texels.size());
  rows.emplace("bounces", side, bounce_steps);
  parallel_for(side, [&](std::size_t row) {
    for (std::size_t i = row * side; i < (row + 1) * side; ++i) hidden[i] = bounced(around[i], seen[i], seen);
    rows->done();
  });
  rows.reset();
  steps.done(bounce_steps);

  hidden = smoothed(mesh, grid, hidden);
  Hidden nothing{};
  nothing[blockers_open] = 1;
  dilate(grid, hidden, nothing);
  steps.done();

  Occlusion out{.side = settings.side, .values = {}, .transfer = {}, .bounced = {}};
  out.values.reserve(seen.size() * 4);
  out.transfer.reserve(seen.size() * harmonic_terms);
  out.bounced.reserve(seen.size() * bounced_terms);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    out.values.insert(out.values.end(), seen[i].begin(), seen[i].begin() + 4);
    for (std::size_t k = 0; k < harmonic_terms; ++k)
      out.transfer.push_back(image::float_to_half(seen[i][4 + k]));
    for (const float value : hidden[i]) out.bounced.push_back(image::float_to_half(value));
  }
  return out;
}

}  // namespace dermis::environment
