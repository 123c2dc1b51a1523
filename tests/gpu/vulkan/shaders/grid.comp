// SPDX-License-Identifier: MIT
// Each thread counts itself; workgroup size and arithmetic are set by specialisation constants.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "common.glsl"
layout(local_size_x = 8, local_size_x_id = 4, local_size_y = 2) in;
layout(constant_id = 4) const uint group_x = 8;
layout(constant_id = 1) const bool doubled = false;
layout(constant_id = 7) const float offset = 0.5;
layout(constant_id = 9) const int unused = 3;
layout(scalar, binding = 0) writeonly buffer To { float values[]; }
to;
void main() {
  const uint width = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  const uint i = gl_GlobalInvocationID.y * width + gl_GlobalInvocationID.x;
  to.values[i] = (doubled ? 2.0 : 1.0) * float(gl_WorkGroupSize.x) + offset;
}
