// SPDX-License-Identifier: MIT
#include "frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "gpu/device.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "image/colour.h"

namespace dermis::tests {

CameraMatrices front_camera(bool reversed_depth) {
  constexpr double near_m = 0.1, far_m = 10, tan_half = 0.25;
  CameraMatrices m;
  m.camera_from_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.4, 1};
  m.clip_from_camera = {1 / tan_half, 0, 0, 0, 0, -1 / tan_half, 0, 0, 0, 0, 0, -1, 0, 0, near_m, 0};
  if (!reversed_depth) {
    m.clip_from_camera[10] = -far_m / (far_m - near_m);
    m.clip_from_camera[14] = -far_m * near_m / (far_m - near_m);
  }
  return m;
}

RenderSettings frame_settings(std::uint32_t samples) {
  RenderSettings s = small_settings("texture-space", static_cast<int>(side), 256);
  s.output.bloom = 0;
  s.output.exposure_ev = 0;
  s.quality.samples = static_cast<int>(samples);
  return s;
}

Scene lit_ball() {
  Scene scene = sphere(0.07);
  scene.add_light({.light = {.colour = {2, 1.8, 1.6}, .direction = {0.5, -0.5, -0.7}}});
  return scene;
}

Pixels pixels_of(const Picture& picture) {
  return {static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height),
          picture.linear_rgba};
}

Pixels rendered(const Scene& scene, RenderSettings settings, bool reversed_depth) {
  settings.camera.matrices = front_camera(reversed_depth);
  return pixels_of(tests::renderer().render(scene, settings));
}

bool contains(const VkRect2D& area, std::uint32_t x, std::uint32_t y) {
  const auto left = static_cast<std::uint32_t>(area.offset.x),
             top = static_cast<std::uint32_t>(area.offset.y);
  return x - left < area.extent.width && y - top < area.extent.height;
}

Pixels part_of(const Pixels& whole, const VkRect2D& area) {
  Pixels part{area.extent.width, area.extent.height, {}};
  for (std::uint32_t y = 0; y < whole.height; ++y)
    for (std::uint32_t x = 0; x < whole.width; ++x)
      if (contains(area, x, y)) part.rgba.insert(part.rgba.end(), whole.at(x, y), whole.at(x, y) + 4);
  return part;
}

namespace {

void for_each_skin_value(const Pixels& a, const Pixels& b, std::size_t least,
                         const std::function<void(double, double)>& see) {
  ASSERT_EQ(a.rgba.size(), b.rgba.size());
  std::size_t skin = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    if (a.rgba[i + 3] != 1 || b.rgba[i + 3] != 1) continue;
    ++skin;
    for (std::size_t c = 0; c < 3; ++c) see(double{a.rgba[i + c]}, double{b.rgba[i + c]});
  }
  EXPECT_GE(skin, least);
}

}  // namespace

double largest_difference(const Pixels& a, const Pixels& b, std::size_t least) {
  double largest = 0, brightest = 0;
  for_each_skin_value(a, b, least, [&](double x, double y) {
    largest = std::max(largest, std::abs(x - y) / std::max({std::abs(x), std::abs(y), 1e-3}));
    brightest = std::max(brightest, x);
  });
  EXPECT_GT(brightest, 0.05) << "nothing is lit";
  return largest;
}

double psnr_db(const Pixels& a, const Pixels& b) {
  double sum = 0, values = 0;
  for_each_skin_value(a, b, 500, [&](double x, double y) { sum += (x - y) * (x - y), ++values; });
  return -10 * std::log10(std::max(sum / values, 1e-12));
}

double psnr_of_all_db(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::pow(double{a.rgba[i]} - double{b.rgba[i]}, 2);
  return -10 * std::log10(std::max(sum / static_cast<double>(a.rgba.size()), 1e-12));
}

namespace {

/// Hands out the first kind of memory that suits, all bits of it 1: no number as float or half.
vulkan::MemoryCallbacks poisoned_memory(const Host& host) {
  const VkDevice device = host.vulkan().device;
  return {.allocate = [&host,
                       device](const vulkan::MemoryRequest& request) -> std::optional<vulkan::MemoryRange> {
            VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
            info.allocationSize = request.requirements.size;
            while (!(request.requirements.memoryTypeBits >> info.memoryTypeIndex & 1u))
              ++info.memoryTypeIndex;
            vulkan::MemoryRange range;
            if (host.vk().vkAllocateMemory(device, &info, nullptr, &range.memory) != VK_SUCCESS) return {};
            if (host.vk().vkMapMemory(device, range.memory, 0, VK_WHOLE_SIZE, 0, &range.mapped) == VK_SUCCESS)
              std::memset(range.mapped, 0xff, request.requirements.size);
            return range;
          },
          .free =
              [&host, device](const vulkan::MemoryRange& range) {
                host.vk().vkFreeMemory(device, range.memory, nullptr);
              }};
}

}  // namespace

Frame::Frame(const Setup& setup) : setup_(setup) {
  if (setup_.options.picture) setup_.options.picture->largest = setup_.extent;
  vulkan::Host device = host.vulkan();
  if (setup_.poisoned) device.memory = poisoned_memory(host);
  renderer.emplace(device);
  frames.emplace(*renderer, setup_.options);
  const vulkan::PictureTargets targets = setup_.options.picture.value_or(vulkan::PictureTargets{});
  colour_image =
      host.image(targets.colour_format, setup_.extent, targets.samples, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  depth_image = host.image(targets.depth_format, setup_.extent, targets.samples,
                           VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
  if (targets.samples > 1)
    resolved_ = host.image(targets.colour_format, setup_.extent, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
}

Frame::~Frame() {
  frames.reset();
  renderer.reset();
  for (const std::string& message : host.messages()) ADD_FAILURE() << message;
}

vulkan::View Frame::view(VkRect2D area) const {
  const bool reversed = !setup_.options.picture || setup_.options.picture->reversed_depth;
  return {.camera = front_camera(reversed),
          .colour = colour_image.view,
          .depth = depth_image.view,
          .extent = setup_.extent,
          .area = area};
}

void Frame::draw(const std::function<void(VkCommandBuffer)>& before, VkRect2D area) {
  const bool reversed = !setup_.options.picture || setup_.options.picture->reversed_depth;
  host.run([&](VkCommandBuffer commands) {
    host.transition(commands, colour_image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    host.transition(commands, depth_image, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    host.clear(commands, &colour_image, {0, 0, 0, 0}, &depth_image, reversed ? 0.0f : 1.0f,
               {{0, 0}, setup_.extent});
    if (before) before(commands);
    const vulkan::View one = view(area);
    recorded = frames->record(commands, std::span(&one, 1), {.frame = number + 1, .finished = number});
    ++number;
    if (!resolved_.handle) return;
    host.transition(commands, resolved_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    host.resolve(commands, colour_image, resolved_);
  });
}

Pixels Frame::colour() {
  const std::vector<std::byte> bytes = host.read(resolved_.handle ? resolved_ : colour_image);
  Pixels pixels{setup_.extent.width, setup_.extent.height, {}};
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    std::uint16_t half = 0;
    std::memcpy(&half, &bytes[i], 2);
    pixels.rgba.push_back(image::half_to_float(half));
  }
  return pixels;
}

std::vector<float> Frame::depth_values() {
  const std::vector<std::byte> bytes = host.read(depth_image);
  std::vector<float> values(bytes.size() / 4);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

void WithHost::SetUp() {
  if (gpu::list_devices().empty())
    GTEST_SKIP() << "no Vulkan device (Debian, Ubuntu: apt install mesa-vulkan-drivers)";
}

}  // namespace dermis::tests
