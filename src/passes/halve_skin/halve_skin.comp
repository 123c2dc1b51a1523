// SPDX-License-Identifier: MIT
// The mean over those of four pixels that show the same skin mesh of a head: the one that most show.
#version 460
#include "passes/screen_surface_io.h"
#include "shaders/half.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(push_constant, scalar) uniform Push { ScreenIo io; };
layout(binding = 0) uniform sampler2D light;
layout(binding = 1) uniform sampler2D depth_of_skin;
layout(binding = 2) uniform usampler2D surface_of_skin;
layout(binding = 3) uniform sampler2DArray leaving_skin;
layout(binding = 4, rgba16f) uniform writeonly image2D halved_light;
layout(binding = 5, r32f) uniform writeonly image2D halved_depth;
layout(binding = 6, r32ui) uniform writeonly uimage2D halved_surface;
layout(binding = 7, rgba16f) uniform writeonly image2DArray halved_leaving;
#include "passes/screen_surface.glsl"

void main() {
  if (any(greaterThanEqual(gl_GlobalInvocationID.xy, io.size))) return;
  const ivec2 at = ivec2(io.low + gl_GlobalInvocationID.xy), extent = ivec2(io.extent);

  // What each pixel shows: head and mesh, 0 where there is no skin.
  ivec2 places[4];
  uint heads[4];
  float meshes[4];
  for (int i = 0; i < 4; ++i) {
    places[i] = 2 * at + ivec2(i & 1, i >> 1);
    const bool inside = all(lessThan(places[i], extent));
    heads[i] = inside ? head_of(texelFetch(surface_of_skin, places[i], 0).x) : 0u;
    meshes[i] = inside ? texelFetch(leaving_skin, ivec3(places[i], 0), 0).a : 0.0;
  }
  int chosen = 0, most = 0;
  for (int i = 0; i < 4; ++i) {
    int same = 0;
    for (int k = 0; k < 4; ++k) same += heads[k] == heads[i] && meshes[k] == meshes[i] ? 1 : 0;
    if (heads[i] == 0u || same <= most) continue;
    most = same;
    chosen = i;
  }
  if (most == 0) {
    imageStore(halved_light, at, vec4(0.0));
    imageStore(halved_depth, at, vec4(0.0));
    imageStore(halved_surface, at, uvec4(0u));
    return;
  }

  vec3 sum = vec3(0.0), normal = vec3(0.0);
  float depth_mm = 0.0;
  for (int i = 0; i < 4; ++i) {
    if (heads[i] != heads[chosen] || meshes[i] != meshes[chosen]) continue;
    sum += texelFetch(light, places[i], 0).rgb;
    depth_mm += texelFetch(depth_of_skin, places[i], 0).r;
    normal += normal_of(texelFetch(surface_of_skin, places[i], 0).x);
  }
  if (dot(normal, normal) < 1e-6) normal = normal_of(texelFetch(surface_of_skin, places[chosen], 0).x);
  imageStore(halved_light, at, vec4(storable(sum / float(most)), 1.0));
  imageStore(halved_depth, at, vec4(depth_mm / float(most)));
  imageStore(halved_surface, at, uvec4(packed_surface(heads[chosen] - 1u, normalize(normal))));
  imageStore(halved_leaving, ivec3(at, 0), vec4(0.0, 0.0, 0.0, meshes[chosen]));
}
