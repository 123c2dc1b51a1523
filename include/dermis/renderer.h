// SPDX-License-Identifier: MIT
/// The renderer: a scene in, a picture and its statistics out. Needs no display.
///
///   const dermis::Scene scene = dermis::Scene::load("head.glb");
///   dermis::Renderer renderer;
///   const dermis::Picture picture = renderer.render(scene, {.width = 960, .height = 1080});
///   picture.save("head.png");
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/cancelled.h"
#include "dermis/error.h"
#include "dermis/scene.h"

namespace dermis {

/// A white lamp as those of the rig: a spot 4 radii from the centre of the head's bounding sphere, aimed at
/// it, its cone just around the sphere.
struct PlacedLight {
  double azimuth_deg = 0;    ///< from the head's front (0) towards its left (90)
  double elevation_deg = 0;  ///< -90 (below) to 90 (above)
  /// at that centre, on a surface that faces the lamp; pi on white Lambert shows 1
  double irradiance = 3;
};

/// What to render. Angles in degrees, distances in radii of the head's bounding sphere, radiance relative
/// (white Lambert under irradiance pi shows 1).
struct RenderSettings {
  std::string technique = "texture-space";  ///< a name of technique_names()
  int width = 1280, height = 720;           ///< pixels, 1 to the device's limit
  /// T_max: texels of a side of the light maps, 32 to the device's limit
  int map_size = 2048;
  int shadow_size = 2048;  ///< texels
  int samples = 4;         ///< anti-aliasing, 1 or 4

  // What is not computed because it is not seen; [JG08] Jimenez, Gutierrez: Faster Rendering of Human Skin,
  // CEIG 2008, sec. 3 to 5.
  bool cull = true;   ///< skin that faces away from the eye
  bool depth = true;  ///< light maps only as large as the head's distance needs
  bool clip = true;   ///< skin outside the picture and a margin
  /// alpha, depth, tiles: how convolutions skip unlit texels; none: fastest on the kind of device
  std::optional<std::string> mask;
  /// full: a Gaussian each at T_max; progressive: those of smooth light on half, a quarter, an eighth
  std::string maps = "full";
  /// distance, in sphere radii, up to which maps have their full size; none: a texel per pixel
  std::optional<double> d_ref;
  std::optional<double> clip_margin_mm;  ///< none: as far as the profile's widest Gaussian reaches, 3 sigma
  /// for light maps, 1e6 bytes; none: four skin meshes at T_max, at most a quarter of the device's memory
  std::optional<double> map_budget_mb;
  std::optional<bool> skip_unseen_heads;  ///< heads wholly outside the picture; none: if anything above is on

  std::string camera;             ///< name; empty: the scene's first, else framing
  std::optional<double> fov_deg;  ///< vertical; none: the camera's, 20 when framing
  /// the paper's test: from the eye to the middle head, in sphere radii
  std::optional<double> distance;
  int heads = 1;                          ///< in a row, 1.6 radii apart
  std::array<double, 2> orbit_deg{0, 0};  ///< azimuth, elevation of the framing camera
  /// that many of the rig instead of the scene's; none: the scene's, else 2
  std::optional<int> lights;
  /// m, of discs that cast soft shadows, see docs/techniques.md; none: the scene's, else points
  std::optional<double> light_radius_m;
  double ambient = 0.05;  ///< uniform radiance from everywhere, where there is no environment
  std::string
      environment;  ///< surroundings: .hdr or .exr (equirectangular), "studio" (built in); empty: uniform
  double environment_intensity = 1;     ///< multiplies their radiance
  double environment_rotation_deg = 0;  ///< about the vertical, from the head's front towards its left
  /// published name or file; empty: the material's, else the published six Gaussians
  std::string profile;
  bool normalise_profile = false;  ///< divide the weights of a profile file by their sum
  /// part of the albedo before scattering, 0 to 1; none: the material's, else 0.5
  std::optional<double> mix;
  bool specular = true;
  bool white_albedo = false;  ///< every albedo is 1
  bool translucency = true;   ///< light also comes through the body: ears lit from behind glow
  double bloom = 0.05;        ///< 0 to 1
  /// radiance is multiplied by 2^EV; none: chosen by the light on the skin, so that white skin would show 0.5
  /// on average (docs/techniques.md); Statistics say what it is
  std::optional<double> exposure_ev = 0.0;
  /// natural, neutral, agx, filmic, srgb, linear: what a display shows; see docs/techniques.md
  std::string tone_map = "natural";
  int frames = 1;  ///< timed frames after one warm-up, >= 1
  /// picture, irradiance, visibility, stretch, texel-density, blur:K, shadow:K
  std::string show = "picture";

