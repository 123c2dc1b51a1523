// SPDX-License-Identifier: MIT
#include "truth/regions/regions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "head/scene/surface/unwrap.h"
#include "rays/alpha_test.h"
#include "truth/reference/camera_ray.h"
#include "truth/reference/shading.h"
#include "truth/regions/head_frame.h"

namespace dermis::regions {
namespace {

constexpr double terminator_cosine = 0.2;
constexpr double terminator_reach_mm = 12;  // on a cheek the band of that cosine is as wide
constexpr double shadow_reach_mm = 5;       // twice the sigma of skin's widest Gaussian is 5.4 mm
constexpr double seam_reach_mm = 3;
constexpr double thin_mm = 10;
constexpr double fold_gap_mm = 5, fold_reach_mm = 3;
// neighbours on one surface are not farther apart than this, unless it is nearly edge-on
constexpr double continuous_pixels = 4;

using Mask = std::vector<std::uint8_t>;

/// The surface of a pixel.
struct Seen {
  bool skin = false;
  rays::SurfacePoint point;
  double pixel_m = 0;  ///< size of a pixel there
  double thickness = 0, gap = 0;
  std::uint32_t chart = 0;
};

/// Chart of the unwrap for each triangle of each primitive, distinct between heads. skin_meshes() joins the
/// primitives of a key in order.
std::vector<std::vector<std::uint32_t>> charts_of(const scene::AssetData& scene) {
  const std::vector<scene::SkinMesh>& meshes = scene.skin;
  std::map<scene::SkinMeshKey, std::pair<std::size_t, std::size_t>> next;  // mesh, triangle
  for (std::size_t i = 0; i < meshes.size(); ++i) next[meshes[i].key] = {i, 0};
  std::vector<std::vector<std::uint32_t>> charts(scene.primitives.size());
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    const scene::Primitive& p = scene.primitives[i];
    if (!rays::is_skin(scene, p) || p.indices.empty()) continue;
    auto& [mesh, triangle] = next.at(scene::skin_mesh_key(p));
    for (std::size_t t = 0; t < p.indices.size() / 3; ++t, ++triangle)
      charts[i].push_back(static_cast<std::uint32_t>(mesh << 16) + meshes[mesh].triangle_chart[triangle]);
  }
  return charts;
}

class Finder {
 public:
  Finder(const rays::RayScene& rays, const reference::RenderSetup& setup) : rays_(rays), setup_(setup) {
    const auto width = static_cast<std::size_t>(setup.width);
    seen_.resize(width * static_cast<std::size_t>(setup.height));
    const std::vector<std::vector<std::uint32_t>> charts = charts_of(rays.scene());
    Steps rows("the surface at each pixel", static_cast<std::size_t>(setup.height));
    parallel_for(static_cast<std::size_t>(setup.height), [&](std::size_t y) {
      for (std::size_t x = 0; x < width; ++x)
        seen_[y * width + x] = look(static_cast<int>(x), static_cast<int>(y), charts);
      rows.done();
    });
  }

  Mask skin() const {
    return where([](const Seen&) { return true; });
  }
  Mask nose() const {
    return frame_ ? where([&](const Seen& s) { return frame_->on_nose(s.point.position_m); }) : none();
  }
  Mask ears() const {
    if (!frame_) return none();
    const auto beside = [&](const Seen& s) { return frame_->beside_the_head(s.point.position_m); };
    const Mask thin =
        where([&](const Seen& s) { return beside(s) && s.thickness < frame_->ear_thickness_m(); });
    return both(grown(thin, frame_->ear_closing_m()), where(beside));
  }
  Mask thin_parts() const {
    return where([&](const Seen& s) { return s.thickness < metres(thin_mm); });
  }
  Mask folds() const {
    return grown(where([&](const Seen& s) { return s.gap < metres(fold_gap_mm); }), metres(fold_reach_mm));
  }
  Mask seams() const {
    return grown(edges([](const Seen& a, const Seen& b) { return a.chart != b.chart; }),
                 metres(seam_reach_mm));
  }

  void add_light(const scene::Light& light, Mask& terminator, Mask& shadow_edges) const {
    const auto count = seen_.size();
    std::vector<double> cosine(count);
    Mask lit(count);
    parallel_for(count, [&](std::size_t i) {
      if (!seen_[i].skin) return;
      const reference::Arriving a = reference::arriving_light(light, seen_[i].point.position_m);
      cosine[i] = glm::dot(seen_[i].point.normal, a.to_light);
      if (cosine[i] <= 0 || a.irradiance == glm::dvec3(0)) return;
      const rays::Ray ray = reference::shadow_ray(seen_[i].point, a);
      lit[i] = ray.t_max_m <= ray.t_min_m || !rays_.solid_between(ray);
    });
    const auto index = [&](const Seen& s) { return static_cast<std::size_t>(&s - seen_.data()); };
    const auto near_zero = [&](const Seen& s) { return std::abs(cosine[index(s)]) < terminator_cosine; };
    const Mask lit_band = where([&](const Seen& s) { return near_zero(s) && lit[index(s)]; });
    add(terminator, both(grown(lit_band, metres(terminator_reach_mm)), where([&](const Seen& s) {
                           return near_zero(s) && (lit[index(s)] || cosine[index(s)] <= 0);
                         })));
    const Mask border = edges([&](const Seen& a, const Seen& b) {
      const bool both_face_it =
          cosine[index(a)] >= terminator_cosine && cosine[index(b)] >= terminator_cosine;
      return both_face_it && lit[index(a)] != lit[index(b)];
    });
    add(shadow_edges, grown(border, metres(shadow_reach_mm)));
  }

