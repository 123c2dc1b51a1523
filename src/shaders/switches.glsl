// SPDX-License-Identifier: MIT
// Conditions and loop bounds that depend on uniform blocks, for fragment shaders.
//
// One software driver (Mesa's lavapipe 22) compiles a shader again for each draw, and keeps the result, if a
// condition or a loop depends on uniform blocks alone: 5 MB per skin mesh and frame. So these depend on the
// fragment too, without effect.

uint nothing() { return gl_FragCoord.w < 0.0 ? 1u : 0u; }  // always 0: w is positive in every fragment

bool is_on(uint value) { return value > nothing(); }
bool is_present(MapIo map) { return is_on(map.present); }