  /// Instead of the scene's lights, at most 64; then `lights` must be none.
  std::vector<PlacedLight> placed_lights{};
};

struct PassStatistics {
  std::string name;
  double ms = 0;  ///< median over the frames
  int calls = 1;  ///< a frame
};

/// See docs/measuring.md for what each figure means and how it is taken.
struct Statistics {
  std::string device, driver, api, technique;
  std::vector<std::string> optimise;  ///< of cull, depth, clip
  std::string mask;                   ///< alpha, depth, tiles; empty if nothing is masked
  std::string maps;                   ///< full, progressive; empty for techniques without light maps
  int width = 0, height = 0, map_size = 0, heads = 1, lights = 0, gaussians = 0;
  int environment_lights = 0;  ///< of `lights`: suns and other compact sources of the environment, at most 8
  std::optional<double> distance;
  bool translucency = false;  ///< light came through the body
  std::string tone_map;
  double exposure_ev = 0;  ///< given or chosen
  /// where the exposure was chosen: mean luminance of the skin in the picture, before bloom; none: no lit
  /// skin
  std::optional<double> skin_mean;
  double frame_ms_median = 0, frame_ms_min = 0, frame_ms_max = 0;
  int frames = 0;
  std::vector<PassStatistics> passes;
  double load_ms = 0, upload_ms = 0, pipeline_ms = 0;
  std::string timing;  ///< "timestamp", or "submit" where each pass is its own submission
  std::vector<std::string> skin_materials;
  std::uint64_t skin_pixels = 0;
  double d_ref = 0;
  std::uint64_t irradiance_texels = 0, convolved_texels = 0, launched = 0, unshaded_reads = 0;
  std::uint64_t transmission_misses = 0;  ///< looks through the body whose lit point was not there to be read
  std::vector<int> used_size;             ///< T of each head in the row; 0: skipped
  std::uint64_t image_bytes = 0, buffer_bytes = 0, peak_bytes = 0;

  std::string json() const;  ///< the keys of the command line's --stats
};

/// A finished picture: linear floats, and eight bits for a display. Rows from top to bottom.
struct Picture {
  int width = 0, height = 0;
  /// with exposure and bloom; alpha = share of the pixel that is skin
  std::vector<float> linear_rgba;
  std::vector<std::uint8_t> display_rgba;  ///< after the tone map
  Statistics statistics;

  /// .png (display values) or .exr (linear, 32-bit float), atomically. InputError: another ending, a missing
  /// folder.
  void save(const std::filesystem::path& path) const;
};

/// Work before a first frame that takes seconds, once: its result is kept for later runs.
struct PreparationProgress {
  std::string what;  ///< "what the skin sees of its surroundings"
  double share = 0;  ///< that is done, 0 to 1
};

class PreparedFrame;

class Renderer {
 public:
  struct Options {
    std::string device = "best";  ///< best, an index or a part of a name
    bool validate = false;        ///< Vulkan validation layer; see validation_messages()
    /// For tests: before each frame its textures hold what is no number, as a driver might leave them. No
    /// picture may show it.
    bool poison = false;
    /// Set by another thread, a signal or `progress`: render(), prepare() and PreparedFrame::set() end with
    /// Cancelled (dermis/cancelled.h) while they prepare; nothing half-done is kept.
    const std::atomic<bool>* stop = nullptr;
    /// Now and then while they prepare; by any thread, by one at a time.
    std::function<void(const PreparationProgress&)> progress{};
  };
  Renderer() : Renderer(Options{}) {}
  /// DeviceError: no driver, no such device, or something that is needed is missing.
  explicit Renderer(const Options& options);
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// InputError: a setting out of range (says which and the range), an unknown name (lists the known ones).
  /// DeviceError: too little memory.
  Picture render(const Scene& scene, const RenderSettings& settings = {});

  /// For many frames of one scene: see PreparedFrame. Errors as render().
  PreparedFrame prepare(const Scene& scene, const RenderSettings& settings = {});

  std::vector<std::string> validation_messages() const;

  struct State;

 private:
  std::shared_ptr<State> state_;
};

/// A scene on the device, with plan, memory and pipelines, ready to be drawn again and again. Keeps its
/// renderer's device alive; frames of one scene share its upload.
class PreparedFrame {
 public:
  PreparedFrame(PreparedFrame&&) noexcept;
  PreparedFrame& operator=(PreparedFrame&&) noexcept;
  ~PreparedFrame();

  /// Other settings for the frames to come. Camera, exposure, ambient light and the like cost little; what
  /// changes the structure (sizes, technique, heads, profile, what is optimised) makes plan and memory anew.
  /// Errors as Renderer::render(), then nothing has changed.
  void set(const RenderSettings& settings);

  /// Draws and times one frame, ms. The first after a change is preceded by one that warms up and counts.
  double draw();

  /// The passes of the frame that draw() timed last, in order; empty before the first since a change.
  std::vector<PassStatistics> last_passes() const;

  /// The last frame, with the statistics of all that were drawn since the last change. If there was none, of
  /// a frame that is not timed.
  Picture picture();

 private:
  friend class Renderer;
  struct State;
  explicit PreparedFrame(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

std::vector<std::string> technique_names();

/// What RenderSettings::tone_map may be; the first is the default.
std::vector<std::string> tone_map_names();

/// The frame that render() would run, as text or in Graphviz's dot language. Needs no device.
std::string describe_plan(const Scene& scene, const RenderSettings& settings, bool dot = false);

}  // namespace dermis
