// SPDX-License-Identifier: MIT
/// Landmarks of a face: 68 points in the order of iBUG (300-W), then the right and the left pupil: 70, as
/// FaceSynthetics has them. Right and left are the person's. Each is fixed to a triangle, so it follows poses
/// and morph targets; iBUG's jaw line slides along the outline instead, and this one does not.
///
///   const auto marks = dermis::Landmarks::of(asset);   // once for each asset
///   const auto points = marks->in_picture(scene, id, dermis::resolved_camera(scene, settings), depth_m);
///
/// A head's places stand in a file NAME.landmarks.json beside it:
///
///   {"schema": 1, "about": "whose points, and how they were found",
///    "meshes": [{"mesh": 0, "vertices": 14629, "triangles": 28068}],
///    "points": [{"mesh": 0, "triangle": [5, 17, 4], "weights": [0.5, 0.25, 0.25]}, ...]}
///
/// Meshes and vertices have the numbers of dermis/asset.h. `vertices` counts those that a triangle uses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dermis/asset.h"
#include "dermis/camera.h"
#include "dermis/scene.h"

namespace dermis {

/// A point of a triangle: the mean of its corners by these weights, which sum to 1.
struct LandmarkPlace {
  int mesh = 0;
  std::array<std::uint32_t, 3> vertices{};
  std::array<double, 3> weights{};
};

/// A landmark in a picture.
struct Landmark {
  std::array<double, 3> position_m{};  ///< in the world, posed
  /// Pixels, the middle of the first one at 0 0; may lie outside the picture. Not a number where the point is
  /// nearer than the near plane.
  double x = 0, y = 0;
  double depth_m = 0;  ///< along the axis of the camera
  /// The picture shows the point: one of the four pixels around it has its depth within 1 mm, or within the
  /// change of depth to the next pixel where that is more. Of two opposite neighbours the nearer one counts,
  /// of rows and columns the larger change. Blended parts such as lashes hide nothing. A landmark of a hidden
  /// instance is not seen.
  bool seen = false;
};

class Landmarks {
 public:
  static constexpr std::size_t count = 70;

  /// Returns the landmarks of an asset: those of the built-in head, or of NAME.landmarks.json beside its file
  /// NAME.gltf or NAME.glb. Else those of a head that the library knows by its triangles (assets/heads).
  /// None: there are none. Throws InputError in one line: the file is faulty, or of another head.
  static std::optional<Landmarks> of(const Asset& asset);
  /// Reads them from a file. Throws InputError likewise.
  static Landmarks load(const Asset& asset, const std::filesystem::path& file);

  std::span<const LandmarkPlace, count> places() const;
  /// Returns where they stand, posed, metres in the world. Throws InputError: no such instance, or one of
  /// another asset.
  std::vector<std::array<double, 3>> positions_m(const Scene& scene, InstanceId id) const;
  /// Returns where a picture shows them. `depth_m`: the picture's label, Results::depth_m. Throws InputError:
  /// as positions_m() does; depths of another size than the camera's picture.
  std::vector<Landmark> in_picture(const Scene& scene, InstanceId id, const ResolvedCamera& camera,
                                   std::span<const float> depth_m) const;

  struct State;  // of the library

 private:
  explicit Landmarks(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

}  // namespace dermis
