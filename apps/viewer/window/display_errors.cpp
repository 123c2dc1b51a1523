// SPDX-License-Identifier: MIT
// Compiled by itself: Xlib's macros take names that others have.
#include "viewer/window/display_errors.h"

#ifdef DERMIS_X11
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#endif

namespace dermis::viewer {

#ifdef DERMIS_X11

namespace {

// Neither may call Xlib, and nothing can be shown any more.
int end_on_error(Display*, XErrorEvent* error) {
  if (error->error_code == BadWindow || error->error_code == BadDrawable)
    std::fputs("dermis: the window was destroyed by another program\n", stderr);
  else
    std::fprintf(stderr, "dermis: the display has refused a request (X11 error %d)\n", error->error_code);
  std::_Exit(1);
}

int end_without_display(Display*) {
  std::fputs("dermis: the connection to the display broke off\n", stderr);
  std::_Exit(1);
}

}  // namespace

void end_on_display_errors() {
  XSetErrorHandler(end_on_error);
  XSetIOErrorHandler(end_without_display);
}

#else

void end_on_display_errors() {}

#endif

}  // namespace dermis::viewer
