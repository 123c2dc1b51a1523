// SPDX-License-Identifier: MIT
// The tone maps of the device and of the processor hold the same curves, written twice.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "base/settings/names.h"
#include "gpu/cmd.h"
#include "gpu/device.h"
#include "gpu/pipelines.h"
#include "image/colour.h"
#include "image/tone_map.h"
#include "render/passes/bindings.h"
#include "render/passes/finish/tone_map/tone_map_io.h"
#include "render/passes/shaders.h"

namespace dermis {
namespace {

constexpr std::uint32_t width = 128;

// Every channel through the toe, around the shoulder, and to the end of half floats; then what is no colour.
std::vector<image::Colour> colours() {
  constexpr float levels[] = {0,    6e-8f, 0.001f, 0.0031f, 0.01f, 0.04f, 0.079f, 0.081f, 0.18f, 0.3f, 0.5f,
                              0.7f, 0.76f, 0.79f,  0.81f,   0.9f,  1,     1.3f,   2,      4,     16,   65504};
  std::vector<image::Colour> out;
  for (const float r : levels)
    for (const float g : levels)
      for (const float b : levels) out.push_back({r, g, b});

  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float odd : {nan, infinity, -infinity, -0.5f})
    for (const float other : {0.0f, 0.2f, infinity, nan}) {
      out.push_back({odd, other, other});
      out.push_back({other, odd, 0.4f});
    }

  while (out.size() % width != 0) out.push_back({0, 0, 0});
  return out;
}

void to_general(gpu::Cmd& cmd, const gpu::Texture& texture) {
  VkImageMemoryBarrier2 image{};
  image.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  image.dstStageMask = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;
  image.dstAccessMask = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT;
  image.newLayout = VK_IMAGE_LAYOUT_GENERAL;
  image.srcQueueFamilyIndex = image.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  image.image = texture.handle();
  image.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};

  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.imageMemoryBarrierCount = 1;
  info.pImageMemoryBarriers = &image;
  cmd.barrier(info);
}

TEST(ToneMapAgreement, DeviceAndProcessorAreOneStepApartAtMost) {
  if (gpu::list_devices().empty()) GTEST_SKIP() << "no Vulkan device";
  gpu::Device device(gpu::Device::Options{});
  gpu::PipelineLibrary library(device, passes::find_shader);
  const VkSampler sampler = library.sampler({.filter = gpu::Filter::nearest});

  std::vector<image::Colour> given = colours();
  const auto height = static_cast<std::uint32_t>(given.size() / width);
  std::vector<std::uint16_t> halves;
  for (image::Colour& colour : given) {
    for (float& value : colour) {
      halves.push_back(image::float_to_half(value));
      value = image::half_to_float(halves.back());
    }
    halves.push_back(image::float_to_half(1));
  }
  const gpu::Texture picture(device, "picture",
                             {.width = width,
                              .height = height,
                              .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                              .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT});
  gpu::upload(device, picture, std::as_bytes(std::span(halves)));

  const gpu::Texture light(device, "light",
                           {.width = width,
                            .height = height,
                            .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                            .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});

  for (const std::string_view name : names_of<ToneMap>) {
    const ToneMap tone_map = find_name<ToneMap>("tone map", name);
    const gpu::Texture display(device, "display",
                               {.width = width,
                                .height = height,
                                .format = VK_FORMAT_R8G8B8A8_UNORM,
                                .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    const gpu::Pipeline& pipeline =
        library.compute("tone_map.comp", {{"tone_map", static_cast<std::uint32_t>(tone_map)}});
    device.run([&](VkCommandBuffer commands) {
      gpu::Cmd cmd(device, commands);
      to_general(cmd, display);
      to_general(cmd, light);
      passes::Bindings()
          .add("picture", gpu::SampledBinding{&picture, sampler})
          .add("open", gpu::SampledBinding{&picture, sampler})
          .add("narrow", gpu::SampledBinding{&picture, sampler})
          .add("wide", gpu::SampledBinding{&picture, sampler})
          .add("light", gpu::StorageImageBinding{&light})
          .add("display", gpu::StorageImageBinding{&display})
          .bind(cmd, pipeline);
      cmd.push(pipeline, io::ToneMapIo{});
      cmd.dispatch_over(pipeline, width, height);
    });

    const std::vector<std::byte> shown = gpu::read_back(device, display, VK_IMAGE_LAYOUT_GENERAL);
    int differ = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::array<std::uint8_t, 3> wanted = image::to_display8(tone_map, given[i]);
      for (std::size_t c = 0; c < 3; ++c) {
        const int found = std::to_integer<int>(shown[4 * i + c]);
        EXPECT_LE(std::abs(found - wanted[c]), 1)
            << name << ": " << given[i][0] << " " << given[i][1] << " " << given[i][2] << ", channel " << c;
        differ += found != wanted[c];
      }
    }
    std::printf("%-8s %d of %zu values differ, by one step\n", std::string(name).c_str(), differ,
                3 * given.size());
  }
}

}  // namespace
}  // namespace dermis
