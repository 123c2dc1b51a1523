// SPDX-License-Identifier: MIT
#include "api/labels.h"

#include <cstring>

#include "core/assert.h"
#include "passes/labels/labels_io.h"

namespace dermis::api {

static_assert(Labels::nose == LABEL_REGION_NOSE && Labels::ear == LABEL_REGION_EAR &&
              Labels::other_skin == LABEL_REGION_OTHER_SKIN);

Labels labels_of(int width, int height, std::span<const std::byte> surface, std::span<const std::byte> names,
                 std::span<const std::byte> motion, std::span<const std::byte> body) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  DERMIS_ASSERT_EQ(surface.size(), pixels * sizeof(io::LabelSurfaceIo));
  DERMIS_ASSERT_EQ(names.size(), pixels * sizeof(io::LabelNamesIo));
  DERMIS_ASSERT_EQ(motion.size(), pixels * 2 * sizeof(float));
  DERMIS_ASSERT_EQ(body.size(), pixels * sizeof(io::LabelBodyIo));

  Labels out{.width = width, .height = height};
  out.instance.resize(pixels);
  out.material.resize(pixels);
  out.depth_m.resize(pixels);
  out.normal.resize(3 * pixels);
  out.uv.resize(2 * pixels);
  out.region.resize(pixels);
  out.motion_px.resize(2 * pixels);
  out.skin_mesh.resize(pixels);
  out.unwrap.resize(2 * pixels);
  out.thickness_mm.resize(pixels);
  std::memcpy(out.motion_px.data(), motion.data(), motion.size());

  for (std::size_t i = 0; i < pixels; ++i) {
    io::LabelSurfaceIo s;
    io::LabelNamesIo n;
    io::LabelBodyIo b;
    std::memcpy(&s, &surface[i * sizeof s], sizeof s);
    std::memcpy(&n, &names[i * sizeof n], sizeof n);
    std::memcpy(&b, &body[i * sizeof b], sizeof b);
    out.instance[i] = n.instance;
    out.material[i] = n.material_and_region & ((1u << LABEL_REGION_SHIFT) - 1);
    out.region[i] = static_cast<std::uint8_t>(n.material_and_region >> LABEL_REGION_SHIFT);
    out.depth_m[i] = s.depth_m;
    for (int k = 0; k < 3; ++k) out.normal[3 * i + static_cast<std::size_t>(k)] = s.normal[k];
    out.skin_mesh[i] = static_cast<std::uint32_t>(b.skin_mesh);
    out.thickness_mm[i] = b.thickness_mm;
    for (int k = 0; k < 2; ++k) out.unwrap[2 * i + static_cast<std::size_t>(k)] = b.unwrap[k];
    for (int k = 0; k < 2; ++k) out.uv[2 * i + static_cast<std::size_t>(k)] = n.uv[k];
  }
  return out;
}

}  // namespace dermis::api
