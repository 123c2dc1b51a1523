// SPDX-License-Identifier: MIT
#include "techniques/texture_space/texture_space.h"

#include "passes/blur/blur.h"
#include "passes/count/count.h"
#include "passes/gutters/gutters.h"
#include "passes/irradiance/irradiance.h"
#include "passes/skin/skin.h"
#include "passes/stretch/stretch.h"
#include "techniques/screen.h"

namespace dermis::techniques {
namespace {

using passes::Gutters;

// Textures that one head after the other uses.
struct LightMaps {
  frame::TextureId irradiance, scratch;
  std::vector<frame::TextureId> stretch;  // one a skin mesh
  std::vector<frame::TextureId> levels;   // one a term, of the profile with most terms
};

LightMaps make_maps(frame::FramePlan& plan, const FrameSettings& settings) {
  const gpu::TextureDesc map{.width = settings.map_size, .height = settings.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
  LightMaps maps;
  maps.irradiance = plan.texture("irradiance", map);
  maps.scratch = plan.texture("scratch", map);
  std::size_t terms = 0;
  for (const SkinPart& part : settings.skin) terms = std::max(terms, part.profile.terms.size());
  for (std::size_t k = 0; k < terms; ++k) maps.levels.push_back(plan.texture(fmt::format("light {}", k), map));
  for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
    const std::string suffix = settings.skin.size() > 1 ? fmt::format(" part {}", mesh) : "";
    maps.stretch.push_back(plan.texture("stretch" + suffix, map));
    plan.add<passes::Stretch>("stretch" + suffix, {maps.stretch.back()}, {.mesh = mesh});
    plan.add<Gutters>("stretch gutters" + suffix, {maps.stretch.back()}, {.mesh = mesh, .what = Gutters::What::stretch});
  }
  return maps;
}

// Gaussians compose: blurring a blurred map adds variances, so each term starts from the one before. Seams are refreshed after each step.
void add_convolution(frame::FramePlan& plan, const FrameSettings& settings, const LightMaps& maps, std::uint32_t head, std::uint32_t mesh) {
  frame::TextureId light = maps.irradiance;
  std::size_t term = 0, number = 0;
  bool first = true;
  for (const passes::BlurStep& step : passes::blur_steps(settings.skin[mesh].profile, settings.skin[mesh].max_texels_per_mm)) {
    const std::string name = label(fmt::format("blur {}", number++), settings, head, mesh);
    // A step between two terms is overwritten by the step that ends the next term: its level serves both.
    const frame::TextureId target = maps.levels[term];
    plan.add<passes::Blur>(name + " u", {light, maps.stretch[mesh], maps.scratch},
                           {.variance_mm2 = step.variance_mm2, .axis = 0, .texel_averaged = first});
    plan.add<passes::Blur>(name + " v", {maps.scratch, maps.stretch[mesh], target},
                           {.variance_mm2 = step.variance_mm2, .axis = 1, .texel_averaged = first});
    plan.add<Gutters>(name + " gutters", {target}, {.mesh = mesh, .what = Gutters::What::light});
    light = target;
    first = false;
    if (step.ends_term) ++term;
  }
}

std::vector<std::array<float, 3>> weights(const gaussians::SumOfGaussians& profile) {
  std::vector<std::array<float, 3>> w;
  for (const gaussians::Gaussian& term : profile.terms)
    w.push_back({static_cast<float>(term.weight[0]), static_cast<float>(term.weight[1]), static_cast<float>(term.weight[2])});
  return w;
}

}  // namespace

FrameOutputs build_texture_space(frame::FramePlan& plan, const FrameSettings& settings) {
  Screen screen(plan, settings);
  const LightMaps maps = make_maps(plan, settings);
  for (std::uint32_t head = 0; head < settings.heads; ++head) {
    screen.add_shadow(head);
    for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
      plan.add<passes::Irradiance>(label("irradiance", settings, head, mesh), {maps.irradiance, screen.shadow()},
                                   {.instance = head, .mesh = mesh});
      plan.add<passes::Count>(label("count texels", settings, head, mesh), {maps.irradiance, screen.counters()},
                              {.slot = counter_irradiance});
      plan.add<Gutters>(label("irradiance gutters", settings, head, mesh), {maps.irradiance}, {.mesh = mesh, .what = Gutters::What::light});
      add_convolution(plan, settings, maps, head, mesh);
      const auto& terms = settings.skin[mesh].profile.terms;
      const std::vector<frame::TextureId> lights(maps.levels.begin(), maps.levels.begin() + static_cast<std::ptrdiff_t>(terms.size()));
      plan.add<passes::Skin>(label("final", settings, head, mesh), {lights, screen.shadow(), screen.colour(), screen.depth()},
                             {.instance = head,
                              .mesh = mesh,
                              .samples = settings.samples,
                              .clear = screen.take_clear(),
                              .weights = weights(settings.skin[mesh].profile)});
    }
    screen.add_surfaces(head);
  }
  FrameOutputs out = screen.finish();
  if (!settings.skin.empty()) {
    out.shows["irradiance"] = maps.irradiance;
    out.shows["stretch"] = maps.stretch.front();
    for (std::size_t k = 0; k < maps.levels.size(); ++k) out.shows[fmt::format("blur:{}", k)] = maps.levels[k];
    for (const auto& [name, id] : out.shows) plan.read_back(id);
  }
  for (const SkinPart& part : settings.skin)
    out.launched_per_head += 2ull * settings.map_size * settings.map_size * passes::blur_steps(part.profile, part.max_texels_per_mm).size();
  return out;
}

}  // namespace dermis::techniques
