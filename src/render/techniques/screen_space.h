// SPDX-License-Identifier: MIT
/// Common part of the techniques that blur light in the picture. Skin is shaded once per entry of a pixel, in
/// parts. Light that entered is blurred between pixels, and leaves. Lights, shadow maps and shading are those
/// of all techniques.
#pragma once

#include "render/passes/screen/screen_surface.h"
#include "render/techniques/technique.h"

namespace dermis::techniques {

struct ScreenBlur {
  /// Returns the share of the light of a skin mesh that is blurred; the rest is lit at the pixel.
  gaussians::Rgb (*blurred)(const FrameSettings& settings, const PlannedMesh& part);
  /// Adds the passes that blur the light of the surface; returns the result.
  frame::TextureId (*add)(passes::FramePlan& plan, const FrameSettings& settings,
                          const passes::ScreenSurface& surface);
};

/// Adds the passes of a frame: Technique::build.
FrameOutputs build_in_screen_space(passes::FramePlan& plan, const FrameSettings& settings,
                                   const ScreenBlur& blur);

/// Returns the share of the light that does not leave where it entered.
gaussians::Rgb scattered_share(const FrameSettings& settings, const PlannedMesh& part);

}  // namespace dermis::techniques
