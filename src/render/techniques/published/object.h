// SPDX-License-Identifier: MIT
/// An object is lit, blurred and drawn at a time: one skin mesh of one head. Objects take turns with one set
/// of light maps. [JG08] sec. 4: these are allocated once, of T_max, and a frame uses their corner of T x T.
#pragma once

#include "render/passes/light_map/light_pool.h"

namespace dermis::techniques::papers {

using Object = passes::MapSquare;
using passes::FrameData;
using passes::head_of;
using passes::mesh_in_asset;

/// Returns the asset's mesh of an object.
inline const passes::GpuMesh& mesh_of(const FrameData& frame, const Object& object) {
  return head_of(frame, object).asset->skin[mesh_in_asset(frame, object)];
}

/// Returns whether the object is lit in this frame. Nothing is spent on heads wholly outside the picture.
inline bool is_lit(const FrameData& frame, const Object& object) { return head_of(frame, object).visible; }

/// Returns T, the texels of a side that this frame uses.
inline std::uint32_t used_side(const FrameData& frame, const Object& object) {
  return head_of(frame, object).detail.side;
}

/// [JG08] sec. 4, glViewport(0, 0, T, T).
inline VkRect2D used_area(const FrameData& frame, const Object& object) {
  const std::uint32_t side = used_side(frame, object);
  return {{0, 0}, {side, side}};
}

}  // namespace dermis::techniques::papers
