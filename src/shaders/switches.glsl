// SPDX-License-Identifier: MIT
// Conditions and loop bounds that depend on uniform blocks, for fragment shaders, and with COMPUTE for
// compute shaders.
//
// One software driver (Mesa's lavapipe 22) compiles a shader again for each draw, and keeps the result, if a
// condition or a loop depends on uniform blocks alone: 5 MB per skin mesh and frame. So these depend on the
// fragment (or invocation) too, without effect.

// Returns 0 always: w is positive in every fragment, and no dispatch is that wide.
#ifdef COMPUTE
uint nothing() { return gl_GlobalInvocationID.x == 0xFFFFFFFFu ? 1u : 0u; }
#else
uint nothing() { return gl_FragCoord.w < 0.0 ? 1u : 0u; }
#endif

bool is_on(uint value) { return value > nothing(); }
bool is_present(MapIo map) { return is_on(map.present); }
