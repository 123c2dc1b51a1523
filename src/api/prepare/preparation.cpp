// SPDX-License-Identifier: MIT
#include "render/setup/preparation.h"

#include "api/prepare/face_parts.h"
#include "base/core/cache.h"
#include "base/core/hooks.h"
#include "environment/body_shape.h"
#include "head/pigments/maps.h"
#include "truth/regions/parts.h"

namespace dermis::api {
namespace {

environment::Occlusion occlusion(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                                 const environment::OcclusionSettings& settings) {
  return environment::cached_occlusion(scene, mesh, cache::default_folder(), settings);
}

std::vector<scene::VertexShape> body_shape(const scene::AssetData& scene, const scene::SkinMesh& mesh) {
  return environment::cached_body_shape(scene, mesh, cache::default_folder());
}

setup::LabelVertices label_vertices(const scene::AssetData& scene, std::span<const scene::SkinMesh> skin,
                                    const std::optional<Asset>& asset) {
  const FaceParts face(asset);
  const std::vector<std::vector<glm::vec2>> parts = regions::parts_of_skin(scene, skin);
  Steps steps("the shape of the body", skin.size());
  setup::LabelVertices found{
      .skin = std::vector<std::vector<io::LabelVertexIo>>(skin.size()),
      .surfaces = std::vector<std::vector<io::LabelVertexIo>>(scene.primitives.size())};
  for (std::size_t i = 0; i < skin.size(); ++i) {
    const std::vector<scene::VertexShape> shape = body_shape(scene, skin[i]);
    for (std::size_t v = 0; v < parts[i].size(); ++v) {
      io::LabelVertexIo vertex = face.of_skin(skin[i].vertices[v].position_m);
      vertex.part = parts[i][v];
      vertex.thickness_mm = shape[v].thickness_mm;
      found.skin[i].push_back(vertex);
    }
    steps.done();
  }

  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    const scene::Primitive& primitive = scene.primitives[i];
    if (scene.materials[static_cast<std::size_t>(primitive.material)].skin) continue;
    for (const scene::Vertex& vertex : primitive.vertices)
      found.surfaces[i].push_back(face.of_surface(scene, primitive, vertex.position_m));
  }
  return found;
}

void repaint(scene::AssetData& scene, const SceneOptions& options) {
  pigments::repaint(scene, {.melanin_map = options.melanin_map,
                            .haemoglobin_map = options.haemoglobin_map,
                            .melanin = options.melanin_factor,
                            .haemoglobin = options.haemoglobin_factor});
}

}  // namespace
}  // namespace dermis::api

extern "C" const dermis::setup::Preparation* dermis_preparation();
const dermis::setup::Preparation* dermis_preparation() {
  using namespace dermis;
  static constexpr setup::Preparation all{.environment = environment::from_name_or_file,
                                          .occlusion = api::occlusion,
                                          .body_shape = api::body_shape,
                                          .label_vertices = api::label_vertices,
                                          .repaint = api::repaint};
  return &all;
}
