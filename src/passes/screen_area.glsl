// SPDX-License-Identifier: MIT
// The pixels that hold all heads, of which alone passes in screen space write any. The outermost have no skin
// unless they are the picture's own, so that a read beside them may read them. Needs ScreenIo `io`.
ivec2 in_area(ivec2 p) { return clamp(p, ivec2(io.low), ivec2(io.low + io.size) - 1); }
vec2 in_area(vec2 p) { return clamp(p, vec2(io.low) + 0.5, vec2(io.low + io.size) - 0.5); }
