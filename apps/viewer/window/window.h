// SPDX-License-Identifier: MIT
/// The window: GLFW's, with ImGui's input in it.
#pragma once

#include <vulkan/vulkan.h>

#include <functional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace dermis::viewer {

/// A letter of the keyboard, as its layout has it.
struct KeyPress {
  char letter = 0;  ///< A to Z
  bool ctrl = false, shift = false;
};

class Window {
 public:
  /// Throws DeviceError: there is no display (says what to do), or it takes no window.
  Window(const std::string& title, int width, int height);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  GLFWwindow* handle() const { return window_; }
  bool should_close() const;
  bool is_minimised() const;
  VkExtent2D pixels() const;  ///< 0 x 0 while it is minimised
  double scale() const;       ///< pixels of the display per pixel of a display of 96 dpi
  void set_title(const std::string& title) const;

  /// Waits for an event, of the window or of wake(), at most so long; negative: as long as it takes.
  void wait(double seconds) const;
  /// Ends a wait(), from any thread.
  static void wake();

  /// Returns the files that were dropped since the last call.
  std::vector<std::string> take_dropped();
  /// Returns the letters that were pressed since the last call. (ImGui misses a key that is pressed and
  /// released between two frames.)
  std::vector<KeyPress> take_keys();
  /// Returns whether the window or its input has changed since the last call.
  bool take_touched();
  /// Returns whether what was shown may be gone since the last call.
  bool take_exposed();

 private:
  static void touch(GLFWwindow* window);
  static void expose(GLFWwindow* window);
  static void take_key(GLFWwindow* window, int key, int scancode, int action, int modifiers);

  GLFWwindow* window_ = nullptr;
  std::vector<std::string> dropped_;
  std::vector<KeyPress> keys_;
  bool touched_ = true, exposed_ = true;
};

}  // namespace dermis::viewer
