// SPDX-License-Identifier: MIT
/// Tells whether two runs would render the same.
#pragma once

#include <cstdint>

#include "dermis/hooks.h"
#include "dermis/renderer.h"

namespace dermis::api {

/// Returns a number that changes with the scene as it stands, camera, lights, surroundings and profiles, by
/// their contents: that of the checkpoints of the reference. Settings that the reference does not know and
/// the size of the picture are not in it. Throws as render_reference() does.
std::uint64_t picture_fingerprint(const Scene& scene, const RenderSettings& settings, const Hooks& hooks);

}  // namespace dermis::api
