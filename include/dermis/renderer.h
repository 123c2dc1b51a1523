// SPDX-License-Identifier: MIT
/// The renderer: a scene in, a picture and its statistics out. Needs no display.
///
///   const dermis::Scene scene = dermis::Scene::load("head.glb");
///   dermis::Renderer renderer;
///   const dermis::Picture picture = renderer.render(scene, {.output = {.width = 960, .height = 1080}});
///   picture.save("head.png");
///
/// A Renderer owns the device, its pipelines, and the scene and environment that it used last. A
/// PreparedFrame keeps all of these alive and adds the memory of one frame. One thread at a time may use a
/// Renderer and its frames; several renderers may work at the same time, with the same scenes and the same
/// cache folder. Errors are those of dermis/error.h.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/device_info.h"
#include "dermis/error.h"
#include "dermis/hooks.h"
#include "dermis/recorded_work.h"
#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis {

/// Device time and memory of one pass of the plan.
struct PassStatistics {
  std::string name;  ///< as describe_plan() prints it
  double ms = 0;     ///< median over the frames
  int calls = 1;     ///< per frame
  /// Of the images that it writes, each counted whole, with its layers and mip levels: texels (samples of one
  /// count once), and bytes of device memory. A pass may write fewer; passes that write the same image count
  /// it each. 0: it writes buffers alone.
  std::uint64_t texels = 0, image_bytes = 0;
};

/// Settings, device and cost of a picture. docs/methodology.md says how each figure is taken.
struct Statistics {
  /// names, for display; api is the version of Vulkan
  std::string device, driver, api, technique;
  std::vector<std::string> optimise;  ///< of cull, depth, clip
  std::string mask;                   ///< alpha, depth, tiles; empty if nothing is masked

  /// Pixels; T_max in texels; how many. `gaussians`: terms of the profile.
  int width = 0, height = 0, map_size = 0, heads = 1, lights = 0, gaussians = 0;
  int environment_lights = 0;  ///< of `lights`: suns and other compact sources of the environment, at most 8

  std::optional<double> distance;  ///< as in the settings, sphere radii
  bool translucency = false;       ///< light came through the body
  bool shape_aware = false;        ///< light that left followed curvature and thickness, of some head
  std::string tone_map;

  RenderSettings settings;  ///< as given
  double exposure_ev = 0;   ///< given or chosen
  /// mean luminance of the skin in the picture, before bloom; none: the exposure was given, or no skin is lit
  std::optional<double> skin_mean;

  /// Of the frames that were timed; 0 without any.
  double frame_ms_median = 0, frame_ms_min = 0, frame_ms_max = 0;
  int frames = 0;
  std::vector<PassStatistics> passes;  ///< in the order of the plan

  /// Wall clock, before the first frame. load_ms is for the caller to set: Scene::load() is not timed.
  double load_ms = 0, upload_ms = 0, pipeline_ms = 0;
  std::string timing;  ///< "timestamp", or "submit" where each pass is its own submission

  std::vector<std::string> skin_materials;
  std::uint64_t skin_pixels = 0;  ///< at least half covered by skin
  double d_ref = 0;               ///< given or chosen, see QualitySettings; sphere radii

  /// Counted on the device; 0 without light maps. Texels that were lit; those texels times the Gaussians that
  /// blur them; shader invocations of shading and convolution; reads of texels that were never lit.
  std::uint64_t irradiance_texels = 0, convolved_texels = 0, launched = 0, unshaded_reads = 0;
  std::uint64_t transmission_misses = 0;  ///< light through the body that was looked up where none was stored
  /// Taps by which light is blurred. Over light maps: those of shader invocations, where an unwrap has its
  /// mean density. In the picture: taps per pixel of skin times skin_pixels. 0: nothing is blurred.
  std::uint64_t light_reads = 0;

  std::vector<int> used_size;  ///< T of each head in the row, texels; 0: skipped
  /// Of each head: Gaussians that are read from light maps, the widest ones; the others are lit per pixel.
  /// 0: the head has no light maps in this frame.
  std::vector<int> mapped_terms;

  /// Layers of shadow maps that were drawn, those of light that enters included; the others still showed what
  /// they had to: see QualitySettings::keep_shadows. Of a PreparedFrame: by the first frame.
  std::uint64_t shadow_maps_drawn = 0;
  RecordedWork recorded;              ///< of the last frame, that of `passes` if it was timed
  std::uint64_t light_map_bytes = 0;  ///< of the light maps that heads of a batch share, of all sizes

  /// Of a frame of a session: what was copied from the device to memory of the host, and from there to the
  /// caller, bytes.
  std::uint64_t read_back_bytes = 0, copied_bytes = 0;

  /// Device memory of the whole renderer: textures now, buffers now, the largest sum of both so far.
  std::uint64_t image_bytes = 0, buffer_bytes = 0, peak_bytes = 0;

  /// Returns an object with the keys of docs/methodology.md, as the program's --stats writes it.
  std::string json() const;
};

