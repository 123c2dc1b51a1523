// SPDX-License-Identifier: MIT
/// Common part of the passes that shade the entries of one skin mesh of one head.
#pragma once

#include <span>

#include "render/passes/bindings.h"
#include "render/passes/pixels/entry_buffers.h"
#include "render/passes/pixels/shade/skin_shading.h"

namespace dermis::passes {

/// Records a dispatch for each part of the mesh, unless its head is not drawn. `pipelines`: by
/// SkinVariant::index(). `bindings`: those of the pass, beside what the shading and the entries offer.
void shade_parts(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame,
                 const SkinParts& shaded, const EntryBuffers& entries, const SkinShading& shading,
                 std::span<const gpu::Pipeline* const> pipelines, Bindings bindings = {});

}  // namespace dermis::passes
