// SPDX-License-Identifier: MIT
// Light at a point and what its surface does with it: the equations of the real-time shaders in double and
// with shadow rays. Written apart from the shaders on purpose, so that the reference cannot inherit their
// mistakes.
#pragma once

#include <vector>

#include "rays/ray_scene.h"
#include "rays/surface_point.h"
#include "truth/reference/maps.h"
#include "truth/reference/random.h"
#include "truth/reference/settings.h"
#include "truth/reference/specular.h"

namespace dermis::reference {

/// A material with its maps prepared for reading.
struct ShadingMaterial {
  const scene::Material* source = nullptr;
  bool skin = false;
  double mix_before = 0.5;  ///< exponent of the albedo that is applied before light scatters
  MapSlot base_colour, normal, detail, roughness, occlusion, specular, emissive, specular_colour;
};

/// Unshadowed light at a point. glTF's KHR_lights_punctual: inverse square, range window, smooth cone.
struct Arriving {
  glm::dvec3 irradiance{0};  ///< on a surface that faces the light
  glm::dvec3 to_light{0, 0, 1};
  double distance_m = 1e30;
};
Arriving arriving_light(const scene::Light& light, const glm::dvec3& position_m);
/// Returns the light from a random point of a light's disc, which faces the position; all points send equal
/// light.
Arriving arriving_light(const scene::Light& light, const glm::dvec3& position_m, Random& random);

/// Returns the ray from the surface to the light, clear of both; it is empty if t_max_m <= t_min_m.
rays::Ray shadow_ray(const rays::SurfacePoint& s, const Arriving& light);

class Shading {
 public:
  Shading(const rays::RayScene& rays, const RenderSetup& setup);

  const ShadingMaterial& material(std::size_t index) const { return materials_[index]; }
  const rays::RayScene& rays() const { return *rays_; }
  const RenderSetup& setup() const { return setup_; }

  /// Returns the irradiance that enters the skin from all lights and the environment, without what the
  /// surface reflects.
  glm::dvec3 entering_irradiance(const rays::SurfacePoint& s, Random& random) const;
  /// Returns the light that spreads from a point of skin: E albedo^mix / pi; 0 where the alpha test cuts it
  /// away.
  glm::dvec3 light_in_skin(const rays::SurfacePoint& s, Random& random) const;
  /// Returns the radiance that the surface emits.
  glm::dvec3 emitted(const rays::SurfacePoint& s) const;
  /// Returns the factor of scattered light on its way to the camera: albedo^(1 - mix) times what the surface
  /// transmits towards `to_eye`.
  glm::dvec3 leaving_factor(const rays::SurfacePoint& s, const glm::dvec3& to_eye) const;
  /// Returns what the surface of skin reflects towards the camera.
  glm::dvec3 skin_reflection(const rays::SurfacePoint& s, const glm::dvec3& to_eye, Random& random) const;

  /// Other surfaces: glTF metallic-roughness. `normal_side`: +1 seen from the front, -1 from behind.
  struct Surface {
    glm::dvec3 radiance{0};
    double alpha = 1;   ///< coverage; 0 where the alpha test cuts it away
    double passes = 0;  ///< part of the light from behind that passes what is covered
  };
  Surface surface(const rays::SurfacePoint& s, double normal_side, const glm::dvec3& to_eye,
                  Random& random) const;

  /// Returns whether something opaque lies between the point and the light.
  bool shadowed(const rays::SurfacePoint& s, const Arriving& light) const;

 private:
  glm::dvec3 mapped_normal(const ShadingMaterial& m, const rays::SurfacePoint& s,
                           const glm::dvec3& normal) const;
  glm::dvec3 eye_normal(const ShadingMaterial& m, const rays::SurfacePoint& s, const glm::dvec3& normal,
                        const glm::dvec3& to_eye) const;
  glm::dvec3 albedo(const ShadingMaterial& m, const rays::SurfacePoint& s) const;
  SkinSpecular skin_specular(const ShadingMaterial& m, const rays::SurfacePoint& s) const;
  /// Under a picture of the environment: its light that enters skin with the mapped normal n, and what the
  /// lobes reflect of it.
  glm::dvec3 entering_from_environment(const rays::SurfacePoint& s, const glm::dvec3& n,
                                       const SkinSpecular& spec, Random& random) const;
  glm::dvec3 reflected_environment(const rays::SurfacePoint& s, const glm::dvec3& n, const SkinSpecular& spec,
                                   const glm::dvec3& to_eye, Random& random) const;
  /// Returns the radiance that reaches the point from a direction: the environment, or what an occluder
  /// reflects. `bounces`: occluders on the path from the camera so far.
  glm::dvec3 arriving_from(const rays::SurfacePoint& s, const glm::dvec3& direction, Random& random,
                           int bounces) const;
  glm::dvec3 sent_on(const rays::SurfacePoint& s, Random& random, int bounces) const;
  double occlusion(const ShadingMaterial& m, const rays::SurfacePoint& s) const;

  const rays::RayScene* rays_;
  RenderSetup setup_;
  std::vector<ShadingMaterial> materials_;
  ReflectanceTable table_;
};

/// Returns all materials of a scene with their maps; images are shared.
std::vector<ShadingMaterial> shading_materials(const scene::AssetData& scene, std::optional<double> mix);

}  // namespace dermis::reference