/// A finished picture, or the map that output.show names: linear floats, and eight bits for a display. Both
/// have four values per pixel, rows from top to bottom, without padding.
struct Picture {
  int width = 0, height = 0;  ///< pixels
  /// Linear Rec.709 with exposure and bloom; alpha = share of the pixel that is skin.
  std::vector<float> linear_rgba;
  std::vector<std::uint8_t> display_rgba;  ///< after the tone map; alpha = 255
  Statistics statistics;

  /// Writes .png (display values) or .exr (linear, 32-bit float), atomically. Throws InputError: another
  /// ending, a missing folder.
  void save(const std::filesystem::path& path) const;
};

class PreparedFrame;

namespace vulkan {
struct Host;  // dermis/vulkan.h
class HostFrames;
}  // namespace vulkan

/// Requests of a renderer to its device so far. A steady frame of a session adds one submission.
struct DeviceCounters {
  std::uint64_t allocations = 0;  ///< of memory from the driver
  std::uint64_t buffers = 0, images = 0, pipelines = 0;
  std::uint64_t submissions = 0;
  std::uint64_t waits = 0;       ///< for work that had not completed
  std::uint64_t idle_waits = 0;  ///< of these, for all that was submitted
};

/// Renders scenes on one device.
class Renderer {
 public:
  struct Options {
    std::string device = "best";  ///< "best", an index or a part of a name; `dermis info` lists them
    bool validate = false;        ///< use the Vulkan validation layer; see validation_messages()
    /// For tests: fills the textures of a frame with NaN before it is drawn, as a driver might leave them. No
    /// picture may show it.
    bool poison = false;
    /// For all calls of the renderer and its frames. `log` receives what each of them says. The others
    /// concern the work that takes seconds before a first frame: render(), prepare() and PreparedFrame::set()
    /// throw Cancelled if they end it, and nothing half-done is kept on disk.
    Hooks hooks{};
  };

  /// Takes the best device, without validation.
  Renderer() : Renderer(Options{}) {}
  /// Opens the device. Throws DeviceError: no driver, no such device, a feature that dermis needs is missing.
  explicit Renderer(const Options& options);
  /// Uses a host's device: see dermis/vulkan.h. Throws InputError: a null handle; DeviceError: it lacks what
  /// dermis needs.
  explicit Renderer(const vulkan::Host& host, const Hooks& hooks = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Prepares a frame, draws it settings.output.frames times and returns the last picture. Throws
  /// - InputError: a setting out of range (names it and the range), an unknown name (lists the known ones), a
  ///   profile or environment that cannot be read;
  /// - DeviceError: too little memory, or more than the device's limits;
  /// - Cancelled: a hook has ended the work.
  Picture render(const Scene& scene, const RenderSettings& settings = {});

  /// Returns a frame that can be drawn many times. Uploads the scene unless it is the one used last. Throws
  /// as render() does.
  PreparedFrame prepare(const Scene& scene, const RenderSettings& settings = {});

  /// Returns what the validation layer has said so far; empty unless Options::validate.
  std::vector<std::string> validation_messages() const;

  DeviceCounters counters() const;

  struct State;  // of the library

 private:
  friend class Session;
  friend class vulkan::HostFrames;
  std::shared_ptr<State> state_;
};

/// A scene on the device, with plan, memory and pipelines, ready to be drawn again and again. Keeps the
/// device alive, so it may outlive its renderer. Frames of one scene share its upload.
class PreparedFrame {
 public:
  PreparedFrame(PreparedFrame&&) noexcept;
  PreparedFrame& operator=(PreparedFrame&&) noexcept;
  ~PreparedFrame();

  /// Changes the settings of the frames to come. Camera, exposure, ambient light and the like cost little. A
  /// change of the structure (sizes, technique, heads, profile, what is optimised) makes a new plan and
  /// memory.
  ///
  /// Throws as Renderer::render() does. After an InputError the frame is as before. After a DeviceError or
  /// Cancelled it cannot be drawn until a set() succeeds: draw() and picture() throw Cancelled.
  void set(const RenderSettings& settings);
  /// Likewise, of an edited scene or of another one. Costs what has changed. Moved instances and lights cost
  /// little, but an instance that turns in an environment costs some 15 ms and 4 MB per skin mesh. A new
  /// asset is uploaded. Another number of instances, and a profile or a scale that none had, make a new plan.
  void set(const Scene& scene, const RenderSettings& settings);

  /// Draws one frame and returns its time, ms. Before the first after a change, draws another
  /// one that warms up and counts texels.
  double draw();

  /// Returns the passes of the frame that draw() timed last, in order; empty if there is none since set().
  std::vector<PassStatistics> last_passes() const;

  /// Returns the last frame, with the statistics of all frames since the last change. Draws one, untimed, if
  /// there was none.
  Picture picture();

 private:
  friend class Renderer;
  struct State;
  explicit PreparedFrame(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Returns what RenderSettings::technique may be; the first is the default.
std::vector<std::string> technique_names();

/// Returns the names of the program's --tone-map, in the order of ToneMap.
std::vector<std::string> tone_map_names();

/// Returns the passes of the frame that render() would draw, as text or in Graphviz's dot language. Needs no
/// device. Throws as render() does.
std::string describe_plan(const Scene& scene, const RenderSettings& settings, bool dot = false,
                          const Hooks& hooks = {});

}  // namespace dermis
