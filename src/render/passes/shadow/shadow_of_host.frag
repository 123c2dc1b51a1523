// SPDX-License-Identifier: MIT
// The depth of a host's shadow map, reversed if the host's is not.
#version 460
#include "render/passes/shadow/shadow_io.h"
layout(push_constant, scalar) uniform Push { HostShadowIo io; };
layout(binding = 0) uniform sampler2D host_depth;
void main() {
  const float depth = textureLod(host_depth, gl_FragCoord.xy * io.texel, 0.0).r;
  gl_FragDepth = io.reversed != 0u ? depth : 1.0 - depth;
}
