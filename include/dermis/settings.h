// SPDX-License-Identifier: MIT
/// Settings of Renderer and, for the most part, of the reference. Each structure has defaults, so that a
/// program names what differs:
///
///   renderer.render(scene, {.camera = {.fov_deg = 30}, .output = {.width = 960, .height = 1080}});
///
/// Angles in degrees, distances in radii of the head's bounding sphere, radiance relative (white Lambert
/// under irradiance pi shows 1).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dermis {

/// A camera of a host. Column-major: element 4 * column + row, columns multiplied by vectors from the right,
/// as GLSL and glm have it. Metres.
struct CameraMatrices {
  /// The "view" matrix: rigid, from the right-handed world of the scene. The camera looks along its -z, or
  /// along its +z if it is left-handed (determinant -1; a perspective then has clip w = z); +y is up.
  std::array<double, 16> camera_from_world{};
  /// The "projection" matrix: a perspective or an orthographic camera, its axis in the middle of the picture
  /// or not. Clip x grows to the right; clip y up or down, the picture stands upright. Depth goes from 0 to 1
  /// (not from -1) or from 1 to 0 with the distance. The near plane lies in front of the eye; the far plane
  /// of a perspective is not used, and may be infinite.
  std::array<double, 16> clip_from_camera{};
};

struct CameraSettings {
  std::string name{};               ///< of the scene; empty: the scene's first, else framing
  std::optional<double> fov_deg{};  ///< vertical; none: that of a camera of the scene, else 20
  /// the paper's test: from the eye to the middle head, in sphere radii
  std::optional<double> distance{};
  std::array<double, 2> orbit_deg{0, 0};  ///< azimuth, elevation of the framing camera
  /// World space, metres: where the camera stands and what is in the middle of the picture, +Y up. Both or
  /// none; in place of name, distance and orbit_deg.
  std::optional<std::array<double, 3>> eye_m{}, target_m{};
  /// In place of all of the above. Files of settings do not hold it.
  std::optional<CameraMatrices> matrices{};
  int heads = 1;  ///< in a row, 1.6 radii apart
};

/// A white lamp as those of the rig: a spot 4 radii from the centre of the head's bounding sphere, aimed at
/// it, its cone just around the sphere.
struct PlacedLight {
  double azimuth_deg = 0;    ///< from the head's front (0) towards its left (90)
  double elevation_deg = 0;  ///< -90 (below) to 90 (above)
  /// at that centre, on a surface that faces the lamp; pi on white Lambert shows 1
  double irradiance = 3;
};

struct LightingSettings {
  /// that many of the rig instead of the scene's; none: the scene's, else 2
  std::optional<int> rig_lights{};
  /// instead of the scene's lights, at most 64; then `rig_lights` must be none
  std::vector<PlacedLight> placed_lights{};
  /// m, of discs that cast soft shadows, see docs/techniques.md; none: the scene's, else points
  std::optional<double> light_radius_m{};
  double ambient = 0.05;  ///< uniform radiance from everywhere, where there is no environment
  /// surroundings: .hdr or .exr (equirectangular), "studio" (built in); empty: uniform
  std::string environment{};
  double environment_intensity = 1;     ///< multiplies their radiance
  double environment_rotation_deg = 0;  ///< about the vertical, from the head's front towards its left
  bool specular = true;                 ///< reflection at every surface
  bool white_albedo = false;            ///< every albedo is 1
};

/// Instead of what the scene's materials say.
struct SkinSettings {
  /// skin, a preset of profile.h, or a file; empty: the material's, else the published six Gaussians
  std::string profile{};
  /// part of the albedo before scattering, 0 to 1; none: the material's, else 0.5
  std::optional<double> mix{};
  bool translucency = true;  ///< light also comes through the body: ears lit from behind glow
  /// Light that leaves follows the curvature and the thickness of the body (docs/techniques.md). none: true
  /// for profiles that know their medium, false for published ones, which cannot have it.
  std::optional<bool> shape_aware{};
};

/// Masks with which technique `published` skips unlit texels, [JG08] sec. 3. texture-space computes tiles
/// that hold light alone.
enum class BlurMask : std::uint8_t {
  alpha,  ///< drawn, and an unlit texel ends before its samples
  depth   ///< drawn, and the depth test rejects it
};

