// SPDX-License-Identifier: MIT
// embedding OUT.ppm [--frames N] [--linear OUT.pfm] [--validate]: an engine, as small as it goes, with heads
// of dermis in its own frames. The left head is drawn by dermis into the engine's colour and depth (way (i)
// of dermis/vulkan.h), the right one by the engine's own shaders with the light that dermis has spread in its
// skin (way (iii)) and the engine's own shadow map (way (ii)). All of a frame is one command buffer, two
// frames are in flight, and half way the window changes its size. Draws off screen, and writes the last
// frame.
#include <dermis/renderer.h>
#include <dermis/vulkan.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <string>

#include "arguments.h"
#include "device.h"
#include "picture.h"
#include "pipeline.h"
#include "stage.h"

namespace {

constexpr std::uint32_t frames_in_flight = 2;
constexpr VkExtent2D first_size{320, 240}, second_size{400, 320};  // of the window, pixels
constexpr VkExtent2D largest_size = second_size, shadow_size{1024, 1024};
constexpr VkFormat colour_format = VK_FORMAT_R16G16B16A16_SFLOAT, depth_format = VK_FORMAT_D32_SFLOAT;

constexpr std::uint32_t floor_vert[] = {
#include "floor.vert.inc"
};
constexpr std::uint32_t floor_frag[] = {
#include "floor.frag.inc"
};
constexpr std::uint32_t head_vert[] = {
#include "head.vert.inc"
};
constexpr std::uint32_t head_frag[] = {
#include "head.frag.inc"
};

// Both as shaders/host.glsl has them.
struct FrameConstants {
  glm::mat4 clip_from_world, shadow_from_world;
  glm::vec4 eye_m, to_lamp, lamp_irradiance;
};
struct Push {
  glm::mat4 world_from_asset{1};
  glm::vec4 albedo{};  // w: roughness
  std::uint32_t record = 0;
};

struct Targets {
  host::Image colour, depth;
};

host::Pipeline floor_pipeline(const host::Device& device) {
  return {device,
          {.vertex = floor_vert,
           .fragment = floor_frag,
           .colour_format = colour_format,
           .depth_format = depth_format,
           .descriptors = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
           .push_bytes = sizeof(Push)}};
}

host::Pipeline head_pipeline(const host::Device& device) {
  return {device,
          {.vertex = head_vert,
           .fragment = head_frag,
           .colour_format = colour_format,
           .depth_format = depth_format,
           .vertex_buffers = {{0, sizeof(glm::vec3), VK_VERTEX_INPUT_RATE_VERTEX},
                              {1, sizeof(glm::vec3), VK_VERTEX_INPUT_RATE_VERTEX},
                              {2, sizeof(glm::vec2), VK_VERTEX_INPUT_RATE_VERTEX}},
           .attributes = {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
                          {1, 1, VK_FORMAT_R32G32B32_SFLOAT, 0},
                          {2, 2, VK_FORMAT_R32G32_SFLOAT, 0}},
           .descriptors = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                           VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER},
           .push_bytes = sizeof(Push)}};
}

class Engine {
 public:
  explicit Engine(const host::Device& device);
  /// Records and submits a frame.
  void draw(VkExtent2D window);
  /// Returns the frame drawn last. Waits for it.
  host::Picture last_picture();

 private:
  // What each frame in flight has for itself.
  struct PerFrame {
    Targets targets;
    host::Buffer constants;
  };
  void make_targets(PerFrame& own, VkExtent2D window) const;
  void draw_shadow_map(VkCommandBuffer commands);
  void draw_floor(VkCommandBuffer commands, const PerFrame& own, std::uint32_t slot) const;
  void draw_right_head(VkCommandBuffer commands, const PerFrame& own, std::uint32_t slot,
                       const dermis::vulkan::Recorded& recorded) const;

  const host::Device* device_;
  stage::Stage stage_;
  host::Buffer positions_, normals_, uvs_, indices_;
  host::Pipeline floor_, head_;
  host::DescriptorSets floor_sets_, head_sets_;
  host::Owned<VkSampler> sampler_, compares_;
  host::Image shadow_;  // one for all frames: barriers keep their order

