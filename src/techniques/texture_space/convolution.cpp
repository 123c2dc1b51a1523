// SPDX-License-Identifier: MIT
#include "techniques/texture_space/convolution.h"

#include "passes/add_transmitted/add_transmitted.h"
#include "passes/blur/blur.h"
#include "passes/downsample/downsample.h"
#include "passes/gutters/gutters.h"
#include "passes/transmission.h"

namespace dermis::techniques {
namespace {

using passes::Gutters;
using passes::MapSquare;

// The chain of blurs of one skin mesh: knows in which map the light is that the next step blurs.
class Convolution {
 public:
  Convolution(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps, std::uint32_t mesh,
              const std::vector<MapSquare>& squares)
      : plan_(&plan),
        settings_(&settings),
        maps_(&maps),
        mesh_(mesh),
        full_size_(squares),
        squares_(squares),
        level_(&maps.levels().front()),
        light_{.blurred = level_->light, .start = level_->light} {}

  void add() {
    const SkinPart& part = settings_->skin[mesh_];
    const std::vector<std::size_t> groups = passes::transmission_groups(part.profile.terms.size());
    std::size_t term = 0;
    bool term_ended = false;

    for (const passes::BlurStep& step : passes::blur_steps(part.profile, part.max_texels_per_mm)) {
      // A group of terms begins: its transmitted light joins before its first step.
      for (std::size_t g = 1; term_ended && settings_->translucency && g < groups.size(); ++g)
        if (groups[g] == term) add_transmitted(g);

      add_step(step, term);
      term_ended = step.ends_term;
      if (term_ended) ++term;
    }
  }

 private:
  // Blurs along both axes into the map of the term, then refreshes the gutters. A step that does not end the
  // term is written there, too: the one that ends it overwrites it.
  void add_step(const passes::BlurStep& step, std::size_t term) {
    passes::Blur::Settings blur{.squares = squares_,
                                .variance_mm2 = step.variance_mm2,
                                .texel_averaged = light_.next_step == 0,
                                .skip_unlit = skip_unlit(*settings_)};
    total_mm2_ += step.variance_mm2;
    // The light is smooth enough by now for smaller maps.
    if (maps_->halvings()[term] != level_->halvings) {
      blur.halvings_before = level_->halvings;
      go_on_in_smaller_maps(maps_->level_of(term));
      blur.squares = squares_;
    }

    const std::uint32_t number = light_.next_step++;
    blur.chain = passes::ChainStep{.number = number, .total_mm2 = total_mm2_};
    const std::string name = fmt::format("blur {}", number);
    const frame::TextureId stretch = maps_->stretch(mesh_), target = maps_->blurred()[term];
    plan_->add<passes::Blur>(
        maps_->name(name + " u", mesh_),
        {light_.blurred, stretch, level_->scratch, level_->lit, level_->depth_mask, light_.start}, blur);
    blur.axis = 1;
    plan_->add<passes::Blur>(maps_->name(name + " v", mesh_),
                             {level_->scratch, stretch, target, level_->lit, level_->depth_mask}, blur);
    plan_->add<Gutters>(maps_->name(name + " gutters", mesh_), {target},
                        {.squares = squares_, .step = number});

    light_.blurred = target;
    if (!settings_->terms_by_need()) light_.start = target;
  }

  void go_on_in_smaller_maps(const Level& level) {
    std::vector<MapSquare> smaller = on_level(full_size_, level);
    maps_->add_halved(level, light_, squares_, smaller);
    squares_ = std::move(smaller);
    level_ = &level;
    light_.blurred = light_.start = level.light;
  }

  // Adds the light that the terms from here on bring through the body to what the terms before have spread;
  // see passes/transmission.h.
  void add_transmitted(std::size_t group) {
    frame::TextureId through = maps_->transmitted()[group - 1];
    if (level_->halvings > 0) {
      const std::string name = at(fmt::format("downsample joining {}", group), *level_);
      const passes::Downsample::In in{through, maps_->stretch(mesh_),
                                      maps_->halved_transmitted(group, *level_), through};
      through =
          plan_->add<passes::Downsample>(maps_->name(name, mesh_), in, {.from = full_size_, .to = squares_})
              .light;
    }

    const std::string name = fmt::format("add transmitted {}", group);
    plan_->add<passes::AddTransmitted>(maps_->name(name, mesh_), {light_.blurred, light_.start, through},
                                       {.squares = squares_, .next_step = light_.next_step});
    plan_->add<Gutters>(maps_->name(name + " gutters", mesh_), {through}, {.squares = squares_});
    light_.blurred = light_.start = through;
  }

  passes::FramePlan* plan_;
  const FrameSettings* settings_;
  LightMaps* maps_;
  std::uint32_t mesh_;
  std::vector<MapSquare> full_size_, squares_;  // squares_: on level_
  const Level* level_;                          // the maps in which the next step blurs
  ChainLight light_;                            // what it blurs
  double total_mm2_ = 0;                        // of all steps so far
};

}  // namespace

void add_convolution(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                     std::uint32_t mesh, const std::vector<MapSquare>& squares) {
  Convolution(plan, settings, maps, mesh, squares).add();
}

}  // namespace dermis::techniques
