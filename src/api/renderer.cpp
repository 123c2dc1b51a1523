// SPDX-License-Identifier: MIT
#include "dermis/renderer.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "api/asset_state.h"
#include "api/renderer_state.h"
#include "api/scene_state.h"
#include "api/shader_scope.h"
#include "base/settings/names.h"
#include "dermis/vulkan.h"
#include "render/setup/choose.h"
#include "render/setup/frame_setup.h"
#include "render/techniques/shaders.h"

namespace dermis {
namespace {

thread_local const api::ShaderScope* innermost = nullptr;

}  // namespace

namespace api {

ShaderScope::ShaderScope(gpu::ShaderSource shaders) : shaders_(std::move(shaders)), outer_(innermost) {
  innermost = this;
}
ShaderScope::~ShaderScope() { innermost = outer_; }
gpu::ShaderSource ShaderScope::current() { return innermost ? innermost->shaders_ : gpu::ShaderSource(); }

}  // namespace api

Renderer::State::State(const Options& wanted)
    : options(wanted),
      device({.select = wanted.device, .validate = wanted.validate}),
      library(device, techniques::find_any_shader, gpu::default_pipeline_cache(), VK_NULL_HANDLE,
              api::ShaderScope::current()) {}

Renderer::State::State(const vulkan::Host& host, const Hooks& hooks)
    : options{.hooks = hooks},
      device(host),
      library(device, techniques::find_any_shader, gpu::default_pipeline_cache(), host.pipeline_cache,
              host.find_shader) {}

std::vector<api::AssetPointer> Renderer::State::assets_of(const Scene& scene) {
  std::vector<api::AssetPointer> of_instances;
  std::map<std::shared_ptr<const scene::AssetData>, api::AssetPointer> known;
  std::erase_if(live_assets, [&](const std::weak_ptr<api::SharedAsset>& live) {
    const api::AssetPointer asset = live.lock();
    if (asset) known[asset->data] = asset;
    return !asset;
  });

  for (const Scene::State::Entry& entry : scene.state().instances) {
    const std::shared_ptr<const scene::AssetData> data = Asset::State::of(entry.instance.asset);
    api::AssetPointer& asset = known[data];
    if (!asset) {
      asset =
          std::make_shared<api::SharedAsset>(api::SharedAsset{.data = data, .source = entry.instance.asset});
      live_assets.push_back(asset);
    }
    of_instances.push_back(asset);
  }
  last_assets = api::each_once(of_instances);
  return of_instances;
}

std::shared_ptr<const setup::EnvironmentLight> Renderer::State::environment_light(
    const Scene& scene, const RenderSettings& settings) {
  const auto source = setup::choose_environment(settings, scene.environment());
  if (!source) return nullptr;
  if (last_environment && last_environment->source == *source) return last_environment;
  return last_environment =
             std::make_shared<const setup::EnvironmentLight>(setup::environment_light(device, *source));
}

Renderer::Renderer(const Options& options) {
  const HookScope scope(Hooks{.log = options.hooks.log});
  state_ = std::make_shared<State>(options);
}
Renderer::Renderer(const vulkan::Host& host, const Hooks& hooks) {
  const HookScope scope(Hooks{.log = hooks.log});
  state_ = std::make_shared<State>(host, hooks);
}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::vector<std::string> Renderer::validation_messages() const {
  return state_->device.validation_messages();
}

DeviceCounters Renderer::counters() const {
  const gpu::DeviceCounters& c = state_->device.counters();
  return {.allocations = c.allocations,
          .buffers = c.buffers,
          .images = c.images,
          .pipelines = c.pipelines,
          .submissions = c.submissions,
          .waits = c.waits,
          .idle_waits = c.idle_waits};
}

Picture Renderer::render(const Scene& scene, const RenderSettings& settings) {
  PreparedFrame frame = prepare(scene, settings);
  for (int i = 0; i < settings.output.frames; ++i) frame.draw();
  return frame.picture();
}

std::vector<DeviceInfo> list_devices() { return gpu::list_devices(); }

std::vector<std::string> technique_names() {
  std::vector<std::string> names;
  for (const techniques::Technique* t : techniques::techniques()) names.emplace_back(t->name);
  return names;
}

std::vector<std::string> tone_map_names() { return {names_of<ToneMap>.begin(), names_of<ToneMap>.end()}; }

std::string describe_plan(const Scene& scene, const RenderSettings& settings, bool dot, const Hooks& hooks) {
  const HookScope scope(hooks);
  setup::check_settings(settings);
  setup::PlacedScene placed = api::placed_scene(scene);
  setup::check_seen(placed);
  std::optional<std::vector<scene::Light>> environment_lights;
  if (const auto source = setup::choose_environment(settings, scene.environment()))
    environment_lights = setup::environment_lights(
        environment::split_sources(setup::read_environment(*source)).sources, settings);

  setup::take_profile(placed, settings);
  const setup::FrameSetup setup = setup::set_up(placed, settings, {}, environment_lights, nullptr, false);
  passes::FramePlan plan;
  setup.technique->build(plan, setup.plan);
  return dot ? frame::print_dot(plan) : frame::print_text(plan);
}

}  // namespace dermis
