// SPDX-License-Identifier: MIT
// What a file manager and a window manager tell a window of the X server:
//   window_events drop WINDOW X Y FILE...   drags files over it and drops them there; X, Y in it, pixels.
//                                           Ends with 0 once the window has taken them
//   window_events close WINDOW              asks it to close
// WINDOW: its number.
// Based on: XDND, Drag-and-Drop Protocol for the X Window System, version 5.
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

namespace {

constexpr long version = 5;

std::string uri_of(const std::string& file) {
  std::string uri = "file://";
  for (const char c : std::filesystem::absolute(file).string()) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::strchr("/._-~", c) != nullptr;
    char code[4] = {c, 0, 0, 0};
    if (!plain) std::snprintf(code, sizeof(code), "%%%02X", static_cast<unsigned char>(c));
    uri += code;
  }
  return uri + "\r\n";
}

class Source {
 public:
  Source(Window target, std::string files)
      : display_(XOpenDisplay(nullptr)), target_(target), files_(std::move(files)) {
    if (!display_) return;
    own_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
  }
  ~Source() {
    if (display_) XCloseDisplay(display_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  // The steps of the protocol, in their order; false: the window does not take part.
  bool drop(int x, int y) {
    if (!display_) return false;
    Window child = 0;
    int root_x = 0, root_y = 0;
    XTranslateCoordinates(display_, target_, DefaultRootWindow(display_), x, y, &root_x, &root_y, &child);

    send("XdndEnter", version << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, (static_cast<long>(root_x) << 16) | root_y, CurrentTime,
         static_cast<long>(atom("XdndActionCopy")));
    if (!wait_for("XdndStatus") || !accepted_) return false;
    send("XdndDrop", 0, CurrentTime, 0, 0);
    return wait_for("XdndFinished");
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

  void send(const char* type, long one, long two, long three, long four) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(own_);
    event.xclient.data.l[1] = one;
    event.xclient.data.l[2] = two;
    event.xclient.data.l[3] = three;
    event.xclient.data.l[4] = four;
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  // Answers who asks for the files, until the message comes; ten seconds at most.
  bool wait_for(const char* type) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < end) {
      while (XPending(display_) > 0) {
        XEvent event{};
        XNextEvent(display_, &event);
        if (event.type == SelectionRequest) give(event.xselectionrequest);
        if (event.type != ClientMessage || event.xclient.message_type != atom(type)) continue;
        accepted_ = (event.xclient.data.l[1] & 1) != 0;
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

  void give(const XSelectionRequestEvent& request) const {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(files_.data()), static_cast<int>(files_.size()));
    XEvent answer{};
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = request.requestor;
    answer.xselection.selection = request.selection;
    answer.xselection.target = request.target;
    answer.xselection.property = request.property;
    answer.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &answer);
    XFlush(display_);
  }

  Display* display_;
  Window target_, own_ = 0;
  std::string files_;
  bool accepted_ = false;
};

// As a window manager does when its cross is clicked: WM_DELETE_WINDOW of ICCCM 4.2.8.1.
bool close(Window window) {
  Display* display = XOpenDisplay(nullptr);
  if (!display) return false;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  const bool sent = XSendEvent(display, window, False, NoEventMask, &event) != 0;
  XCloseDisplay(display);
  return sent;
}

int usage() {
  std::fprintf(stderr, "usage: window_events drop WINDOW X Y FILE... | window_events close WINDOW\n");
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 2 ? argv[1] : "";
  const Window window = argc > 2 ? std::strtoul(argv[2], nullptr, 0) : 0;
  if (what == "close") return close(window) ? 0 : 1;
  if (what != "drop" || argc < 6) return usage();

  std::string files;
  for (int i = 5; i < argc; ++i) files += uri_of(argv[i]);
  Source source(window, files);
  if (source.drop(std::atoi(argv[3]), std::atoi(argv[4]))) return 0;
  std::fprintf(stderr, "window_events: the window took nothing\n");
  return 1;
}
