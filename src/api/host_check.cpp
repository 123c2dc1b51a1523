// SPDX-License-Identifier: MIT
#include "api/host_check.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/core/error.h"
#include "gpu/formats.h"

namespace dermis::api {
namespace {

constexpr std::array depth_formats{VK_FORMAT_D16_UNORM,         VK_FORMAT_X8_D24_UNORM_PACK32,
                                   VK_FORMAT_D32_SFLOAT,        VK_FORMAT_D16_UNORM_S8_UINT,
                                   VK_FORMAT_D24_UNORM_S8_UINT, VK_FORMAT_D32_SFLOAT_S8_UINT};

constexpr std::uint32_t most_frames_in_flight = 8;
constexpr std::size_t most_depth_targets = 16;

void check_samples(const char* what, std::uint32_t samples) {
  if (samples != 1 && samples != 4) throw input_error("", "{} must be 1 or 4, got {}", what, samples);
}

void check_format(const char* what, const gpu::Device& device, VkFormat format, VkFormatFeatureFlags needed,
                  VkImageUsageFlags usage, std::uint32_t samples) {
  const auto can =
      device.format_supports(format, needed) ? device.image_format_properties(format, usage) : std::nullopt;
  if (!can || !(can->sampleCounts & samples))
    throw input_error("", "{}: {} with {} samples is not a format that {} draws to as dermis does", what,
                      gpu::format_name(format), samples, device.summary().name);
}

void check_depth_format(const char* what, const gpu::Device& device, VkFormat format, std::uint32_t samples) {
  if (std::find(depth_formats.begin(), depth_formats.end(), format) == depth_formats.end())
    throw input_error("", "{} must be a format of depth, got {}", what, gpu::format_name(format));
  check_format(what, device, format, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT,
               VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, samples);
}

}  // namespace

void check_host_options(const vulkan::HostFrames::Options& options, const gpu::Device& device) {
  if (options.frames_in_flight < 1 || options.frames_in_flight > most_frames_in_flight)
    throw input_error("", "frames_in_flight must be 1 to {}, got {}", most_frames_in_flight,
                      options.frames_in_flight);
  if (!options.picture && options.depths.empty() && !options.scattered)
    throw input_error("", "HostFrames need a way in: picture, depths or scattered");
  if (options.depths.size() > most_depth_targets)
    throw input_error("", "at most {} kinds of depth targets, got {}", most_depth_targets,
                      options.depths.size());

  if (options.picture) {
    check_samples("picture.samples", options.picture->samples);
    check_format("picture.colour_format", device, options.picture->colour_format,
                 VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                 options.picture->samples);
    check_depth_format("picture.depth_format", device, options.picture->depth_format,
                       options.picture->samples);
    const auto& [width, height] = options.picture->largest;
    const std::uint32_t most = device.limits().max_image_side;
    if (width < 1 || height < 1 || width > most || height > most)
      throw input_error(
          "", "picture.largest, of the largest images of views, must be 1 to {} pixels each, got {} x {}",
          most, width, height);
  }
  for (const vulkan::DepthTargets& depth : options.depths) {
    check_samples("depths.samples", depth.samples);
    check_depth_format("depths.format", device, depth.format, depth.samples);
  }
}

void check_host_settings(const RenderSettings& settings) {
  if (!settings.output.exposure_ev)
    throw input_error("",
                      "an automatic output.exposure_ev needs frames of its own; give a host's frames a "
                      "number");
  if (settings.output.show != "picture")
    throw input_error("", "output.show must be 'picture' in a host's frames, got '{}'", settings.output.show);
  if (settings.camera.heads != 1)
    throw input_error("",
                      "camera.heads must be 1 in a host's frames, whose scene has an instance for each "
                      "head; got {}",
                      settings.camera.heads);
}

VkRect2D checked_area(const char* what, const VkExtent2D& extent, const VkRect2D& area,
                      const gpu::DeviceLimits& limits) {
  const std::uint32_t most = limits.max_image_side;
  if (extent.width < 1 || extent.height < 1 || extent.width > most || extent.height > most)
    throw input_error("", "{}.extent must be 1 to {} pixels each, got {} x {}", what, most, extent.width,
                      extent.height);
  if (area.extent.width == 0 && area.extent.height == 0 && area.offset.x == 0 && area.offset.y == 0)
    return {{0, 0}, extent};

  const auto fits = [](std::int32_t offset, std::uint32_t size, std::uint32_t whole) {
    return offset >= 0 && size >= 1 && size <= whole && std::uint32_t(offset) <= whole - size;
  };
  if (!fits(area.offset.x, area.extent.width, extent.width) ||
      !fits(area.offset.y, area.extent.height, extent.height))
    throw input_error("", "{}.area must lie in the image of {} x {} pixels, got {} x {} at {}, {}", what,
                      extent.width, extent.height, area.extent.width, area.extent.height, area.offset.x,
                      area.offset.y);
  return area;
}

void check_room(const VkExtent2D& extent, const vulkan::PictureTargets& targets) {
  const auto& [width, height] = targets.largest;
  if (extent.width > width || extent.height > height)
    throw input_error("", "view.extent must be at most picture.largest, {} x {} pixels, got {} x {}", width,
                      height, extent.width, extent.height);
}

void check_finite(const char* what, std::span<const double> values) {
  if (!std::all_of(values.begin(), values.end(),
                   [](double v) { return std::isfinite(v) && std::abs(v) < 1e9; }))
    throw input_error("", "{} must be numbers under 1e9", what);
}

void check_handle(const char* what, bool given) {
  if (!given) throw input_error("", "{} must not be null", what);
}

}  // namespace dermis::api
