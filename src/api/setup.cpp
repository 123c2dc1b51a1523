// SPDX-License-Identifier: MIT
#include "api/setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "gaussians/json.h"
#include "gaussians/known.h"
#include "passes/blur/blur.h"
#include "passes/shadow/fit.h"
#include "scene/coverage.h"
#include "scene/framing.h"

namespace dermis::api {
namespace {

template <class T>
void require(const char* name, T value, T low, T high, const char* unit) {
  if (!(value >= low && value <= high)) throw input_error("", "--{} must be {} to {}{}, got {}", name, low, high, unit, value);
}

scene::Camera find_camera(const scene::Scene& scene, const RenderSettings& s, const scene::BoundingSphere& sphere) {
  const double aspect = static_cast<double>(s.width) / s.height;
  const double fov = s.fov_deg.value_or(20);
  if (s.distance) return scene::distance_camera(sphere, *s.distance, fov);
  const auto with_fov = [&](scene::Camera camera) {
    if (s.fov_deg) camera.fov_y_rad = static_cast<float>(fov * std::numbers::pi / 180);
    return camera;
  };
  if (!s.camera.empty()) {
    std::string names;
    for (const scene::Camera& camera : scene.cameras) {
      if (camera.name == s.camera) return with_fov(camera);
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", camera.name);
    }
    throw input_error("", "--camera '{}' is not in {}; {}", s.camera, scene.name,
                      names.empty() ? "it has no cameras" : "there are: " + names);
  }
  const bool orbits = s.orbit_deg != std::array<double, 2>{0, 0};
  if (!scene.cameras.empty() && !orbits && s.heads == 1) return with_fov(scene.cameras.front());
  return scene::framing_camera(sphere, aspect, s.orbit_deg[0], s.orbit_deg[1], fov);
}

// Reversed depth without a far plane (glTF allows one; nothing here needs it): clip z = near, w = -z_view.
glm::mat4 projection(const scene::Camera& camera, double aspect) {
  glm::mat4 p(0);
  if (camera.orthographic) {
    const float far_m = camera.zfar_m.value_or(1000.0f), near_m = camera.znear_m;
    p[0][0] = 1 / (camera.ymag_m * static_cast<float>(aspect));
    p[1][1] = 1 / camera.ymag_m;
    p[2][2] = 1 / (far_m - near_m);
    p[3][2] = far_m / (far_m - near_m);
    p[3][3] = 1;
    return p;
  }
  const float f = 1 / std::tan(camera.fov_y_rad / 2);
  p[0][0] = f / static_cast<float>(aspect);
  p[1][1] = f;
  p[3][2] = camera.znear_m;
  p[2][3] = -1;
  return p;
}

io::LightIo light_io(const scene::Light& light, const passes::ShadowFit& fit, std::size_t first_layer) {
  io::LightIo out{};
  out.colour = light.colour;
  out.type = light.type == scene::LightType::directional ? LIGHT_DIRECTIONAL
             : light.type == scene::LightType::spot      ? LIGHT_SPOT
                                                         : LIGHT_POINT;
  out.position_m = light.position_m;
  out.range_m = light.range_m;
  out.direction = light.direction;
  out.cos_inner = std::cos(light.inner_cone_rad);
  out.cos_outer = std::cos(light.outer_cone_rad);
  out.shadow_layer = static_cast<std::uint32_t>(first_layer);
  out.shadow_layers = static_cast<std::uint32_t>(fit.shadow_from_world.size());
  out.shadow_texel = fit.texel;
  return out;
}

// The casters' sphere, not only the skin's: hair cards and collars cast shadows too.
scene::BoundingSphere caster_sphere(const scene::Scene& scene) {
  std::vector<glm::vec3> points;
  for (const scene::Primitive& p : scene.primitives)
    for (const scene::Vertex& v : p.vertices) points.push_back(v.position_m);
  return scene::bounding_sphere(points);
}

std::vector<HeadSetup> set_up_heads(const scene::Scene& scene, const RenderSettings& s, const FrameSetup& setup,
                                    const std::vector<scene::Light>& lights, const glm::vec3& eye_m) {
  const scene::BoundingSphere casters = caster_sphere(scene);
  std::vector<HeadSetup> heads;
  for (const glm::vec3& offset : scene::head_row_offsets(s.heads, setup.sphere.radius_m)) {
    HeadSetup head{.offset_m = offset, .lights = {}, .shadow_from_world = {}};
    for (const scene::Light& light : lights) {
      const passes::ShadowFit fit = passes::fit_shadow(light, {casters.centre_m + offset, casters.radius_m}, s.shadow_size);
      head.lights.push_back(light_io(light, fit, head.shadow_from_world.size()));
      head.shadow_from_world.insert(head.shadow_from_world.end(), fit.shadow_from_world.begin(), fit.shadow_from_world.end());
    }
    heads.push_back(std::move(head));
  }
  const auto distance = [&](const HeadSetup& head) { return glm::distance(setup.sphere.centre_m + head.offset_m, eye_m); };
  std::stable_sort(heads.begin(), heads.end(), [&](const HeadSetup& a, const HeadSetup& b) { return distance(a) > distance(b); });
  return heads;
}

techniques::SkinPart skin_part(const scene::Scene& scene, const scene::SkinMesh& mesh, const RenderSettings& s) {
  techniques::SkinPart part;
  const scene::SkinSettings& material = scene.materials[static_cast<std::size_t>(mesh.triangle_material.front())].skin_settings;
  part.profile =
      !s.profile.empty() ? gaussians::from_name_or_file(s.profile, s.normalise_profile) : material.profile.value_or(gaussians::skin_six());
  // The 95 % quantile: a few crumpled triangles may be denser; there the first step is a little coarse, not wrong in width.
  part.max_texels_per_mm = std::max(scene::unwrap_density(mesh, scene.mm_per_unit).largest_texels_per_mm.p95 * s.map_size, 1e-6);
  part.gutter_texels = passes::gutter_width(part.profile, part.max_texels_per_mm);
  return part;
}

// [JG08] sec. 4: the distance at which the map at T_max has one texel a pixel, from the mean density of the unwrap.
double reference_distance(const scene::Scene& scene, const FrameSetup& setup, const RenderSettings& s, double fov_y_rad) {
  if (setup.skin.empty() || setup.sphere.radius_m <= 0) return 0;
  const double texels_per_mm = scene::unwrap_density(setup.skin.front(), scene.mm_per_unit).texels_per_mm.mean * s.map_size;
  // pixels per mm at distance d (mm) = (height / 2) / (d tan(fov / 2)).
  const double d_mm = s.height / 2.0 / (texels_per_mm * std::tan(fov_y_rad / 2));
  return d_mm / (setup.sphere.radius_m * scene.mm_per_unit);
}

passes::ViewTransform view_transform(const std::string& name) {
  if (name == "filmic") return passes::ViewTransform::filmic;
  if (name == "srgb") return passes::ViewTransform::srgb;
  if (name == "linear") return passes::ViewTransform::linear;
  throw input_error("", "--view '{}' is not known; there are: filmic, srgb, linear", name);
}

void set_up_plan(FrameSetup& setup, const scene::Scene& scene, const RenderSettings& s) {
  techniques::FrameSettings& plan = setup.plan;
  plan.width = static_cast<std::uint32_t>(s.width);
  plan.height = static_cast<std::uint32_t>(s.height);
  plan.samples = static_cast<std::uint32_t>(s.samples);
  plan.map_size = static_cast<std::uint32_t>(s.map_size);
  plan.shadow_size = static_cast<std::uint32_t>(s.shadow_size);
  plan.heads = static_cast<std::uint32_t>(s.heads);
  plan.shadow_layers = static_cast<std::uint32_t>(std::max<std::size_t>(setup.heads.front().shadow_from_world.size(), 1));
  plan.bloom = static_cast<float>(s.bloom);
  plan.view = view_transform(s.view);
  for (const scene::SkinMesh& mesh : setup.skin) {
    plan.skin.push_back(skin_part(scene, mesh, s));
    setup.gaussians = std::max(setup.gaussians, static_cast<int>(plan.skin.back().profile.terms.size()));
  }
  if (!setup.technique->scatters) setup.gaussians = 0;
  for (const scene::Primitive& p : scene.primitives) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(p.material)];
    if (material.skin && p.has_uv) continue;
    (material.alpha_mode == scene::AlphaMode::blend ? plan.has_blended : plan.has_surfaces) = true;
  }
}

}  // namespace

