// SPDX-License-Identifier: MIT
#include "base/core/error.h"
#include "base/settings/check.h"
#include "render/setup/background.h"
#include "render/setup/frame_setup.h"

namespace dermis::setup {
namespace {

void check_camera(const CameraSettings& camera) {
  const bool chosen =
      !camera.name.empty() || camera.distance || camera.orbit_deg != CameraSettings{}.orbit_deg;
  if (camera.eye_m.has_value() != camera.target_m.has_value())
    throw input_error("", "camera.eye_m and camera.target_m go together; {} is missing",
                      camera.eye_m ? "camera.target_m" : "camera.eye_m");
  if (camera.eye_m && chosen)
    throw input_error(
        "",
        "camera.eye_m and camera.target_m place the camera, and so do camera.name, camera.distance "
        "and camera.orbit_deg; give one of these");
  if (camera.matrices && (camera.eye_m || camera.fov_deg || chosen))
    throw input_error("", "camera.matrices are the whole camera: no other setting of it may be given");
}

void check_taps(const RenderSettings& s) {
  const techniques::TapRange& range = techniques::find_technique(s.technique).taps;
  if (!s.quality.taps || range.most == 0) return;
  const auto taps = static_cast<std::uint32_t>(*s.quality.taps);
  if (taps < range.least || taps > range.most || (range.odd && taps % 2 == 0))
    throw input_error("", "quality.taps of technique '{}' must be {} to {}{}, got {}", s.technique,
                      range.least, range.most, range.odd ? " and odd" : "", taps);
}

void check_kernel(const RenderSettings& s) {
  const techniques::Technique& technique = techniques::find_technique(s.technique);
  if (s.quality.kernel == ScreenKernel::ue && technique.screen_space && !technique.ue_kernel)
    throw input_error("", "quality.kernel ue is not one of technique '{}'; it has: profile, published",
                      s.technique);
}

}  // namespace

void check_settings(const RenderSettings& s) {
  check_ranges(s);
  check_camera(s.camera);
  check_taps(s);
  check_kernel(s);
  background_of(s.output.background);
  if (s.quality.samples != 1 && s.quality.samples != 4)
    throw input_error("", "quality.samples must be 1 or 4, got {}", s.quality.samples);
  if (s.lighting.rig_lights && !s.lighting.placed_lights.empty())
    throw input_error(
        "", "lighting.rig_lights and lighting.placed_lights both replace the lights of the scene; give one");
}

}  // namespace dermis::setup
