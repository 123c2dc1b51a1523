// SPDX-License-Identifier: MIT
#include "render/setup/pool.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/core/error.h"
#include "render/techniques/memory.h"

namespace dermis::setup {
namespace {

constexpr double default_squares = 4;        // of T_max
constexpr double default_maps_mb = 512;      // if those take less
constexpr double default_shadows_mb = 512;   // beyond those of as many heads
constexpr std::uint32_t most_together = 64;  // heads

// Returns a side that holds `used_side` texels, by steps of an eighth of a power of two of T_max. A head that
// comes nearer changes the plan four times until its map has twice the side.
std::uint32_t side_of_squares(std::uint32_t most_side, std::uint32_t used_side) {
  std::uint32_t octave = most_side;
  while (octave % 16 == 0 && octave / 2 >= used_side) octave /= 2;
  const std::uint32_t step = std::max(1u, octave / 8);
  return std::min(octave, (used_side + step - 1) / step * step);
}

double budget_mb(double largest_square_mb, const RenderSettings& s, const DeviceTraits& device) {
  if (s.quality.map_budget_mb) return *s.quality.map_budget_mb;
  const double budget = std::max(default_squares * largest_square_mb, default_maps_mb);
  if (device.memory_bytes == 0) return budget;
  return std::min(budget, std::max(largest_square_mb, static_cast<double>(device.memory_bytes) / 4e6));
}

// Returns how many squares the pool of light maps holds, one per head and skin mesh.
std::uint32_t squares_in_budget(double budget_mb, double square_mb, std::uint32_t side,
                                const DeviceTraits& device) {
  // As many rows and columns as a texture of this device can have.
  const double rows = std::max(1u, device.max_image_side / side);
  const double squares = std::floor(budget_mb / square_mb * (1 + 1e-12));
  return static_cast<std::uint32_t>(std::clamp(squares, 1.0, rows * rows));
}

// Shadow maps come on top of the light maps. Large ones must not drive the heads of a batch out of memory,
// and small ones not beyond the layers of a texture.
double heads_in_shadow(const techniques::FrameSettings& plan, double shadow_mb, const RenderSettings& s,
                       const DeviceTraits& device) {
  double heads = std::min(most_together, device.max_array_layers / std::max(plan.shadow_layers, 1u));
  if (device.memory_bytes > 0)
    heads = std::min(heads, static_cast<double>(device.memory_bytes) / 4e6 / shadow_mb);
  if (!s.quality.map_budget_mb)
    heads = std::min(heads, std::max(default_squares, default_shadows_mb / shadow_mb));
  return std::max(1.0, std::floor(heads));
}

}  // namespace

// As many heads as the pool holds at a time; of a head with more skin meshes than that, as many meshes. As
// published, one set of maps serves one skin mesh after the other.
void set_up_pool(techniques::FrameSettings& plan, const techniques::Technique& technique,
                 const PoolHeads& heads, const RenderSettings& s, const DeviceTraits& device) {
  plan.heads_per_batch = 1;
  plan.square_side = plan.most_side;
  if (plan.skin.empty() || !technique.has_light_maps) return;

  const auto mb = [](std::uint64_t bytes) { return static_cast<double>(bytes) / 1e6; };
  const double largest_mb = mb(techniques::map_memory(technique, plan).light_maps);
  const double budget = budget_mb(largest_mb, s, device);
  if (budget < largest_mb)
    throw input_error("",
                      "quality.map_budget_mb {} does not hold the light maps of one head: at "
                      "{} texels per side they take {:.0f} MB",
                      budget, plan.most_side, std::ceil(largest_mb));

  plan.square_side = side_of_squares(plan.most_side, heads.used_side);
  if (technique.as_published) return;
  const techniques::MapMemory memory = techniques::map_memory(technique, plan);
  const std::uint32_t squares = squares_in_budget(budget, mb(memory.light_maps), plan.square_side, device);
  const std::uint32_t meshes = plan.most_meshes();
  if (squares < meshes) {
    plan.meshes_per_batch = std::bit_floor(squares);
    return;
  }
  if (!plan.optimise.any()) return;

  const double together = std::min(heads_in_shadow(plan, mb(memory.shadow_maps), s, device),
                                   static_cast<double>(std::min(squares / meshes, heads.count)));
  plan.heads_per_batch = static_cast<std::uint32_t>(std::max(1.0, together));
}

bool can_keep_shadows(const techniques::FrameSettings& plan, const techniques::Technique& technique,
                      const DeviceTraits& device, bool many_frames) {
  if (plan.head_count() <= plan.heads_per_batch) return true;
  if (!many_frames || plan.head_count() * plan.shadow_layers > device.max_array_layers) return false;

  double budget = 1e6 * default_shadows_mb;
  if (device.memory_bytes > 0) budget = std::min(budget, static_cast<double>(device.memory_bytes) / 4);
  const auto of_a_head = static_cast<double>(techniques::map_memory(technique, plan).shadow_maps);
  return of_a_head * plan.head_count() <= budget;
}

}  // namespace dermis::setup
