// SPDX-License-Identifier: MIT
#include "dermis/renderer.h"

#include <algorithm>
#include <chrono>

#include "api/output.h"
#include "api/setup.h"
#include "core/error.h"
#include "frame/executor.h"
#include "gpu/device.h"
#include "passes/frame_data.h"
#include "passes/shaders.h"

namespace dermis {
namespace {

using Clock = std::chrono::steady_clock;
double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n == 0 ? 0 : n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

frame::FrameData frame_data(gpu::Device& device, const api::FrameSetup& setup, const passes::GpuScene& scene) {
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  frame::FrameData data;
  data.scene = &scene;
  data.eye_m = setup.frame.eye_m;
  data.frame_io = gpu::make_buffer(device, "frame", std::span(&setup.frame, 1), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  for (const api::HeadSetup& head : setup.heads) {
    frame::Instance instance;
    instance.offset_m = head.offset_m;
    instance.lights = gpu::make_buffer(device, "lights", std::span<const io::LightIo>(head.lights), storage);
    instance.shadow_matrices = gpu::make_buffer(device, "shadow matrices", std::span<const glm::mat4>(head.shadow_from_world), storage);
    instance.shadow_from_world = head.shadow_from_world;
    data.instances.push_back(std::move(instance));
  }
  return data;
}

void fill_times(Statistics& statistics, const std::vector<frame::FrameTime>& frames, bool separate) {
  std::vector<double> totals;
  for (const frame::FrameTime& f : frames) totals.push_back(f.total_ms);
  statistics.frame_ms_median = median(totals);
  statistics.frame_ms_min = *std::min_element(totals.begin(), totals.end());
  statistics.frame_ms_max = *std::max_element(totals.begin(), totals.end());
  statistics.frames = static_cast<int>(frames.size());
  statistics.timing = separate ? "submit" : "timestamp";
  for (std::size_t p = 0; p < frames.front().passes.size(); ++p) {
    std::vector<double> times;
    for (const frame::FrameTime& f : frames) times.push_back(f.passes[p].ms);
    statistics.passes.push_back({.name = frames.front().passes[p].name, .ms = median(times), .calls = 1});
  }
}

}  // namespace

struct Renderer::State {
  gpu::Device device;
  gpu::PipelineLibrary library;
  explicit State(const Options& options)
      : device({.select = options.device, .validate = options.validate}),
        library(device, passes::find_shader, gpu::default_pipeline_cache()) {}
};

Renderer::Renderer(const Options& options) : state_(std::make_unique<State>(options)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

std::vector<std::string> Renderer::validation_messages() const { return state_->device.validation_messages(); }

Picture Renderer::render(const Scene& scene, const RenderSettings& settings) {
  gpu::Device& device = state_->device;
  api::check_settings(settings);
  api::check_device_limits(settings, device.limits());
  const api::FrameSetup setup = api::set_up(scene.data(), settings);
  if (setup.plan.shadow_layers > device.limits().max_array_layers)
    throw input_error(scene.name(), "{} lights need {} shadow maps a head, this device has at most {}; --lights uses fewer", setup.lights,
                      setup.plan.shadow_layers, device.limits().max_array_layers);
  frame::FramePlan plan;
  const techniques::FrameOutputs out = setup.technique->build(plan, setup.plan);
  api::check_show(out, settings);
  // Before the scene is prepared: a frame that does not fit must say so at once, not after a minute of work on its maps.
  const double pipelines_before = state_->library.creation_ms();
  frame::Executor executor(state_->library, std::move(plan));
  const double pipelines_ms = state_->library.creation_ms() - pipelines_before;
  state_->library.save_cache();

  const auto upload_start = Clock::now();
  const passes::GpuScene gpu_scene(state_->library, scene.data(), setup.skin, api::upload_settings(settings, setup));
  const frame::FrameData data = frame_data(device, setup, gpu_scene);
  Picture picture;
  Statistics& statistics = picture.statistics;
  statistics.upload_ms = ms_since(upload_start);
  statistics.pipeline_ms = pipelines_ms;

  // The first frame warms up (first use of a pipeline compiles on software devices) and counts.
  executor.run_counting(data);
  const std::vector<std::byte> counters = gpu::read_back(device, executor.resources().buffer(out.counters));
  std::vector<frame::FrameTime> frames;
  for (int i = 0; i < settings.frames; ++i) frames.push_back(executor.run(data));
  fill_times(statistics, frames, executor.separate_submissions());
  api::fill_counts(statistics, scene.data(), settings, setup, out, counters);
  const gpu::DeviceSummary& summary = device.summary();
  statistics.device = summary.name, statistics.driver = summary.driver, statistics.api = summary.api;
  statistics.image_bytes = device.image_bytes(), statistics.buffer_bytes = device.buffer_bytes(),
  statistics.peak_bytes = device.peak_bytes();
  api::read_picture(picture, executor, out, settings);
  return picture;
}

std::vector<std::string> technique_names() {
  std::vector<std::string> names;
  for (const techniques::Technique& t : techniques::techniques()) names.emplace_back(t.name);
  return names;
}

std::string describe_plan(const Scene& scene, const RenderSettings& settings, bool dot) {
  const api::FrameSetup setup = api::set_up(scene.data(), settings);
  frame::FramePlan plan;
  setup.technique->build(plan, setup.plan);
  return dot ? frame::print_dot(plan) : frame::print_text(plan);
}

}  // namespace dermis