void check_settings(const RenderSettings& s) {
  techniques::find_technique(s.technique);
  if (s.width < 1 || s.height < 1 || s.width > 65536 || s.height > 65536)
    throw input_error("", "--size must be 1x1 to 65536x65536 pixels, got {}x{}", s.width, s.height);
  require("map-size", s.map_size, 32, 65536, " texels");
  require("shadow-size", s.shadow_size, 32, 65536, " texels");
  if (s.samples != 1 && s.samples != 4) throw input_error("", "--samples must be 1 or 4, got {}", s.samples);
  if (s.fov_deg) require("fov", *s.fov_deg, 0.1, 170.0, " degrees");
  if (s.distance) require("distance", *s.distance, 1e-3, 1e6, " radii");
  require("heads", s.heads, 1, 1024, "");
  if (s.lights) require("lights", *s.lights, 0, 64, "");
  require("ambient", s.ambient, 0.0, 1e6, "");
  if (s.mix) require("mix", *s.mix, 0.0, 1.0, "");
  require("bloom", s.bloom, 0.0, 1.0, "");
  require("exposure", s.exposure_ev, -64.0, 64.0, " EV");
  require("frames", s.frames, 1, 1'000'000, "");
  for (const double angle : s.orbit_deg) require("orbit", angle, -3600.0, 3600.0, " degrees");
}