 private:
  double metres(double mm) const { return mm / rays_.scene().mm_per_unit; }
  Mask none() const { return Mask(seen_.size()); }

  Seen look(int x, int y, const std::vector<std::vector<std::uint32_t>>& charts) const {
    Seen seen;
    rays::Ray ray = reference::camera_ray(setup_, x + 0.5, y + 0.5);
    while (const auto hit = rays_.nearest(ray)) {
      const scene::Primitive& primitive = rays_.scene().primitives[hit->primitive];
      const scene::Material& material = rays_.scene().materials[static_cast<std::size_t>(primitive.material)];
      seen.point = rays::surface_point(rays_.scene(), *hit);
      const bool front = material.double_sided || glm::dot(seen.point.face_normal, ray.direction) < 0;
      // Lashes and brows that lie over the skin do not hide it from a mask.
      if (front && material.alpha_mode != AssetAlpha::blend &&
          !rays::is_cut_away(rays_.scene(), seen.point)) {
        seen.skin = rays::is_skin(rays_.scene(), primitive);
        if (!seen.skin) break;
        seen.chart = charts[hit->primitive][hit->triangle];
        seen.thickness = thickness_m(rays_, seen.point);
        seen.gap = gap_m(rays_, seen.point);
        const scene::Camera& camera = setup_.camera;
        seen.pixel_m = (camera.orthographic ? camera.ymag_m : hit->t_m * std::tan(camera.fov_y_rad / 2.0)) *
                       2 / setup_.height;
        break;
      }
      ray.t_min_m = std::nextafter(static_cast<float>(hit->t_m), 1e30f);
    }
    return seen;
  }

  template <class Test>
  Mask where(const Test& test) const {
    Mask mask(seen_.size());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = seen_[i].skin && test(seen_[i]);
    return mask;
  }

  static Mask both(Mask a, const Mask& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] && b[i];
    return a;
  }
  static void add(Mask& to, const Mask& from) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = to[i] || from[i];
  }

  /// Pixels that differ from their right or lower neighbour on the same surface.
  template <class Differ>
  Mask edges(const Differ& differ) const {
    Mask mask(seen_.size());
    const auto width = static_cast<std::size_t>(setup_.width);
    const auto try_pair = [&](std::size_t i, std::size_t j) {
      const Seen &a = seen_[i], &b = seen_[j];
      if (!a.skin || !b.skin ||
          glm::distance(a.point.position_m, b.point.position_m) > continuous_pixels * a.pixel_m)
        return;
      if (differ(a, b)) mask[i] = mask[j] = 1;
    };
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if ((i + 1) % width != 0) try_pair(i, i + 1);
      if (i + width < seen_.size()) try_pair(i, i + width);
    }
    return mask;
  }

  /// Skin within reach of the mask, in space.
  Mask grown(const Mask& mask, double reach_m) const {
    Mask out(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (!mask[i]) continue;
      const Seen& from = seen_[i];
      const int x0 = static_cast<int>(i % static_cast<std::size_t>(setup_.width)),
                y0 = static_cast<int>(i / static_cast<std::size_t>(setup_.width));
      const int window = static_cast<int>(std::min(std::ceil(reach_m / from.pixel_m), 65536.0));
      for (int y = std::max(0, y0 - window); y <= std::min(setup_.height - 1, y0 + window); ++y)
        for (int x = std::max(0, x0 - window); x <= std::min(setup_.width - 1, x0 + window); ++x) {
          const std::size_t j = static_cast<std::size_t>(y) * static_cast<std::size_t>(setup_.width) +
                                static_cast<std::size_t>(x);
          if (!out[j] && seen_[j].skin &&
              glm::distance(seen_[j].point.position_m, from.point.position_m) <= reach_m)
            out[j] = 1;
        }
    }
    return out;
  }

  const rays::RayScene& rays_;
  const reference::RenderSetup& setup_;
  std::optional<HeadFrame> frame_ = HeadFrame::find(rays_);
  std::vector<Seen> seen_;
};

}  // namespace

std::vector<Region> find(const rays::RayScene& rays, const reference::RenderSetup& setup) {
  constexpr std::size_t masks = 9;
  Steps steps("finding the regions of the picture", 1 + setup.lights.size() + masks);
  const Finder finder(rays, setup);
  steps.done();

  Mask terminator(static_cast<std::size_t>(setup.width) * static_cast<std::size_t>(setup.height)),
      shadow_edges = terminator;
  for (const scene::Light& light : setup.lights) {
    if (light.colour != glm::vec3(0)) finder.add_light(light, terminator, shadow_edges);
    steps.done();
  }

  std::vector<Region> all;
  const auto add = [&](const char* name, Mask mask) {
    all.push_back({.name = name, .mask = std::move(mask)});
    steps.done();
  };

  add("skin", finder.skin());
  add("ears", finder.ears());
  add("nose", finder.nose());
  add("terminator", std::move(terminator));
  add("shadow edges", std::move(shadow_edges));
  add("thin parts", finder.thin_parts());
  add("folds", finder.folds());
  add("seams", finder.seams());

  Mask rest = all.front().mask;
  for (std::size_t i = 0; i < rest.size(); ++i)
    for (std::size_t k = 1; k < all.size(); ++k)
      if (all[k].mask[i]) rest[i] = 0;
  add("the rest", std::move(rest));

  for (Region& region : all)
    region.pixels = static_cast<std::size_t>(
        std::count_if(region.mask.begin(), region.mask.end(), [](std::uint8_t m) { return m != 0; }));
  return all;
}

}  // namespace dermis::regions