/// Kernel of the techniques in screen space.
enum class ScreenKernel : std::uint8_t {
  profile,    ///< the profile of the skin, in mm
  published,  ///< the kernel of the technique's publication
  ue          ///< of burley-disc alone: the profile, weighted as Unreal Engine does
};

/// Details against time and memory; what is not computed because it is not seen.
/// [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin, CEIG 2008, sec. 3 to 5.
struct QualitySettings {
  /// T_max: texels of a side of the light maps, at most, 32 to the device's limit. With `depth` texture-space
  /// takes as few as its wide Gaussians need (docs/techniques.md), whatever this is: 512 for a scan of a
  /// head.
  int map_size = 2048;
  /// Texels of a side, at most: heads take three per pixel across, in steps of half an octave.
  int shadow_size = 1024;
  int samples = 4;  ///< anti-aliasing, 1 or 4 per pixel
  /// Points, 1 or 2, at which skin is lit and shaded in a pixel that one surface covers. Light has edges and
  /// glints finer than a pixel, which anti-aliasing of surfaces does not see.
  int light_samples = 2;

  bool cull = true;                         ///< leave out skin that faces away from the eye
  bool depth = true;                        ///< light maps only as large as the head's distance needs
  bool clip = true;                         ///< leave out skin outside the picture and a margin
  std::optional<bool> skip_unseen_heads{};  ///< heads wholly outside the picture; none: if any of these is on
  /// The shadow maps of heads and lights that have not moved since the frame before are not drawn again. So
  /// in frames of a session or a host each head has maps of its own, up to 512 MB of them. Others have as
  /// many as heads are lit together.
  bool keep_shadows = true;

  std::optional<BlurMask> mask{};               ///< of technique `published`; none: depth
  ScreenKernel kernel = ScreenKernel::profile;  ///< of techniques in screen space
  std::optional<int> taps{};  ///< of their kernels, see docs/techniques.md; none: as many as usual
  /// distance, in sphere radii, at which a texel of a map of map_size is as large as a pixel; none: as it is.
  /// Light maps take their sizes from it.
  std::optional<double> d_ref{};
  std::optional<double> clip_margin_mm{};  ///< none: as far as the profile's widest Gaussian reaches, 3 sigma
  /// for light maps, 1e6 bytes; none: four skin meshes at T_max or 512e6, at most a quarter of the device's
  /// memory
  std::optional<double> map_budget_mb{};
};

/// From linear light to what a display shows; see docs/techniques.md. The order is that of the shader.
enum class ToneMap : std::uint8_t {
  /// Leaves every colour alone whose greatest channel is at most 0.8, whatever its hue, and compresses what
  /// is brighter: a shoulder in which hue stays.
  natural,
  neutral,  ///< Khronos PBR Neutral, exact, with its toe
  agx,      ///< AgX
  filmic,   ///< ACES fit, each channel by itself
  srgb,     ///< clamped
  linear    ///< clamped, and no sRGB curve
};

struct OutputSettings {
  int width = 1280, height = 720;  ///< pixels, 1 to the device's limit
  /// radiance is multiplied by 2^EV; none: chosen by the light on the skin, so that white skin would show 0.5
  /// on average (docs/techniques.md); Statistics say what it is
  std::optional<double> exposure_ev = 0.0;
  ToneMap tone_map = ToneMap::natural;
  double bloom = 0.05;  ///< share of the light that is spread over the picture, 0 to 1
  /// behind the heads, where no surface covers a pixel: black; studio, a grey wall that is lit in its middle;
  /// environment, the surroundings, else lighting.ambient. Or #RRGGBB, a colour of the display (sRGB), which
  /// neither exposure nor tone map changes. A host's frames have none
  std::string background = "black";
  int frames = 1;  ///< timed frames after one warm-up, >= 1
  /// picture, irradiance, visibility, stretch, texel-density, blur:K, shadow:K
  std::string show = "picture";
};

struct RenderSettings {
  std::string technique = "texture-space";  ///< a name of technique_names()
  CameraSettings camera{};
  LightingSettings lighting{};
  SkinSettings skin{};
  QualitySettings quality{};
  OutputSettings output{};
};

}  // namespace dermis