FrameSetup set_up(const scene::Scene& scene, const RenderSettings& s) {
  check_settings(s);
  FrameSetup setup;
  setup.technique = &techniques::find_technique(s.technique);
  setup.skin = scene::skin_meshes(scene);
  for (const scene::SkinMesh& mesh : setup.skin) scene::warn_overlap(mesh);
  setup.sphere = scene::skin_sphere(scene);
  if (!(setup.sphere.radius_m > 0)) throw input_error(scene.name, "has nothing to see: all its triangles lie at one point");
  const scene::Camera camera = find_camera(scene, s, setup.sphere);
  const glm::vec3 eye_m(camera.world_from_camera[3]);

  const std::vector<glm::vec3> offsets = scene::head_row_offsets(s.heads, setup.sphere.radius_m);
  const bool rig = s.lights || scene.lights.empty();
  const std::vector<scene::Light> lights =
      rig ? (s.lights.value_or(2) == 0 ? std::vector<scene::Light>{} : scene::light_rig(setup.sphere, s.lights.value_or(2), offsets))
          : scene.lights;
  setup.lights = static_cast<int>(lights.size());
  setup.heads = set_up_heads(scene, s, setup, lights, eye_m);
  set_up_plan(setup, scene, s);
  setup.d_ref = reference_distance(scene, setup, s, camera.fov_y_rad);

  io::FrameIo& frame = setup.frame;
  frame.clip_from_world = projection(camera, static_cast<double>(s.width) / s.height) * glm::inverse(camera.world_from_camera);
  frame.eye_m = eye_m;
  frame.radiance_scale = static_cast<float>(std::exp2(s.exposure_ev));
  frame.view_direction = -glm::normalize(glm::vec3(camera.world_from_camera[2]));
  frame.orthographic = camera.orthographic ? 1 : 0;
  frame.ambient = glm::vec3(static_cast<float>(s.ambient));
  frame.light_count = static_cast<std::uint32_t>(lights.size());
  frame.specular_on = s.specular ? 1 : 0;
  frame.white_albedo = s.white_albedo ? 1 : 0;
  return setup;
}

}  // namespace dermis::api
