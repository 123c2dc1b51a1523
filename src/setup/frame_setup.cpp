// SPDX-License-Identifier: MIT
#include "setup/frame_setup.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/assert.h"
#include "core/error.h"
#include "core/log.h"
#include "passes/blur/blur.h"
#include "passes/final_pass/final_pass.h"
#include "passes/shadow/fit.h"
#include "scene/framing.h"
#include "setup/choose.h"
#include "setup/frame_camera.h"
#include "techniques/memory.h"

namespace dermis::setup {
namespace {

// Returns the number that shaders know a type by. No default: a new type without one is a warning here.
std::uint32_t type_number(scene::LightType type) {
  switch (type) {
    case scene::LightType::directional: return LIGHT_DIRECTIONAL;
    case scene::LightType::spot: return LIGHT_SPOT;
    case scene::LightType::point: return LIGHT_POINT;
  }
  assertion_failed("a light has a LightType", fmt::format("{}", static_cast<int>(type)), __FILE__, __LINE__);
}

io::LightIo light_io(const scene::Light& light, const passes::ShadowFit& fit, std::size_t first_layer) {
  io::LightIo out{};
  out.colour = light.colour;
  out.type = type_number(light.type);
  out.position_m = light.position_m;
  out.range_m = light.range_m;
  out.direction = light.direction;
  out.cos_inner = std::cos(light.inner_cone_rad);
  out.cos_outer = std::cos(light.outer_cone_rad);
  out.shadow_layer = static_cast<std::uint32_t>(first_layer);
  out.shadow_layers = static_cast<std::uint32_t>(fit.shadow_from_world.size());
  out.shadow_texel = fit.texel;
  out.radius = light.radius;
  return out;
}

// Far to near, so that what is blended is drawn over what lies behind it.
std::vector<HeadSetup> set_up_heads(const Subject& subject, const RenderSettings& s,
                                    const scene::Camera& camera, const io::CameraIo& frame_camera,
                                    const std::vector<scene::Light>& lights) {
  std::vector<HeadSetup> heads;
  const bool skip = s.quality.skip_unseen_heads.value_or(s.quality.cull || s.quality.depth || s.quality.clip);

  for (const glm::vec3& offset : scene::head_row_offsets(s.camera.heads, subject.sphere.radius_m)) {
    HeadSetup head{
        .number = static_cast<int>(heads.size()), .offset_m = offset, .lights = {}, .shadow_from_world = {}};
    for (const scene::Light& light : lights) {
      const passes::ShadowFit fit = passes::fit_shadow(
          light, {subject.casters.centre_m + offset, subject.casters.radius_m}, s.quality.shadow_size);
      head.lights.push_back(light_io(light, fit, head.shadow_from_world.size()));
      head.shadow_from_world.insert(head.shadow_from_world.end(), fit.shadow_from_world.begin(),
                                    fit.shadow_from_world.end());
    }
    head.map_side = map_side(subject, s, camera, offset);
    head.visible = !skip || in_view(subject, frame_camera, offset);
    heads.push_back(std::move(head));
  }

  const auto distance = [&](const HeadSetup& head) {
    return glm::distance(subject.sphere.centre_m + head.offset_m, frame_camera.eye_m);
  };
  std::stable_sort(heads.begin(), heads.end(),
                   [&](const HeadSetup& a, const HeadSetup& b) { return distance(a) > distance(b); });
  return heads;
}

// Heads of one batch have sets of shadow maps one after the other.
void place_shadows(std::vector<HeadSetup>& heads, const techniques::FrameSettings& plan) {
  for (std::uint32_t i = 0; i < heads.size(); ++i) {
    heads[i].first_shadow_layer = i % plan.heads_per_batch * plan.shadow_layers;
    for (io::LightIo& light : heads[i].lights) light.shadow_layer += heads[i].first_shadow_layer;
  }
}

// Whether a twentieth of the skin has so few texels that terms are lit at the pixel there.
void fill_coarse(techniques::SkinPart& part, const scene::UnwrapDensity& density, double map_size) {
  if (!(density.uv_per_mm.mean > 0) || !(density.area_mm2 > 0)) return;
  part.even_uv_per_mm = 1 / std::sqrt(density.area_mm2);
  part.least_texels_per_mm = density.uv_per_mm.p05 * map_size;
  const double widest_mm = std::sqrt(part.profile.max_variance_mm2());
  part.coarse = passes::is_coarse(static_cast<float>(widest_mm), static_cast<float>(part.least_texels_per_mm),
                                  static_cast<float>(part.even_uv_per_mm * map_size));
}

techniques::SkinPart skin_part(const Subject& subject, std::size_t number, const RenderSettings& s) {
  techniques::SkinPart part;
  const auto material = static_cast<std::size_t>(subject.skin[number].triangle_material.front());
  part.profile = choose_profile(subject.scene->materials[material], s);
  // The 95 % quantile: a few crumpled triangles may be denser; there the first step is a little coarse, not
  // wrong in width.
  part.max_uv_per_mm = subject.densities[number].largest_uv_per_mm.p95;
  part.max_texels_per_mm = std::max(part.max_uv_per_mm * s.quality.map_size, 1e-6);
  part.off_map = scene::has_chartless(subject.skin[number]);
  fill_coarse(part, subject.densities[number], s.quality.map_size);
  part.mean_texels_per_mm = subject.densities[number].uv_per_mm.mean * s.quality.map_size;
  for (const int index : subject.skin[number].triangle_material) {
    const scene::Material& of_triangle = subject.scene->materials[static_cast<std::size_t>(index)];
    part.cut_out = part.cut_out || of_triangle.alpha_mode == scene::AlphaMode::mask;
    part.emits = part.emits || of_triangle.emissive != glm::vec3(0);
  }
  return part;
}

constexpr double default_squares = 4;

// How many squares of T_max, one per head and skin mesh, the pool of light maps holds.
double squares_in_budget(std::uint64_t square_bytes, const RenderSettings& s, const DeviceTraits& device) {
  const double square_mb = static_cast<double>(square_bytes) / 1e6;
  double budget_mb = default_squares * square_mb;
  if (device.memory_bytes > 0)
    budget_mb = std::min(budget_mb, std::max(square_mb, static_cast<double>(device.memory_bytes) / 4e6));
  if (s.quality.map_budget_mb) budget_mb = *s.quality.map_budget_mb;
  if (budget_mb < square_mb)
    throw input_error("",
                      "quality.map_budget_mb {} does not hold the light maps of one head: at "
                      "quality.map_size {} they take {:.0f} MB",
                      budget_mb, s.quality.map_size, std::ceil(square_mb));

  // As many rows and columns of squares as a texture of this device can have.
  const double rows =
      std::max<double>(1, device.max_image_side / static_cast<std::uint32_t>(s.quality.map_size));
  return std::clamp(std::floor(budget_mb / square_mb * (1 + 1e-12)), 1.0, rows * rows);
}

// As many heads as the pool holds at a time; of a head with more skin meshes than that, as many meshes. Only
// the published baseline uses one set of maps for one head after the other.
void set_up_batches(FrameSetup& setup, const RenderSettings& s, const DeviceTraits& device) {
  techniques::FrameSettings& plan = setup.plan;
  plan.heads_per_batch = 1;
  if (plan.skin.empty() || !setup.technique->has_light_maps) return;

  const techniques::MapMemory memory = techniques::map_memory(*setup.technique, plan);
  const double squares = squares_in_budget(memory.light_maps, s, device);
  const auto meshes = static_cast<double>(plan.skin.size());
  if (squares < meshes) {
    plan.meshes_per_batch = std::bit_floor(static_cast<std::uint32_t>(squares));
    return;
  }
  if (!plan.optimise.any()) return;

  // Their shadow maps come on top; large ones must not drive the heads of a batch out of memory.
  const double shadow_mb = static_cast<double>(memory.shadow_maps) / 1e6;
  const double shadowed = device.memory_bytes > 0
                              ? std::max(1.0, static_cast<double>(device.memory_bytes) / 4e6 / shadow_mb)
                              : squares;
  plan.heads_per_batch = static_cast<std::uint32_t>(
      std::clamp(std::floor(squares / meshes), 1.0, std::min(64.0, std::floor(shadowed))));
}

// From a measurement on each kind of device, docs/measuring.md; never from one at run time, or frames would
// not be bit-equal.
passes::SkipUnlit choose_skip_unlit(const RenderSettings& s, const DeviceTraits& device) {
  if (!s.quality.mask) return device.software ? passes::SkipUnlit::by_depth : passes::SkipUnlit::by_tiles;
  switch (*s.quality.mask) {
    case BlurMask::alpha: return passes::SkipUnlit::by_alpha;
    case BlurMask::depth: return passes::SkipUnlit::by_depth;
    case BlurMask::tiles: break;
  }
  return passes::SkipUnlit::by_tiles;
}

// Whether light enters whole wherever it falls on something: skin whose whole albedo acts after scattering.
// What is blended casts no shadow.
bool all_enters(const scene::Scene& scene, const RenderSettings& s) {
  return std::all_of(scene.primitives.begin(), scene.primitives.end(), [&](const scene::Primitive& p) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(p.material)];
    if (material.alpha_mode == scene::AlphaMode::blend) return true;
    const auto of_material = static_cast<double>(material.skin_settings.mix_or_default());
    return material.skin && s.skin.mix.value_or(of_material) == 0;
  });
}