  // dermis keeps what frames in flight use, so frames_ is destroyed first: that waits for them.
  dermis::Renderer renderer_;
  dermis::vulkan::HostFrames heads_;
  std::array<PerFrame, frames_in_flight> per_frame_;
  host::Frames frames_;
  std::uint32_t last_slot_ = 0;
};

Engine::Engine(const host::Device& device)
    : device_(&device),
      positions_(device.make_buffer_of(stage_.head.positions_m, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
      normals_(device.make_buffer_of(stage_.head.normals, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
      uvs_(device.make_buffer_of(stage_.head.uvs, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
      indices_(device.make_buffer_of(stage_.head.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT)),
      floor_(floor_pipeline(device)),
      head_(head_pipeline(device)),
      floor_sets_(device, floor_, frames_in_flight),
      head_sets_(device, head_, frames_in_flight),
      sampler_(host::make_sampler(device)),
      compares_(host::make_sampler(device, VK_COMPARE_OP_LESS_OR_EQUAL)),
      shadow_(device.make_image(depth_format, shadow_size,
                                VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT)),
      renderer_(device.host()),
      heads_(renderer_, {.frames_in_flight = frames_in_flight,
                         .picture = dermis::vulkan::PictureTargets{.colour_format = colour_format,
                                                                   .depth_format = depth_format,
                                                                   .largest = largest_size},
                         .depths = {{.format = depth_format, .reversed_depth = false}},
                         .scattered = true}),
      frames_(device, frames_in_flight) {
  for (PerFrame& own : per_frame_)
    own.constants = device.make_buffer(sizeof(FrameConstants), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

// Each frame in flight has its own targets, so a resize waits for nothing: begin() has waited for those that
// are destroyed here.
void Engine::make_targets(PerFrame& own, VkExtent2D window) const {
  if (own.targets.colour.extent.width == window.width && own.targets.colour.extent.height == window.height)
    return;
  own.targets = {
      .colour = device_->make_image(colour_format, window,
                                    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT),
      .depth = device_->make_image(depth_format, window, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)};
}

void Engine::draw(VkExtent2D window) {
  const host::Frames::Frame frame = frames_.begin();
  PerFrame& own = per_frame_[frame.slot];
  make_targets(own, window);
  last_slot_ = frame.slot;

  // Poses cost little. The first call makes maps and pipelines, and takes long.
  stage_.turn(frame.numbers.frame);
  heads_.update(stage_.scene, stage::settings(), {.drawn_by_host = {stage_.right}});

  const dermis::CameraMatrices camera = stage::camera(frame.numbers.frame, window.width, window.height);
  const FrameConstants constants{.clip_from_world = stage::matrix_of(dermis::vulkan::clip_from_world(camera)),
                                 .shadow_from_world = glm::mat4(stage::shadow_from_world()),
                                 .eye_m = glm::vec4(stage::eye_m(frame.numbers.frame), 1),
                                 .to_lamp = glm::vec4(-glm::normalize(stage::lamp_direction), 0),
                                 .lamp_irradiance = glm::vec4(stage::lamp_irradiance, 0)};
  std::memcpy(own.constants.mapped, &constants, sizeof(constants));

  draw_shadow_map(frame.commands);
  host::transition(frame.commands, own.targets.colour, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  host::transition(frame.commands, own.targets.depth, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
  draw_floor(frame.commands, own, frame.slot);

  // Lights both heads and draws the left one. No barriers around it, and no state to restore but what this
  // host binds anew anyway.
  const dermis::vulkan::View view{.camera = camera,
                                  .colour = own.targets.colour.view.get(),
                                  .depth = own.targets.depth.view.get(),
                                  .extent = window};
  const dermis::vulkan::Recorded recorded = heads_.record(frame.commands, std::span(&view, 1), frame.numbers);
  draw_right_head(frame.commands, own, frame.slot, recorded);
  frames_.submit();
}

// Both heads, by way (ii): for the light that the host's shader adds to that of dermis.
void Engine::draw_shadow_map(VkCommandBuffer commands) {
  shadow_.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  host::transition(commands, shadow_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
  host::begin_rendering(commands, nullptr, &shadow_, {}, 1.0f);
  vkCmdEndRendering(commands);
  heads_.record_depth(commands, stage::columns_of(stage::shadow_from_world()),
                      {.depth = shadow_.view.get(), .extent = shadow_size});
  host::transition(commands, shadow_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

void Engine::draw_floor(VkCommandBuffer commands, const PerFrame& own, std::uint32_t slot) const {
  Push push{.albedo = {0.35f, 0.4f, 0.45f, 1}};
  push.world_from_asset[3] = {0, stage::floor_height_m, 0, 1};
  const host::Descriptor constants{.buffer = {own.constants.buffer.get(), 0, VK_WHOLE_SIZE}};

  host::begin_rendering(commands, &own.targets.colour, &own.targets.depth, std::array<float, 4>{}, 0.0f);
  floor_.bind(commands, floor_sets_.write(slot, std::span(&constants, 1)));
  floor_.push(commands, push);
  vkCmdDraw(commands, 6, 1, 0, 0);
  vkCmdEndRendering(commands);
}

void Engine::draw_right_head(VkCommandBuffer commands, const PerFrame& own, std::uint32_t slot,
                             const dermis::vulkan::Recorded& recorded) const {
  const std::array descriptors{
      host::Descriptor{.buffer = {own.constants.buffer.get(), 0, VK_WHOLE_SIZE}},
      host::Descriptor{
          .image = {sampler_.get(), recorded.scattered, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}},
      host::Descriptor{.buffer = {recorded.records, recorded.records_offset, recorded.records_bytes}},
      host::Descriptor{
          .image = {compares_.get(), shadow_.view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}}};
  const Push push{.world_from_asset = stage::matrix_of(stage_.scene.instance(stage_.right).world_from_asset),
                  .albedo = {stage::skin_albedo, stage::skin_roughness},
                  .record = heads_.record_of(stage_.right)};

  host::begin_rendering(commands, &own.targets.colour, &own.targets.depth);
  head_.bind(commands, head_sets_.write(slot, descriptors));
  head_.push(commands, push);
  const std::array buffers{positions_.buffer.get(), normals_.buffer.get(), uvs_.buffer.get()};
  constexpr std::array<VkDeviceSize, 3> offsets{};
  vkCmdBindVertexBuffers(commands, 0, buffers.size(), buffers.data(), offsets.data());
  vkCmdBindIndexBuffer(commands, indices_.buffer.get(), 0, VK_INDEX_TYPE_UINT32);
  vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(stage_.head.indices.size()), 1, 0, 0, 0);
  vkCmdEndRendering(commands);
}

host::Picture Engine::last_picture() {
  frames_.wait();
  host::Image& colour = per_frame_[last_slot_].targets.colour;
  return host::picture_of_halves(colour.extent.width, colour.extent.height, device_->read(colour, 8));
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<host::Arguments> arguments = host::read_arguments({argv + 1, argv + argc});
  if (!arguments) {
    std::fprintf(stderr, "usage: embedding OUT.ppm [--frames 1..1000000] [--linear OUT.pfm] [--validate]\n");
    return 2;
  }
  try {
    const host::Device device(arguments->validate);
    host::Picture picture;
    {
      Engine engine(device);
      for (int i = 0; i < arguments->frames; ++i)
        engine.draw(i < arguments->frames / 2 ? first_size : second_size);
      picture = engine.last_picture();
    }
    host::write_ppm(arguments->picture, picture);
    if (!arguments->linear.empty()) host::write_pfm(arguments->linear, picture);

    std::printf("%s: %d frames, the last of %u x %u pixels, on %s, %s\n", arguments->picture.c_str(),
                arguments->frames, picture.width, picture.height, device.name().c_str(),
                device.validated() ? (std::to_string(device.messages().size()) + " messages").c_str()
                                   : "not validated");
    return device.messages().empty() ? 0 : 1;
  } catch (const std::exception& error) {
    // dermis's errors are among these: dermis/error.h
    std::fprintf(stderr, "embedding: %s\n", error.what());
    return 1;
  }
}
