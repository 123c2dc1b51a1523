// SPDX-License-Identifier: MIT
/// Outputs of a frame of a session: the picture, and labels of each pixel.
///
/// Labels are unfiltered: one sample at the middle of the pixel, never averaged over several and never
/// blended, so that a number is always one that the scene has. They are of the opaque and cut-out parts of
/// all visible instances, culled and cut out as in the picture. Blended parts (lashes, brows) leave no label:
/// what lies behind them does; `front` and `front_part` are theirs. They do not depend on technique, samples
/// and light.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>

namespace dermis {

/// The members of Results say what each means.
enum class Output : std::uint8_t {
  display,
  linear,
  instance,
  material,
  depth,
  normal,
  uv,
  motion,
  region,
  skin_mesh,
  unwrap,
  thickness,
  matte,
  part,
  front,
  front_part
};

/// A set of outputs: {Output::display, Output::depth}.
class Outputs {
 public:
  constexpr Outputs() = default;
  constexpr Outputs(std::initializer_list<Output> outputs) {
    for (const Output output : outputs) bits_ |= bit(output);
  }
  static constexpr Outputs picture() { return {Output::display, Output::linear}; }
  /// Outputs that take light: all but the labels.
  static constexpr Outputs lit() { return {Output::display, Output::linear, Output::matte}; }
  static constexpr Outputs labels() {
    return {Output::instance, Output::material, Output::depth,     Output::normal, Output::uv,
            Output::motion,   Output::region,   Output::skin_mesh, Output::unwrap, Output::thickness,
            Output::part,     Output::front,    Output::front_part};
  }
  static constexpr Outputs all() { return lit() | labels(); }

  constexpr bool has(Output output) const { return (bits_ & bit(output)) != 0; }
  constexpr bool has_all(Outputs others) const { return (bits_ & others.bits_) == others.bits_; }
  constexpr bool has_any(Outputs others) const { return (bits_ & others.bits_) != 0; }
  constexpr Outputs operator|(Outputs others) const {
    others.bits_ |= bits_;
    return others;
  }
  constexpr bool operator==(const Outputs&) const = default;

 private:
  static constexpr std::uint32_t bit(Output output) { return 1u << static_cast<unsigned>(output); }
  std::uint32_t bits_ = 0;
};

/// Layout of an output in memory: rows from top to bottom, without padding, `channels` values per pixel.
struct OutputRow {
  Output output{};
  const char* name = "";  ///< "depth"; of the command line, of files and of the Python module
  enum class Type : std::uint8_t { uint8, uint32, float32 } type{};
  int channels = 1;
  const char* unit = "";  ///< "m"; empty: a number without one
  const char* help = "";  ///< one line

  constexpr std::size_t bytes_per_pixel() const {
    return static_cast<std::size_t>(channels) * (type == Type::uint8 ? 1 : 4);
  }
};
/// Returns the rows of all outputs, in the order of Output.
std::span<const OutputRow> output_rows();

/// The outputs of one frame, in the memory that the device wrote; those that the session does not want are
/// empty. A lease: the spans stay as they are, whatever the session draws, until the last copy of the object
/// is destroyed, by any thread, also after session and renderer. A session whose memory is all leased takes
/// more of it. Writes into the spans go into that memory.
struct Results {
  int width = 0, height = 0;  ///< pixels

  /// RGBA, 8 bits, after the tone map; alpha = 255.
  std::span<std::uint8_t> display;
  /// RGBA, linear Rec.709 with exposure and bloom; alpha = share of the pixel that is skin, which is no
  /// matte. The device computes with half floats, of which these are the exact values.
  std::span<float> linear;

