// SPDX-License-Identifier: MIT
#include "render/setup/models.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/core/error.h"
#include "base/core/one_line.h"
#include "render/passes/asset/gpu_asset.h"
#include "render/setup/choose.h"
#include "render/techniques/technique.h"

namespace dermis::setup {
namespace {

// Sigma of light that a picture shows to have spread, whatever its pixels: that of narrower Gaussians is not
// told from light that has not, beside the wider ones. Truth decides it: docs/notes/techniques.md, "The next
// term".
constexpr double wide_mm = 1;

// Common properties of the heads of a model.
struct ModelKey {
  const scene::AssetData* asset = nullptr;
  float scale = 1;
  std::optional<ScatterProfile> profile;
  /// An instance in a pose has a metric of its own.
  std::optional<std::size_t> posed{};
};

// In the millimetres of an asset that is shown at this scale.
ScatterProfile in_asset(ScatterProfile profile, double scale) {
  for (Gaussian& term : profile.terms) term.variance_mm2 /= scale * scale;
  for (std::size_t c = 0; c < 3; ++c) {
    if (profile.medium) {
      profile.medium->sigma_a_per_mm[c] *= scale;
      profile.medium->sigma_s_per_mm[c] *= scale;
    }
    if (!profile.shape) continue;
    ShapeLaws& laws = *profile.shape;
    for (auto* lengths_mm :
         {&laws.curvature_mm, &laws.convex_mm, &laws.concave_mm, &laws.difference_mm, &laws.front_mm})
      (*lengths_mm)[c] /= scale;
    laws.difference_mm2[c] /= scale * scale;
  }
  return profile;
}

// Leaves the laws of shape in a profile that is to follow them.
void choose_shape(ScatterProfile& profile, const RenderSettings& s) {
  const techniques::Technique& technique = techniques::find_technique(s.technique);
  const bool can_follow = technique.has_light_maps && !technique.as_published;
  if (s.skin.shape_aware == true && can_follow && !profile.shape)
    throw input_error(
        "",
        "skin.shape_aware: profile '{}' does not say what medium it is of; profiles that `dermis "
        "profile` makes do",
        one_line(profile.name, 80));
  if (!can_follow || !s.skin.shape_aware.value_or(true)) profile.shape.reset();
}

// Takes the light that leaves where it entered out of the profile. A light map has at least one term.
void take_unscattered(techniques::PlannedMesh& part) {
  std::vector<Gaussian>& terms = part.profile.terms;
  if (terms.empty() || terms.front().variance_mm2 > 0) return;
  part.unscattered = terms.front().weight;
  terms.erase(terms.begin());
  if (terms.empty()) terms.push_back({.variance_mm2 = 1, .weight = {}});
}

techniques::PlannedMesh skin_part(const ModelKey& model, std::size_t number, const RenderSettings& s) {
  const scene::AssetData& asset = *model.asset;
  const scene::SkinMesh& mesh = asset.skin[number];
  const scene::UnwrapDensity& density = mesh.density;
  const auto material = static_cast<std::size_t>(mesh.triangle_material.front());

  techniques::PlannedMesh part;
  part.in_model = static_cast<std::uint32_t>(number);
  part.triangles = static_cast<std::uint32_t>(mesh.triangle_chart.size());
  part.vertices = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::vector<passes::GpuDraw> draws = passes::draws_of(mesh);
  part.draws = static_cast<std::uint32_t>(draws.size());
  part.parts = 0;
  for (const passes::GpuDraw& draw : draws) part.parts += draw.parts();
  part.profile = choose_profile(asset.materials[material], model.profile);
  choose_shape(part.profile, s);
  take_unscattered(part);
  part.mm_per_unit = asset.mm_per_unit;
  if (model.scale != 1) {
    part.profile = in_asset(part.profile, double{model.scale});
    part.mm_per_unit /= double{model.scale};
  }

  // The 95 % quantile: a few crumpled triangles may be denser; there the first step is a little coarse, not
  // wrong in width.
  part.max_uv_per_mm = density.largest_uv_per_mm.p95;
  part.mean_uv_per_mm = density.uv_per_mm.mean;
  part.least_uv_per_mm = density.uv_per_mm.p05;
  part.wide_mm = std::min(wide_mm / double{model.scale}, 0.5 * std::sqrt(part.profile.max_variance_mm2()));

  part.off_map = scene::has_chartless(mesh);
  part.kinds.reset();
  for (const int index : mesh.triangle_material) {
    const scene::Material& of_triangle = asset.materials[static_cast<std::size_t>(index)];
    const passes::SkinKind kind{.cut_out = of_triangle.alpha_mode == AssetAlpha::mask,
                                .emits = of_triangle.emissive != glm::vec3(0),
                                .detailed = of_triangle.skin_settings.detail.present()};
    part.cut_out = part.cut_out || kind.cut_out;
    part.kinds.set(kind.index());
  }
  return part;
}

// Notes whether there is anything beside skin, blended or not.
void fill_surfaces(techniques::Model& model, const scene::AssetData& scene) {
  for (const scene::Primitive& p : scene.primitives) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(p.material)];
    if (material.skin) continue;
    (material.alpha_mode == AssetAlpha::blend ? model.has_blended : model.has_surfaces) = true;
  }
}

}  // namespace

void set_up_models(FrameSetup& setup, const PlacedScene& scene, const RenderSettings& s) {
  techniques::FrameSettings& plan = setup.plan;
  plan.models.clear();
  // Models that differ in no more than their profile.
  std::map<std::tuple<const scene::AssetData*, float, bool, std::size_t>,
           std::vector<std::pair<std::optional<ScatterProfile>, std::uint32_t>>>
      known;
  std::map<std::pair<const scene::AssetData*, std::optional<std::size_t>>, std::uint32_t> first_unwraps;
  std::uint32_t unwraps = 0;

  for (passes::Head& head : setup.heads) {
    const PlacedInstance& instance = scene.instances[head.instance];
    const ModelKey key{.asset = instance.asset.get(),
                       .scale = head.world_from_asset.scale,
                       .profile = instance.profile,
                       .posed = instance.posed ? std::optional(head.instance) : std::nullopt};
    auto& alike = known[{key.asset, key.scale, key.posed.has_value(), key.posed.value_or(0)}];
    const auto found = std::find_if(alike.begin(), alike.end(),
                                    [&](const auto& model) { return model.first == key.profile; });
    head.model = found == alike.end() ? static_cast<std::uint32_t>(plan.models.size()) : found->second;
    if (found != alike.end()) continue;
    alike.emplace_back(key.profile, head.model);

    const auto meshes = static_cast<std::uint32_t>(key.asset->skin.size());
    const auto [unwrap, is_new] = first_unwraps.try_emplace(std::pair(key.asset, key.posed), unwraps);
    if (is_new) unwraps += meshes;

    techniques::Model model{.first_mesh = static_cast<std::uint32_t>(plan.skin.size()), .meshes = meshes};
    fill_surfaces(model, *key.asset);
    for (std::uint32_t mesh = 0; mesh < meshes; ++mesh) {
      plan.skin.push_back(skin_part(key, mesh, s));
      plan.skin.back().unwrap = unwrap->second + mesh;
      plan.skin.back().posed = key.posed.has_value();
      setup.meshes.push_back({.instance = head.instance, .mesh = mesh});
    }
    plan.models.push_back(model);
  }
}

}  // namespace dermis::setup
