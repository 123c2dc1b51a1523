// SPDX-License-Identifier: MIT
// Data that changes per frame, for passes while they record.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "frame/plan.h"
#include "gpu/cmd.h"
#include "gpu/resources.h"
#include "render/passes/head.h"
#include "render/passes/light_map/kept_maps.h"
#include "render/passes/pixels/pixel_area.h"
#include "render/shared/scene_io.h"

namespace dermis::passes {

/// An instance that this frame moves.
struct RigMove {
  const PosedShape* shape = nullptr;
  const GpuAsset* asset = nullptr;       ///< with its rig
  gpu::BufferBinding matrices, weights;  ///< mat4x3[], float[]: scene::PosedRig
};

/// An instance whose light of the sky this frame finds anew.
struct SkyTurn {
  const PosedShape* shape = nullptr;
  const GpuAsset* asset = nullptr;  ///< with its rig
  gpu::BufferBinding sky;           ///< SkyHarmonicsIo
};

struct UsedSquare;

/// Draws irradiance into squares of a map, RGBA16F, ready to be rendered to and cleared to 0.
using DrawIrradiance =
    std::function<void(gpu::Cmd& cmd, const gpu::Texture& map, std::span<const UsedSquare> squares)>;

/// Buffers lie in the memory of the frame, which must outlive this.
struct FrameData {
  io::CameraIo camera{};                      ///< that of frame_io
  gpu::BufferBinding frame_io;                ///< FrameIo
  gpu::BufferBinding lamps;                   ///< LightIo[] and mat4[] of all heads: LampsIo
  const gpu::Texture* environment = nullptr;  ///< RGBA16F, prefiltered; none: uniform light
  /// RGBA16F, what stands behind the heads, with its lamps; none: uniform light, or it is not shown
  const gpu::Texture* environment_picture = nullptr;
  std::vector<Head> heads;           ///< at least one, in the order of the plan
  std::vector<RigMove> moves;        ///< those that move in this frame, each once
  std::vector<SkyTurn> sky_turns;    ///< those, and any in a pose under another sky than before
  std::optional<VkRect2D> area;      ///< part of the targets that is the picture; none: all
  PixelArea with_heads;              ///< of the targets: beside it is no head
  DrawIrradiance draw_irradiance;    ///< of a host
  KeptMaps* kept_shadows = nullptr;  ///< of the memory of the plan; none: all shadow maps are drawn
  KeptMaps* kept_texels = nullptr;   ///< likewise of TexelMap
};

using FramePlan = frame::FramePlan<FrameData>;

}  // namespace dermis::passes
