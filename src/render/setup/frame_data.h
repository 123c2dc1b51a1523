// SPDX-License-Identifier: MIT
/// Data that change per frame, on the device.
#pragma once

#include "gpu/frame_memory.h"
#include "render/passes/frame_data.h"
#include "render/setup/environment_light.h"
#include "render/setup/frame_setup.h"

namespace dermis::setup {

/// Writes what passes read while they record a frame of `setup`: camera, lights, poses, and where light lies
/// in the maps of `outputs`, which its plan has made. api::SceneOnDevice::give() tells its heads next what
/// they have on the device. `memory` and `environment`, which may be null, must outlive the result.
passes::FrameData frame_data(gpu::FrameMemory& memory, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs, const EnvironmentLight* environment);

}  // namespace dermis::setup
