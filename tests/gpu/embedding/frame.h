// SPDX-License-Identifier: MIT
// A host's frame with heads in it, and the picture that a renderer of its own makes of the same.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/vulkan.h"
#include "gpu/support/host.h"

namespace dermis::tests {

inline constexpr std::uint32_t side = 96;  // pixels

/// Looks at the origin from (0, 0, 0.4), near plane at 0.1 m. Clip y down, as Vulkan has it.
CameraMatrices front_camera(bool reversed_depth = true);

/// Those of a frame that is side x side pixels and seen by front_camera().
RenderSettings frame_settings(std::uint32_t samples = 1);

/// A head-sized ball of skin under one light from the upper left.
Scene lit_ball();

/// Linear RGBA, rows from top to bottom.
struct Pixels {
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgba;
  const float* at(std::uint32_t x, std::uint32_t y) const {
    return &rgba[std::size_t{4} * (std::size_t{y} * width + x)];
  }
};
Pixels pixels_of(const Picture& picture);
bool contains(const VkRect2D& area, std::uint32_t x, std::uint32_t y);
Pixels part_of(const Pixels& whole, const VkRect2D& area);

/// What the program's own renderer draws of the scene as front_camera() sees it.
Pixels rendered(const Scene& scene, RenderSettings settings, bool reversed_depth = true);

/// The largest difference of two values, as a share of the greater, over pixels that are skin alone in both.
/// At least `least` pixels must be.
double largest_difference(const Pixels& a, const Pixels& b, std::size_t least = 500);
/// Peak signal-to-noise ratio, dB, over pixels that are skin alone in both, for a peak of 1.
double psnr_db(const Pixels& a, const Pixels& b);
/// The same over all values, alpha too.
double psnr_of_all_db(const Pixels& a, const Pixels& b);

/// A host with targets, one HostFrames, and a renderer on its device.
class Frame {
 public:
  struct Setup {
    vulkan::HostFrames::Options options{.picture = vulkan::PictureTargets{}};
    VkExtent2D extent{side, side};
    bool poisoned = false;  ///< memory of the device begins as no number, where the host can write it
  };
  Frame() : Frame(Setup{}) {}
  explicit Frame(const Setup& setup);
  ~Frame();

  /// Clears the targets, lets the host record what it will, records the heads, and waits.
  void draw(const std::function<void(VkCommandBuffer)>& before = {}, VkRect2D area = {});
  vulkan::View view(VkRect2D area = {}) const;
  Pixels colour();
  std::vector<float> depth_values();
  std::vector<std::byte> depth_bytes() { return host.read(depth_image); }

  Host host;
  std::optional<Renderer> renderer;
  std::optional<vulkan::HostFrames> frames;
  HostImage colour_image, depth_image;
  std::uint64_t number = 0;
  vulkan::Recorded recorded;

 private:
  Setup setup_;
  HostImage resolved_;
};

/// Skips where there is no device; fails if the validation layer has said something.
class WithHost : public testing::Test {
 protected:
  void SetUp() override;
};

}  // namespace dermis::tests
