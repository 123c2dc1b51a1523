// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <utility>

#include "api/exposure.h"
#include "api/output.h"
#include "api/renderer_state.h"
#include "api/scene_on_device.h"
#include "api/scene_state.h"
#include "core/error.h"
#include "core/log.h"
#include "dermis/cancelled.h"
#include "frame/executor.h"
#include "setup/frame_data.h"
#include "setup/frame_setup.h"

namespace dermis {

struct PreparedFrame::State {
  std::shared_ptr<Renderer::State> renderer;
  Scene source;
  RenderSettings settings;
  api::SceneOnDevice scene;
  std::shared_ptr<const setup::EnvironmentLight> environment_light;
  setup::FrameSetup setup;
  techniques::FrameOutputs outputs;
  std::optional<frame::Executor<passes::FrameData>> executor;
  passes::FrameData data;
  std::vector<frame::FrameTime> times;  ///< since the last change
  std::vector<std::byte> counters;      ///< of this view; empty: not counted yet
  double pipeline_ms = 0;
  bool ready = false;                 ///< false: set() has thrown half way
  bool changed = true;                ///< `data`, since the last frame
  std::optional<double> exposure_ev;  ///< given or chosen; none: it was to be chosen, and no skin is lit

  gpu::Device& device() { return renderer->device; }
  void set(const Scene& wanted_scene, const RenderSettings& wanted);
  void plan(const RenderSettings& wanted, const setup::FrameSetup& next);
  std::optional<double> measure_exposure();
  void draw(bool with_statistics);
  void count();
  Picture picture();
};

void PreparedFrame::State::set(const Scene& wanted_scene, const RenderSettings& wanted) {
  const gpu::DeviceLimits& limits = device().limits();
  setup::check_settings(wanted);
  api::check_device_limits(wanted, limits);

  api::SceneOnDevice next_scene(renderer->assets_of(wanted_scene));
  const setup::PlacedScene placed = api::placed_scene(wanted_scene, next_scene.skin_spheres());
  const setup::DeviceTraits traits{.software = limits.software,
                                   .memory_bytes = device().summary().memory_bytes,
                                   .max_image_side = limits.max_image_side};
  const std::shared_ptr<const setup::EnvironmentLight> next_environment =
      renderer->environment_light(wanted_scene, wanted);
  std::optional<std::vector<scene::Light>> environment_lights;
  if (next_environment) environment_lights = setup::environment_lights(next_environment->sources, wanted);
  setup::FrameSetup next = setup::set_up(placed, next_scene.subjects(), wanted, traits, environment_lights);

  const std::uint64_t layers = std::uint64_t{next.plan.shadow_layers} * next.plan.heads_per_batch;
  if (layers > limits.max_array_layers)
    throw input_error(wanted_scene.name(),
                      "{} lights need {} shadow maps for {} heads at a time, this device has at most {}; "
                      "a smaller lighting.rig_lights uses fewer ({} of them are in the environment)",
                      next.lights, layers, next.plan.heads_per_batch, limits.max_array_layers,
                      next.environment_lights);
  bool warned = true;
  for (const api::AssetPointer& asset : next_scene.different_assets())
    warned = std::exchange(asset->warned_coarse, true) && warned;
  if (!warned) setup::warn_coarse(next_scene.subjects(), next);
  if (next_environment) setup::fill_environment(next.frame, *next_environment, wanted);

  // Before the scene is uploaded: a frame that does not fit must say so at once, not after a minute of work
  // on its maps. An unknown `show` is refused while the frame is still as it was.
  if (!executor || next.plan != setup.plan || next.technique != setup.technique)
    plan(wanted, next);
  else
    api::check_show(outputs, wanted);

  // Count as unready until all below is done: any of it may throw.
  ready = false;

  setup = std::move(next);
  settings = wanted;
  source = wanted_scene;
  next_scene.upload(renderer->library, placed, settings, setup, next_environment, scene);
  data = setup::frame_data(device(), setup, outputs, next_scene.instances(), next_environment.get());
  scene = std::move(next_scene);
  environment_light = next_environment;
  changed = true;

  exposure_ev = wanted.output.exposure_ev;
  if (!exposure_ev) exposure_ev = measure_exposure();
  if (!exposure_ev)
    warn("{}: no lit skin in the picture, so an automatic output.exposure_ev is 0", source.name());
  times.clear();
  counters.clear();
  ready = true;
}

// Draws frames of the same view with white skin that does not reflect at its surface: they show the light on
// the skin. Exposes the view by what is found, and returns that; none: no lit skin, 0 EV.
std::optional<double> PreparedFrame::State::measure_exposure() {
  const auto expose = [&](io::FrameIo frame, double ev) {
    frame.radiance_scale = static_cast<float>(std::exp2(ev));
    data.frame_io = setup::frame_buffer(device(), frame);
    changed = true;
  };

  io::FrameIo white = setup.frame;
  white.white_albedo = 1;
  white.specular_on = 0;
  const std::optional<double> ev = api::choose_exposure([&](double tried_ev) {
    expose(white, tried_ev);
    draw(false);
    return api::mean_skin_luminance(api::read_before_bloom(*executor, outputs));
  });

  expose(setup.frame, ev.value_or(0));
  return ev;
}

void PreparedFrame::State::plan(const RenderSettings& wanted, const setup::FrameSetup& next) {
  passes::FramePlan made;
  const techniques::FrameOutputs made_outputs = next.technique->build(made, next.plan);
  api::check_show(made_outputs, wanted);
  ready = false;
  executor.reset();  // its memory first: two frames may not fit
  const double before = renderer->library.creation_ms();
  executor.emplace(renderer->library, made);
  pipeline_ms = renderer->library.creation_ms() - before;
  renderer->library.save_cache();
  outputs = made_outputs;
}

void PreparedFrame::State::draw(bool with_statistics) {
  if (renderer->options.poison) executor->poison();
  executor->draw(data, {.changed = changed, .statistics = with_statistics});
  changed = false;
}

// The first frame of a view warms up (the first use of a pipeline compiles on software devices), makes what
// lasts, and counts.
void PreparedFrame::State::count() {
  if (!ready)
    throw Cancelled(source.name() + ": the frame was stopped while it was prepared; set() prepares it again");
  if (!counters.empty()) return;
  draw(true);
  counters = gpu::read_back(device(), executor->resources().buffer(outputs.counters));
}

PreparedFrame Renderer::prepare(const Scene& scene, const RenderSettings& settings) {
  auto state =
      std::make_unique<PreparedFrame::State>(PreparedFrame::State{.renderer = state_, .source = scene});
  state_->preparing(scene, [&] { state->set(scene, settings); });
  return PreparedFrame(std::move(state));
}

PreparedFrame::PreparedFrame(std::unique_ptr<State> state) : state_(std::move(state)) {}
PreparedFrame::PreparedFrame(PreparedFrame&&) noexcept = default;
PreparedFrame& PreparedFrame::operator=(PreparedFrame&&) noexcept = default;
PreparedFrame::~PreparedFrame() = default;

void PreparedFrame::set(const RenderSettings& settings) { set(Scene(state_->source), settings); }

void PreparedFrame::set(const Scene& scene, const RenderSettings& settings) {
  try {
    state_->renderer->preparing(scene, [&] { state_->set(scene, settings); });
  } catch (const InputError&) { throw; } catch (...) {
    // The frame may be half changed: refuse to draw it until a set() succeeds.
    state_->ready = false;
    throw;
  }
}

double PreparedFrame::draw() {
  return state_->renderer->drawing(state_->source, [&] {
    state_->count();
    if (state_->renderer->options.poison) state_->executor->poison();
    state_->times.push_back(state_->executor->run(state_->data));
    return state_->times.back().total_ms;
  });
}

std::vector<PassStatistics> PreparedFrame::last_passes() const {
  std::vector<PassStatistics> passes;
  if (!state_->times.empty())
    for (const gpu::Timing& pass : state_->times.back().passes)
      passes.push_back({.name = pass.name, .ms = pass.ms, .calls = 1});
  return passes;
}

Picture PreparedFrame::picture() {
  return state_->renderer->drawing(state_->source, [&] { return state_->picture(); });
}

Picture PreparedFrame::State::picture() {
  count();
  Picture picture;
  Statistics& statistics = picture.statistics;

  statistics.timing = executor->separate_submissions() ? "submit" : "timestamp";
  if (!times.empty()) api::fill_times(statistics, times);
  api::fill_counts(statistics, scene.subjects(), settings, setup, counters);
  statistics.upload_ms = scene.upload_ms();
  statistics.pipeline_ms = pipeline_ms;

  const gpu::DeviceSummary& summary = device().summary();
  statistics.device = summary.name;
  statistics.driver = summary.driver;
  statistics.api = summary.api;
  statistics.image_bytes = device().image_bytes();
  statistics.buffer_bytes = device().buffer_bytes();
  statistics.peak_bytes = device().peak_bytes();

  statistics.exposure_ev = exposure_ev.value_or(0);
  if (!settings.output.exposure_ev && exposure_ev)
    statistics.skin_mean = api::mean_skin_luminance(api::read_before_bloom(*executor, outputs));

  api::read_picture(picture, *executor, outputs, settings, setup);
  return picture;
}

}  // namespace dermis
