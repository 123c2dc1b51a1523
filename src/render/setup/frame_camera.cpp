// SPDX-License-Identifier: MIT
#include "render/setup/frame_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>

namespace dermis::setup {
namespace {

constexpr int side_step = 32;  // texels

// The mean density of the first skin mesh that has texture coordinates, at quality.map_size; 0 if none has.
double texels_per_mm(const scene::AssetData& asset, const RenderSettings& s) {
  for (const scene::SkinMesh& mesh : asset.skin)
    if (mesh.density.uv_per_mm.mean > 0) return mesh.density.uv_per_mm.mean * s.quality.map_size;
  return 0;
}

// Returns by how much pixels are denser across than up and down; 1 where they are not.
double density_across(const RenderSettings& s, const scene::Camera& camera) {
  const double picture_aspect = static_cast<double>(s.output.width) / s.output.height;
  return camera.aspect ? std::max(1.0, picture_aspect / double{*camera.aspect}) : 1;
}

// The corners of the cube around a sphere.
std::array<glm::vec3, 8> cube_around(const scene::BoundingSphere& sphere) {
  std::array<glm::vec3, 8> corners_m;
  for (unsigned i = 0; i < corners_m.size(); ++i) {
    const glm::vec3 side(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    corners_m[i] = sphere.centre_m + sphere.radius_m * side;
  }
  return corners_m;
}

}  // namespace

io::CameraIo frame_camera(const scene::Camera& camera, double picture_aspect) {
  const double aspect = camera.aspect ? double{*camera.aspect} : picture_aspect;
  // Reversed depth. A perspective has no far plane (glTF allows one; nothing here needs it): clip z = near,
  // w = -z_view.
  glm::mat4 clip_from_camera(0);
  if (camera.orthographic) {
    const float far_m = camera.zfar_m.value_or(1000.0f), near_m = camera.znear_m;
    clip_from_camera[0][0] = 1 / (camera.ymag_m * static_cast<float>(aspect));
    clip_from_camera[1][1] = 1 / camera.ymag_m;
    clip_from_camera[2][2] = 1 / (far_m - near_m);
    clip_from_camera[3][2] = far_m / (far_m - near_m);
    clip_from_camera[3][0] = camera.axis_at.x;
    clip_from_camera[3][1] = camera.axis_at.y;
    clip_from_camera[3][3] = 1;
  } else {
    const float f = 1 / std::tan(camera.fov_y_rad / 2);
    clip_from_camera[0][0] = f / static_cast<float>(aspect);
    clip_from_camera[1][1] = f;
    clip_from_camera[3][2] = camera.znear_m;
    clip_from_camera[2][0] = -camera.axis_at.x;
    clip_from_camera[2][1] = -camera.axis_at.y;
    clip_from_camera[2][3] = -1;
  }

  io::CameraIo out{.clip_from_world = clip_from_camera * glm::inverse(camera.world_from_camera),
                   .eye_m = glm::vec3(camera.world_from_camera[3]),
                   .orthographic = camera.orthographic ? 1u : 0u,
                   .direction = -glm::normalize(glm::vec3(camera.world_from_camera[2])),
                   .planes = {}};

  // Rows of the matrix, as half spaces: -w <= x <= w, -w <= y <= w, and z <= w, which is the near plane of
  // reversed depth.
  const glm::mat4 rows = glm::transpose(out.clip_from_world);
  const std::array planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1],
                          rows[3] - rows[2]};
  std::transform(planes.begin(), planes.end(), out.planes,
                 [](const glm::vec4& plane) { return plane / glm::length(glm::vec3(plane)); });
  return out;
}

double reference_distance(const scene::AssetData& asset, const RenderSettings& s,
                          const scene::Camera& camera) {
  if (camera.orthographic) return 0;
  if (s.quality.d_ref) return *s.quality.d_ref;
  const double density = texels_per_mm(asset, s);
  if (density <= 0) return 0;

  // pixels per mm at distance d (mm) = (height / 2) / (d tan(fov / 2)).
  const double fov_y_rad = camera.fov_y_rad;
  const double pixels = s.output.height * density_across(s, camera);
  const double d_mm = pixels / 2.0 / (density * std::tan(fov_y_rad / 2));
  return d_mm / (asset.bounds.sphere.radius_m * asset.mm_per_unit);
}

