// SPDX-License-Identifier: MIT
#include "setup/preparation.h"

#include "core/cache.h"
#include "environment/body_shape.h"
#include "pigments/maps.h"
#include "regions/parts.h"

namespace dermis::api {
namespace {

environment::Occlusion occlusion(const scene::Scene& scene, const scene::SkinMesh& mesh,
                                 const environment::OcclusionSettings& settings) {
  return environment::cached_occlusion(scene, mesh, cache::default_folder(), settings);
}

std::vector<scene::VertexShape> body_shape(const scene::Scene& scene, const scene::SkinMesh& mesh) {
  return environment::cached_body_shape(scene, mesh, cache::default_folder());
}

void repaint(scene::Scene& scene, const SceneOptions& options) {
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
                                          .parts_of_skin = regions::parts_of_skin,
                                          .repaint = api::repaint};
  return &all;
}
