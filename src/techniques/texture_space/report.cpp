// SPDX-License-Identifier: MIT
#include "techniques/texture_space/report.h"

#include <array>

#include "passes/blur/blur.h"
#include "shared/tiles_io.h"
#include "techniques/texture_space/counters.h"
#include "techniques/texture_space/light_maps.h"

namespace dermis::techniques {
namespace {

constexpr std::uint32_t levels = passes::max_halvings + 1;

// What runs over the squares of one skin mesh in maps of one size.
struct LevelWork {
  std::uint32_t terms = 0;         // Gaussians that end there
  std::uint32_t convolutions = 0;  // passes, both axes counted
  bool halved = false;             // the level is made by Downsample
};
using Work = std::array<LevelWork, levels>;  // by halvings

// Follows the steps of Convolution (convolution.cpp) and counts instead of adding passes.
Work work_of(const SkinPart& part, const std::vector<std::uint32_t>& halvings) {
  Work work{};
  std::size_t term = 0;
  for (const passes::BlurStep& step : passes::blur_steps(part.profile, part.max_texels_per_mm)) {
    LevelWork& level = work[halvings[term]];
    level.halved = halvings[term] > 0;
    level.convolutions += 2;
    if (!step.ends_term) continue;
    ++level.terms;
    ++term;
  }
  return work;
}

bool has_mesh(const Model& model, std::uint32_t mesh) {
  return mesh >= model.first_mesh && mesh - model.first_mesh < model.meshes;
}

// The figures of a frame from its counters; docs/measuring.md says what each means.
class Figures {
 public:
  Figures(const FrameSettings& settings, std::span<const std::uint32_t> counters,
          std::span<const DrawnHead> drawn)
      : settings_(settings), counters_(counters), drawn_(drawn) {
    const std::vector<std::uint32_t> halvings = halvings_of_terms(settings);
    for (const SkinPart& part : settings.skin) work_.push_back(work_of(part, halvings));
  }

  std::uint64_t irradiance_texels() const {
    std::uint64_t sum = 0;
    for (std::uint32_t mesh = 0; mesh < work_.size(); ++mesh) sum += counted(mesh, 0, counter_lit_texels);
    return sum;
  }

  // Texels lit by the mesh itself, times the Gaussians that blur them. In halved maps texels beside seams
  // count too.
  std::uint64_t convolved_texels() const {
    std::uint64_t sum = 0;
    for (std::uint32_t mesh = 0; mesh < work_.size(); ++mesh)
      for (std::uint32_t halvings = 0; halvings < levels; ++halvings) {
        const MeshCounter which = halvings == 0 ? counter_lit_texels : counter_masked_texels;
        sum += counted(mesh, halvings, which) * work_[mesh][halvings].terms;
      }
    return sum;
  }

  // Shader invocations of shading, downsampling and convolution.
  std::uint64_t launched() const {
    std::uint64_t sum = irradiance_texels();
    for (std::uint32_t mesh = 0; mesh < work_.size(); ++mesh)
      for (std::uint32_t halvings = 0; halvings < levels; ++halvings) {
        const LevelWork& work = work_[mesh][halvings];
        if (work.halved) sum += used_texels(mesh, halvings);
        sum += convolved_at_once(mesh, halvings) * work.convolutions;
      }
    return sum;
  }

 private:
  std::uint64_t counted(std::uint32_t mesh, std::uint32_t halvings, MeshCounter which) const {
    return counters_[mesh_counter(mesh, halvings, which)];
  }

  std::uint64_t used_texels(std::uint32_t mesh, std::uint32_t halvings) const {
    std::uint64_t sum = 0;
    for (const DrawnHead& head : drawn_)
      if (has_mesh(settings_.models[head.model], mesh)) {
        const std::uint64_t halved = passes::halved_side(head.side, settings_.map_size, halvings);
        sum += halved * halved;
      }
    return sum;
  }

  // Shader invocations of one convolution: what is not skipped of the used squares. SkipUnlit::by_alpha
  // leaves all: its fragments end early, but they start.
  std::uint64_t convolved_at_once(std::uint32_t mesh, std::uint32_t halvings) const {
    switch (skip_unlit(settings_)) {
      case passes::SkipUnlit::by_tiles:
        return std::uint64_t{TILE_WIDTH * TILE_HEIGHT} * counted(mesh, halvings, counter_tiles);
      case passes::SkipUnlit::by_depth: return counted(mesh, halvings, counter_masked_texels);
      default: return used_texels(mesh, halvings);
    }
  }

  const FrameSettings& settings_;
  std::span<const std::uint32_t> counters_;
  std::span<const DrawnHead> drawn_;
  std::vector<Work> work_;  // by skin mesh
};

std::vector<std::string> names_of(const Optimise& optimise) {
  std::vector<std::string> names;
  if (optimise.cull) names.emplace_back("cull");
  if (optimise.depth) names.emplace_back("depth");
  if (optimise.clip) names.emplace_back("clip");
  return names;
}

std::string name_of(passes::SkipUnlit skip) {
  return skip == passes::SkipUnlit::by_alpha   ? "alpha"
         : skip == passes::SkipUnlit::by_depth ? "depth"
                                               : "tiles";
}

}  // namespace

FrameReport texture_space_report(const FrameSettings& settings, std::span<const std::uint32_t> counters,
                                 std::span<const DrawnHead> drawn) {
  DERMIS_ASSERT_EQ(counters.size(), counter_count(settings.skin.size()));
  const Figures figures(settings, counters, drawn);

  FrameReport report = screen_report(settings, counters, drawn);
  report.optimise = names_of(settings.optimise);
  if (is_sparse(settings)) report.mask = name_of(settings.skip_unlit);
  report.maps = settings.progressive ? "progressive" : "full";
  report.translucency = settings.translucency;
  report.irradiance_texels = figures.irradiance_texels();
  report.convolved_texels = figures.convolved_texels();
  report.launched = figures.launched();
  report.unshaded_reads = counters[counter_unshaded_reads];
  report.transmission_misses = counters[counter_transmission_misses];
  return report;
}

std::vector<GutterSize> texture_space_gutters(const FrameSettings& settings,
                                              std::span<const DrawnHead> drawn) {
  const std::vector<std::uint32_t> halvings = halvings_of_terms(settings);
  std::vector<GutterSize> sizes;

  for (std::uint32_t mesh = 0; mesh < settings.skin.size(); ++mesh) {
    const SkinPart& part = settings.skin[mesh];
    const Work work = work_of(part, halvings);
    const auto add = [&](std::uint32_t side) {
      const double texels_per_mm = std::max(part.max_uv_per_mm * side, 1e-6);
      sizes.push_back(
          {.mesh = mesh, .side = side, .width_texels = passes::gutter_width(part.profile, texels_per_mm)});
    };

    add(settings.map_size);  // of the stretch map
    for (const DrawnHead& head : drawn) {
      if (!has_mesh(settings.models[head.model], mesh)) continue;
      for (std::uint32_t level = 0; level < levels; ++level)
        if (level == 0 || work[level].halved) add(passes::halved_side(head.side, settings.map_size, level));
    }
  }
  return sizes;
}

}  // namespace dermis::techniques
