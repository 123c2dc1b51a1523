// SPDX-License-Identifier: MIT
#include "dermis/session.h"

#include <atomic>
#include <utility>
#include <vector>

#include "api/output.h"
#include "api/outputs.h"
#include "api/planned_frame.h"
#include "base/core/error.h"
#include "gpu/frame_memory.h"
#include "gpu/transfer.h"

namespace dermis {
namespace {

// Memory of one frame in flight.
struct Slot {
  Slot(gpu::Device& device, std::size_t number) : memory(device, fmt::format("frame {}", number)) {}

  gpu::FrameMemory memory;
  std::shared_ptr<api::Readback> readback;  // null until a frame needs it
  gpu::Buffer counters;                     // read back; empty until a frame needs it
  RenderSettings settings;
  setup::FrameSetup setup;
  api::SceneOnDevice scene;
  std::uint64_t counter_bytes = 0;
  api::RecordCounts recorded;
  std::uint64_t ticket = 0;  // 0: none
  std::uint64_t serial = 0;  // of its submission
};

void check_options(const Session::Options& options) {
  if (options.frames_in_flight < 1 || options.frames_in_flight > 3)
    throw input_error("", "frames_in_flight must be 1 to 3, got {}", options.frames_in_flight);
  if (options.wanted == Outputs{}) throw input_error("", "a session must want at least one output");
}

void check_request(const RenderSettings& settings, std::span<const View> views) {
  if (views.size() != 1) throw input_error("", "a session draws one view per frame, got {}", views.size());
  if (!settings.output.exposure_ev)
    throw input_error("",
                      "an automatic output.exposure_ev needs frames of its own; give a session the number "
                      "that a picture with it reports");
  if (settings.output.show != "picture")
    throw input_error("", "output.show must be 'picture' in a session, got '{}'", settings.output.show);
}

}  // namespace

struct Session::State {
  State(std::shared_ptr<Renderer::State> renderer, const Options& wanted)
      : options(wanted),
        frame(std::move(renderer), {.all_views = true,
                                    .picture = wanted.wanted.has_any(Outputs::lit()),
                                    .display = wanted.wanted.has(Output::display),
                                    .linear = wanted.wanted.has(Output::linear),
                                    .matte = wanted.wanted.has(Output::matte),
                                    .labels = api::label_bits(wanted.wanted)}) {
    for (int i = 0; i < options.frames_in_flight; ++i)
      slots.push_back(std::make_unique<Slot>(frame.device(), slots.size()));
  }

  Options options;
  api::PlannedFrame frame;
  std::vector<std::unique_ptr<Slot>> slots;
  std::uint64_t last_ticket = 0, last_serial = 0;
  bool first_of_plan = true;  // the last frame had passes that the next one has not

