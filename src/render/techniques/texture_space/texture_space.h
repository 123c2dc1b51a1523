// SPDX-License-Identifier: MIT
/// Texture-space diffusion: lights the skin in the space of its unwrap, blurs that light by the Gaussians of
/// the profile, and draws the head with the sum.
/// Based on:
/// [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007; GPU Gems 3, ch. 14
/// [JG08]  Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008 (what is left out: Optimise)
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {

extern const Technique texture_space;

}  // namespace dermis::techniques
