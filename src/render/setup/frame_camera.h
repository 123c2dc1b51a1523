// SPDX-License-Identifier: MIT
/// The camera of a frame, and what it needs of the heads: how large light maps, which of them at all.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "dermis/settings.h"
#include "head/scene/asset_data.h"
#include "render/passes/pixels/pixel_area.h"
#include "render/passes/shadow/fit.h"
#include "render/setup/placed_scene.h"
#include "render/shared/scene_io.h"

namespace dermis::setup {

/// Returns the camera as passes and shaders see it, for pictures of this ratio of width to height.
io::CameraIo frame_camera(const scene::Camera& camera, double picture_aspect);

/// Returns d_ref of [JG08] sec. 4, sphere radii: the distance at which a map of quality.map_size texels,
/// its T_max, has one texel per pixel, unless the settings give it. It is 0 if the camera is orthographic.
double reference_distance(const scene::AssetData& asset, const RenderSettings& settings,
                          const scene::Camera& camera);

/// Returns the number of pixels that show a mm of the asset where the head is nearest: at the nearest point
/// of its box. The paper takes the nearest vertex; a point that is never farther keeps maps from being too
/// small. Infinity if the eye is inside. A d_ref that the settings give stands for that of the picture.
/// `posed`: of a head in a pose, whose box is that of the pose.
double pixels_per_mm(const scene::AssetData& asset, const RenderSettings& settings,
                     const scene::Camera& camera, const scene::Similarity& world_from_asset,
                     const PosedAsset* posed = nullptr);

/// Returns the number of pixels across a sphere around all that casts shadows, where it is nearest; infinity
/// if the eye is inside.
double pixels_across(const scene::BoundingSphere& casters, const RenderSettings& settings,
                     const scene::Camera& camera);

/// Returns T of a head as [JG08] sec. 4 has it: min(d_ref / d, 1) T_max, where a texel is as large as a
/// pixel, rounded up to 32 texels.
int paper_side(const scene::AssetData& asset, const RenderSettings& settings, double pixels_per_mm);

/// Returns all that paper_side() may return, largest first.
std::vector<int> paper_sides(const RenderSettings& settings);

/// Returns whether any part of the head may lie in the picture: its sphere against the planes.
bool in_view(const scene::AssetData& asset, const io::CameraIo& camera,
             const scene::Similarity& world_from_asset, const PosedAsset* posed = nullptr);

/// Returns pixels that hold all that a head may show, of a picture of `size` pixels. They hold the corners of
/// a body around it, or of a cube around its sphere, and two pixels more.
passes::PixelArea area_of(const passes::ShadowBounds& bounds, const io::CameraIo& camera,
                          const glm::uvec2& size);

/// Returns the smallest area that holds both.
passes::PixelArea joined(const passes::PixelArea& a, const passes::PixelArea& b);

}  // namespace dermis::setup
