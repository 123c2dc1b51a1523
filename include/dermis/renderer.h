// SPDX-License-Identifier: MIT
/// The renderer: a scene in, a picture and its statistics out. Needs no display.
///
///   const dermis::Scene scene = dermis::Scene::load("head.glb");
///   dermis::Renderer renderer;
///   const dermis::Picture picture = renderer.render(scene, {.output = {.width = 960, .height = 1080}});
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
#include "dermis/settings.h"

namespace dermis {

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

/// In the order of ToneMap.
std::vector<std::string> tone_map_names();

/// The frame that render() would run, as text or in Graphviz's dot language. Needs no device.
std::string describe_plan(const Scene& scene, const RenderSettings& settings, bool dot = false);

}  // namespace dermis
