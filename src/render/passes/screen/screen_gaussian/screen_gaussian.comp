// SPDX-License-Identifier: MIT
// One axis of one Gaussian on the tangent plane of the pixel, or as the authors have it. Taps stand on whole
// rows or columns, with weights whose variance is exact. Across slanted rows light is read between two
// pixels; the variance that this adds is taken from the other axis.
#version 460
#include "render/passes/scatter/kernels_io.h"
#include "render/passes/screen/screen_gaussian/screen_gaussian_io.h"
#include "render/shaders/half.glsl"
#include "render/shared/scene_io.h"
layout(constant_id = 0) const int radius = 6;
layout(constant_id = 1) const int axis = 0;
layout(constant_id = 2) const bool published = false;
layout(constant_id = 3) const bool begins = false;
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ScreenIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1, r32f) uniform readonly image2D depth_of_skin;
layout(binding = 2, r32ui) uniform readonly uimage2D surface_of_skin;
#include "render/shaders/frame.glsl"
layout(binding = 4) uniform sampler2DArray leaving_skin;
layout(binding = 5, scalar) readonly buffer Steps { GaussianStepIo steps[]; };
layout(binding = 6) uniform utextureBuffer Kernels;
layout(binding = 7, rgba16f) uniform writeonly image2D target;
layout(binding = 8, rgba16f) uniform image2D sum_of_light;
#include "render/passes/screen/screen_area.glsl"
#include "render/passes/screen/screen_surface.glsl"
#include "render/passes/screen/screen_tangents.glsl"

// The pixel that gathers: its skin, and the light that taps take where they find none of this skin.
struct Middle {
  ivec2 at;
  vec3 light;
  uint head;
  float depth_mm, reach_mm;
  Tangents tangents;
};

#include "render/passes/scatter/kernel_row.glsl"

// sigma: in units of the tap spacing.
void load_kernel(float sigma) {
  load_kernel_row(clamp(sigma * 3.0 / float(radius), 0.0, 1.0) * float(KERNEL_ROWS - 1), 0, radius);
}

// Returns the rows or columns between taps of a kernel so wide.
int spacing(float sigma_pixels) { return max(1, int(ceil(sigma_pixels * 3.0 / float(radius) - 1e-4))); }

vec3 light_at(Middle m, ivec2 p) {
  p = in_area(p);
  if (head_of(imageLoad(surface_of_skin, p).x) != m.head) return m.light;
  const float off_mm = imageLoad(depth_of_skin, p).r - plane_depth_mm(m.tangents, m.depth_mm, vec2(p - m.at));
  const float off = clamp(abs(off_mm) * m.tangents.cosine / m.reach_mm, 0.0, 1.0);
  return mix(texelFetch(light, p, 0).rgb, m.light, off);
}

// Returns the light between two pixels of a row.
vec3 light_between(Middle m, float x, int y) {
  const float whole = floor(x), f = x - whole;
  const vec3 before = light_at(m, ivec2(int(whole), y));
  return f < 1e-3 ? before : mix(before, light_at(m, ivec2(int(whole) + 1, y)), f);
}

vec3 blurred(Middle m, float sigma_mm) {
  // A row further down on the skin, where it is perpendicular to the rows, and its length.
  const vec3 right = m.tangents.right_mm, down = m.tangents.down_mm;
  const float along = dot(right, down) / dot(right, right);
  const float sigma_rows = sigma_mm / length(down - along * right);
  int step = spacing(sigma_rows);
  load_kernel(sigma_rows / float(step));

  vec3 sum = vec3(0.0);
  if (axis == 0) {
    sum = kernel_row[0] * m.light;
    for (int k = 1; k <= radius; ++k) {
      const float shift = along * float(k * step);
      sum += kernel_row[k] * (light_between(m, float(m.at.x) - shift, m.at.y + k * step) +
                              light_between(m, float(m.at.x) + shift, m.at.y - k * step));
    }
    return sum;
  }

  float interpolation = 0.0;  // variance along the rows that the other pass has added, pixels^2
  for (int k = 1; k <= radius; ++k) {
    const float f = fract(along * float(k * step));
    interpolation += 2.0 * kernel_row[k] * f * (1.0 - f);
  }
  const float wanted = sigma_mm / length(right), sigma = sqrt(max(wanted * wanted - interpolation, 0.0));
  step = spacing(sigma);
  load_kernel(sigma / float(step));
  sum = kernel_row[0] * m.light;
  for (int k = 1; k <= radius; ++k)
    sum += kernel_row[k] * (light_at(m, m.at + ivec2(k * step, 0)) + light_at(m, m.at - ivec2(k * step, 0)));
  return sum;
}

// [JSG09] and the authors' demo: seven taps one sigma apart, narrower by the depth gradient along the axis
// within the pair of pixels. No tap is rejected.
vec3 blurred_as_published(Middle m, float sigma_mm, float mm_per_unit) {
  const bool orthographic = frame.camera.orthographic != 0u;
  const float pixels_per_mm =
      io.up * 0.5 * io.picture_size.y / (orthographic ? mm_per_unit : max(m.depth_mm, 1e-6));
  const float z_mm = orthographic ? 0.5 * io.picture_size.y * GAUSSIANS_COT / pixels_per_mm : m.depth_mm;

  const ivec2 other = axis == 0 ? ivec2(m.at.x, m.at.y ^ 1) : ivec2(m.at.x ^ 1, m.at.y);
  const float there_mm = all(lessThan(other, ivec2(io.extent))) ? imageLoad(depth_of_skin, other).r : 0.0;
  const float gradient_mm =
      there_mm > 0.0 ? min(abs(there_mm - m.depth_mm), GAUSSIANS_MOST_GRADIENT) : GAUSSIANS_MOST_GRADIENT;
  const float sigma = sigma_mm * pixels_per_mm * z_mm / (z_mm + GAUSSIANS_GRADIENT * gradient_mm);

  const vec2 step = axis == 0 ? vec2(0.0, sigma) : vec2(sigma, 0.0), middle = vec2(m.at) + 0.5;
  const float weights[] = {0.242, 0.061, 0.006};
  vec3 sum = 0.382 * m.light;
  for (int k = 0; k < 3; ++k)
    sum += weights[k] * (skin_light(middle + float(k + 1) * step, m.light) +
                         skin_light(middle - float(k + 1) * step, m.light));
  return sum;
}

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.size))) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy);
  const vec4 middle = texelFetch(light, at, 0);
  if (middle.a == 0.0) {
    imageStore(target, at, vec4(0.0));
    if (axis == 1 && begins) imageStore(sum_of_light, at, vec4(0.0));
    return;
  }

  const GaussianStepIo step =
      steps[uint(int(texelFetch(leaving_skin, ivec3(at, 0), 0).a) + SURFACE_MESH_MIDDLE)];
  const uint surface = imageLoad(surface_of_skin, at).x;
  const float depth_mm = imageLoad(depth_of_skin, at).r;
  vec3 result = middle.rgb;
  if (step.sigma_mm > 0.0) {
    const Middle m = Middle(at, middle.rgb, head_of(surface), depth_mm, step.reach_mm,
                            tangents_at(at, normal_of(surface), depth_mm, step.mm_per_unit));
    result = published ? blurred_as_published(m, step.sigma_mm, step.mm_per_unit) : blurred(m, step.sigma_mm);
  }
  result = storable(result);
  imageStore(target, at, vec4(result, 1.0));
  if (axis == 0) return;
  const vec3 before = begins ? vec3(0.0) : imageLoad(sum_of_light, at).rgb;
  imageStore(sum_of_light, at, vec4(storable(before + step.weight * result), 1.0));
}
