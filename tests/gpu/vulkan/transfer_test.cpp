// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <numeric>

#include "fixture.h"
#include "gpu/formats.h"

namespace dermis::gpu {
namespace {

using Transfer = GpuTest;
using Colour = std::array<float, 4>;

struct SamplePush {
  float u, v, layer, mip;
};

std::vector<std::byte> counting_bytes(std::uint64_t count) {
  std::vector<std::byte> bytes(count);
  for (std::uint64_t i = 0; i < count; ++i) bytes[i] = static_cast<std::byte>(i * 7 + i / 251);
  return bytes;
}

TEST(TextureBytes, CountMipsLayersAndSamples) {
  EXPECT_EQ(bytes_of({.width = 5, .height = 3, .format = VK_FORMAT_R8G8B8A8_SRGB}), 60u);
  EXPECT_EQ(
      bytes_of({.width = 5, .height = 3, .layers = 2, .mips = 3, .format = VK_FORMAT_R16G16B16A16_SFLOAT}),
      (15u + 2u + 1u) * 2 * 8);
  EXPECT_EQ(bytes_of({.width = 4, .height = 4, .format = VK_FORMAT_D32_SFLOAT, .samples = 4}), 256u);
  EXPECT_EQ(bytes_of({.width = 65536, .height = 65536, .layers = 2, .format = VK_FORMAT_R32G32B32A32_SFLOAT}),
            std::uint64_t{1} << 37);
  EXPECT_EQ(aspect_of(VK_FORMAT_D32_SFLOAT), static_cast<VkImageAspectFlags>(VK_IMAGE_ASPECT_DEPTH_BIT));
  EXPECT_EQ(aspect_of(VK_FORMAT_R8_UNORM), static_cast<VkImageAspectFlags>(VK_IMAGE_ASPECT_COLOR_BIT));
  EXPECT_STREQ(format_name(VK_FORMAT_R16G16_SFLOAT), "R16G16_SFLOAT");
}

TEST_F(Transfer, BuffersComeBackAsTheyWent) {
  for (const std::uint64_t count : {1u, 3u, 4096u, 1000003u}) {
    const auto bytes = counting_bytes(count);
    const Buffer buffer(device(), "bytes", {.bytes = count});
    upload(device(), buffer, bytes);
    EXPECT_EQ(read_back(device(), buffer), bytes) << count;
  }
  const Buffer none =
      make_buffer<float>(device(), "none", std::span<const float>{}, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  EXPECT_EQ(none.desc().bytes, sizeof(float));
}

TEST_F(Transfer, MappedBuffersReachTheDevice) {
  const Buffer up(device(), "up", {.bytes = 64, .place = BufferPlace::upload});
  const Buffer down(device(), "down", {.bytes = 64, .place = BufferPlace::readback});
  ASSERT_EQ(up.mapped().size(), 64u);
  std::iota(reinterpret_cast<std::uint8_t*>(up.mapped().data()),
            reinterpret_cast<std::uint8_t*>(up.mapped().data()) + 64, std::uint8_t{1});
  device().run([&](VkCommandBuffer commands) { Cmd(device(), commands).copy(up, down, 64); });
  EXPECT_TRUE(std::ranges::equal(up.mapped(), down.mapped()));
  device().run([&](VkCommandBuffer commands) { Cmd(device(), commands).fill(down, 0x04030201); });
  EXPECT_EQ(static_cast<int>(down.mapped()[62]), 3);
}

TEST_F(Transfer, TexturesComeBackAsTheyWent) {
  for (const VkFormat format :
       {VK_FORMAT_R8_UNORM, VK_FORMAT_R8G8B8A8_SRGB, VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32_SFLOAT}) {
    const TextureDesc desc{
        .width = 37, .height = 21, .layers = 3, .format = format, .usage = VK_IMAGE_USAGE_SAMPLED_BIT};
    const auto bytes = counting_bytes(bytes_of(desc));
    const Texture texture(device(), "map", desc);
    upload(device(), texture, bytes);
    const std::uint64_t layer_bytes = bytes.size() / 3;
    for (const std::uint32_t layer : {0u, 2u}) {
      const auto back = read_back(device(), texture, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, layer);
      EXPECT_TRUE(std::ranges::equal(back, std::span(bytes).subspan(layer * layer_bytes, layer_bytes)))
          << format_name(format) << " layer " << layer;
    }
  }
}

TEST_F(Transfer, EveryMipAndLayerIsWhereItBelongs) {
  // Each texel holds (layer, mip, x, y), so a shader that samples it says where it landed.
  const TextureDesc desc{.width = 6,
                         .height = 5,
                         .layers = 2,
                         .mips = 3,
                         .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                         .usage = VK_IMAGE_USAGE_SAMPLED_BIT};

  std::vector<float> texels;
  for (std::uint32_t mip = 0; mip < desc.mips; ++mip)
    for (std::uint32_t layer = 0; layer < desc.layers; ++layer)
      for (std::uint32_t y = 0; y < std::max(1u, desc.height >> mip); ++y)
        for (std::uint32_t x = 0; x < std::max(1u, desc.width >> mip); ++x)
          for (const std::uint32_t value : {layer, mip, x, y}) texels.push_back(static_cast<float>(value));
  const Texture texture(device(), "places", desc);
  upload(device(), texture, std::as_bytes(std::span(texels)));

  const Buffer out(device(), "out", {.bytes = sizeof(Colour), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  const Pipeline& sample = library().compute("sample.comp");
  const VkSampler nearest = library().sampler({.filter = Filter::nearest});

  for (const auto& [layer, mip, x, y] :
       {std::array{0u, 0u, 5u, 4u}, {1u, 0u, 2u, 3u}, {1u, 1u, 2u, 1u}, {0u, 2u, 0u, 0u}, {1u, 2u, 0u, 0u}}) {
    const float width = static_cast<float>(std::max(1u, desc.width >> mip)),
                height = static_cast<float>(std::max(1u, desc.height >> mip));
    device().run([&](VkCommandBuffer commands) {
      Cmd cmd(device(), commands);
      cmd.bind(sample, std::array<Binding, 2>{SampledBinding{&texture, nearest}, BufferBinding{&out}});
      cmd.push(sample,
               SamplePush{(static_cast<float>(x) + 0.5f) / width, (static_cast<float>(y) + 0.5f) / height,
                          static_cast<float>(layer), static_cast<float>(mip)});
      cmd.dispatch(1, 1);
    });

    const auto found = values_of<float>(out);
    EXPECT_EQ(found, (std::vector<float>{static_cast<float>(layer), static_cast<float>(mip),
                                         static_cast<float>(x), static_cast<float>(y)}));
  }
}

TEST_F(Transfer, SamplersFilterAndRepeatAsAsked) {
  const std::array<Colour, 2> texels{Colour{0, 0, 0, 0}, Colour{1, 1, 1, 1}};
  const Texture texture(device(), "ramp",
                        {.width = 2,
                         .height = 1,
                         .format = VK_FORMAT_R32G32B32A32_SFLOAT,
                         .usage = VK_IMAGE_USAGE_SAMPLED_BIT,
                         .array = true});
  upload(device(), texture, std::as_bytes(std::span(texels)));

  const Buffer out(device(), "out", {.bytes = sizeof(Colour), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  const Pipeline& sample = library().compute("sample.comp");

  const auto at = [&](float u, const SamplerDesc& desc) {
    device().run([&](VkCommandBuffer commands) {
      Cmd cmd(device(), commands);
      cmd.bind(sample, std::array<Binding, 2>{SampledBinding{&texture, library().sampler(desc)},
                                              BufferBinding{&out}});
      cmd.push(sample, SamplePush{u, 0.5f, 0, 0});
      cmd.dispatch(1, 1);
    });
    return values_of<float>(out)[0];
  };

  EXPECT_NEAR(at(0.5f, {}), 0.5f, 1e-3);
  EXPECT_EQ(at(0.45f, {.filter = Filter::nearest}), 0);
  EXPECT_EQ(at(1.25f, {}), 1);
  EXPECT_EQ(at(1.25f, {.u = Address::repeat}), 0);
  EXPECT_EQ(at(1.25f, {.u = Address::mirror}), 1);
  EXPECT_EQ(at(1.75f, {.u = Address::mirror}), 0);
}

TEST_F(Transfer, StorageImagesAreWrittenToTheirEdges) {
  const TextureDesc desc{
      .width = 13, .height = 9, .format = VK_FORMAT_R16G16B16A16_SFLOAT, .usage = VK_IMAGE_USAGE_STORAGE_BIT};
  const Texture texture(device(), "target", desc);
  const float factor[] = {1, 2, 0.5f, 4};
  const Buffer scale = make_buffer<float>(device(), "scale", factor, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  const Buffer out(device(), "out", {.bytes = bytes_of(desc), .place = BufferPlace::readback});
  const Pipeline& store = library().compute("store.comp");

  device().run([&](VkCommandBuffer commands) {
    Cmd cmd(device(), commands);
    transition(cmd, texture, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
    cmd.bind(store, std::array<Binding, 2>{StorageImageBinding{&texture}, BufferBinding{&scale}});
    cmd.dispatch_over(store, desc.width, desc.height);
    transition(cmd, texture, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    cmd.copy(texture, out);
  });

  const auto half = [](std::uint16_t bits) {  // all values here are normal numbers or 0
    if (bits == 0) return 0.0f;
    return std::ldexp(static_cast<float>((bits & 0x3ff) + 0x400), (bits >> 10 & 31) - 25);
  };

  std::vector<std::uint16_t> halves(out.desc().bytes / 2);
  std::memcpy(halves.data(), out.mapped().data(), out.desc().bytes);
  for (std::uint32_t y = 0; y < desc.height; ++y)
    for (std::uint32_t x = 0; x < desc.width; ++x) {
      const std::uint16_t* texel = &halves[(y * desc.width + x) * 4];
      ASSERT_EQ((std::array{half(texel[0]), half(texel[1]), half(texel[2]), half(texel[3])}),
                (std::array{static_cast<float>(x), static_cast<float>(2 * y), 0.5f, 4.0f}))
          << x << ',' << y;
    }
}

}  // namespace
}  // namespace dermis::gpu
