// SPDX-License-Identifier: MIT
// The stretch map, [DLE07] GPU Gems 3, ch. 14.4.2: how far a length on the skin
// reaches on the map. The paper has two lengths, along u and v. Here it is the Cholesky factor of the inverse
// metric, because u and v are far from perpendicular on unwraps of heads (median |cos| 0.35 on the scan). Per
// metre, so that a half float holds heads and giants alike. Alpha: the number of the chart.
#version 460
#include "render/shaders/half.glsl"
layout(location = 0) in vec3 in_metric;  // g_uu, g_uv, g_vv: mm^2 per unit^2
layout(location = 1) flat in uint in_chart;
layout(location = 0) out vec4 out_stretch;

void main() {
  // g^-1 = 1/det [g_vv, -g_uv; -g_uv, g_uu] = L L^T,  L = [a 0; b c].
  const float det = max(in_metric.x * in_metric.z - in_metric.y * in_metric.y, 1e-12);
  const float a = sqrt(in_metric.z / det);
  const float b = -in_metric.y / (det * a);
  const float c = sqrt(max(in_metric.x / det - b * b, 0.0));
  out_stretch =
      vec4(round_to_half(clamp(vec3(a, b, c) * 1000.0, vec3(-65000.0), vec3(65000.0))), float(in_chart));
}
