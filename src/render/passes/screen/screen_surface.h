// SPDX-License-Identifier: MIT
/// Light that techniques in screen space blur, and its surface: one value per pixel, of the entry that most
/// of its samples show (render/passes/pixels/entries). Light of other surfaces in a pixel, beside a
/// silhouette, is not blurred; they take the blurred light of their pixel, if that is of the same head.
#pragma once

#include "gpu/resources.h"
#include "render/passes/frame_data.h"
#include "render/passes/screen/screen_surface_io.h"

namespace dermis::passes {

struct ScreenSurface {
  /// RGBA16F: light that entered, times the part of the albedo before scattering, as radiance; alpha 1 where
  /// there is skin
  frame::TextureId light;
  frame::TextureId depth_mm;  ///< R32F: distance along the view, mm of the asset; 0 where there is no skin
  frame::TextureId surface;   ///< R32_UINT: head and normal, see screen_surface_io.h
  /// RGBA16F, a layer for each entry of a pixel: what blurred light is multiplied by where it leaves; alpha
  /// of the first: the skin mesh of the plan, less SURFACE_MESH_MIDDLE
  frame::TextureId leaving;
  bool halved = false;  ///< of half the width and height of the picture
};

/// Makes them for a picture of this size with so many samples, and clears them.
ScreenSurface make_screen_surface(FramePlan& plan, std::uint32_t width, std::uint32_t height,
                                  std::uint32_t samples);

/// Returns the texture that blurred light is written to: as `light`.
gpu::TextureDesc screen_light(std::uint32_t width, std::uint32_t height);

/// Returns the pixels of a surface beside which there is no skin. Passes compute these alone.
PixelArea area_of(const ScreenSurface& surface, const FrameData& frame);

/// Returns what shaders need to know of the pixels of a surface, which lie in textures as large as this one,
/// and of the camera beside its matrix.
io::ScreenIo screen_io(const gpu::TextureDesc& texture, const ScreenSurface& surface, const FrameData& frame);

}  // namespace dermis::passes
