// SPDX-License-Identifier: MIT
#version 460
#include "render/shared/scene_io.h"
#include "render/shaders/vertex_pull.glsl"
#include "render/shaders/skin_vertex.glsl"
#include "render/shaders/placement.glsl"
#include "render/shaders/head.glsl"
#include "render/shaders/frame.glsl"
#include "render/passes/pixels/labels/labels_io.h"
layout(constant_id = 0) const bool skin = false;
layout(constant_id = 3) const bool body = false;  // LabelVertices are there
layout(binding = 34, scalar) readonly buffer LabelVertices { LabelVertexIo label_vertices[]; };
layout(binding = 36, scalar) readonly buffer BeforePositions { vec3 before_m[]; };
layout(binding = 37, scalar) readonly buffer BeforePlacements { PlacementIo before_placements[]; };
layout(binding = 38, scalar) uniform Before { LabelsBeforeIo before; };
layout(location = 0) out vec3 out_position_m;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_uv;
layout(location = 3) out vec4 out_colour;
layout(location = 4) out vec2 out_part;
layout(location = 5) out vec4 out_clip;
layout(location = 6) out vec4 out_clip_before;
layout(location = 7) out vec4 out_body;  // unwrap, thickness in mm, how far on the left
layout(location = 8) out vec4 out_face;  // LabelVertexIo
layout(location = 9) flat out uint out_kind;

// The same products and sums for both frames: what stands still has a motion of 0 exactly.
vec4 clip_at(mat4 clip_from_world, SimilarityIo s, PlacementIo placement, vec3 position_m) {
  return clip_position(clip_from_world, world_position(s, placed_position(placement, position_m)));
}

void main() {
  const VertexIo v = placed_vertex();
  out_position_m = world_position(v.position_m);
  out_normal = world_direction(v.normal);
  const VertexExtraIo extra = vertex_extra(gl_VertexIndex);
  out_uv = vec4(v.uv0, extra.uv1);
  out_colour = extra.colour;
  out_part = vec2(-1.0);
  out_body = vec4(0.0);
  out_face = vec4(-1.0);
  out_kind = 0u;
  if (skin) out_body.xy = unwrap_of(gl_VertexIndex);
  if (body) {
    const LabelVertexIo label = label_vertices[gl_VertexIndex];
    out_kind = label.kind;
    if (skin) {
      out_part = label.part;
      out_body.z = label.thickness_mm * WORLD_FROM_ASSET.scale;
      out_body.w = label.left;
      out_face = label.face;
    }
  }

  const vec3 now_m = vertex_position(gl_VertexIndex);
  // Not by a uniform alone: render/shaders/switches.glsl says why. No vertex has a number below 0.
  const bool moved = before.moved > (gl_VertexIndex < 0 ? 1u : 0u);
  const vec3 then_m = moved ? before_m[gl_VertexIndex] : now_m;
  out_clip = clip_at(frame.camera.clip_from_world, WORLD_FROM_ASSET, placements[gl_InstanceIndex], now_m);
  out_clip_before =
      clip_at(before.clip_from_world, before.world_from_asset, before_placements[gl_InstanceIndex], then_m);
  gl_Position = frame.camera.clip_from_world * vec4(out_position_m, 1.0);
}
