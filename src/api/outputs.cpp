// SPDX-License-Identifier: MIT
#include "api/outputs.h"

#include <array>

#include "base/core/assert.h"
#include "render/passes/pixels/labels/label_planes.h"
#include "render/passes/pixels/labels/labels_io.h"

namespace dermis {
namespace {

using Type = OutputRow::Type;
constexpr std::array rows{
    OutputRow{Output::display, "display", Type::uint8, 4, "", "the picture, RGBA after the tone map"},
    OutputRow{Output::linear, "linear", Type::float32, 4, "",
              "the picture, linear Rec.709; alpha: share of skin"},
    OutputRow{Output::instance, "instance", Type::uint32, 1, "", "1 + number of the instance; 0: nothing"},
    OutputRow{Output::material, "material", Type::uint32, 1, "", "1 + number of the material; 0: nothing"},
    OutputRow{Output::depth, "depth", Type::float32, 1, "m",
              "along the axis of the camera; infinity: nothing"},
    OutputRow{Output::normal, "normal", Type::float32, 3, "", "interpolated, in the world; 0: nothing"},
    OutputRow{Output::uv, "uv", Type::float32, 2, "", "texture coordinates of the file, v down"},
    OutputRow{Output::motion, "motion", Type::float32, 2, "px", "since the frame before, right and down"},
    OutputRow{Output::region, "region", Type::uint8, 1, "", "0 no skin, 1 nose, 2 ear, 3 other skin"},
    OutputRow{Output::skin_mesh, "skin_mesh", Type::uint32, 1, "", "1 + number of the skin mesh; 0: no skin"},
    OutputRow{Output::unwrap, "unwrap", Type::float32, 2, "", "coordinates of the light map, v down"},
    OutputRow{Output::thickness, "thickness", Type::float32, 1, "mm",
              "of the body below the skin; 0: no skin"},
    OutputRow{Output::matte, "matte", Type::float32, 1, "", "share of the pixel that heads cover, 0 to 1"},
    OutputRow{Output::part, "part", Type::uint32, 1, "", "of the face; 0: nothing"},
    OutputRow{Output::front, "front", Type::float32, 1, "",
              "share of the pixel that blended parts before that cover"},
    OutputRow{Output::front_part, "front_part", Type::uint32, 1, "",
              "the nearest blended part that covers a half; 0: none"}};

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].output != static_cast<Output>(i)) return false;
  return rows.size() == static_cast<std::size_t>(Output::front_part) + 1;
}
static_assert(are_in_order());
static_assert(Results::nose == LABEL_REGION_NOSE && Results::ear == LABEL_REGION_EAR &&
              Results::other_skin == LABEL_REGION_OTHER_SKIN);

std::uint32_t label_bit(Output output) {
  switch (output) {
    case Output::display:
    case Output::linear:
    case Output::matte: break;
    case Output::instance: return LABEL_INSTANCE;
    case Output::material: return LABEL_MATERIAL;
    case Output::depth: return LABEL_DEPTH;
    case Output::normal: return LABEL_NORMAL;
    case Output::uv: return LABEL_UV;
    case Output::motion: return LABEL_MOTION;
    case Output::region: return LABEL_REGION;
    case Output::skin_mesh: return LABEL_SKIN_MESH;
    case Output::unwrap: return LABEL_UNWRAP;
    case Output::thickness: return LABEL_THICKNESS;
    case Output::part: return LABEL_PART;
    case Output::front: return LABEL_FRONT;
    case Output::front_part: return LABEL_FRONT_PART;
  }
  return 0;
}

// Numbers of FaceSynthetics: README of microsoft/FaceSynthetics. Of CelebAMask-HQ: README of
// switchablenorms/CelebAMask-HQ.
constexpr std::array parts{PartRow{Results::nothing, "nothing", 0, 0},
                           PartRow{Results::face, "face", 1, 1},
                           PartRow{Results::part_nose, "nose", 2, 2},
                           PartRow{Results::right_eye, "right eye", 3, 5},
                           PartRow{Results::left_eye, "left eye", 4, 4},
                           PartRow{Results::right_brow, "right brow", 5, 7},
                           PartRow{Results::left_brow, "left brow", 6, 6},
                           PartRow{Results::right_ear, "right ear", 7, 9},
                           PartRow{Results::left_ear, "left ear", 8, 8},
                           PartRow{Results::mouth_interior, "mouth interior", 9, 10},
                           PartRow{Results::upper_lip, "upper lip", 10, 11},
                           PartRow{Results::lower_lip, "lower lip", 11, 12},
                           PartRow{Results::neck, "neck", 12, 17},
                           PartRow{Results::hair, "hair", 13, 13},
                           PartRow{Results::lashes, "lashes", 255, 0},
                           PartRow{Results::other, "other", 255, 0}};
