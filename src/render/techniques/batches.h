// SPDX-License-Identifier: MIT
/// Heads that go through each pass together. Batches take turns with the shadow maps and the light maps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/passes/light_map/light_pool.h"
#include "render/techniques/technique.h"

namespace dermis::techniques {

struct Batch {
  std::uint32_t number = 0;
  std::uint32_t first_head = 0, heads = 0;
};
std::vector<Batch> batches_of(const FrameSettings& settings);

/// Returns the skin meshes of the heads of a batch, mesh by mesh as the plan counts them. With an end, those
/// that are number first_mesh to end_mesh - 1 of their head.
std::vector<passes::MapSquare> squares_of(const FrameSettings& settings, const Batch& batch,
                                          std::uint32_t first_mesh = 0, std::uint32_t end_mesh = ~0u);
/// Returns those of one skin mesh of the plan.
std::vector<passes::MapSquare> of_mesh(const std::vector<passes::MapSquare>& all, std::uint32_t mesh);
/// Returns the skin meshes of the plan that squares sorted by mesh have, each once.
std::vector<std::uint32_t> meshes_of(const std::vector<passes::MapSquare>& all);

/// Returns the name of a pass: "shadow" where all heads are of one batch, else "shadow batch 3".
std::string label(std::string_view what, const FrameSettings& settings, const Batch& batch);

}  // namespace dermis::techniques