  /// 0: nothing is there. Else 1 + the number of the instance in Scene::instances(), hidden ones counted. In
  /// a row of camera.heads, 1 + the number of the head, from that which stands farthest towards -X.
  std::span<std::uint32_t> instance;
  /// 0: nothing is there. Else 1 + the number of the material in Asset::materials() of the instance's asset,
  /// which are the names.
  std::span<std::uint32_t> material;
  /// Metres from the eye, along the direction in which the camera looks, not along the ray; under an
  /// orthographic camera from the plane through its eye. At least the distance of the near plane. Infinity:
  /// nothing is there.
  std::span<float> depth_m;
  /// Three values per pixel: the vertices' normals, interpolated, without normal maps. Of unit length, in the
  /// world, on the side of the surface that is seen. Near an outline interpolated ones may lean away from the
  /// eye by a little. 0 0 0: nothing is there.
  std::span<float> normal;
  /// Two values per pixel: the asset's first set of texture coordinates as they are in the file, v down,
  /// before the transform of a map; any number. 0 0 where nothing is, and where the mesh has none.
  std::span<float> uv;
  /// Two values per pixel: pixels, to the right and down, that this point of the surface has moved in the
  /// picture since the session's frame before. Camera, instance and pose move it. So it was at the middle of
  /// the pixel minus these. 0 0 where nothing is, in the first frame, and for an instance that the frame
  /// before had not; infinity where the point lay behind the camera. An instance that was outside the picture
  /// counts from the pose in which it was drawn last; one whose pose has just been taken off, from its rest.
  std::span<float> motion_px;
  enum Region : std::uint8_t { no_region, nose, ear, other_skin };
  /// A Region: nose and ears of a head that looks along +Z in its asset's coordinates. They are found at the
  /// vertices of the skin, as picture_regions() finds them (docs/methodology.md). `other_skin` is the rest of
  /// the skin, and all skin that is no such head; `no_region` is nothing, or no skin.
  std::span<std::uint8_t> region;
  /// 0: no skin is there. Else 1 + the number of the skin mesh in the asset: parts of it that share a light
  /// map.
  std::span<std::uint32_t> skin_mesh;
  /// Two values per pixel: the texture coordinates of the light map of that skin mesh, 0 to 1, v down, which
  /// the map of `output.show` "irradiance" has, too. 0 0 where no skin is.
  std::span<float> unwrap;
  /// Thickness of the body below the skin, millimetres. It is the mean of rays into a cone around the inward
  /// normal, in the rest pose, times the scale of the instance: the thickness that laws of shape use. The
  /// most is 50 mm times that scale, also where the body does not close. 0 where no skin is.
  std::span<float> thickness_mm;

  /// Share of the pixel that heads cover, 0 to 1, as the picture samples it; blended parts (lashes, brows) by
  /// their alpha. The picture over light of radiance L behind the heads is linear + (1 - matte) * L. No
  /// label: it takes a lit frame.
  std::span<float> matte;

  enum Part : std::uint32_t {
    nothing,
    face,  ///< its skin, the scalp and eyelids among it
    part_nose,
    right_eye,  ///< the person's right; with caruncle and tears
    left_eye,
    right_brow,
    left_brow,
    right_ear,
    left_ear,
    mouth_interior,
    upper_lip,
    lower_lip,
    neck,  ///< with the shoulders
    hair,
    lashes,
    other  ///< no skin, of a material whose name says none of these
  };
  /// A Part; part_rows() has their names. Skin is divided where the asset has landmarks (dermis/landmarks.h):
  /// lips by their outline, the neck by the jaw line. Without them its nose and ears are found alone. All
  /// else is what the name of its primitive or material says (eye, iris, teeth, tongue, brow, lash, hair
  /// ...); the side is that on which it lies at rest.
  std::span<std::uint32_t> part;
  /// Share of the pixel's middle that blended parts before that cover, by their alpha, 0 to 1; as half
  /// floats.
  std::span<float> front;
  /// A Part: of the nearest blended part that covers a half or more. `nothing`: there is none.
  std::span<std::uint32_t> front_part;

  /// Returns one of the above as bytes.
  std::span<std::byte> bytes(Output output) const;

  std::shared_ptr<const void> lease;  ///< of the memory; null: there is none
};

/// A part of a face, and the class that it has in data sets of others.
struct PartRow {
  Results::Part part{};
  const char* name = "";
  /// Of FaceSynthetics (Wood et al., ICCV 2021). 255, which it ignores: it has no such class.
  std::uint8_t face_synthetics = 0;
  /// Of CelebAMask-HQ (Lee et al., CVPR 2020), by the order of its g_mask.py; `l_` is taken for the person's
  /// left. 0, background: it has no such class.
  std::uint8_t celeba_mask_hq = 0;
};
/// Returns the rows of all parts, in the order of Results::Part.
std::span<const PartRow> part_rows();

}  // namespace dermis
