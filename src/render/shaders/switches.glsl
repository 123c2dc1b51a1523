// SPDX-License-Identifier: MIT
// Conditions and loop bounds that depend on uniform blocks, for shaders that shade points.
//
// One software driver (Mesa's lavapipe 22) compiles a shader again for each draw if a condition or a loop
// depends on uniform blocks alone. It keeps the result: 5 MB per skin mesh and frame. So these depend on the
// fragment (or what main() reads) too, without effect.

// Always 0.
#ifdef COMPUTE_SHADING
uint zero;  // the shader sets it, from memory
uint nothing() { return zero; }
#else
uint nothing() { return gl_FragCoord.w < 0.0 ? 1u : 0u; }  // w is positive in every fragment
#endif

bool is_on(uint value) { return value > nothing(); }
bool is_present(MapIo map) { return is_on(map.present); }
