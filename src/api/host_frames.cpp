// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "api/host_check.h"
#include "api/host_frames_state.h"
#include "api/scene_state.h"
#include "base/core/error.h"
#include "render/setup/camera_matrices.h"

namespace dermis::vulkan {

HostFrames::State::State(std::shared_ptr<Renderer::State> renderer, const Options& wanted)
    : options(wanted), frame(std::move(renderer), {.all_views = true}) {
  for (std::uint32_t i = 0; i < options.frames_in_flight; ++i)
    slots.push_back(std::make_unique<Slot>(frame.device(), slots.size()));
  for (const DepthTargets& depth : options.depths)
    depths.emplace_back(frame.renderer().library,
                        passes::HostDepthFormat{depth.format, depth.samples, depth.reversed_depth});
}

void HostFrames::State::update(const Scene& wanted, const RenderSettings& settings,
                               const HostInputs& wanted_inputs) {
  api::check_host_settings(settings);
  HostImages next_images;
  const setup::HostSetup host = host_setup(options, wanted, settings, wanted_inputs, next_images);

  // The plan of before may point to the images of before until this has gone well.
  frame.set(wanted, settings, host);
  images = std::move(next_images);
  // Unready until all below is done: any of it may throw.
  frame.pause();
  scene = wanted;
  inputs = wanted_inputs;
  records = api::HostRecords(frame.scene().assets(), frame.setup().plan.host_lights() ? 0 : 1);
  ids = scene.instances();
  move.keep(frame.scene(), ids, inputs.deformed);

  // All frames take as much, whatever their camera.
  fill(*slots.front(), true);
  for (const std::unique_ptr<Slot>& slot : slots) slot->memory.reserve(slots.front()->memory.bytes());
  frame.make_ready();
}

// Writes what the frame shows; nothing reaches the device before it is recorded.
HostFrames::State::Filled HostFrames::State::fill(Slot& slot, bool measured) {
  slot.memory.clear();
  Filled filled{.data = frame.data(slot.memory, measured), .records = {}};
  for (passes::Head& head : filled.data.heads) head.vertices = move.vertices_of(head.instance);
  filled.records = slot.memory.add(std::span<const api::HostRecord>(records.of(filled.data)));
  return filled;
}

void HostFrames::State::check_ready() const {
  if (!frame.is_ready()) throw input_error("", "nothing to record: update() must succeed first");
}

// Returns the slot of a frame that has finished.
HostFrames::State::Slot& HostFrames::State::begin(const FrameNumbers& numbers) {
  if (numbers.frame <= last.frame)
    throw input_error("", "frame {} must come after frame {}", numbers.frame, last.frame);
  if (numbers.finished < last.finished)
    throw input_error("", "frame {} had finished, so {} cannot be the last one", last.finished,
                      numbers.finished);
  if (numbers.finished >= numbers.frame)
    throw input_error("", "frame {} cannot have finished before frame {} is recorded", numbers.finished,
                      numbers.frame);

  const auto free = std::find_if(slots.begin(), slots.end(), [&](const std::unique_ptr<Slot>& slot) {
    return slot->frame <= numbers.finished;
  });
  if (free == slots.end())
    throw input_error("", "{} frames are in flight already: wait until frame {} has finished", slots.size(),
                      (*std::min_element(slots.begin(), slots.end(), [](const auto& a, const auto& b) {
                        return a->frame < b->frame;
                      }))->frame);
  return **free;
}

void HostFrames::State::set_targets(const View& view) {
  if (!options.picture) return;
  const auto texture = [&](const char* name, VkFormat format, VkImageUsageFlags usage, VkImageView image) {
    return gpu::Texture(name,
                        {.width = view.extent.width,
                         .height = view.extent.height,
                         .format = format,
                         .samples = options.picture->samples,
                         .usage = usage},
                        image);
  };
  const techniques::FrameOutputs& outputs = frame.outputs();
  frame.executor().set_texture_of_host(outputs.host_colour,
                                       texture("colour of the host", options.picture->colour_format,
                                               VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, view.colour));
  frame.executor().set_texture_of_host(outputs.host_depth,
                                       texture("depth of the host", options.picture->depth_format,
                                               VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, view.depth));
}

passes::DrawIrradiance HostFrames::State::irradiance_drawer(const gpu::BufferBinding& records_at) const {
  if (!inputs.draw_irradiance) return {};
  return
      [this, records_at](gpu::Cmd& cmd, const gpu::Texture& map, std::span<const passes::UsedSquare> used) {
        std::vector<IrradianceSquare> squares;
        for (const passes::UsedSquare& square : used) {
          const passes::Head& head = frame.setup().heads[square.head];
          const std::uint32_t mesh = square.mesh - frame.setup().plan.models[head.model].first_mesh;
          squares.push_back({.instance = ids[head.instance],
                             .skin_mesh = mesh,
                             .area = square.area(),
                             .record = records.number(head.instance, mesh)});
        }
        inputs.draw_irradiance(cmd.handle(), {.view = map.layer_view(0),
                                              .extent = {map.desc().width, map.desc().height},
                                              .squares = squares,
                                              .records = records_at.buffer->handle(),
                                              .records_offset = records_at.offset,
                                              .records_bytes = records_at.bytes});
      };
}

Recorded HostFrames::State::record(VkCommandBuffer commands, std::span<const View> views,
                                   const FrameNumbers& numbers) {
  check_ready();
  api::check_handle("commands", commands != VK_NULL_HANDLE);
  if (views.size() != 1) throw input_error("", "one view per frame so far, got {}", views.size());
  const View& view = views.front();
  const VkRect2D area = api::checked_area("view", view.extent, view.area, frame.device().limits());
  if (options.picture) {
    api::check_handle("view.colour", view.colour != VK_NULL_HANDLE);
    api::check_handle("view.depth", view.depth != VK_NULL_HANDLE);
    api::check_room(view.extent, *options.picture);
  }
  Slot& slot = begin(numbers);
  frame.set_view(view.camera, area);

  last = numbers;
  gpu::Device& device = frame.device();
  device.begin_host_frame(numbers.frame, numbers.finished);
  slot.frame = numbers.frame;
  Filled filled = fill(slot);
  filled.data.area = area;
  filled.data.draw_irradiance = irradiance_drawer(filled.records);
  set_targets(view);

  gpu::Cmd cmd(device, commands);
  cmd.barrier_all();
  slot.memory.record(commands);
  frame.posed().record(cmd);
  frame.executor().record(commands, filled.data, {.changed = true});
  cmd.barrier_all();

  Recorded recorded;
  if (!options.scattered || !frame.outputs().scattered.valid()) return recorded;
  recorded.scattered = frame.executor().resources().texture(frame.outputs().scattered).view();
  recorded.records = filled.records.buffer->handle();
  recorded.records_offset = filled.records.offset;
  recorded.records_bytes = filled.records.bytes;
  return recorded;
}

void HostFrames::State::record_depth(VkCommandBuffer commands, const std::array<double, 16>& clip_from_world,
                                     const DepthView& view) {
  check_ready();
  api::check_handle("commands", commands != VK_NULL_HANDLE);
  api::check_handle("view.depth", view.depth != VK_NULL_HANDLE);
  api::check_finite("clip_from_world", clip_from_world);
  if (view.targets >= depths.size())
    throw input_error("", "view.targets must be below {}, the number of Options::depths, got {}",
                      depths.size(), view.targets);
  passes::HostDepthTarget target{
      .area = api::checked_area("view", view.extent, view.area, frame.device().limits()),
      .y_down = view.y_down,
      .cull = view.cull};
  for (int i = 0; i < 16; ++i)
    target.clip_from_world[i / 4][i % 4] = static_cast<float>(clip_from_world[static_cast<std::size_t>(i)]);

  const DepthTargets& kind = options.depths[view.targets];
  const gpu::Texture depth("depth of the host",
                           {.width = view.extent.width,
                            .height = view.extent.height,
                            .format = kind.format,
                            .samples = kind.samples,
                            .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT},
                           view.depth);
  target.depth = &depth;

  std::vector<passes::Head> shown;
  for (const passes::Head& head : frame.setup().heads) {
    if (!scene.instance(ids[head.instance]).visible) continue;
    // Of what the set-up has decided, depth needs no more.
    shown.emplace_back().instance = head.instance;
    shown.back().world_from_asset = head.world_from_asset;
  }
  frame.scene().give(shown);
  for (passes::Head& head : shown) {
    head.vertices = move.vertices_of(head.instance);
    head.posed = frame.posed().shape(head.instance);
    head.placements = frame.posed().placements(head.instance);
  }

  gpu::Cmd cmd(frame.device(), commands);
  cmd.barrier_all();
  frame.posed().record(cmd);
  depths[view.targets].record(cmd, target, shown);
  cmd.barrier_all();
}

std::uint32_t HostFrames::State::record_of(InstanceId instance, std::uint32_t skin_mesh) const {
  check_ready();
  const auto found = std::find(ids.begin(), ids.end(), instance);
  if (found == ids.end())
    throw input_error("", "instance {} is not in the scene of the last update()",
                      static_cast<std::uint32_t>(instance));
  const auto number = static_cast<std::size_t>(found - ids.begin());
  if (skin_mesh >= records.meshes(number))
    throw input_error("", "instance {} has {} skin meshes, so there is no number {}",
                      static_cast<std::uint32_t>(instance), records.meshes(number), skin_mesh);
  return records.number(number, skin_mesh);
}

HostFrames::HostFrames(const Renderer& renderer, const Options& options) {
  const std::shared_ptr<Renderer::State>& shared = renderer.state_;
  shared->drawing(Scene(), [&] {
    api::check_host_options(options, shared->device);
    state_ = std::make_unique<State>(shared, options);
  });
}
HostFrames::HostFrames(HostFrames&&) noexcept = default;
HostFrames& HostFrames::operator=(HostFrames&&) noexcept = default;
HostFrames::~HostFrames() = default;

void HostFrames::update(const Scene& scene, const RenderSettings& settings, const HostInputs& inputs) {
  State& s = *state_;
  s.frame.renderer().preparing(scene, [&] {
    try {
      s.update(scene, settings, inputs);
    } catch (const InputError&) { throw; } catch (...) {
      s.frame.make_unready();
      throw;
    }
  });
}

Recorded HostFrames::record(VkCommandBuffer commands, std::span<const View> views,
                            const FrameNumbers& numbers) {
  State& s = *state_;
  return s.frame.renderer().drawing(s.scene, [&] { return s.record(commands, views, numbers); });
}

void HostFrames::record_depth(VkCommandBuffer commands, const std::array<double, 16>& clip_from_world,
                              const DepthView& view) {
  State& s = *state_;
  s.frame.renderer().drawing(s.scene, [&] { s.record_depth(commands, clip_from_world, view); });
}

void HostFrames::record_deformation(VkCommandBuffer commands, InstanceId instance,
                                    std::span<const DeformedMesh> meshes) {
  State& s = *state_;
  s.frame.renderer().drawing(s.scene, [&] {
    s.check_ready();
    api::check_handle("commands", commands != VK_NULL_HANDLE);
    s.move.record(commands, instance, meshes);
  });
}

std::uint32_t HostFrames::record_of(InstanceId instance, std::uint32_t skin_mesh) const {
  return state_->record_of(instance, skin_mesh);
}

std::array<double, 16> clip_from_world(const CameraMatrices& camera) {
  const glm::dmat4 product =
      setup::matrix_of(camera.clip_from_camera) * setup::matrix_of(camera.camera_from_world);
  std::array<double, 16> out{};
  for (int i = 0; i < 16; ++i) out[static_cast<std::size_t>(i)] = product[i / 4][i % 4];
  return out;
}

}  // namespace dermis::vulkan
