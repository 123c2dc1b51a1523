// SPDX-License-Identifier: MIT
#include "passes/texel_list/texel_list.h"

#include "frame/resources.h"
#include "passes/bindings.h"
#include "passes/texel_list/texel_list_io.h"

namespace dermis::passes {

ListTexels::Out ListTexels::declare(frame::Declare& d) {
  const bool counted = in.lists.materials > 1 && !settings.counts_only;
  compute(d, "list_texels.comp",
          {{"counts_only", settings.counts_only ? 1u : 0u}, {"counted", counted ? 1u : 0u}});
  d.sample(in.texels);
  if (in.kept.valid()) d.read(in.kept.indices);
  d.write(in.lists.lists);
  d.write(in.lists.entries);
  return {};
}

void ListTexels::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  for (const UsedSquare& square : used_squares(frame, settings.squares)) {
    const GpuMesh& mesh = instance_of(frame, square).scene->skin[mesh_in_asset(frame, square)];
    Bindings bindings;
    bindings.add("texels", resources.nearest(in.texels))
        .add("Lists", resources.buffer(in.lists.lists))
        .add("entries", resources.storage(in.lists.entries));
    mesh.offer(bindings);
    if (in.kept.valid()) bindings.add("Indices", kept_in(in.kept, resources, square));
    bindings.bind(cmd, pipeline());

    DERMIS_ASSERT_LE(mesh.draws.size(), std::size_t{in.lists.materials});
    for (std::size_t k = 0; k < mesh.draws.size(); ++k) {
      const GpuDraw& draw = mesh.draws[k];
      dispatch(cmd,
               io::ListTexelsIo{.origin = square.origin,
                                .side = square.side,
                                .first_triangle = draw.first_index / 3,
                                .end_triangle = (draw.first_index + draw.index_count) / 3,
                                .list = texel_list(in.lists, square, k)},
               (square.side + TEXEL_RUN - 1) / TEXEL_RUN, square.side);
    }
  }
}

TexelRanges::Out TexelRanges::declare(frame::Declare& d) {
  compute(d, "texel_ranges.comp");
  d.write(in.lists.lists);
  d.write(in.lists.arguments);
  return {};
}

void TexelRanges::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Lists", resources.buffer(in.lists.lists))
      .add("Arguments", resources.buffer(in.lists.arguments))
      .bind(cmd, pipeline());
  for (const UsedSquare& square : used_squares(frame, settings.squares))
    dispatch(
        cmd,
        io::TexelRangesIo{.first_list = texel_list(in.lists, square, 0), .materials = in.lists.materials}, 1,
        1);
}

}  // namespace dermis::passes
