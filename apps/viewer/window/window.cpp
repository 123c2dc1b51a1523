// SPDX-License-Identifier: MIT
#include "viewer/window/window.h"

#include <GLFW/glfw3.h>

#include <string>
#include <utility>

#include "dermis/error.h"
#include "viewer/window/display_errors.h"

namespace dermis::viewer {
namespace {

std::string what_glfw_says() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

}  // namespace

Window::Window(const std::string& title, int width, int height) {
  if (!glfwInit())
    throw DeviceError("there is no display to open a window on (" + what_glfw_says() +
                      "); 'dermis render' draws to a file without one");
  end_on_display_errors();
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string reason = what_glfw_says();
    glfwTerminate();
    throw DeviceError("the display takes no window (" + reason +
                      "); 'dermis render' draws to a file without one");
  }
  glfwSetWindowSizeLimits(window_, 320, 180, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowUserPointer(window_, this);
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
    self.dropped_.insert(self.dropped_.end(), paths, paths + count);
    self.touched_ = true;
  });

  // ImGui's callbacks, which come later, call these too.
  glfwSetKeyCallback(window_, take_key);
  glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { touch(w); });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { touch(w); });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { touch(w); });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double) { touch(w); });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { touch(w); });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { touch(w); });
  glfwSetWindowIconifyCallback(window_, [](GLFWwindow* w, int) { expose(w); });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { expose(w); });
  glfwSetWindowRefreshCallback(window_, expose);
}

void Window::touch(GLFWwindow* window) {
  static_cast<Window*>(glfwGetWindowUserPointer(window))->touched_ = true;
}

void Window::expose(GLFWwindow* window) {
  touch(window);
  static_cast<Window*>(glfwGetWindowUserPointer(window))->exposed_ = true;
}

void Window::take_key(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
  touch(window);
  if (action != GLFW_PRESS) return;
  const char* name = glfwGetKeyName(key, scancode);
  char letter = name && name[0] != 0 && name[1] == 0 ? name[0] : 0;
  if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  if (letter < 'A' || letter > 'Z') return;
  static_cast<Window*>(glfwGetWindowUserPointer(window))
      ->keys_.push_back({.letter = letter,
                         .ctrl = (modifiers & GLFW_MOD_CONTROL) != 0,
                         .shift = (modifiers & GLFW_MOD_SHIFT) != 0});
}

std::vector<KeyPress> Window::take_keys() { return std::exchange(keys_, {}); }

bool Window::take_touched() { return std::exchange(touched_, false); }
bool Window::take_exposed() { return std::exchange(exposed_, false); }

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

bool Window::should_close() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }
bool Window::is_minimised() const { return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE; }
void Window::set_title(const std::string& title) const { glfwSetWindowTitle(window_, title.c_str()); }

VkExtent2D Window::pixels() const {
  if (is_minimised()) return {};
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

double Window::scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_, &x, &y);
  return x > 0 ? x : 1;
}

void Window::wait(double seconds) const {
  if (seconds < 0)
    glfwWaitEvents();
  else if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}

void Window::wake() { glfwPostEmptyEvent(); }

std::vector<std::string> Window::take_dropped() { return std::exchange(dropped_, {}); }

}  // namespace dermis::viewer
