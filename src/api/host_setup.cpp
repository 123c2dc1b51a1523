// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "api/asset_state.h"
#include "api/host_check.h"
#include "api/host_frames_state.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "render/setup/camera_matrices.h"
#include "render/techniques/technique.h"

namespace dermis::vulkan {
namespace {

std::size_t number_of(const std::vector<InstanceId>& ids, InstanceId id, const char* member) {
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end())
    throw input_error("", "{}: instance {} is not in the scene", member, static_cast<std::uint32_t>(id));
  return static_cast<std::size_t>(found - ids.begin());
}

setup::HostMapOfInstance host_map(const Scene& scene, const std::vector<InstanceId>& ids,
                                  const MaterialImage& image) {
  const std::size_t instance = number_of(ids, image.instance, "images");
  api::check_handle("images.view", image.view != VK_NULL_HANDLE);
  const std::vector<scene::Material>& materials =
      Asset::State::of(scene.instance(image.instance).asset)->materials;
  const auto found = std::find_if(materials.begin(), materials.end(), [&](const scene::Material& material) {
    return material.name == image.material;
  });
  if (found == materials.end())
    throw input_error("", "images: {} has no material '{}'", scene.instance(image.instance).asset.name(),
                      image.material);
  return {.instance = instance,
          .map = {.material = static_cast<int>(found - materials.begin()),
                  .map = image.map == MaterialImage::Map::normal ? MAP_NORMAL : MAP_BASE_COLOUR,
                  .view = image.view}};
}

// The side of a texel where w is 1, which is a metre away if the matrix has w in metres.
double texel_side(const glm::dmat4& m, const VkExtent2D& extent) {
  const glm::dvec3 x(m[0][0], m[1][0], m[2][0]), y(m[0][1], m[1][1], m[2][1]);
  const double per_m = std::min(glm::length(x) * extent.width, glm::length(y) * extent.height);
  return 2 / per_m;
}

setup::HostShadow host_shadow(const Scene& scene, const LightShadow& shadow) {
  const std::vector<LightId> lights = scene.lights();
  const auto found = std::find(lights.begin(), lights.end(), shadow.light);
  if (found == lights.end())
    throw input_error("", "shadows: light {} is not in the scene", static_cast<std::uint32_t>(shadow.light));
  if (scene.light(shadow.light).light.type == LightType::point)
    throw input_error("", "shadows: light {} shines to all sides, which one map does not hold",
                      static_cast<std::uint32_t>(shadow.light));
  api::check_handle("shadows.depth", shadow.depth != VK_NULL_HANDLE);
  api::check_finite("shadows.clip_from_world", shadow.clip_from_world);
  if (shadow.extent.width < 1 || shadow.extent.height < 1 || shadow.extent.width > 65536 ||
      shadow.extent.height > 65536)
    throw input_error("", "shadows.extent must be 1 to 65536 texels each, got {} x {}", shadow.extent.width,
                      shadow.extent.height);

  // w in metres, so that a texel is metres wide, or metres per metre of distance.
  glm::dmat4 m = setup::matrix_of(shadow.clip_from_world);
  const glm::dvec3 w(m[0][3], m[1][3], m[2][3]);
  const double scale = glm::length(w) > 1e-9 ? glm::length(w) : std::abs(m[3][3]);
  if (!(scale > 1e-9) || !(std::abs(glm::determinant(m)) > 0))
    throw input_error("", "shadows.clip_from_world must be a matrix that can be inverted");
  m /= scale;
  const double texel = texel_side(m, shadow.extent);
  if (!(texel > 1e-9 && texel < 1e9))
    throw input_error("", "shadows.clip_from_world must show something: a texel would be {:g} m wide", texel);

  if (!shadow.y_down)
    for (int column = 0; column < 4; ++column) m[column][1] = -m[column][1];
  // Depth reversed, as all shadow maps are read.
  if (!shadow.reversed_depth)
    for (int column = 0; column < 4; ++column) m[column][2] = m[column][3] - m[column][2];
  return {.light = static_cast<std::size_t>(found - lights.begin()),
          .shadow_from_world = glm::mat4(m),
          .texel = static_cast<float>(texel),
          .depth = nullptr,
          .reversed = shadow.reversed_depth};
}

techniques::HostPart host_part(const HostFrames::Options& options, const RenderSettings& settings,
                               const HostInputs& inputs) {
  techniques::HostPart part{.picture = {},
                            .width = 0,
                            .height = 0,
                            .scattered = options.scattered,
                            .irradiance = static_cast<bool>(inputs.draw_irradiance),
                            .shadows = !inputs.shadows.empty()};
  if (options.picture) {
    part.picture = {.colour = options.picture->colour_format,
                    .depth = options.picture->depth_format,
                    .reversed_depth = options.picture->reversed_depth};
    part.width = options.picture->largest.width;
    part.height = options.picture->largest.height;
  }

  const techniques::Technique& technique = techniques::find_technique(settings.technique);
  if (!technique.has_light_maps && (part.scattered || part.irradiance))
    throw input_error("", "technique '{}' has no light maps, which {} needs", settings.technique,
                      part.scattered ? "Options::scattered" : "HostInputs::draw_irradiance");
  return part;
}

}  // namespace

setup::HostSetup host_setup(const HostFrames::Options& options, const Scene& scene,
                            const RenderSettings& settings, const HostInputs& inputs, HostImages& images) {
  const std::vector<InstanceId> ids = scene.instances();
  setup::HostSetup host{.part = host_part(options, settings, inputs),
                        .samples = options.picture ? options.picture->samples : 1,
                        .not_drawn = {},
                        .deformed = {},
                        .maps = {},
                        .shadows = {}};
  for (const InstanceId id : inputs.drawn_by_host)
    host.not_drawn.push_back(number_of(ids, id, "drawn_by_host"));
  for (const InstanceId id : inputs.deformed) {
    host.deformed.push_back(number_of(ids, id, "deformed"));
    if (scene.instance(id).pose)
      throw input_error("", "deformed: instance {} has a pose, by which dermis moves it",
                        static_cast<std::uint32_t>(id));
  }
  for (const MaterialImage& image : inputs.images) host.maps.push_back(host_map(scene, ids, image));

  if (!inputs.shadows.empty() && (settings.lighting.rig_lights || !settings.lighting.placed_lights.empty()))
    throw input_error("",
                      "shadows are of lights of the scene, which lighting.rig_lights and "
                      "lighting.placed_lights replace");
  for (const LightShadow& shadow : inputs.shadows) {
    setup::HostShadow of_light = host_shadow(scene, shadow);
    if (std::any_of(host.shadows.begin(), host.shadows.end(),
                    [&](const setup::HostShadow& before) { return before.light == of_light.light; }))
      throw input_error("", "shadows: light {} has two", static_cast<std::uint32_t>(shadow.light));
    images.push_back(std::make_unique<gpu::Texture>(
        "shadow map of the host",
        gpu::TextureDesc{.width = shadow.extent.width, .height = shadow.extent.height}, shadow.depth));
    of_light.depth = images.back().get();
    host.shadows.push_back(of_light);
  }
  return host;
}

}  // namespace dermis::vulkan
