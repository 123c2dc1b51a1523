// SPDX-License-Identifier: MIT
/// Data that change per frame, on the device.
#pragma once

#include <span>

#include "gpu/frame_memory.h"
#include "render/passes/frame_data.h"
#include "render/setup/environment_light.h"
#include "render/setup/frame_setup.h"
#include "render/shared/scene_io.h"

namespace dermis::setup {

io::InstanceIo instance_io(const Similarity& world_from_asset);

/// Writes what passes read while they record a frame of `setup`: camera, lights, poses, and where light lies
/// in the maps of `outputs`, which its plan has made. `instances`, by their numbers in the scene, know
/// their assets, looks and skies. What they point to, `memory` and `environment`, which may be null, must
/// outlive the result.
passes::FrameData frame_data(gpu::FrameMemory& memory, const FrameSetup& setup,
                             const techniques::FrameOutputs& outputs,
                             std::span<const passes::Instance> instances,
                             const EnvironmentLight* environment);

}  // namespace dermis::setup
