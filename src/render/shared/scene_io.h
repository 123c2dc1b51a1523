// SPDX-License-Identifier: MIT
// The scene as shaders read it: vertices, materials, lights, camera.
#ifndef DERMIS_SHARED_SCENE_IO_H
#define DERMIS_SHARED_SCENE_IO_H
#include "render/shared/types.h"

DERMIS_IO_BEGIN

// A vertex in three parts. Few passes need all of them, and only the first moves.
struct VertexIo {
  vec3 position_m;
  vec3 normal;
  vec4 tangent;  // w = handedness
  vec2 uv0;
};

// One for all vertices of a buffer if they are equal, as they mostly are.
struct VertexExtraIo {
  vec4 colour;
  vec2 uv1;
  vec2 unused;  // whole texels
};

struct SkinVertexIo {
  vec2 unwrap;            // texture coordinates of the light maps, 0..1, v down
  vec3 metric_mm2;        // g_uu, g_uv, g_vv: mm^2 per unit of unwrap squared
  uint chart;             // of all triangles at this vertex; 0: they have none
  uint curvature_per_mm;  // mean of both principal curvatures, half their difference: two half floats
  uint body_mm;           // thickness, and distance to the nearest open border: two half floats
                          // (all 0 until a profile asks for them)
};

struct MapIo {
  vec2 u_axis, v_axis, offset;  // uv' = u_axis * u + v_axis * v + offset
  uint uv_set;
  uint channel;
  float scale;
  uint present;
};

// Indices into MaterialIo::maps and the order of the texture bindings.
#define MAP_BASE_COLOUR 0
#define MAP_NORMAL 1
#define MAP_ROUGHNESS 2  // skin: roughness; others: metallic-roughness (G, B)
#define MAP_OCCLUSION 3
#define MAP_SPECULAR 4
#define MAP_EMISSIVE 5
#define MAP_SPECULAR_COLOUR 6  // skin has no such map: it has
#define MAP_DETAIL 6           // a tile of normals finer than MAP_NORMAL
#define MAP_COUNT 7

#define MATERIAL_DOUBLE_SIDED 1u
#define MATERIAL_UNLIT 2u
#define MATERIAL_ALPHA_MASK 4u
#define MATERIAL_ALPHA_BLEND 8u

struct MaterialIo {
  vec4 base_colour;
  vec3 emissive;
  float metallic;
  float roughness;  // glTF; m = roughness^2
  float ior;
  float specular;
  float alpha_cutoff;
  float transmission;  // part of what is not reflected that passes
  vec3 specular_colour;
  uint flags;
  float mix_before;  // exponent of the albedo that is applied before light scatters
  float rho_s;       // scale of the specular of skin
  float lobe_factor_0, lobe_weight_0;
  float lobe_factor_1, lobe_weight_1;
  MapIo maps[MAP_COUNT];
};

#define LIGHT_DIRECTIONAL 0u
#define LIGHT_SPOT 1u
#define LIGHT_POINT 2u

#define LIGHT_TEXELS 5  // of 16 bytes, as light_at() of lights.glsl reads them
struct LightIo {
  vec3 colour;  // intensity included: irradiance facing the light is colour (directional) or colour / d^2
  uint type;
  vec3 position_m;
  float range_m;   // 0 = unlimited
  vec3 direction;  // direction in which light travels
  float cos_inner;
  float cos_outer;
  uint shadow_layer;   // first layer in the shadow map
  uint shadow_layers;  // 0 = casts none, 1, or 6 for a point light inside the scene
  float shadow_texel;  // side of a shadow texel: m (directional) or m per m of distance
  float radius;        // of the light: m; directional: tangent of its angular radius
  float shadow_side;   // of the map, in the corner of its layer, texels
  vec2 unused;         // whole texels
};

// Where the lights of a head lie among the texels of Lamps, 16 bytes each. They are LightIo[], and mat4[] for
// the layers of the shadow maps, of which a head has those from its first on.
struct LampsIo {
  int lights, shadow_matrices;  // the texel of number 0
};

struct CameraIo {
  mat4 clip_from_world;
  vec3 eye_m;
  uint orthographic;
  vec3 direction;  // unit, where it looks
  // Of the picture: left, right, bottom, top, near. dot(xyz, position_m) + w is the distance inside, metres.
  vec4 planes[5];
};

struct FrameIo {
  CameraIo camera;
  uvec2 picture_low, picture_size;  // the part of its targets that the camera sees, pixels
  float clip_margin_m;              // light maps keep skin that is no further outside the planes than this
  float radiance_scale;             // 2^EV, applied before anything is stored in half floats
  vec3 ambient;                     // uniform radiance from everywhere
  uint light_count;
  uint specular_on;
  uint white_albedo;  // tests: every albedo is 1
  float environment_intensity;
  float environment_cos, environment_sin;  // of the angle by which the environment is turned about +Y
  vec3 environment_irradiance[9];          // environment::Irradiance times the intensity
};

// Place of an instance of an asset in the world: turned, scaled, then moved.
struct SimilarityIo {
  vec3 x_axis, y_axis, z_axis;  // unit: images of the asset's axes
  vec3 origin_m;                // image of its origin
  float scale;                  // > 0
};
// Data that differ from head to head, in one buffer: devices may have no more than 32 bindings.
struct HeadIo {
  SimilarityIo world_from_asset;
  LampsIo lamps;
};

DERMIS_IO_END

#ifdef __cplusplus
static_assert(sizeof(dermis::io::VertexIo) == 12 * 4);
static_assert(sizeof(dermis::io::VertexExtraIo) == 8 * 4);
static_assert(sizeof(dermis::io::SkinVertexIo) == 8 * 4);
static_assert(sizeof(dermis::io::MapIo) == 40);
static_assert(sizeof(dermis::io::LightIo) == 16 * LIGHT_TEXELS);
static_assert(sizeof(dermis::io::SimilarityIo) == 13 * 4);
#endif
#endif
