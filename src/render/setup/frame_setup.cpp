// SPDX-License-Identifier: MIT
#include "render/setup/frame_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/log.h"
#include "head/scene/framing.h"
#include "render/passes/screen/screen_surface_io.h"
#include "render/passes/shadow/fit.h"
#include "render/setup/background.h"
#include "render/setup/camera_matrices.h"
#include "render/setup/casters.h"
#include "render/setup/choose.h"
#include "render/setup/frame_camera.h"
#include "render/setup/map_sides.h"
#include "render/setup/models.h"
#include "render/setup/pool.h"
#include "render/shared/entries_io.h"
#include "render/techniques/sides_by_need.h"

namespace dermis::setup {
namespace {

// Returns the number that shaders know a type by. No default: a new type without one is a warning here.
std::uint32_t type_number(LightType type) {
  switch (type) {
    case LightType::directional: return LIGHT_DIRECTIONAL;
    case LightType::spot: return LIGHT_SPOT;
    case LightType::point: return LIGHT_POINT;
  }
  assertion_failed("a light has a LightType", fmt::format("{}", static_cast<int>(type)), __FILE__, __LINE__);
}

io::LightIo light_io(const scene::Light& light, const passes::ShadowFit& fit, int side,
                     std::size_t first_layer) {
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
  out.shadow_side = static_cast<float>(side);
  out.radius = light.radius;
  return out;
}

const HostShadow* host_shadow(const HostSetup* host, std::size_t light) {
  if (!host) return nullptr;
  const auto found = std::find_if(host->shadows.begin(), host->shadows.end(),
                                  [&](const HostShadow& shadow) { return shadow.light == light; });
  return found == host->shadows.end() ? nullptr : &*found;
}

bool is_deformed(const HostSetup* host, const passes::Head& head) {
  return host &&
         std::find(host->deformed.begin(), host->deformed.end(), head.instance) != host->deformed.end();
}

// Returns the side of the shadow maps of a head. Finer ones are not seen: at these the error against ground
// truth no longer falls (docs/notes/techniques.md). A layer that is shown is drawn whole. A head that moves
// counts with the size of its rest, so that only its distance changes the side.
std::uint32_t shadow_side(const passes::ShadowBounds& bounds, const RenderSettings& s,
                          const scene::Camera& camera) {
  constexpr double texels_per_pixel = 3;
  const auto most = static_cast<std::uint32_t>(s.quality.shadow_size);
  if (s.output.show.starts_with("shadow")) return most;
  scene::BoundingSphere sphere = bounds.sphere;
  if (bounds.rest) sphere.radius_m = bounds.rest->sphere.radius_m;
  return techniques::side_of(texels_per_pixel * pixels_across(sphere, s, camera), most);
}

// Returns the instances, or the row of camera.heads of a single one.
std::vector<passes::Head> placed_heads(const PlacedScene& scene, const RenderSettings& s) {
  std::vector<passes::Head> heads;
  const auto add = [&](const scene::Similarity& world_from_asset, std::size_t instance) -> passes::Head& {
    passes::Head& head = heads.emplace_back();
    head.number = static_cast<std::uint32_t>(heads.size() - 1);
    head.instance = instance;
    head.world_from_asset = world_from_asset;
    return head;
  };
  if (s.camera.heads == 1) {
    for (const PlacedInstance& instance : scene.instances) add(instance.world_from_asset, heads.size());
    return heads;
  }

  if (scene.instances.size() > 1)
    throw input_error("", "camera.heads must be 1 for a scene of {} instances, got {}",
                      scene.instances.size(), s.camera.heads);
  const PlacedInstance& one = scene.instances.front();
  const float radius_m = one.world_from_asset.sphere(one.asset->bounds.sphere).radius_m;
  for (const glm::vec3& offset : scene::head_row_offsets(s.camera.heads, radius_m))
    add(one.world_from_asset, 0).world_from_asset.origin_m += offset;
  return heads;
}

// Fits the shadow maps of a head, which are as large as it shows.
void set_up_shadows(passes::Head& head, const std::vector<scene::Light>& lights,
                    const passes::ShadowBounds& bounds, const RenderSettings& s, const scene::Camera& camera,
                    const HostSetup* host) {
  head.shadow_side = shadow_side(bounds, s, camera);
  head.lights.clear();
  head.shadow_from_world.clear();
  head.host_shadows.clear();

  for (std::size_t i = 0; i < lights.size(); ++i) {
    const HostShadow* of_host = host_shadow(host, i);
    const int side = of_host ? s.quality.shadow_size : static_cast<int>(head.shadow_side);
    const passes::ShadowFit fit =
        of_host
            ? passes::ShadowFit{.shadow_from_world = {of_host->shadow_from_world}, .texel = of_host->texel}
            : passes::fit_shadow(lights[i], bounds, side);
    if (of_host) {
      head.host_shadows.resize(head.shadow_from_world.size());
      head.host_shadows.push_back({of_host->depth, of_host->reversed});
    }
    head.lights.push_back(light_io(lights[i], fit, side, head.shadow_from_world.size()));
    head.shadow_from_world.insert(head.shadow_from_world.end(), fit.shadow_from_world.begin(),
                                  fit.shadow_from_world.end());
  }
}

// Decides all that follows from the camera: how large each head shows, and whether at all.
void set_up_camera(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& s,
                   const HeadSpheres& spheres, const HostSetup* host) {
  const scene::Camera camera = choose_camera(scene, s, spheres);
  io::CameraIo& seen_by = setup.frame.camera;
  seen_by = frame_camera(camera, static_cast<double>(s.output.width) / s.output.height);
  if (s.camera.matrices)
    seen_by.clip_from_world = host ? glm::mat4(upright_clip_from_world(*s.camera.matrices))
                                   : picture_from_world(*s.camera.matrices, camera);
  setup.frame.picture_size = glm::uvec2(s.output.width, s.output.height);
  setup.d_ref = reference_distance(*scene.instances.front().asset, s, camera);
  const bool skip = s.quality.skip_unseen_heads.value_or(s.quality.cull || s.quality.depth || s.quality.clip);

  for (passes::Head& head : setup.heads) {
    const PlacedInstance& instance = scene.instances[head.instance];
    const scene::AssetData& asset = *instance.asset;
    const PosedAsset* posed = instance.posed.get();
    head.middle_m = head.world_from_asset.position((posed ? posed->skin : asset.bounds).sphere.centre_m);
    const Casters casters(asset, posed, head.world_from_asset, is_deformed(host, head));
    set_up_shadows(head, setup.lights, casters.bounds(), s, camera, host);

    if (!asset.skin.empty())
      head.detail.pixels_per_mm = pixels_per_mm(asset, s, camera, head.world_from_asset, posed);
    head.visible = instance.visible && (!skip || in_view(asset, seen_by, head.world_from_asset, posed));
    // A host may move vertices anywhere.
    const glm::uvec2 size = setup.frame.picture_size;
    head.area = !head.visible             ? passes::PixelArea{}
                : is_deformed(host, head) ? passes::PixelArea{glm::uvec2(0), size}
                                          : area_of(casters.bounds(), seen_by, size);
  }
}

// Sorts far to near, so that what is blended is drawn over what lies behind it. Where one batch holds all
// heads, their blended parts are sorted when they are drawn. Heads of a model then stand together, and the
// plan stays as it is while heads change places.
void sort_heads(FrameSetup& setup, const RenderSettings& s) {
  const techniques::FrameSettings& plan = setup.plan;
  const bool blends = std::any_of(plan.models.begin(), plan.models.end(),
                                  [](const techniques::Model& model) { return model.has_blended; });
  // The plan of a host must serve every view.
  const bool by_model =
      s.output.show == "picture" && (plan.host || !blends || setup.heads.size() <= plan.heads_per_batch);

  // The map that `show` names is of the last head: the nearest that has something to show.
  const auto shows = [&](const passes::Head& head) {
    return head.visible && plan.models[head.model].meshes > 0;
  };
  const bool shows_picture = s.output.show == "picture";
  const auto distance = [&](const passes::Head& head) {
    return glm::distance(head.middle_m, setup.frame.camera.eye_m);
  };
  std::sort(setup.heads.begin(), setup.heads.end(), [&](const passes::Head& a, const passes::Head& b) {
    if (by_model && a.model != b.model) return a.model < b.model;
    if (!shows_picture && shows(a) != shows(b)) return shows(b);
    return std::pair(-distance(a), a.number) < std::pair(-distance(b), b.number);
  });

  setup.plan.heads.clear();
  for (const passes::Head& head : setup.heads) setup.plan.heads.push_back(head.model);
}

// Heads of one batch have sets of shadow maps one after the other. Those that last have the place of their
// head, whatever the order in which heads are drawn.
void place_shadows(std::vector<passes::Head>& heads, const techniques::FrameSettings& plan) {
  for (std::uint32_t i = 0; i < heads.size(); ++i) {
    const std::uint32_t set = plan.keep_shadows ? heads[i].number : i % plan.heads_per_batch;
    heads[i].first_shadow_layer = set * plan.shadow_layers;
    for (io::LightIo& light : heads[i].lights) light.shadow_layer += heads[i].first_shadow_layer;
  }
}

// Whether light enters whole wherever it falls on something: skin whose whole albedo acts after scattering.
// Blended surfaces cast no shadow.
bool all_enters(const PlacedInstance& instance, const RenderSettings& s) {
  const scene::AssetData& asset = *instance.asset;
  return std::all_of(asset.primitives.begin(), asset.primitives.end(), [&](const scene::Primitive& p) {
    const scene::Material& material = asset.materials[static_cast<std::size_t>(p.material)];
    if (material.alpha_mode == AssetAlpha::blend) return true;
    const float mix = instance.mix.value_or(material.skin_settings.mix_or_default());
    return material.skin && s.skin.mix.value_or(double{mix}) == 0;
  });
}

// Returns the number of Gaussians of the profile of a part, that without width too.
int gaussians_of(const techniques::PlannedMesh& part) {
  const auto has_weight = [](const gaussians::Rgb& weight) { return weight != gaussians::Rgb{}; };
  const std::vector<Gaussian>& terms = part.profile.terms;
  const bool all_leaves = terms.size() == 1 && !has_weight(terms.front().weight);
  return static_cast<int>(all_leaves ? 0 : terms.size()) + (has_weight(part.unscattered) ? 1 : 0);
}

// The light of a host is that of light maps, which hold what has scattered. Its shaders find them by texture
// coordinates, scaled and moved: see scene::lay_charts_apart().
void check_host_maps(const FrameSetup& setup, const PlacedScene& scene) {
  const techniques::FrameSettings& plan = setup.plan;
  if (!plan.host || !(plan.host_lights() || plan.host->scattered)) return;
  for (const PlacedInstance& instance : scene.instances)
    for (const scene::SkinMesh& mesh : instance.asset->skin)
      if (mesh.layers > 1)
        throw input_error(instance.asset->name,
                          "skin '{}' has charts on the same texture coordinates, so its light map lays them "
                          "apart. A host that reads or draws that light needs an unwrap without overlaps",
                          mesh.name);

  if (!plan.host_lights()) return;
  for (const techniques::PlannedMesh& part : plan.skin)
    if (part.unscattered != gaussians::Rgb{})
      throw input_error("", "a profile with a variance of 0 mm^2 does not go with light that a host draws");
}

// Ids tell parts apart, and techniques in screen space tell heads and skin meshes apart.
void check_numbers(const FrameSetup& setup) {
  const techniques::FrameSettings& plan = setup.plan;
  if (plan.parts() > MOST_PARTS)
    throw input_error("",
                      "a frame may have {} parts of skin, this one has {}: runs of up to {} triangles of one "
                      "material of a head",
                      MOST_PARTS, plan.parts(), 1 << ID_TRIANGLE_BITS);
  if (!setup.technique->screen_space) return;
  if (plan.head_count() > MOST_SURFACE_HEADS || plan.skin.size() > MOST_SURFACE_MESHES)
    throw input_error("", "technique '{}' tells {} heads and {} skin meshes apart, this frame has {} and {}",
                      setup.technique->name, MOST_SURFACE_HEADS, MOST_SURFACE_MESHES, plan.head_count(),
                      plan.skin.size());
}

// Its maps are those of heads that stand as their files have them, in a picture of ours.
void check_published(const FrameSetup& setup) {
  if (!setup.technique->as_published) return;
  if (setup.plan.host)
    throw input_error("", "technique '{}' draws no frames of a host; take texture-space",
                      setup.technique->name);
  if (setup.plan.poses)
    throw input_error("", "technique '{}' takes no poses; take texture-space", setup.technique->name);
}

void set_up_plan(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& s,
                 const DeviceTraits& device, bool every_view) {
  techniques::FrameSettings& plan = setup.plan;

  plan.width = static_cast<std::uint32_t>(s.output.width);
  plan.height = static_cast<std::uint32_t>(s.output.height);
  plan.samples = static_cast<std::uint32_t>(s.quality.samples);
  plan.light_samples = static_cast<std::uint32_t>(s.quality.light_samples);
  const auto most = static_cast<std::uint32_t>(s.quality.shadow_size);
  plan.shadow_size = every_view ? most : techniques::side_of(0, most);
  for (const passes::Head& head : setup.heads) {
    if (head.visible) plan.shadow_size = std::max(plan.shadow_size, head.shadow_side);
    plan.shadow_layers =
        std::max(plan.shadow_layers, static_cast<std::uint32_t>(head.shadow_from_world.size()));
  }
  plan.bloom = static_cast<float>(s.output.bloom);
  plan.tone_map = s.output.tone_map;
  plan.behind = background_of(s.output.background);
  plan.visibility = s.output.show == "visibility";
  plan.irradiance = s.output.show == "irradiance";
  plan.soft_shadows = std::any_of(setup.lights.begin(), setup.lights.end(),
                                  [](const scene::Light& light) { return light.radius > 0; });

  if (plan.host) {
    plan.width = std::max(plan.host->width, 1u);
    plan.height = std::max(plan.host->height, 1u);
    plan.bloom = 0;
    plan.tone_map = ToneMap::linear;
    plan.behind = {};
  }

  if (setup.technique->has_light_maps) {
    plan.optimise = {.cull = s.quality.cull, .depth = s.quality.depth, .clip = s.quality.clip};
    plan.mask = s.quality.mask.value_or(BlurMask::depth);
    plan.all_mapped = setup.technique->as_published;
  }
  set_up_map_sides(setup, scene, s, every_view);

  if (setup.technique->uses_profile) {
    plan.translucency =
        s.skin.translucency && !plan.skin.empty() && !setup.lights.empty() && !plan.host_lights();
    plan.all_enters = std::all_of(scene.instances.begin(), scene.instances.end(),
                                  [&](const PlacedInstance& instance) { return all_enters(instance, s); });
  }

  if (setup.technique->screen_space) {
    plan.kernel = s.quality.kernel;
    plan.taps = static_cast<std::uint32_t>(s.quality.taps.value_or(0));
  }

  for (const techniques::PlannedMesh& part : plan.skin)
    setup.gaussians = std::max(setup.gaussians, gaussians_of(part));
  if (!setup.technique->uses_profile) setup.gaussians = 0;

  PoolHeads heads{.count = static_cast<std::uint32_t>(setup.heads.size())};
  for (const passes::Head& head : setup.heads)
    heads.used_side = std::max(heads.used_side, every_view ? plan.most_side : head.detail.side);
  set_up_pool(plan, *setup.technique, heads, s, device);
}

// Light from just outside the picture still arrives: as far as the widest Gaussian reaches.
double clip_margin_m(const FrameSetup& setup, const RenderSettings& s) {
  if (s.quality.clip_margin_mm) return *s.quality.clip_margin_mm / 1000;
  double reach_m = 0;
  for (const techniques::PlannedMesh& part : setup.plan.skin)
    reach_m = std::max(reach_m, 3 * std::sqrt(part.profile.max_variance_mm2()) / part.mm_per_unit);
  return reach_m;
}

}  // namespace

void warn_coarse(const PlacedScene& scene, const FrameSetup& setup) {
  const auto widest_texels = [&](const techniques::PlannedMesh& part) {
    return std::sqrt(part.profile.max_variance_mm2()) * part.least_uv_per_mm * part.most_side;
  };
  const techniques::PlannedMesh* worst = nullptr;
  for (const techniques::PlannedMesh& part : setup.plan.skin)
    if (part.mean_uv_per_mm > 0 && (!worst || widest_texels(part) < widest_texels(*worst))) worst = &part;
  if (!worst || !setup.plan.mixes()) return;
  if (widest_texels(*worst) > 0.15) return;

  const MeshSource& source = setup.meshes[static_cast<std::size_t>(worst - setup.plan.skin.data())];
  const scene::AssetData& asset = *scene.instances[source.instance].asset;
  warn(
      "{}: a twentieth of skin '{}' has {:.2g} texels per mm of light map or fewer: light does not scatter "
      "there. Coordinates that fill more of the square hold more, or a larger quality.map_size, where that "
      "bounds the maps ({} texels are taken)",
      asset.name, asset.skin[source.mesh].name, worst->least_uv_per_mm * worst->most_side, worst->most_side);
}

std::vector<passes::Head> every_size(const FrameSetup& setup, const RenderSettings& settings) {
  std::vector<passes::Head> heads;
  for (std::uint32_t model = 0; model < setup.plan.models.size(); ++model)
    for (const std::uint32_t side : map_sides(setup.plan, settings)) {
      passes::Head& head = heads.emplace_back();
      head.model = model;
      head.detail.side = side;
    }
  return heads;
}

FrameSetup set_up(const PlacedScene& scene, const RenderSettings& s, const DeviceTraits& device,
                  const std::optional<std::vector<scene::Light>>& environment_lights, const HostSetup* host,
                  bool every_view) {
  for (const PlacedInstance& instance : scene.instances)
    DERMIS_ASSERT(instance.asset->bounds.sphere.radius_m > 0);
  FrameSetup setup;
  setup.technique = &techniques::find_technique(s.technique);
  setup.heads = placed_heads(scene, s);
  const HeadSpheres spheres = head_spheres(scene, s);
  setup.lights = choose_lights(scene, s, spheres);
  if (environment_lights) {
    setup.lights.insert(setup.lights.end(), environment_lights->begin(), environment_lights->end());
    setup.environment_lights = static_cast<int>(environment_lights->size());
  }

  set_up_camera(setup, scene, s, spheres, host);
  set_up_models(setup, scene, s);
  if (host) {
    setup.plan.host = host->part;
    for (passes::Head& head : setup.heads)
      head.drawn =
          std::find(host->not_drawn.begin(), host->not_drawn.end(), head.instance) == host->not_drawn.end();
  }
  setup.plan.poses = std::any_of(scene.instances.begin(), scene.instances.end(),
                                 [](const PlacedInstance& instance) { return instance.posed != nullptr; });
  setup.plan.environment = environment_lights.has_value();
  set_up_plan(setup, scene, s, device, every_view);
  if (host) setup.plan.samples = host->samples;
  sort_heads(setup, s);
  setup.plan.keep_shadows = s.quality.keep_shadows && s.output.show == "picture" &&
                            can_keep_shadows(setup.plan, *setup.technique, device, every_view);
  check_numbers(setup);
  check_published(setup);
  check_host_maps(setup, scene);
  place_shadows(setup.heads, setup.plan);

  io::FrameIo& frame = setup.frame;
  frame.clip_margin_m = static_cast<float>(clip_margin_m(setup, s));
  frame.radiance_scale = static_cast<float>(std::exp2(s.output.exposure_ev.value_or(0)));
  frame.ambient = glm::vec3(static_cast<float>(s.lighting.ambient));
  frame.light_count = static_cast<std::uint32_t>(setup.lights.size());
  frame.specular_on = s.lighting.specular ? 1 : 0;
  frame.white_albedo = s.lighting.white_albedo ? 1 : 0;
  return setup;
}

void set_view(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& s, const HostSetup& host) {
  set_up_camera(setup, scene, s, head_spheres(scene, s), &host);
  set_head_sides(setup, scene, s);
  sort_heads(setup, s);
  place_shadows(setup.heads, setup.plan);
}

}  // namespace dermis::setup
