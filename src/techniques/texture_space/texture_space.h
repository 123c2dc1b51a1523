// SPDX-License-Identifier: MIT
/// Texture-space diffusion. Based on: [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin.
/// EGSR 2007; GPU Gems 3, ch. 14.
#pragma once

#include "techniques/technique.h"

namespace dermis::techniques {

extern const Technique texture_space;

}  // namespace dermis::techniques
