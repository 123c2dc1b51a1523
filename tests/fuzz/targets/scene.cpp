// SPDX-License-Identifier: MIT
// glTF: the whole way from a file to a scene, and to the skin that is rendered from it.
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "api/rig_pose.h"
#include "head/scene/framing.h"
#include "head/scene/gltf/load.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/fine_normals.h"
#include "head/scene/surface/gutters.h"
#include "head/scene/surface/measured.h"
#include "support.h"

namespace dermis::fuzz {
namespace {

using namespace scene;
using scene::AssetData;  // not the handle of dermis/scene.h

void check_finite(const glm::vec3& v) {
  DERMIS_ASSERT(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
}

void check_map(const AssetData& scene, const MapRef& map) {
  if (!map.present()) return;
  DERMIS_ASSERT_LT(static_cast<std::size_t>(map.image), scene.images.size());
  DERMIS_ASSERT(map.uv_set == 0 || map.uv_set == 1);
  DERMIS_ASSERT(map.channel >= 0 && map.channel < 4);
}

/// The contract of head/scene/asset_data.h, as far as whoever reads a scene relies on it without looking.
void check_scene(const AssetData& scene) {
  DERMIS_ASSERT(!scene.primitives.empty());

  for (const Primitive& primitive : scene.primitives) {
    DERMIS_ASSERT_LT(static_cast<std::size_t>(primitive.material), scene.materials.size());
    DERMIS_ASSERT_EQ(primitive.indices.size() % 3, 0u);
    DERMIS_ASSERT_LE(0, primitive.source_mesh);
    DERMIS_ASSERT(primitive.source_vertices.empty() ||
                  primitive.source_vertices.size() == primitive.vertices.size());
    for (const std::uint32_t index : primitive.indices) DERMIS_ASSERT_LT(index, primitive.vertices.size());
    for (const Vertex& v : primitive.vertices) {
      check_finite(v.position_m);
      check_finite(v.normal);
      check_finite(glm::vec3(v.tangent));
      check_finite(glm::vec3(v.uv0, 0));
      check_finite(glm::vec3(v.uv1, 0));
    }
  }

  for (const Material& material : scene.materials) {
    for (const MapRef* map :
         {&material.base_colour_map, &material.metallic_roughness_map, &material.normal_map,
          &material.occlusion_map, &material.emissive_map, &material.specular_map,
          &material.specular_colour_map, &material.skin_settings.specular, &material.skin_settings.roughness,
          &material.skin_settings.displacement, &material.skin_settings.detail})
      check_map(scene, *map);
  }

  for (const MapImage& image : scene.images) {
    const std::size_t pixels =
        static_cast<std::size_t>(image.pixels->width) * static_cast<std::size_t>(image.pixels->height);
    DERMIS_ASSERT_EQ(image.pixels->rgba.size(), 4 * pixels);
  }
}

void check_skin(const SkinMesh& mesh) {
  DERMIS_ASSERT_EQ(mesh.unwrap.size(), mesh.vertices.size());
  DERMIS_ASSERT_EQ(mesh.sources.size(), mesh.vertices.size());
  DERMIS_ASSERT_EQ(mesh.metric.size(), mesh.vertices.size());
  DERMIS_ASSERT_EQ(mesh.triangle_chart.size(), mesh.indices.size() / 3);
  for (const std::uint32_t index : mesh.indices) DERMIS_ASSERT_LT(index, mesh.vertices.size());
  for (const glm::vec3& metric : mesh.metric) {
    check_finite(metric);
    DERMIS_ASSERT_LT(0.0f, metric.x * metric.z - metric.y * metric.y);
  }
}

/// What a renderer does with a scene before it draws, with maps so small that it takes no time.
void prepare(const AssetData& scene) {
  constexpr int side = 32, gutter_texels = 4;
  const std::shared_ptr<const AssetData> asset = measured(scene);
  const std::vector<SkinMesh>& skin = asset->skin;

  for (const SkinMesh& mesh : skin) {
    check_skin(mesh);
    warn_overlap(mesh);
    for (const GutterTexel& texel : build_gutters(mesh, side, gutter_texels))
      DERMIS_ASSERT(texel.x < side && texel.y < side && texel.source_x >= 0 && texel.source_x <= side &&
                    texel.source_y >= 0 && texel.source_y <= side);
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i) fine_normals(*asset, i);
}

void check_inside(const Bounds& bounds, const glm::vec3& position_m) {
  // Below the least normal number floats have few digits.
  const double slack = 1e-4 * (bounds.sphere.radius_m + glm::length(glm::dvec3(position_m))) +
                       std::numeric_limits<float>::min();
  DERMIS_ASSERT_LE(glm::distance(glm::dvec3(position_m), glm::dvec3(bounds.sphere.centre_m)),
                   bounds.sphere.radius_m + slack);
}

/// What a renderer does with an instance in a pose: all of it but the device.
void check_pose(const AssetData& rest, const RigPose& pose) {
  accepts([&] {
    const std::shared_ptr<const setup::PosedAsset> posed = api::posed_asset(rest, pose);
    AssetData moved = rest;
    take_pose(*rest.rig, posed->rig, moved);
    check_scene(moved);
    for (const Primitive& primitive : moved.primitives)
      if (primitive.placements.empty())
        for (const Vertex& v : primitive.vertices) check_inside(posed->all, v.position_m);
  });
}

/// Poses by the first clips, one with another, and by the names of joints and weights.
void check_poses(const AssetData& scene) {
  if (!scene.rig) return;
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(scene.clips.size(), most); ++i)
    for (const double seconds : {-1.0, 0.3, 1e9}) {
      const ClipTime at{.clip = scene.clips[i], .seconds = seconds};
      check_pose(scene, {.clip = at});
      check_pose(scene, {.clip = at, .second = ClipTime{.clip = scene.clips[0]}, .blend = 0.4});
    }

  RigPose named;
  for (const std::string& name : api::morph_names(scene))
    if (named.weights.size() < most) named.weights.push_back({.name = name, .weight = 1.5});
  check_pose(scene, named);
  for (const std::string& name : api::joint_names(scene))
    if (named.joints.size() < most)
      named.joints.push_back({.name = name, .rotation = std::array{0.3, -0.2, 0.1, 0.9}});
  check_pose(scene, named);
}

bool load_and_prepare(Bytes file) {
  const std::filesystem::path path = put_file("scene", file);
  return accepts([&] {
    const AssetData scene = load_gltf(path);
    check_scene(scene);
    prepare(scene);
    check_poses(scene);
    if (!scene.clips.empty()) check_scene(load_gltf(path, {.time_s = 0.3}));
  });
}

void append_u32(std::vector<std::byte>& to, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<std::byte>(value >> shift));
}

/// A chunk of a .glb, padded to a multiple of four.
void append_chunk(std::vector<std::byte>& to, const char* type, Bytes data, std::byte padding) {
  const std::size_t padded = (data.size() + 3) / 4 * 4;
  append_u32(to, padded);
  for (int i = 0; i < 4; ++i) to.push_back(static_cast<std::byte>(type[i]));
  to.insert(to.end(), data.begin(), data.end());
  to.insert(to.end(), padded - data.size(), padding);
}

}  // namespace

bool gltf(Bytes file) { return load_and_prepare(file); }

bool glb(Bytes json_and_bin) {
  const std::string_view text = as_text(json_and_bin);
  const std::size_t json_bytes = std::min(text.find('\0'), text.size());

  std::vector<std::byte> chunks;
  append_chunk(chunks, "JSON", json_and_bin.first(json_bytes), std::byte{' '});
  if (json_bytes < text.size())
    append_chunk(chunks, "BIN\0", json_and_bin.subspan(json_bytes + 1), std::byte{0});

  std::vector<std::byte> file;
  for (const char c : {'g', 'l', 'T', 'F'}) file.push_back(static_cast<std::byte>(c));
  append_u32(file, 2);
  append_u32(file, 12 + chunks.size());
  file.insert(file.end(), chunks.begin(), chunks.end());
  return load_and_prepare(file);
}

}  // namespace dermis::fuzz
