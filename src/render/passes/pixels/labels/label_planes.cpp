// SPDX-License-Identifier: MIT
#include "render/passes/pixels/labels/label_planes.h"

#include "base/core/assert.h"
#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/pixels/labels/label_planes_io.h"

namespace dermis::passes {
std::uint64_t plane_offset(std::uint32_t labels, std::uint32_t label, std::uint64_t pixels) {
  std::uint64_t bytes = 0;
  for (std::uint32_t i = 0; i < LABEL_COUNT && 1u << i < label; ++i)
    if ((labels >> i & 1) != 0) bytes += (1u << i == LABEL_REGION ? 1 : 4 * label_words[i]) * pixels;
  return bytes;
}

std::uint64_t bytes_of_planes(std::uint32_t labels, std::uint64_t pixels) {
  return (plane_offset(labels, 1u << LABEL_COUNT, pixels) + 3) / 4 * 4;
}

LabelPlanes::Out LabelPlanes::declare(frame::Declare& d) {
  DERMIS_ASSERT(settings.labels != 0);
  compute(d, "label_planes.comp", {{"labels", settings.labels}});
  for (const frame::TextureId words : in.words)
    if (words.valid()) d.sample(words);
  const std::uint64_t pixels = std::uint64_t{settings.width} * settings.height;
  out_.planes = d.create("label planes", gpu::BufferDesc{.bytes = bytes_of_planes(settings.labels, pixels)});
  d.write(out_.planes);
  return out_;
}

void LabelPlanes::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData&) const {
  // Those that no label needs are not read: any will do.
  const auto words = [&](std::size_t i) {
    return resources.nearest(in.words[i].valid() ? in.words[i] : in.words[0]);
  };
  Bindings()
      .add("words_0", words(0))
      .add("words_1", words(1))
      .add("words_2", words(2))
      .add("words_3", words(3))
      .add("Planes", resources.buffer(out_.planes))
      .bind(cmd, pipeline());
  dispatch(cmd, io::LabelPlanesIo{.size = {settings.width, settings.height}}, settings.width,
           settings.height);
}

}  // namespace dermis::passes
