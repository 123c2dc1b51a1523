// SPDX-License-Identifier: MIT
// What uniform blocks say of a material or of a frame, as conditions and bounds of loops in fragment shaders.
//
// One software driver (Mesa's lavapipe 22) compiles a shader anew for each draw, and keeps what it has
// compiled, if a condition or a loop depends on uniform blocks alone: 5 MB per skin mesh and frame. So these
// depend on the fragment too, in a way that changes nothing.

uint nothing() { return gl_FragCoord.w < 0.0 ? 1u : 0u; }  // 0: w is positive wherever a fragment is

bool is_on(uint value) { return value > nothing(); }
bool is_present(MapIo map) { return is_on(map.present); }
