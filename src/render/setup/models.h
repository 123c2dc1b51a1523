// SPDX-License-Identifier: MIT
/// Heads that the plan of a frame treats alike.
#pragma once

#include "render/setup/frame_setup.h"

namespace dermis::setup {

/// Groups the heads of `setup` into models: instances of an asset that have the same profile and scale.
/// Fills in the skin meshes and models of its plan, where each mesh comes from, and the model of each head.
void set_up_models(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& settings);

}  // namespace dermis::setup
