// SPDX-License-Identifier: MIT
/// The technique of the papers, whole and in this folder alone; README.md walks through it.
/// Based on:
/// [DLE07] d'Eon, Luebke, Enderton: Efficient Rendering of Human Skin. EGSR 2007; GPU Gems 3, ch. 14
/// [JG08]  Jimenez, Gutierrez: Faster Rendering of Human Skin. CEIG 2008
#pragma once

#include "render/techniques/technique.h"

namespace dermis::techniques {

extern const Technique published;

}  // namespace dermis::techniques
