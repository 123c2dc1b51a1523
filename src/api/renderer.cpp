// SPDX-License-Identifier: MIT
#include "dermis/renderer.h"

#include "api/renderer_state.h"
#include "passes/shaders.h"
#include "settings/names.h"
#include "setup/frame_setup.h"

namespace dermis {

Renderer::State::State(const Options& wanted)
    : options(wanted),
      device({.select = wanted.device, .validate = wanted.validate}),
      library(device, passes::find_shader, gpu::default_pipeline_cache()) {}

std::shared_ptr<api::SharedScene> Renderer::State::shared(const Scene& scene,
                                                          const RenderSettings& settings) {
  const std::optional<float> mix =
      settings.skin.mix ? std::optional(static_cast<float>(*settings.skin.mix)) : std::nullopt;
  if (last_scene && last_scene->subject.scene == scene.shared() && last_scene->mix == mix) return last_scene;
  auto made = std::make_shared<api::SharedScene>();
  made->subject = setup::examine(scene.shared());
  made->mix = mix;
  return last_scene = made;
}

std::shared_ptr<const setup::EnvironmentLight> Renderer::State::environment_light(
    const RenderSettings& settings) {
  if (settings.lighting.environment.empty()) return nullptr;
  if (last_environment && setup::is_current(*last_environment, settings.lighting.environment))
    return last_environment;
  return last_environment = std::make_shared<const setup::EnvironmentLight>(
             setup::environment_light(device, settings.lighting.environment));
}

Renderer::Renderer(const Options& options) {
  const HookScope scope(Hooks{.log = options.hooks.log});
  state_ = std::make_shared<State>(options);
}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::vector<std::string> Renderer::validation_messages() const {
  return state_->device.validation_messages();
}

Picture Renderer::render(const Scene& scene, const RenderSettings& settings) {
  PreparedFrame frame = prepare(scene, settings);
  for (int i = 0; i < settings.output.frames; ++i) frame.draw();
  return frame.picture();
}

std::vector<std::string> technique_names() {
  std::vector<std::string> names;
  for (const techniques::Technique* t : techniques::techniques()) names.emplace_back(t->name);
  return names;
}

std::vector<std::string> tone_map_names() { return {names_of<ToneMap>.begin(), names_of<ToneMap>.end()}; }

std::string describe_plan(const Scene& scene, const RenderSettings& settings, bool dot, const Hooks& hooks) {
  const HookScope scope(hooks);
  setup::check_settings(settings);
  std::vector<scene::Light> environment_lights;
  if (!settings.lighting.environment.empty())
    environment_lights = setup::environment_lights(
        environment::split_sources(environment::from_name_or_file(settings.lighting.environment)).sources,
        settings);
  const setup::FrameSetup setup =
      setup::set_up(setup::examine(scene.shared()), settings, {}, environment_lights);
  passes::FramePlan plan;
  setup.technique->build(plan, setup.plan);
  return dot ? frame::print_dot(plan) : frame::print_text(plan);
}

}  // namespace dermis
