// SPDX-License-Identifier: MIT
#include "core/error.h"
#include "settings/names.h"
#include "setup/frame_setup.h"

namespace dermis::setup {
namespace {

template <class T>
void require(const char* name, T value, T low, T high, const char* unit) {
  if (!(value >= low && value <= high))
    throw input_error("", "--{} must be {} to {}{}, got {}", name, low, high, unit, value);
}

// A number that was made an enumeration need not be one of its values.
template <class Enum>
void require_known(const char* name, Enum value) {
  require(name, static_cast<std::size_t>(value), std::size_t{0}, names_of<Enum>.size() - 1, "");
}

}  // namespace

void check_settings(const RenderSettings& s) {
  techniques::find_technique(s.technique);
  if (s.output.width < 1 || s.output.height < 1 || s.output.width > 65536 || s.output.height > 65536)
    throw input_error("", "--size must be 1x1 to 65536x65536 pixels, got {}x{}", s.output.width,
                      s.output.height);

  require_known("mask", s.quality.mask.value_or(BlurMask::alpha));
  require_known("maps", s.quality.maps);
  require_known("tone-map", s.output.tone_map);

  if (s.quality.d_ref) require("d-ref", *s.quality.d_ref, 1e-6, 1e6, " radii");
  if (s.quality.clip_margin_mm) require("clip-margin", *s.quality.clip_margin_mm, 0.0, 1e6, " mm");
  if (s.quality.map_budget_mb) require("map-budget", *s.quality.map_budget_mb, 0.0, 1e9, " MB");
  require("map-size", s.quality.map_size, 32, 65536, " texels");
  require("shadow-size", s.quality.shadow_size, 32, 65536, " texels");
  if (s.quality.samples != 1 && s.quality.samples != 4)
    throw input_error("", "--samples must be 1 or 4, got {}", s.quality.samples);

  if (s.camera.fov_deg) require("fov", *s.camera.fov_deg, 0.1, 170.0, " degrees");
  if (s.camera.distance) require("distance", *s.camera.distance, 1e-3, 1e6, " radii");
  require("heads", s.camera.heads, 1, 1024, "");

  if (s.lighting.rig_lights) require("lights", *s.lighting.rig_lights, 0, 64, "");
  if (s.lighting.rig_lights && !s.lighting.placed_lights.empty())
    throw input_error("", "--lights and --light both replace the lights of the scene; give one");
  if (s.lighting.placed_lights.size() > 64)
    throw input_error("", "--light must be given at most 64 times, got {}", s.lighting.placed_lights.size());
  for (const PlacedLight& light : s.lighting.placed_lights) {
    require("light (azimuth)", light.azimuth_deg, -3600.0, 3600.0, " degrees");
    require("light (elevation)", light.elevation_deg, -90.0, 90.0, " degrees");
    require("light (irradiance)", light.irradiance, 0.0, 1e6, "");
  }
  if (s.lighting.light_radius_m) require("light-radius", *s.lighting.light_radius_m, 0.0, 1000.0, " m");
  require("ambient", s.lighting.ambient, 0.0, 1e6, "");
  require("environment-intensity", s.lighting.environment_intensity, 0.0, 1e6, "");
  require("environment-rotation", s.lighting.environment_rotation_deg, -3600.0, 3600.0, " degrees");

  if (s.skin.mix) require("mix", *s.skin.mix, 0.0, 1.0, "");
  require("bloom", s.output.bloom, 0.0, 1.0, "");
  if (s.output.exposure_ev) require("exposure", *s.output.exposure_ev, -64.0, 64.0, " EV");
  require("frames", s.output.frames, 1, 1'000'000, "");
  for (const double angle : s.camera.orbit_deg) require("orbit", angle, -3600.0, 3600.0, " degrees");
}

}  // namespace dermis::setup
