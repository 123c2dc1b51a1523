// SPDX-License-Identifier: MIT
/// Checks of the inputs of a host. All throw InputError, and name what is wrong.
#pragma once

#include <span>

#include "dermis/vulkan.h"
#include "gpu/device.h"
#include "render/passes/targets.h"

namespace dermis::api {

void check_host_options(const vulkan::HostFrames::Options& options, const gpu::Device& device);
void check_host_settings(const RenderSettings& settings);

/// Returns the part of an image that `area` names, all of it if that has no size.
VkRect2D checked_area(const char* what, const VkExtent2D& extent, const VkRect2D& area,
                      const gpu::DeviceLimits& limits);
/// Whether the images of a view are as large as PictureTargets::largest at most.
void check_room(const VkExtent2D& extent, const vulkan::PictureTargets& targets);
void check_finite(const char* what, std::span<const double> values);
void check_handle(const char* what, bool given);

}  // namespace dermis::api
