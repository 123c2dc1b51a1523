// SPDX-License-Identifier: MIT
/// What changes per frame, on the device.
#pragma once

#include "passes/frame_data.h"
#include "setup/environment_light.h"
#include "setup/frame_setup.h"

namespace dermis::setup {

/// Uploads what passes read while they record a frame of `setup`: camera, lights, and where light lies in the
/// maps of `outputs`, which its plan has made. `scene` and `sky` must outlive the result.
passes::FrameData frame_data(gpu::Device& device, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs, const passes::GpuScene& scene,
                             const SkyOnSkin& sky);

/// Returns the part of them that all passes share: camera, exposure, light from everywhere.
gpu::Buffer frame_buffer(gpu::Device& device, const io::FrameIo& frame);

}  // namespace dermis::setup
