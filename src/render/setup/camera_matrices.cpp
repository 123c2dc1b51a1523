// SPDX-License-Identifier: MIT
#include "render/setup/camera_matrices.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string>

#include "base/core/error.h"

namespace dermis::setup {
namespace {

// Of a unit vector: a host keeps its matrices as floats, and multiplies some.
constexpr double tolerance = 1e-3;
// Floats hold these with some digits to spare.
constexpr double least_m = 1e-6, most_m = 1e6, least_aspect = 1e-4;

template <class... Args>
InputError view_error(fmt::format_string<Args...> format, Args&&... args) {
  return input_error("camera.matrices.camera_from_world", format, std::forward<Args>(args)...);
}
template <class... Args>
InputError projection_error(fmt::format_string<Args...> format, Args&&... args) {
  return input_error("camera.matrices.clip_from_camera", format, std::forward<Args>(args)...);
}

bool is_finite(const std::array<double, 16>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double v) { return std::isfinite(v) && std::abs(v) < 1e9; });
}

// The matrices of a host, as if its camera looked along -z and its clip y grew upwards.
struct Upright {
  glm::dmat4 camera_from_world, clip_from_camera;
  bool perspective = true;
  bool along_z = false;  ///< it looked along +z
};

Upright upright(const CameraMatrices& matrices) {
  Upright out{matrix_of(matrices.camera_from_world), matrix_of(matrices.clip_from_camera)};
  glm::dmat4& clip = out.clip_from_camera;

  // The row of w: (0 0 -1 0), (0 0 1 0) or (0 0 0 1), times any number.
  const glm::dvec4 w(clip[0][3], clip[1][3], clip[2][3], clip[3][3]);
  out.perspective = std::abs(w.z) > std::abs(w.w);
  const double scale = out.perspective ? std::abs(w.z) : w.w;
  if (!(scale > 0) || glm::length(w) > (1 + tolerance) * scale)
    throw projection_error(
        "the row of w must be 0 0 -1 0, 0 0 1 0 (perspective) or 0 0 0 1 (orthographic). It is {:g} {:g} "
        "{:g} {:g}",
        w.x, w.y, w.z, w.w);
  clip /= scale;

  // A camera that looks along +z, seen in a mirror, looks along -z.
  out.along_z = out.perspective ? w.z > 0 : glm::determinant(glm::dmat3(out.camera_from_world)) < 0;
  if (out.along_z) {
    glm::dmat4 mirror(1);
    mirror[2][2] = -1;
    clip = clip * mirror;
    out.camera_from_world = mirror * out.camera_from_world;
  }

  if (clip[1][1] < 0)
    for (int column = 0; column < 4; ++column) clip[column][1] = -clip[column][1];
  return out;
}

void check_rigid(const glm::dmat4& camera_from_world, bool along_z) {
  const glm::dmat3 turn(camera_from_world);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b)
      if (std::abs(glm::dot(turn[a], turn[b]) - (a == b ? 1 : 0)) > tolerance)
        throw view_error("must be rigid: columns {} and {} have the product {:.4g}, not {}", a, b,
                         glm::dot(turn[a], turn[b]), a == b ? 1 : 0);
    if (std::abs(camera_from_world[a][3]) > tolerance)
      throw view_error("must be rigid: its last row must be 0 0 0 1");
  }
  if (std::abs(camera_from_world[3][3] - 1) > tolerance)
    throw view_error("must be rigid: its last row must be 0 0 0 1");
  if (glm::determinant(turn) < 0)
    throw along_z
        ? view_error("must be a reflection, of determinant -1, where clip w is z: the scene is right-handed")
        : view_error("is a reflection, which goes with clip w = z alone");
}

void check_form(const glm::dmat4& clip, bool perspective) {
  if (!(clip[0][0] > 0) || !(clip[1][1] > 0))
    throw projection_error("must show something, x growing to the right: its diagonal has {:g} and {:g}",
                           clip[0][0], clip[1][1]);

  // Compare with the smaller of both scales: an orthographic camera may show metres or millimetres.
  const double least = tolerance * std::min({clip[0][0], clip[1][1], 1.0});
  const glm::dvec2 shear(clip[1][0], clip[0][1]), depth(clip[0][2], clip[1][2]);
  const glm::dvec2 moved = perspective ? glm::dvec2(clip[3]) : glm::dvec2(clip[2]);
  if (glm::length(shear) > least || glm::length(depth) > least || glm::length(moved) > least)
    throw projection_error("must be a perspective or an orthographic camera, not sheared or oblique");
}

