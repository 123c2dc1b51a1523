// SPDX-License-Identifier: MIT
#include "api/host_records.h"

#include "render/passes/scatter/scatter_sum/scatter_sum.h"

namespace dermis::api {

HostRecords::HostRecords(std::span<const AssetPointer> assets, float unlit_rest) {
  for (const AssetPointer& asset : assets) {
    for (const scene::SkinMesh& mesh : asset->data->skin)
      unlit_.push_back(
          {.uv_scale = mesh.unwrap_scale, .uv_offset = mesh.unwrap_offset, .unlit_rest = unlit_rest});
    first_.push_back(static_cast<std::uint32_t>(unlit_.size()));
  }
}

std::vector<HostRecord> HostRecords::of(const passes::FrameData& frame) const {
  std::vector<HostRecord> records = unlit_;
  for (std::size_t i = 0; i < frame.heads.size(); ++i) {
    const passes::Head& head = frame.heads[i];
    const std::uint32_t first = first_[head.instance];
    for (std::size_t mesh = 0; mesh < head.map_places.size(); ++mesh) {
      HostRecord& record = records[first + mesh];
      record.origin = head.map_places[mesh].origin;
      record.side = static_cast<float>(head.detail.side);
      record.layer = passes::ScatterSum::layer_of(head.map_places[mesh].batch);
      const passes::MapSquare square{static_cast<std::uint32_t>(i),
                                     head.first_mesh + static_cast<std::uint32_t>(mesh)};
      record.lit = passes::holds_light(frame, square) ? 1 : 0;
    }
  }
  return records;
}

}  // namespace dermis::api