double pixels_per_mm(const scene::AssetData& asset, const RenderSettings& s, const scene::Camera& camera,
                     const scene::Similarity& world_from_asset, const PosedAsset* posed) {
  if (camera.orthographic) {
    const double pixels = s.output.height * density_across(s, camera);
    return pixels / (2.0 * camera.ymag_m * asset.mm_per_unit) * double{world_from_asset.scale};
  }

  // In the asset, where lengths are in the same proportion.
  glm::vec3 low_m = asset.bounds.low_m, high_m = asset.bounds.high_m;
  if (posed) {
    // By steps, so that T stays while a head moves a little: each new T needs lists of gutters.
    const float step_m = asset.bounds.sphere.radius_m / 8;
    low_m -= glm::ceil((low_m - posed->skin.low_m) / step_m) * step_m;
    high_m += glm::ceil((posed->skin.high_m - high_m) / step_m) * step_m;
  }
  const glm::vec3 eye_m = world_from_asset.position_in_asset(glm::vec3(camera.world_from_camera[3]));
  const glm::vec3 nearest_m = glm::clamp(eye_m, low_m, high_m);
  const double d = glm::distance(eye_m, nearest_m) / asset.bounds.sphere.radius_m;
  if (!(d > 0)) return std::numeric_limits<double>::infinity();
  return reference_distance(asset, s, camera) / d * texels_per_mm(asset, s);
}

double pixels_across(const scene::BoundingSphere& casters, const RenderSettings& s,
                     const scene::Camera& camera) {
  const double pixels = s.output.height * density_across(s, camera), radius_m = casters.radius_m;
  if (camera.orthographic) return pixels * radius_m / double{camera.ymag_m};
  const double distance_m =
      double{glm::distance(glm::vec3(camera.world_from_camera[3]), casters.centre_m)} - radius_m;
  if (!(distance_m > 0)) return std::numeric_limits<double>::infinity();
  return pixels * radius_m / (distance_m * std::tan(double{camera.fov_y_rad} / 2));
}

int paper_side(const scene::AssetData& asset, const RenderSettings& s, double pixels_per_mm) {
  const double density = texels_per_mm(asset, s),
               needed = density > 0 ? pixels_per_mm / density : 0;  // of quality.map_size
  const double steps = std::ceil(std::min(needed, 1.0) * s.quality.map_size / side_step);
  return std::min(s.quality.map_size, side_step * std::max(1, static_cast<int>(steps)));
}

std::vector<int> paper_sides(const RenderSettings& s) {
  std::vector<int> sides{s.quality.map_size};
  for (int side = (s.quality.map_size - 1) / side_step * side_step; side > 0; side -= side_step)
    sides.push_back(side);
  return sides;
}

bool in_view(const scene::AssetData& asset, const io::CameraIo& camera,
             const scene::Similarity& world_from_asset, const PosedAsset* posed) {
  const scene::BoundingSphere sphere = world_from_asset.sphere(posed ? posed->all.sphere : asset.casters);
  const glm::vec4 centre(sphere.centre_m, 1);
  return std::all_of(std::begin(camera.planes), std::end(camera.planes),
                     [&](const glm::vec4& plane) { return glm::dot(plane, centre) > -sphere.radius_m; });
}

passes::PixelArea area_of(const passes::ShadowBounds& bounds, const io::CameraIo& camera,
                          const glm::uvec2& size) {
  const passes::PixelArea all{glm::uvec2(0), size};
  const std::array<glm::vec3, 8> cube_m = cube_around(bounds.sphere);
  const std::span<const glm::vec3> corners_m = bounds.corners_m.empty() ? cube_m : bounds.corners_m;

  glm::vec2 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const glm::vec3& corner_m : corners_m) {
    const glm::vec4 clip = camera.clip_from_world * glm::vec4(corner_m, 1);
    if (!(clip.w > 0)) return all;  // beside or behind the eye
    const glm::vec2 pixel = (0.5f + 0.5f * glm::vec2(clip.x, -clip.y) / clip.w) * glm::vec2(size);
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }

  constexpr float margin = 2;  // more than corners and vertices may round apart
  const glm::vec2 end(size), from = glm::clamp(glm::floor(low - margin), glm::vec2(0), end),
                             to = glm::clamp(glm::ceil(high + margin), from, end);
  return {glm::uvec2(from), glm::uvec2(to)};
}

passes::PixelArea joined(const passes::PixelArea& a, const passes::PixelArea& b) {
  if (a.low == a.high) return b;
  if (b.low == b.high) return a;
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

}  // namespace dermis::setup