// Depth is b / t - a (perspective) or b - a t (orthographic) at the distance t. The near plane is where it is
// 1 if it falls with t (reversed), else 0.
double near_m(const glm::dmat4& clip, bool perspective) {
  const double a = clip[2][2], b = clip[3][2];
  if (perspective) return b > 0 ? b / (1 + a) : b / a;
  return a > 0 ? (b - 1) / a : b / a;
}

}  // namespace

glm::dmat4 matrix_of(const std::array<double, 16>& values) {
  glm::dmat4 matrix;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      matrix[column][row] = values[static_cast<std::size_t>(4 * column + row)];
  return matrix;
}

glm::dmat4 upright_clip_from_world(const CameraMatrices& matrices) {
  glm::dmat4 clip = matrix_of(matrices.clip_from_camera);
  if (clip[1][1] < 0)
    for (int column = 0; column < 4; ++column) clip[column][1] = -clip[column][1];
  return clip * matrix_of(matrices.camera_from_world);
}

glm::mat4 picture_from_world(const CameraMatrices& matrices, const scene::Camera& camera) {
  glm::dmat4 out = upright_clip_from_world(matrices);
  const glm::dmat4 camera_from_world = upright(matrices).camera_from_world;
  const double near_m = double{camera.znear_m};
  for (int column = 0; column < 4; ++column) {
    const double moved = column == 3 ? 1 : 0;
    if (camera.orthographic) {
      const double far_m = double{*camera.zfar_m};
      out[column][2] =
          matrices.clip_from_camera[15] * (moved * far_m + camera_from_world[column][2]) / (far_m - near_m);
    } else {
      out[column][2] = std::abs(matrices.clip_from_camera[11]) * moved * near_m;
    }
  }
  return glm::mat4(out);
}

bool is_reversed(const CameraMatrices& matrices) {
  const Upright camera = upright(matrices);
  // As near_m() has it.
  return camera.perspective ? camera.clip_from_camera[3][2] > 0 : camera.clip_from_camera[2][2] > 0;
}

scene::Camera camera_of(const CameraMatrices& matrices) {
  if (!is_finite(matrices.camera_from_world)) throw view_error("must be numbers under 1e9");
  if (!is_finite(matrices.clip_from_camera)) throw projection_error("must be numbers under 1e9");
  const auto [camera_from_world, clip, perspective, along_z] = upright(matrices);
  check_rigid(camera_from_world, along_z);
  check_form(clip, perspective);

  // Checked as doubles: what a float does not hold is refused before it is one.
  const double near = near_m(clip, perspective), half_height = 1 / clip[1][1],
               aspect = clip[1][1] / clip[0][0];
  if (!(near >= (perspective ? least_m : 0) && near <= most_m))
    throw projection_error(
        "must have its near plane in front of the eye, depth from 0 to 1 or from 1 to 0; it is at {:g} m",
        near);
  if (!(half_height >= least_m && half_height <= most_m) ||
      !(aspect >= least_aspect && aspect <= 1 / least_aspect))
    throw projection_error("must show something: half of its picture is {:g} high and {:g} wide", half_height,
                           1 / clip[0][0]);

  scene::Camera camera;
  camera.name = "matrices";
  camera.world_from_camera = glm::mat4(glm::inverse(camera_from_world));
  camera.orthographic = !perspective;
  camera.aspect = static_cast<float>(aspect);
  camera.axis_at = perspective ? -glm::vec2(clip[2]) : glm::vec2(clip[3]);
  camera.znear_m = static_cast<float>(near);
  if (perspective) {
    camera.fov_y_rad = static_cast<float>(2 * std::atan(half_height));
    return camera;
  }

  const double a = clip[2][2], b = clip[3][2], far_m = a > 0 ? b / a : (b - 1) / a;
  if (!(far_m <= most_m && static_cast<float>(far_m) > camera.znear_m))
    throw projection_error("must have a far plane behind its near plane, {:g} and {:g} m", far_m, near);
  camera.ymag_m = static_cast<float>(half_height);
  camera.zfar_m = static_cast<float>(far_m);
  return camera;
}

}  // namespace dermis::setup
