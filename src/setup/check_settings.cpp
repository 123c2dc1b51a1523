// SPDX-License-Identifier: MIT
#include "core/error.h"
#include "setup/frame_setup.h"

namespace dermis::setup {
namespace {

template <class T>
void require(const char* name, T value, T low, T high, const char* unit) {
  if (!(value >= low && value <= high))
    throw input_error("", "--{} must be {} to {}{}, got {}", name, low, high, unit, value);
}

}  // namespace

void check_settings(const RenderSettings& s) {
  techniques::find_technique(s.technique);
  image::find_tone_map(s.tone_map);
  if (s.width < 1 || s.height < 1 || s.width > 65536 || s.height > 65536)
    throw input_error("", "--size must be 1x1 to 65536x65536 pixels, got {}x{}", s.width, s.height);
  if (s.mask && *s.mask != "alpha" && *s.mask != "depth" && *s.mask != "tiles")
    throw input_error("", "--mask '{}' is not known; there are: alpha, depth, tiles", *s.mask);
  if (s.maps != "full" && s.maps != "progressive")
    throw input_error("", "--maps '{}' is not known; there are: full, progressive", s.maps);

  if (s.d_ref) require("d-ref", *s.d_ref, 1e-6, 1e6, " radii");
  if (s.clip_margin_mm) require("clip-margin", *s.clip_margin_mm, 0.0, 1e6, " mm");
  if (s.map_budget_mb) require("map-budget", *s.map_budget_mb, 0.0, 1e9, " MB");
  require("map-size", s.map_size, 32, 65536, " texels");
  require("shadow-size", s.shadow_size, 32, 65536, " texels");
  if (s.samples != 1 && s.samples != 4) throw input_error("", "--samples must be 1 or 4, got {}", s.samples);

  if (s.fov_deg) require("fov", *s.fov_deg, 0.1, 170.0, " degrees");
  if (s.distance) require("distance", *s.distance, 1e-3, 1e6, " radii");
  require("heads", s.heads, 1, 1024, "");

  if (s.lights) require("lights", *s.lights, 0, 64, "");
  if (s.lights && !s.placed_lights.empty())
    throw input_error("", "--lights and --light both replace the lights of the scene; give one");
  if (s.placed_lights.size() > 64)
    throw input_error("", "--light must be given at most 64 times, got {}", s.placed_lights.size());
  for (const PlacedLight& light : s.placed_lights) {
    require("light (azimuth)", light.azimuth_deg, -3600.0, 3600.0, " degrees");
    require("light (elevation)", light.elevation_deg, -90.0, 90.0, " degrees");
    require("light (irradiance)", light.irradiance, 0.0, 1e6, "");
  }
  if (s.light_radius_m) require("light-radius", *s.light_radius_m, 0.0, 1000.0, " m");
  require("ambient", s.ambient, 0.0, 1e6, "");
  require("environment-intensity", s.environment_intensity, 0.0, 1e6, "");
  require("environment-rotation", s.environment_rotation_deg, -3600.0, 3600.0, " degrees");

  if (s.mix) require("mix", *s.mix, 0.0, 1.0, "");
  require("bloom", s.bloom, 0.0, 1.0, "");
  if (s.exposure_ev) require("exposure", *s.exposure_ev, -64.0, 64.0, " EV");
  require("frames", s.frames, 1, 1'000'000, "");
  for (const double angle : s.orbit_deg) require("orbit", angle, -3600.0, 3600.0, " degrees");
}

}  // namespace dermis::setup