void set_up_plan(FrameSetup& setup, const Subject& subject, const RenderSettings& s,
                 const std::vector<scene::Light>& lights, const DeviceTraits& device) {
  const scene::Scene& scene = *subject.scene;
  techniques::FrameSettings& plan = setup.plan;

  plan.width = static_cast<std::uint32_t>(s.output.width);
  plan.height = static_cast<std::uint32_t>(s.output.height);
  plan.samples = static_cast<std::uint32_t>(s.quality.samples);
  plan.map_size = static_cast<std::uint32_t>(s.quality.map_size);
  plan.shadow_size = static_cast<std::uint32_t>(s.quality.shadow_size);
  plan.heads = static_cast<std::uint32_t>(s.camera.heads);
  plan.shadow_layers =
      static_cast<std::uint32_t>(std::max<std::size_t>(setup.heads.front().shadow_from_world.size(), 1));
  plan.bloom = static_cast<float>(s.output.bloom);
  plan.tone_map = s.output.tone_map;
  plan.visibility = s.output.show == "visibility";
  plan.environment = !s.lighting.environment.empty();
  plan.soft_shadows =
      std::any_of(lights.begin(), lights.end(), [](const scene::Light& light) { return light.radius > 0; });

  if (setup.technique->has_light_maps) {
    plan.optimise = {.cull = s.quality.cull, .depth = s.quality.depth, .clip = s.quality.clip};
    plan.skip_unlit = choose_skip_unlit(s, device);
    plan.progressive = s.quality.maps == LightMaps::progressive;
    plan.translucency = s.skin.translucency && !subject.skin.empty() && setup.lights > 0;
    plan.all_enters = all_enters(scene, s);
    plan.mm_per_unit = scene.mm_per_unit;
  }

  for (std::size_t i = 0; i < subject.skin.size(); ++i) {
    plan.skin.push_back(skin_part(subject, i, s));
    setup.gaussians = std::max(setup.gaussians, static_cast<int>(plan.skin.back().profile.terms.size()));
  }
  if (!setup.technique->uses_profile) setup.gaussians = 0;

  // Note whether there is anything beside skin, blended or not.
  for (const scene::Primitive& p : scene.primitives) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(p.material)];
    if (material.skin) continue;
    (material.alpha_mode == scene::AlphaMode::blend ? plan.has_blended : plan.has_surfaces) = true;
  }

  set_up_batches(setup, s, device);
}

