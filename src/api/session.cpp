// SPDX-License-Identifier: MIT
#include "dermis/session.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "api/labels.h"
#include "api/output.h"
#include "api/planned_frame.h"
#include "core/error.h"
#include "gpu/frame_memory.h"
#include "gpu/transfer.h"

namespace dermis {
namespace {

// What one frame in flight has for itself.
struct Slot {
  Slot(gpu::Device& device, std::size_t number) : memory(device, fmt::format("frame {}", number)) {}

  gpu::FrameMemory memory;
  // Read back; empty until a frame needs them.
  gpu::Buffer picture, display, counters, label_surface, label_names, label_motion, label_body;
  RenderSettings settings;
  setup::FrameSetup setup;
  api::SceneOnDevice scene;
  std::uint64_t counter_bytes = 0;
  api::RecordCounts recorded;
  std::uint64_t ticket = 0;  // 0: none
  std::uint64_t serial = 0;  // of its submission
};

void make_readback(gpu::Device& device, gpu::Buffer& buffer, const char* name, std::uint64_t bytes) {
  if (buffer && buffer.desc().bytes == bytes) return;
  buffer = gpu::Buffer(device, name, {.bytes = bytes, .place = gpu::BufferPlace::readback});
}

void check_options(const Session::Options& options) {
  if (options.frames_in_flight < 1 || options.frames_in_flight > 3)
    throw input_error("", "frames_in_flight must be 1 to 3, got {}", options.frames_in_flight);
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
      : options(wanted), frame(std::move(renderer), {.all_views = true, .labels = wanted.labels}) {
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
  Picture picture(const Slot& slot) const;
  Labels labels(const Slot& slot) const;
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

void Session::State::record(VkCommandBuffer commands, Slot& slot, const passes::FrameData& data) {
  gpu::Device& device = frame.device();
  const techniques::FrameOutputs& outputs = frame.outputs();
  const frame::Resources& resources = frame.executor().resources();
  const auto pixels = std::uint64_t(slot.settings.output.width) * std::uint64_t(slot.settings.output.height);
  make_readback(device, slot.picture, "picture to read", 8 * pixels);
  make_readback(device, slot.display, "display values to read", 4 * pixels);

  slot.memory.record(commands);
  slot.recorded = frame.count(
      [&] { frame.executor().record(commands, data, {.changed = true, .statistics = options.statistics}); });

  const auto copy = [&](frame::TextureId id, const gpu::Buffer& to) {
    gpu::record_read_back(device, commands, resources.texture(id), frame.executor().layout_of(id), to);
  };
  copy(outputs.picture, slot.picture);
  copy(outputs.display, slot.display);
  if (options.labels) {
    make_readback(device, slot.label_surface, "label surfaces to read", 16 * pixels);
    make_readback(device, slot.label_names, "label names to read", 16 * pixels);
    copy(outputs.label_surface, slot.label_surface);
    copy(outputs.label_names, slot.label_names);
    make_readback(device, slot.label_motion, "label motions to read", 8 * pixels);
    copy(outputs.label_motion, slot.label_motion);
    make_readback(device, slot.label_body, "label bodies to read", 16 * pixels);
    copy(outputs.label_body, slot.label_body);
  }

  const gpu::Buffer& counters = resources.buffer(outputs.counters);
  slot.counter_bytes = counters.desc().bytes;
  if (!options.statistics) return;
  make_readback(device, slot.counters, "counters to read", counters.desc().bytes);
  gpu::record_read_back(device, commands, counters, slot.counters);
}

const Slot& Session::State::slot_of(Ticket ticket) const {
  const auto number = static_cast<std::uint64_t>(ticket);
  for (const std::unique_ptr<Slot>& slot : slots)
    if (slot->ticket == number && number != 0) return *slot;
  throw input_error("", "ticket {} is not of the last {} frames of this session", number, slots.size());
}

Picture Session::State::picture(const Slot& slot) const {
  gpu::Device& device = frame.device();
  device.wait(slot.serial);

  Picture picture;
  api::fill_picture(picture, slot.settings, slot.picture.mapped(), slot.display.mapped());
  // Not counted: zero.
  std::vector<std::byte> counters(slot.counter_bytes);
  if (options.statistics) {
    const std::span<const std::byte> counted = slot.counters.mapped();
    counters.assign(counted.begin(), counted.end());
  }
  api::fill_counts(picture.statistics, slot.scene.subjects(), slot.settings, slot.setup, counters);
  api::fill_recorded(picture.statistics, slot.recorded);
  api::fill_device(picture.statistics, device);
  picture.statistics.exposure_ev = *slot.settings.output.exposure_ev;
  return picture;
}

Labels Session::State::labels(const Slot& slot) const {
  if (!options.labels) throw input_error("", "this session draws no labels: its Options do not ask for them");
  frame.device().wait(slot.serial);
  return api::labels_of(slot.settings.output.width, slot.settings.output.height, slot.label_surface.mapped(),
                        slot.label_names.mapped(), slot.label_motion.mapped(), slot.label_body.mapped());
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

Picture Session::picture(Ticket ticket) const {
  const Slot& slot = state_->slot_of(ticket);
  return state_->picture(slot);
}

Labels Session::labels(Ticket ticket) const {
  const Slot& slot = state_->slot_of(ticket);
  return state_->labels(slot);
}

}  // namespace dermis
