// SPDX-License-Identifier: MIT
/// Shows frames of ImGui in a window: a device, a swapchain, and a renderer of the lists. Made anew when the
/// surface or the device is lost.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/window/ui_renderer.h"
#include "viewer/window/window.h"

struct ImDrawData;

namespace dermis::viewer {

class Presenter {
 public:
  /// Throws DeviceError: see PresentDevice.
  Presenter(Window& window, bool validate);
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;
  ~Presenter();

  void set_picture(PictureSlot slot, int width, int height, std::span<const std::uint8_t> rgba);

  /// Begins a frame of ImGui. False: the window shows nothing now (minimised); no frame was begun.
  bool begin();
  /// Draws and shows the frame, unless the window shows just that. Returns whether the window shows it: one
  /// that is just changing or hidden takes none. Throws DeviceError if the device is lost again and again.
  bool end();
  /// Ends the frame in place of end(), and shows nothing.
  void drop();

  bool is_software() const { return parts_->device.is_software(); }
  /// Destroys what shows the window; nothing can be shown after it.
  void close() { parts_.reset(); }
  /// Messages of the validation layer; complete after close().
  const std::vector<std::string>& validation_messages() const { return said_; }
  std::uint64_t frames() const { return frames_; }  ///< that were shown

 private:
  struct Parts {
    Parts(const Window& window, bool validate, std::vector<std::string>& said)
        : device(window.handle(), validate, said), chain(device), ui(device, chain.format()) {}
    /// The last frame may still draw with any of the members.
    ~Parts() { device.wait_idle(); }
    PresentDevice device;
    Swapchain chain;
    UiRenderer ui;
  };
  /// A picture, so that new parts have it too.
  struct Kept {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
  };
  void make();
  /// Returns whether a frame would be what the window shows; takes it for shown.
  bool is_shown(const ImDrawData& lists);

  Window& window_;
  bool validate_;
  std::vector<std::string> said_;  ///< by the validation layer of all parts so far; outlives them
  std::array<Kept, picture_slots> kept_;
  std::unique_ptr<Parts> parts_;
  std::chrono::steady_clock::time_point lost_at_{};
  std::uint64_t frames_ = 0;
  std::size_t shown_ = 0;  ///< hash of the lists that the window shows
  bool has_news_ = true;   ///< pictures, or parts
};

}  // namespace dermis::viewer
