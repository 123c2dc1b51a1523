// SPDX-License-Identifier: MIT
// The Cholesky factor of the inverse metric, per metre (a half float then holds heads and giants alike), and
// the number of the chart. Skin that is cut away keeps its metric, for texels that are only partly cut away,
// but belongs to no chart.
#version 460
#include "render/shared/types.h"
#include "render/shaders/half.glsl"
#include "render/shared/scene_io.h"
layout(binding = 2, scalar) uniform Material { MaterialIo material; };
layout(binding = 8) uniform sampler2D map_base_colour;
#include "render/shaders/cut_out.glsl"
layout(location = 0) in vec3 in_metric;  // g_uu, g_uv, g_vv: mm^2 per unit^2
layout(location = 1) flat in uint in_chart;
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_colour;
layout(location = 0) out vec4 out_stretch;
void main() {
  // g^-1 = 1/det [g_vv, -g_uv; -g_uv, g_uu] = L L^T,  L = [a 0; b c].
  const float det = max(in_metric.x * in_metric.z - in_metric.y * in_metric.y, 1e-12);
  const float a = sqrt(in_metric.z / det);
  const float b = -in_metric.y / (det * a);
  const float c = sqrt(max(in_metric.x / det - b * b, 0.0));
  out_stretch = vec4(round_to_half(clamp(vec3(a, b, c) * 1000.0, vec3(-65000.0), vec3(65000.0))),
                     cut_out && is_cut(in_uv, in_colour) ? 0.0 : float(in_chart));
}
