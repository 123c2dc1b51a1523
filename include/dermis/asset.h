// SPDX-License-Identifier: MIT
/// Assets: heads with all that belongs to them (meshes, materials, maps), from a file, from arrays, or built
/// in. An Asset is a cheap handle; copies share what they hold, and nothing ever changes it. Any number of
/// threads may use one.
///
/// Each mesh of an asset has a number, and each vertex of a mesh has one, both from 0, as its source has
/// them, whatever dermis drops, splits or joins:
/// - arrays: a mesh is an element of AssetArrays::meshes, a vertex one of its positions_m;
/// - a file: a mesh is a primitive at a node. They are counted node by node in the order of the file's
///   `nodes`, all primitives of the node's mesh in their order, shown or not, triangles or not; what two
///   nodes show counts twice. Vertices are those of the accessors, or as Draco's decoder returns them. Copies
///   of a mesh that is not skin, which nodes only move, turn and scale, are kept as one, with one of their
///   numbers;
/// - the head built in: its skin is mesh 0, its eyes are mesh 1, then what else it has.
/// Coordinates of an asset are metres, after unit_scale and the nodes of a file.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/hooks.h"
#include "dermis/light.h"

namespace dermis {

struct AssetArrays;  // dermis/asset_arrays.h

struct SceneOptions {
  double unit_scale = 1;  ///< multiplies every length of the file; glTF says metres
  /// Names of the materials that are skin, or shell patterns of them ("*Skin*"), each of which must match
  /// one. Empty: those that say so in extras.dermis, else those with the word "skin" in their name, else the
  /// only one in use, unless an unused one is called skin.
  std::vector<std::string> skin_material{};
  /// The pose: that of an animation of the file at a time in seconds, clamped to the clip. Neither: as the
  /// file has it at rest. A time alone: of the first animation; a clip alone: at its begin. Arrays have none.
  std::string clip{};
  std::optional<double> time_s{};
  /// For all maps of the asset, 1e6 bytes, 1 to 1e6: as decoded and on the device with their levels, 9.3
  /// bytes per texel, 14.7 of colour maps. Over it the largest maps are halved while they are read, with a
  /// note.
  double texture_budget_mb = 2000;
  /// Other pigments for the skin: pictures of volume fractions, as `dermis profile --head` writes them;
  /// empty: those of its colour map. The spectral model (docs/theory.md) changes the colour map.
  std::string melanin_map{}, haemoglobin_map{};
  /// Multiply those fractions, 0.01 to 100: blush, tan, pallor.
  double melanin_factor = 1, haemoglobin_factor = 1;
};

/// Bounds of an asset's skin, or of all of it if nothing is skin; in its coordinates, metres.
struct AssetBounds {
  std::array<double, 3> low_m{}, high_m{};  ///< corners of the box
  /// The sphere around the middle of the box whose radius is the unit of distances (CameraSettings, lamps).
  std::array<double, 3> centre_m{};
  double radius_m = 0;
};

class Asset {
 public:
  /// Loads glTF 2.0, .gltf or .glb; or makes the built-in head of a skin: "built-in:light",
  /// "built-in:medium", "built-in:dark". There is one in each class of typology angles, too:
  /// "built-in:ita-very-light", "ita-light", "ita-intermediate", "ita-tan", "ita-brown", "ita-dark". Warns of
  /// doubtful things. Takes seconds with large maps. Throws
  /// - InputError: one line with file and place;
  /// - Cancelled: a hook has ended the work.
  static Asset load(const std::filesystem::path& path, const SceneOptions& options = {},
                    const Hooks& hooks = {});
  /// Makes the asset that a glTF file with the same content gives, without lights and cameras: see
  /// dermis/asset_arrays.h. Copies the arrays. Of `options`, unit_scale must be 1. Throws
  /// - InputError: one line with asset, mesh and place;
  /// - Cancelled: a hook has ended the work.
  static Asset from_arrays(const AssetArrays& arrays, const SceneOptions& options = {},
                           const Hooks& hooks = {});
  /// Makes the head that is built into the library; no file needed. Takes seconds. Throws Cancelled as load()
  /// does.
  static Asset built_in(const Hooks& hooks = {});

  const std::string& name() const;             ///< file name, or "built-in"
  std::vector<std::string> materials() const;  ///< their names
  std::vector<std::string> cameras() const;    ///< those of the file; CameraSettings::name takes one
  std::vector<std::string> clips() const;  ///< names of the file's animations; "0", "1" ... if unnamed. Their
                                           ///< numbers, from 0, stand for them where no name does
  /// Time of the last key frame of a clip, seconds. Throws InputError: no such clip, or a faulty one.
  double clip_end_s(const std::string& clip) const;
  /// Names of what poses can move (dermis/pose.h): the file's nodes, and the morph targets of its meshes,
  /// each once. Where the file has no name, a number: of the node, or of the target in its mesh. Empty:
  /// nothing.
  std::vector<std::string> joints() const;
  std::vector<std::string> morph_weights() const;
  std::vector<Light> lights() const;  ///< those of the file, in the asset's own coordinates
  AssetBounds bounds() const;

  /// Compares identity, not contents.
  bool operator==(const Asset& other) const { return state_ == other.state_; }

  struct State;  // of the library

 private:
  explicit Asset(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace dermis
