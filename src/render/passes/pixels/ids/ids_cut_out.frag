// SPDX-License-Identifier: MIT
// As ids.frag, where the alpha test leaves skin.
#version 460
#include "render/shared/scene_io.h"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
layout(binding = 8) uniform sampler2D map_base_colour;
#include "render/shaders/cut_out.glsl"
layout(location = 0) flat in uint in_id;
layout(location = 3) in vec4 in_uv;
layout(location = 4) in vec4 in_colour;
layout(location = 0) out vec4 out_id;
void main() {
  if (cut_out && is_cut(in_uv, in_colour)) discard;
  out_id = unpackUnorm4x8(in_id);
}
