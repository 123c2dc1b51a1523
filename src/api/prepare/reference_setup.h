// SPDX-License-Identifier: MIT
/// The reference sees and lights a scene as the renderer does.
#pragma once

#include "dermis/settings.h"
#include "render/setup/placed_scene.h"
#include "truth/reference/settings.h"

namespace dermis::api {

/// Returns what the reference renders. Throws InputError: a setting out of range or that only the renderer
/// knows (several heads, a picture of more than 2^26 pixels), an empty scene.
reference::RenderSetup reference_setup(const setup::PlacedScene& scene, const RenderSettings& settings);

}  // namespace dermis::api