// Light from just outside the picture still arrives: as far as the widest Gaussian reaches.
double clip_margin_m(const FrameSetup& setup, const Subject& subject, const RenderSettings& s) {
  double reach_mm = 0;
  for (const techniques::SkinPart& part : setup.plan.skin)
    reach_mm = std::max(reach_mm, 3 * std::sqrt(part.profile.max_variance_mm2()));
  return s.quality.clip_margin_mm.value_or(reach_mm) / subject.scene->mm_per_unit;
}

}  // namespace

void warn_coarse(const Subject& subject, const FrameSetup& setup) {
  const techniques::SkinPart* worst = nullptr;
  for (const techniques::SkinPart& part : setup.plan.skin)
    if (part.coarse && (!worst || part.least_texels_per_mm < worst->least_texels_per_mm)) worst = &part;
  if (!worst || !setup.technique->has_light_maps) return;

  const auto number = static_cast<std::size_t>(worst - setup.plan.skin.data());
  const double lost_mm =
      std::min(0.3 / worst->least_texels_per_mm, std::sqrt(worst->profile.max_variance_mm2()));
  warn(
      "{}: a part of skin '{}' has {:.2g} texels per mm of light map or fewer: Gaussians narrower than about "
      "{:.2g} mm do not scatter there. A larger quality.map_size holds them, or texture coordinates that "
      "fill more "
      "of the square",
      subject.scene->name, subject.skin[number].name, worst->least_texels_per_mm, lost_mm);
}

std::vector<std::uint32_t> sides_of_drawn_heads(const FrameSetup& setup) {
  std::vector<std::uint32_t> sides;
  for (const HeadSetup& head : setup.heads)
    if (head.visible) sides.push_back(static_cast<std::uint32_t>(head.map_side));
  return sides;
}

FrameSetup set_up(const Subject& subject, const RenderSettings& s, const DeviceTraits& device,
                  const std::vector<scene::Light>& environment_lights) {
  FrameSetup setup;
  setup.technique = &techniques::find_technique(s.technique);

  const scene::Camera camera = choose_camera(*subject.scene, s, subject.sphere);
  setup.frame.camera = frame_camera(camera, static_cast<double>(s.output.width) / s.output.height);
  setup.d_ref = reference_distance(subject, s, camera);

  const std::vector<glm::vec3> offsets = scene::head_row_offsets(s.camera.heads, subject.sphere.radius_m);
  std::vector<scene::Light> lights = choose_lights(*subject.scene, s, subject.sphere, offsets);
  lights.insert(lights.end(), environment_lights.begin(), environment_lights.end());
  setup.lights = static_cast<int>(lights.size());
  setup.environment_lights = static_cast<int>(environment_lights.size());
  setup.heads = set_up_heads(subject, s, camera, setup.frame.camera, lights);
  set_up_plan(setup, subject, s, lights, device);
  place_shadows(setup.heads, setup.plan);

  io::FrameIo& frame = setup.frame;
  frame.clip_margin_m = static_cast<float>(clip_margin_m(setup, subject, s));
  frame.radiance_scale = static_cast<float>(std::exp2(s.output.exposure_ev.value_or(0)));
  frame.ambient = glm::vec3(static_cast<float>(s.lighting.ambient));
  frame.light_count = static_cast<std::uint32_t>(lights.size());
  frame.specular_on = s.lighting.specular ? 1 : 0;
  frame.white_albedo = s.lighting.white_albedo ? 1 : 0;
  return setup;
}

}  // namespace dermis::setup
