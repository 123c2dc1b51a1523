// SPDX-License-Identifier: MIT
/// Sessions: frames of a scene that changes while it is looked at.
///
///   dermis::Session session(renderer);
///   for (;;) {
///     scene.set_transform(head, pose);
///     const dermis::Ticket ticket = session.draw(scene, settings);
///     ...                                         // the device draws
///     show(session.results(ticket).display);
///   }
///
/// draw() returns before the device has drawn. Camera, lights, transforms, exposure and the rotation of an
/// environment change from frame to frame without waiting for the device, without an allocation on it and
/// with one submission. Changes that make a new plan (RenderSettings of the structure, a number of instances,
/// a profile or a scale that no instance had) or need new maps cost that once. A picture is the same to the
/// bit as that of Renderer::render(). Outputs of a session are named when it is made: nothing else is drawn
/// or read back.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "dermis/outputs.h"
#include "dermis/renderer.h"

namespace dermis {

/// The view of one frame: a camera. Its target has the size that OutputSettings have.
struct View {
  CameraSettings camera{};
};

/// Names a frame of a session.
enum class Ticket : std::uint64_t {};

/// One thread at a time may use a session and its renderer. A session keeps the device alive.
class Session {
 public:
  struct Options {
    /// Frames that may be on their way at a time, 1 to 3: draw() waits for the one before these. Each takes
    /// memory for its results and for what changes per frame, but not for maps.
    int frames_in_flight = 2;
    bool statistics = false;  ///< counts what each frame computes: Statistics of its picture; costs time
    /// Outputs of results(), at least one. Labels take one more pass, which is one more time all visible
    /// triangles; without display, linear and matte nothing is lit. Nose, ears and thickness of an asset are
    /// found when region or thickness is first wanted of it: a second for 20,000 triangles; the thickness is
    /// kept in the cache.
    Outputs wanted = Outputs::picture();
  };

  explicit Session(const Renderer& renderer) : Session(renderer, Options{}) {}
  /// Throws InputError: a number out of range.
  Session(const Renderer& renderer, const Options& options);
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// Draws the scene as it is now. `settings.output.exposure_ev` must be given, and `output.show` be
  /// "picture". Throws as Renderer::render() does; after an InputError the session is as before.
  Ticket draw(const Scene& scene, const RenderSettings& settings);
  /// Likewise, as these views see it in place of settings.camera; camera.heads stays that of the settings.
  /// One view per frame so far: throws InputError for another number.
  Ticket draw(const Scene& scene, const RenderSettings& settings, std::span<const View> views);

  /// Returns whether results() would not wait. Throws InputError: see results().
  bool is_ready(Ticket ticket) const;

  /// Returns what the frame has given, without copying it; waits for the frame, but not for later ones. May
  /// be called again, until as many frames have been drawn after it as may be in flight. Throws InputError: a
  /// ticket of an earlier frame or of another session.
  Results results(Ticket ticket) const;
  /// Returns the statistics of the frame, as results() does. Times are 0: frames of a session are not timed.
  Statistics statistics(Ticket ticket) const;
  /// Returns a copy of the picture, which depends on no memory of the device. Throws InputError as results()
  /// does, and if display or linear is not wanted.
  Picture picture(Ticket ticket) const;

  struct State;  // of the library

 private:
  std::unique_ptr<State> state_;
};

}  // namespace dermis
