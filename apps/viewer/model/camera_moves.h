// SPDX-License-Identifier: MIT
/// The camera under the mouse: it turns around what it looks at, moves with the picture, comes nearer, flies.
/// A camera of the scene or a framing becomes an eye and a target (CameraSettings), so that every move is a
/// setting that a command line can name.
#pragma once

#include <array>

#include "render/shared/scene_io.h"
#include "viewer/model/document.h"

namespace dermis::viewer {

/// Where the camera stands, metres, and what is in the middle of its picture.
struct CameraPlace {
  std::array<double, 3> eye_m{}, target_m{};
  double fov_deg = 20;  ///< vertical
};

/// The sphere that cameras and lamps of the document are placed by, in the world.
struct HeadSphere {
  std::array<double, 3> centre_m{};
  double radius_m = 0;
};
HeadSphere head_sphere(const Document& document);

/// The same, found anew only when an instance has come, gone or moved: it reads all vertices.
class HeadSphereCache {
 public:
  const HeadSphere& of(const Document& document);

 private:
  std::vector<InstanceId> ids_;
  std::vector<std::uint64_t> poses_;
  int heads_ = 0;
  HeadSphere sphere_;
};

/// Returns where the camera of the document stands. The target is the point of its axis that is nearest to
/// the heads. Throws InputError: settings that name no camera.
CameraPlace camera_place(const Document& document);

/// Returns the camera by which a picture with these settings shows the scene. Throws as camera_place().
io::CameraIo drawn_camera(const Scene& scene, const RenderSettings& settings);

/// Returns the point of the world that a camera sees at `u`, `v` of its picture (0 to 1, to the right and
/// down) in this depth: metres along the direction in which it looks, as Labels have it.
std::array<double, 3> point_at_depth(const io::CameraIo& camera, double u, double v, double depth_m);

/// Sets eye, target and field of view, rounded to micrometres, in place of all else that names a camera.
void set_camera(RenderSettings& settings, const CameraPlace& place);

// The moves. Angles in degrees: the camera turns around the target.
CameraPlace orbited(const CameraPlace& place, double azimuth_deg, double elevation_deg);
/// Moves eye and target by parts of the picture's height, to the right and up.
CameraPlace panned(const CameraPlace& place, double right, double up);
/// Multiplies the distance to the target, which stays.
CameraPlace dollied(const CameraPlace& place, double factor);
/// Moves eye and target in metres along the camera's axes: to the right, up, ahead.
CameraPlace flown(const CameraPlace& place, const std::array<double, 3>& by_m);
/// Looks at the heads from the side where the camera is, as near as framing has it.
CameraPlace framed(const CameraPlace& place, const HeadSphere& sphere, double aspect);

/// Returns the names of the cameras that the scene has.
std::vector<std::string> camera_names(const Scene& scene);

}  // namespace dermis::viewer
