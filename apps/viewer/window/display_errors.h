// SPDX-License-Identifier: MIT
#pragma once

namespace dermis::viewer {

/// Ends the program in one line and with status 1 where the display refuses a request or breaks off. Another
/// program may destroy the window, and Xlib's own handlers tell that as a fault of this one. Does nothing in
/// a build without Xlib.
void end_on_display_errors();

}  // namespace dermis::viewer
