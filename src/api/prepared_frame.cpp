// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <utility>

#include "api/exposure.h"
#include "api/output.h"
#include "api/planned_frame.h"
#include "base/core/log.h"
#include "dermis/cancelled.h"
#include "gpu/frame_memory.h"

namespace dermis {

struct PreparedFrame::State {
  State(std::shared_ptr<Renderer::State> renderer, const Scene& scene)
      : source(scene), frame(std::move(renderer)) {}

  Scene source;
  RenderSettings settings;
  api::PlannedFrame frame;
  gpu::FrameMemory memory{frame.device(), "frame"};
  passes::FrameData data;
  std::vector<frame::FrameTime> times;  ///< since the last change
  std::vector<std::byte> counters;      ///< of this view; empty: not counted yet
  api::RecordCounts recorded;           ///< likewise
  bool changed = true;                  ///< `data`, since the last frame
  std::optional<double> exposure_ev;    ///< given or chosen; none: it was to be chosen, and no skin is lit

  void set(const Scene& wanted_scene, const RenderSettings& wanted);
  std::optional<double> measure_exposure();
  void draw(bool with_statistics);
  void count();
  Picture picture();
};

void PreparedFrame::State::set(const Scene& wanted_scene, const RenderSettings& wanted) {
  frame.set(wanted_scene, wanted);
  // Unready until all below is done: any of it may throw.
  frame.make_unready();
  settings = wanted;
  source = wanted_scene;
  memory.clear();
  data = frame.data(memory);
  memory.upload();
  changed = true;

  exposure_ev = wanted.output.exposure_ev;
  if (!exposure_ev) exposure_ev = measure_exposure();
  if (!exposure_ev)
    warn("{}: no lit skin in the picture, so an automatic output.exposure_ev is 0", source.name());
  times.clear();
  counters.clear();
  frame.make_ready();
}

// Draws frames of the same view with white skin that does not reflect at its surface: they show the light on
// the skin. Exposes the view by what is found, and returns that; none: no lit skin, 0 EV.
std::optional<double> PreparedFrame::State::measure_exposure() {
  const auto expose = [&](io::FrameIo io, double ev) {
    io.radiance_scale = static_cast<float>(std::exp2(ev));
    memory.replace(data.frame_io, std::span<const io::FrameIo>(&io, 1));
    memory.upload();
    changed = true;
  };

  // Other light enters white skin: what its frames leave in shadow maps is not kept.
  std::vector<std::uint64_t> versions;
  for (passes::Head& head : data.heads) versions.push_back(std::exchange(head.shadow_version, 0));

  io::FrameIo white = frame.setup().frame;
  white.white_albedo = 1;
  white.specular_on = 0;
  const std::optional<double> ev = api::choose_exposure([&](double tried_ev) {
    expose(white, tried_ev);
    draw(false);
    return api::mean_skin_luminance(api::read_before_bloom(frame.executor(), frame.outputs()));
  });

  expose(frame.setup().frame, ev.value_or(0));
  for (std::size_t i = 0; i < versions.size(); ++i) data.heads[i].shadow_version = versions[i];
  return ev;
}

void PreparedFrame::State::draw(bool with_statistics) {
  if (frame.renderer().options.poison) frame.executor().poison();
  frame.executor().draw(data, {.changed = changed, .statistics = with_statistics});
  changed = false;
}

// The first frame of a view warms up (the first use of a pipeline compiles on software devices), makes what
// lasts, and counts.
void PreparedFrame::State::count() {
  if (!frame.is_ready())
    throw Cancelled(source.name() + ": the frame was stopped while it was prepared; set() prepares it again");
  if (!counters.empty()) return;
  recorded = frame.count([&] { draw(true); });
  counters = gpu::read_back(frame.device(), frame.executor().resources().buffer(frame.outputs().counters));
}

PreparedFrame Renderer::prepare(const Scene& scene, const RenderSettings& settings) {
  auto state = std::make_unique<PreparedFrame::State>(state_, scene);
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
    state_->frame.renderer().preparing(scene, [&] { state_->set(scene, settings); });
  } catch (const InputError&) { throw; } catch (...) {
    // The frame may be half changed: refuse to draw it until a set() succeeds.
    state_->frame.make_unready();
    throw;
  }
}

double PreparedFrame::draw() {
  return state_->frame.renderer().drawing(state_->source, [&] {
    state_->count();
    if (state_->frame.renderer().options.poison) state_->frame.executor().poison();
    state_->times.push_back(state_->frame.executor().run(state_->data));
    state_->recorded.work = state_->frame.executor().recorded();
    return state_->times.back().total_ms;
  });
}

std::vector<PassStatistics> PreparedFrame::last_passes() const {
  if (state_->times.empty()) return {};
  return api::passes_of(state_->times.back(), state_->frame.executor().graph());
}

Picture PreparedFrame::picture() {
  return state_->frame.renderer().drawing(state_->source, [&] { return state_->picture(); });
}

Picture PreparedFrame::State::picture() {
  count();
  Picture picture;
  Statistics& statistics = picture.statistics;

  statistics.timing = frame.executor().separate_submissions() ? "submit" : "timestamp";
  if (!times.empty()) api::fill_times(statistics, times, frame.executor().graph());
  api::fill_counts(statistics, frame.scene().different_assets(), settings, frame.setup(), counters);
  api::fill_recorded(statistics, recorded);
  statistics.upload_ms = frame.scene().upload_ms();
  statistics.pipeline_ms = frame.pipeline_ms();

  api::fill_device(statistics, frame.device());
  statistics.exposure_ev = exposure_ev.value_or(0);
  if (!settings.output.exposure_ev && exposure_ev)
    statistics.skin_mean =
        api::mean_skin_luminance(api::read_before_bloom(frame.executor(), frame.outputs()));

  api::read_picture(picture, frame.executor(), frame.outputs(), settings, frame.setup());
  return picture;
}

}  // namespace dermis
