// SPDX-License-Identifier: MIT
#include "api/planned_frame.h"

#include <utility>

#include "api/output.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "base/core/warnings.h"
#include "head/scene/surface/coverage.h"
#include "render/passes/scatter/scatter_sum/scatter_sum.h"
#include "render/setup/camera_matrices.h"
#include "render/setup/choose.h"
#include "render/setup/frame_data.h"
#include "render/techniques/lambert/lambert.h"
#include "render/techniques/screen.h"
#include "render/techniques/texture_space/map_pool.h"

namespace dermis::api {
namespace {

void check_layers(const Scene& scene, const setup::FrameSetup& setup, const gpu::DeviceLimits& limits) {
  const std::uint64_t layers = std::uint64_t{setup.plan.shadow_layers} * setup.plan.shadow_sets();
  if (layers > limits.max_array_layers)
    throw input_error(scene.name(),
                      "{} lights need {} shadow maps for {} heads at a time, this device has at most {}; "
                      "a smaller lighting.rig_lights uses fewer ({} of them are in the environment)",
                      setup.lights.size(), layers, setup.plan.shadow_sets(), limits.max_array_layers,
                      setup.environment_lights);
  if (!setup.plan.host || !setup.plan.host->scattered) return;
  const std::uint32_t scattered = passes::ScatterSum::layer_of(techniques::MapPool(setup.plan).batches());
  if (scattered > limits.max_array_layers)
    throw input_error(
        scene.name(),
        "scattered light of {} heads takes {} layers of an image, this device has at most {}; a "
        "larger quality.map_budget_mb puts more heads into one",
        setup.heads.size(), scattered, limits.max_array_layers);
}

// Says once of each asset where light maps cannot show its skin as it is.
void warn_of_unwraps_once(const SceneOnDevice& scene, const setup::PlacedScene& placed,
                          const setup::FrameSetup& setup) {
  if (!setup.technique->has_light_maps) return;
  const WarningGroup group;
  bool warned = true;
  for (const AssetPointer& asset : scene.different_assets()) {
    if (std::exchange(asset->warned_of_unwrap, true)) continue;
    warned = false;
    for (const scene::SkinMesh& mesh : asset->data->skin) scene::warn_overlap(mesh);
  }
  if (!warned) setup::warn_coarse(placed, setup);
}

}  // namespace

bool PlannedFrame::set(const Scene& scene, const RenderSettings& asked,
                       const std::optional<setup::HostSetup>& host) {
  RenderSettings settings = asked;
  if (!options_.picture) {  // no light maps, and none of what skin sees
    setup::check_settings(asked);
    settings.technique = techniques::lambert.name;
  }
  const gpu::DeviceLimits& limits = device().limits();
  setup::check_settings(settings);
  check_device_limits(settings, limits);

  SceneOnDevice next_scene(renderer_->assets_of(scene));
  Input input{.placed = placed_scene(scene), .environment_lights = {}, .host = host};
  setup::check_seen(input.placed);
  setup::take_profile(input.placed, settings);
  const std::shared_ptr<const setup::EnvironmentLight> next_environment =
      options_.picture ? renderer_->environment_light(scene, settings) : nullptr;
  if (next_environment)
    input.environment_lights = setup::environment_lights(next_environment->sources, settings);

  setup::FrameSetup next = set_up(input, settings);
  check_layers(scene, next, limits);
  warn_of_unwraps_once(next_scene, input.placed, next);
  if (next_environment) setup::fill_environment(next.frame, *next_environment, settings);

  // Before the scene is uploaded: a frame that does not fit must say so at once, not after a minute of work
  // on its maps. An unknown `show` is refused while the frame is still as it was. The memory of a plan holds
  // the metric of its meshes: other assets need another one, even if all their numbers are equal.
  std::vector<AssetPointer> unwrap_assets = next_scene.different_assets();
  const bool plans = !executor_ || next.plan != setup_.plan || next.technique != setup_.technique ||
                     unwrap_assets != unwrap_assets_;
  if (plans)
    plan(settings, next);
  else
    check_show(outputs_, settings, next);

  // Count as unready until all below is done: any of it may throw.
  ready_ = false;
  setup_ = std::move(next);
  std::vector<passes::Head> every_size;
  if (options_.all_views && plans) every_size = setup::every_size(setup_, settings);
  const std::vector<passes::Head>& heads = options_.all_views ? every_size : setup_.heads;
  next_scene.upload(renderer_->library, input.placed, settings, setup_, heads, next_environment, scene_,
                    host ? &*host : nullptr);
  ids_ = scene.instances();
  posed_.keep(renderer_->library, next_scene, ids_, input.placed, host.has_value());
  if (plans) posed_.move_all();
  unwrap_assets_ = std::move(unwrap_assets);
  scene_ = std::move(next_scene);
  environment_ = next_environment;
  input_ = std::move(input);
  settings_ = settings;
  ready_ = true;
  return plans;
}

setup::FrameSetup PlannedFrame::set_up(const Input& input, const RenderSettings& settings) const {
  const gpu::DeviceLimits& limits = device().limits();
  const setup::DeviceTraits traits{.memory_bytes = device().summary().memory_bytes,
                                   .max_image_side = limits.max_image_side,
                                   .max_array_layers = limits.max_array_layers};
  setup::FrameSetup setup = setup::set_up(input.placed, settings, traits, input.environment_lights,
                                          input.host ? &*input.host : nullptr, options_.all_views);
  setup.plan.picture = options_.picture;
  setup.plan.display = options_.display;
  setup.plan.linear = options_.linear;
  setup.plan.matte = options_.matte;
  setup.plan.labels = options_.labels;
  if (!options_.picture) setup.technique = &techniques::labels_alone;
  return setup;
}

void PlannedFrame::set_view(const CameraMatrices& camera, const VkRect2D& area) {
  RenderSettings settings = settings_;
  settings.camera.matrices = camera;
  settings.output.width = static_cast<int>(area.extent.width);
  settings.output.height = static_cast<int>(area.extent.height);
  check_device_limits(settings, device().limits());

  setup::FrameSetup next = setup_;
  setup::set_view(next, input_.placed, settings, *input_.host);
  const std::optional<passes::PictureFormat>& picture = next.plan.host->picture;
  if (picture && setup::is_reversed(camera) != picture->reversed_depth)
    throw input_error("", "view.camera has depth that {} with the distance; picture.reversed_depth is {}",
                      picture->reversed_depth ? "grows" : "falls", picture->reversed_depth);
  next.frame.picture_low = {area.offset.x, area.offset.y};
  setup_ = std::move(next);
}

void PlannedFrame::plan(const RenderSettings& settings, const setup::FrameSetup& next) {
  passes::FramePlan made;
  const techniques::FrameOutputs made_outputs = next.technique->build(made, next.plan);
  check_show(made_outputs, settings, next);

  ready_ = false;
  executor_.reset();  // its memory first: two frames may not fit
  const double before = renderer_->library.creation_ms();
  executor_.emplace(renderer_->library, made);
  kept_shadows_ = kept_texels_ = {};
  pipeline_ms_ = renderer_->library.creation_ms() - before;
  renderer_->library.save_cache();
  outputs_ = made_outputs;
  light_map_bytes_ = 0;
  for (const frame::TextureId map : outputs_.light_maps)
    light_map_bytes_ += gpu::bytes_of(made.textures()[map.index].desc);
}

passes::FrameData PlannedFrame::data(gpu::FrameMemory& memory, bool measured) {
  passes::FrameData data = setup::frame_data(memory, setup_, outputs_, environment_.get());
  scene_.give(data.heads);
  posed_.fill(memory, data, measured);
  shadow_versions_.fill(setup_, scene_, input_.placed, input_.host ? &*input_.host : nullptr, data);
  data.kept_shadows = &kept_shadows_;
  data.kept_texels = &kept_texels_;
  if (options_.labels != 0) motion_.fill(memory, input_.placed, ids_, data);
  return data;
}

RecordCounts PlannedFrame::count(const std::function<void()>& record) const {
  const std::uint64_t maps = kept_shadows_.drawn();
  record();
  return {kept_shadows_.drawn() - maps, executor_->recorded(), light_map_bytes_};
}

void fill_recorded(Statistics& statistics, const RecordCounts& counts) {
  statistics.shadow_maps_drawn = counts.shadow_maps;
  statistics.recorded = counts.work;
  statistics.light_map_bytes = counts.light_map_bytes;
}

}  // namespace dermis::api