static_assert(parts[Results::other].part == Results::other && parts.size() == Results::other + 1);
static_assert(Results::face == LABEL_PART_FACE && Results::part_nose == LABEL_PART_NOSE &&
              Results::right_eye == LABEL_PART_RIGHT_EYE && Results::right_brow == LABEL_PART_RIGHT_BROW &&
              Results::right_ear == LABEL_PART_RIGHT_EAR && Results::mouth_interior == LABEL_PART_MOUTH &&
              Results::upper_lip == LABEL_PART_UPPER_LIP && Results::lower_lip == LABEL_PART_LOWER_LIP &&
              Results::neck == LABEL_PART_NECK && Results::hair == LABEL_PART_HAIR &&
              Results::lashes == LABEL_PART_LASHES && Results::other == LABEL_PART_OTHER);

template <class T>
std::span<T> span_of(std::span<std::byte> bytes) {
  return {reinterpret_cast<T*>(bytes.data()), bytes.size() / sizeof(T)};
}

}  // namespace

std::span<const OutputRow> output_rows() { return rows; }

std::span<const PartRow> part_rows() { return parts; }

std::span<std::byte> Results::bytes(Output output) const {
  switch (output) {
    case Output::display: return std::as_writable_bytes(display);
    case Output::linear: return std::as_writable_bytes(linear);
    case Output::instance: return std::as_writable_bytes(instance);
    case Output::material: return std::as_writable_bytes(material);
    case Output::depth: return std::as_writable_bytes(depth_m);
    case Output::normal: return std::as_writable_bytes(normal);
    case Output::uv: return std::as_writable_bytes(uv);
    case Output::motion: return std::as_writable_bytes(motion_px);
    case Output::region: return std::as_writable_bytes(region);
    case Output::skin_mesh: return std::as_writable_bytes(skin_mesh);
    case Output::unwrap: return std::as_writable_bytes(unwrap);
    case Output::thickness: return std::as_writable_bytes(thickness_mm);
    case Output::matte: return std::as_writable_bytes(matte);
    case Output::part: return std::as_writable_bytes(part);
    case Output::front: return std::as_writable_bytes(front);
    case Output::front_part: return std::as_writable_bytes(front_part);
  }
  return {};
}

namespace api {

std::uint32_t label_bits(Outputs wanted) {
  std::uint32_t bits = 0;
  for (const OutputRow& row : rows)
    if (wanted.has(row.output)) bits |= label_bit(row.output);
  return bits;
}

ReadbackSizes readback_sizes(Outputs wanted, std::uint64_t pixels) {
  return {.display = wanted.has(Output::display) ? 4 * pixels : 0,
          .linear = wanted.has(Output::linear) ? 16 * pixels : 0,
          .matte = wanted.has(Output::matte) ? 4 * pixels : 0,
          .labels = passes::bytes_of_planes(label_bits(wanted), pixels)};
}

Results results_of(Outputs wanted, int width, int height, const std::shared_ptr<Readback>& readback) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  const std::uint32_t labels = label_bits(wanted);

  const auto plane = [&](Output output) -> std::span<std::byte> {
    if (!wanted.has(output)) return {};
    return readback->labels.mapped().subspan(
        passes::plane_offset(labels, label_bit(output), pixels),
        rows[static_cast<std::size_t>(output)].bytes_per_pixel() * pixels);
  };
  const auto whole = [](const gpu::Buffer& buffer) {
    return buffer ? buffer.mapped() : std::span<std::byte>();
  };
  return {.width = width,
          .height = height,
          .display = span_of<std::uint8_t>(whole(readback->display)),
          .linear = span_of<float>(whole(readback->linear)),
          .instance = span_of<std::uint32_t>(plane(Output::instance)),
          .material = span_of<std::uint32_t>(plane(Output::material)),
          .depth_m = span_of<float>(plane(Output::depth)),
          .normal = span_of<float>(plane(Output::normal)),
          .uv = span_of<float>(plane(Output::uv)),
          .motion_px = span_of<float>(plane(Output::motion)),
          .region = span_of<std::uint8_t>(plane(Output::region)),
          .skin_mesh = span_of<std::uint32_t>(plane(Output::skin_mesh)),
          .unwrap = span_of<float>(plane(Output::unwrap)),
          .thickness_mm = span_of<float>(plane(Output::thickness)),
          .matte = span_of<float>(whole(readback->matte)),
          .part = span_of<std::uint32_t>(plane(Output::part)),
          .front = span_of<float>(plane(Output::front)),
          .front_part = span_of<std::uint32_t>(plane(Output::front_part)),
          .lease = readback};
}

}  // namespace api
}  // namespace dermis