  void draw(const Scene& scene, const RenderSettings& settings);
  void record(VkCommandBuffer commands, Slot& slot, const passes::FrameData& data);
  const Slot& slot_of(Ticket ticket) const;
  void offer_readback(Slot& slot);
  Results results(const Slot& slot) const;
  Statistics statistics(const Slot& slot) const;
  Picture picture(const Slot& slot) const;
};

void Session::State::draw(const Scene& scene, const RenderSettings& settings) {
  gpu::Device& device = frame.device();
  const bool is_first = frame.set(scene, settings);

  // Barriers hold between frames that have the same passes.
  if (first_of_plan || is_first) device.wait(last_serial);
  first_of_plan = is_first;

  Slot& slot = *slots[(last_ticket + 1) % slots.size()];
  device.wait(slot.serial);
  slot.ticket = 0;
  slot.settings = settings;
  slot.setup = frame.setup();
  slot.scene = frame.scene();
  slot.memory.clear();
  const passes::FrameData data = frame.data(slot.memory);

  VkCommandBuffer commands = device.begin();
  try {
    record(commands, slot, data);
  } catch (...) {
    device.discard(commands);
    frame.make_unready();
    throw;
  }
  last_serial = slot.serial = device.submit(commands);
  slot.ticket = ++last_ticket;
}

// Memory for the results, unless what the slot has is free again.
void Session::State::offer_readback(Slot& slot) {
  const auto pixels = static_cast<std::uint64_t>(slot.settings.output.width) *
                      static_cast<std::uint64_t>(slot.settings.output.height);
  const api::ReadbackSizes sizes = api::readback_sizes(options.wanted, pixels);
  if (slot.readback && slot.readback.use_count() == 1 && slot.readback->sizes == sizes) {
    std::atomic_thread_fence(std::memory_order_acquire);  // after whoever has released it
    return;
  }

  slot.readback.reset();
  Renderer::State& renderer = frame.renderer();
  slot.readback = {renderer.readbacks.take(frame.device(), sizes).release(),
                   [keeps = frame.shared_renderer()](api::Readback* readback) {
                     keeps->readbacks.give(std::unique_ptr<api::Readback>(readback));
                   }};
}

void Session::State::record(VkCommandBuffer commands, Slot& slot, const passes::FrameData& data) {
  gpu::Device& device = frame.device();
  const techniques::FrameOutputs& outputs = frame.outputs();
  const frame::Resources& resources = frame.executor().resources();
  offer_readback(slot);

  slot.memory.record(commands);
  slot.recorded = frame.count(
      [&] { frame.executor().record(commands, data, {.changed = true, .statistics = options.statistics}); });

  const api::Readback& to = *slot.readback;
  if (to.display)
    gpu::record_read_back(device, commands, resources.texture(outputs.display),
                          frame.executor().layout_of(outputs.display), to.display);
  if (to.linear) gpu::record_read_back(device, commands, resources.buffer(outputs.linear), to.linear);
  if (to.matte) gpu::record_read_back(device, commands, resources.buffer(outputs.matte), to.matte);
  if (to.labels) gpu::record_read_back(device, commands, resources.buffer(outputs.labels), to.labels);

  const gpu::Buffer& counters = resources.buffer(outputs.counters);
  slot.counter_bytes = counters.desc().bytes;
  if (!options.statistics) return;
  if (!slot.counters || slot.counters.desc().bytes != slot.counter_bytes)
    slot.counters = gpu::Buffer(device, "counters to read",
                                {.bytes = slot.counter_bytes, .place = gpu::BufferPlace::readback});
  gpu::record_read_back(device, commands, counters, slot.counters);
}

const Slot& Session::State::slot_of(Ticket ticket) const {
  const auto number = static_cast<std::uint64_t>(ticket);
  for (const std::unique_ptr<Slot>& slot : slots)
    if (slot->ticket == number && number != 0) return *slot;
  throw input_error("", "ticket {} is not of the last {} frames of this session", number, slots.size());
}

Results Session::State::results(const Slot& slot) const {
  frame.device().wait(slot.serial);
  return api::results_of(options.wanted, slot.settings.output.width, slot.settings.output.height,
                         slot.readback);
}

Statistics Session::State::statistics(const Slot& slot) const {
  gpu::Device& device = frame.device();
  device.wait(slot.serial);

  Statistics statistics;
  // Not counted: zero.
  std::vector<std::byte> counters(slot.counter_bytes);
  if (options.statistics) {
    const std::span<const std::byte> counted = slot.counters.mapped();
    counters.assign(counted.begin(), counted.end());
  }
  api::fill_counts(statistics, slot.scene.different_assets(), slot.settings, slot.setup, counters);
  api::fill_recorded(statistics, slot.recorded);
  api::fill_device(statistics, device);
  statistics.exposure_ev = *slot.settings.output.exposure_ev;
  const api::ReadbackSizes& sizes = slot.readback->sizes;
  statistics.read_back_bytes = sizes.display + sizes.linear + sizes.matte + sizes.labels;
  if (options.statistics) statistics.read_back_bytes += slot.counter_bytes;
  return statistics;
}

Picture Session::State::picture(const Slot& slot) const {
  if (!options.wanted.has_all(Outputs::picture()))
    throw input_error("", "a copy of the picture needs a session that wants display and linear");
  const Results found = results(slot);
  Picture picture{.width = found.width,
                  .height = found.height,
                  .linear_rgba = {found.linear.begin(), found.linear.end()},
                  .display_rgba = {found.display.begin(), found.display.end()},
                  .statistics = statistics(slot)};
  picture.statistics.copied_bytes = found.linear.size_bytes() + found.display.size_bytes();
  return picture;
}

Session::Session(const Renderer& renderer, const Options& options) {
  check_options(options);
  state_ = std::make_unique<State>(renderer.state_, options);
}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Ticket Session::draw(const Scene& scene, const RenderSettings& settings) {
  const View view{.camera = settings.camera};
  return draw(scene, settings, std::span(&view, 1));
}

Ticket Session::draw(const Scene& scene, const RenderSettings& settings, std::span<const View> views) {
  State& s = *state_;
  s.frame.renderer().preparing(scene, [&] {
    check_request(settings, views);
    RenderSettings of_view = settings;
    of_view.camera = views.front().camera;
    of_view.camera.heads = settings.camera.heads;
    s.draw(scene, of_view);
  });
  return Ticket{s.last_ticket};
}

bool Session::is_ready(Ticket ticket) const {
  return state_->frame.device().has_completed(state_->slot_of(ticket).serial);
}

Results Session::results(Ticket ticket) const { return state_->results(state_->slot_of(ticket)); }

Statistics Session::statistics(Ticket ticket) const { return state_->statistics(state_->slot_of(ticket)); }

Picture Session::picture(Ticket ticket) const { return state_->picture(state_->slot_of(ticket)); }

}  // namespace dermis
