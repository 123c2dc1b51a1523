// SPDX-License-Identifier: MIT
// Bilinear among the texels that hold skin. Beside a cut the light map continues for a texel that
// convolutions skip; it is used only if there is nothing else.
vec3 light_left(sampler2D light, vec2 at) {
  const ivec2 size = textureSize(light, 0);
  const vec2 p = at * vec2(size) - 0.5, corner = floor(p), f = p - corner;
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    const ivec2 d = ivec2(k & 1, k >> 1);
    const vec4 texel = texelFetch(light, clamp(ivec2(corner) + d, ivec2(0), size - 1), 0);
    const float weight = (d.x == 1 ? f.x : 1.0 - f.x) * (d.y == 1 ? f.y : 1.0 - f.y);
    // A texel without weight may be outside the used square and hold anything: 0 times NaN is NaN.
    if (weight <= 0.0 || texel.a == 0.0) continue;
    sum += weight * (texel.a == BORDER_ALPHA ? 1.0 / 256.0 : 1.0) * vec4(texel.rgb, 1.0);
  }
  return sum.rgb / max(sum.w, 1e-6);
}
