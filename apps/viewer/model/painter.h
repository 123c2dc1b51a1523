// SPDX-License-Identifier: MIT
/// The thread that draws pictures: it owns the renderer, so that the window answers while a slow device
/// works. It draws the newest wish and passes over those between; what is saved comes first.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/session.h"
#include "render/shared/scene_io.h"
#include "viewer/model/live_shaders.h"
#include "viewer/model/priority.h"

namespace dermis::viewer {

/// A picture that the window would like to show.
struct Wish {
  Scene scene;
  RenderSettings settings{};
  std::uint64_t revision = 0;  ///< of the document
  std::uint64_t serial = 0;    ///< grows with each change of what is to be seen
  bool moving = false;         ///< while something changes: as small as the device needs it
  double exposure_ev = 0;      ///< while something changes, of settings that leave it open
  bool timed = false;          ///< with the times of the passes
  bool labels = false;         ///< with what each pixel shows
  bool light = false;          ///< and, at rest, with the light map
  bool is_b = false;           ///< of what A is compared with
};

/// The map of `output.show` "irradiance".
struct LightMap {
  int side = 0;             ///< T, texels
  std::vector<float> rgba;  ///< radiance of the light that enters, with exposure; alpha 0: not lit
  double exposure_ev = 0;
};

struct Painted {
  Picture picture;
  std::optional<Results> labels{};
  std::optional<io::CameraIo> camera{};    ///< with labels
  std::optional<LightMap> light{};         ///< with labels, where the technique stores it
  std::uint64_t revision = 0, serial = 0;  ///< of the wish
  int divisor = 1;                         ///< of the sides of what was wished
  bool is_b = false;
  bool moving = false;
  double ms = 0;  ///< wall clock, from wish to picture
};

/// A picture to be written: drawn as `dermis render` draws it.
struct SaveWish {
  Scene scene;
  RenderSettings settings{};
  std::filesystem::path file;
};

/// News of the thread.
struct PainterNews {
  std::shared_ptr<const Painted> painted{}, painted_b{};  ///< newest since the last call, or null
  std::vector<std::string> saved{};                       ///< files that were written
  std::vector<std::string> errors{};                      ///< of wishes and of files, one line each
  std::vector<std::string> notes{};                       ///< messages of the library
  bool renewed = false;                                   ///< the device was lost, and another one draws
};

class Easel;  // viewer/model/easel.h

class Painter {
 public:
  struct Options {
    std::string device = "best";
    bool validate = false;
    Priority priority = Priority::hand;
    /// Called by any thread after something new; may be empty.
    std::function<void()> on_news{};
    /// For tests: called before each picture, and may throw what a device throws.
    std::function<void()> before_drawing{};
  };

  explicit Painter(Options options);
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;
  ~Painter();  ///< ends what is under way as soon as it can be ended

  void wish(Wish wish);
  /// Forgets a picture of A that is not drawn yet.
  void drop();
  void save(SaveWish wish);
  /// Later pictures are drawn with these in the place of dermis's own.
  void use_shaders(std::shared_ptr<const ShaderSet> shaders);
  PainterNews take_news();

  bool is_busy() const;       ///< draws, or has something to draw
  std::string doing() const;  ///< "occlusion of the surroundings: 40 %"; empty if nothing takes long
  std::vector<std::string> validation_messages() const;
  std::string device_name() const;  ///< empty before the first picture

  /// Ends the thread if that takes no longer than so many seconds. Returns whether it has ended.
  bool stop(double seconds);

 private:
  /// A picture for the window, or one for a file.
  struct Job {
    std::optional<Wish> wish;
    std::optional<SaveWish> to_save;
    std::shared_ptr<const ShaderSet> shaders;  ///< from now on; null: those there are
  };

  void run();
  Hooks hooks();
  std::optional<Job> next_job();
  void serve(Easel& easel, const Job& job);
  void tell(const std::function<void(PainterNews&)>& change);

  Options options_;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> cancel_ = false;  ///< ends the preparation: a newer wish waits
  bool may_cancel_ = false;           ///< a picture at rest is being drawn
  mutable std::mutex mutex_;
  std::condition_variable wake_, ended_;
  std::optional<Wish> wish_, wish_b_;
  std::vector<SaveWish> saves_;
  std::shared_ptr<const ShaderSet> shaders_;  ///< that the easel has not taken yet
  PainterNews news_;
  bool working_ = false, has_ended_ = false;
  std::string doing_, device_name_;
  std::vector<std::string> validation_;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace dermis::viewer
