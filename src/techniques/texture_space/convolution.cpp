// SPDX-License-Identifier: MIT
#include "techniques/texture_space/convolution.h"

#include <algorithm>
#include <deque>
#include <string>
#include <utility>
#include <variant>

#include "frame/together.h"
#include "passes/add_transmitted/add_transmitted.h"
#include "passes/blur/blur.h"
#include "passes/downsample/downsample.h"
#include "passes/gutters/gutters.h"
#include "passes/transmission.h"

namespace dermis::techniques {
namespace {

using frame::Member;
using frame::Together;
using passes::AddTransmitted;
using passes::Blur;
using passes::Downsample;
using passes::Gutters;
using passes::MapSquare;

// The masks of a level, which lists its tiles for all meshes at once.
struct Masks {
  const Level* level = nullptr;
  std::vector<MapSquare> squares;
};

// What one skin mesh does in a pass. Meshes whose next step has the same name take it together.
struct MeshStep {
  std::string name;
  std::variant<Member<Blur>, Member<Gutters>, Member<Downsample>, Member<AddTransmitted>, Masks> does;
};
using Chain = std::deque<MeshStep>;

// Where the light of a skin mesh is between two steps of its chain of blurs. Heads enter the chain at
// different steps: see passes::MappedTerms.
struct ChainLight {
  frame::TextureId blurred;     // of heads that have entered
  frame::TextureId start;       // of the others; the same before the first step, and where all enter there
  std::uint32_t next_step = 0;  // of passes::blur_steps()
};

// Makes the chain of blurs of one skin mesh: knows in which map the light is that the next step blurs.
class MakeChain {
 public:
  MakeChain(const FrameSettings& settings, const LightMaps& maps, const std::vector<MapSquare>& squares)
      : settings_(&settings),
        maps_(&maps),
        mesh_(squares.front().mesh),
        full_size_(squares),
        squares_(squares),
        level_(&maps.levels().front()),
        light_{.blurred = level_->light, .start = level_->light} {}

  Chain make() {
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
    return std::move(chain_);
  }

 private:
  template <class Pass>
  void add(std::string name, typename Pass::In in, typename Pass::Settings settings) {
    chain_.push_back({std::move(name), Member<Pass>{std::move(in), std::move(settings)}});
  }

  // Blurs along both axes into the map of the term, then refreshes the gutters. A step that does not end the
  // term is written there, too: the one that ends it overwrites it.
  void add_step(const passes::BlurStep& step, std::size_t term) {
    Blur::Settings blur{
        .squares = squares_, .variance_mm2 = step.variance_mm2, .texel_averaged = light_.next_step == 0};
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
    add<Blur>(name + " u", {light_.blurred, stretch, level_->scratch, level_->lit, light_.start}, blur);
    blur.axis = 1;
    add<Blur>(name + " v", {level_->scratch, stretch, target, level_->lit}, blur);
    add<Gutters>(name + " gutters", {target}, {.squares = squares_, .step = number});

    light_.blurred = target;
    if (!settings_->terms_by_need()) light_.start = target;
  }

  void go_on_in_smaller_maps(const Level& level) {
    std::vector<MapSquare> smaller = on_level(full_size_, level);
    add<Downsample>(at("downsample", level),
                    {light_.blurred, maps_->stretch(mesh_), level.light, light_.start},
                    {.from = squares_, .to = smaller, .next_step = light_.next_step});
    chain_.push_back({at("masks", level), Masks{&level, smaller}});
    squares_ = std::move(smaller);
    level_ = &level;
    light_.blurred = light_.start = level.light;
  }

  // Adds the light that the terms from here on bring through the body to what the terms before have spread;
  // see passes/transmission.h.
  void add_transmitted(std::size_t group) {
    frame::TextureId through = maps_->transmitted()[group - 1];
    if (level_->halvings > 0) {
      const frame::TextureId halved = maps_->halved_transmitted(group, *level_);
      add<Downsample>(at(fmt::format("downsample joining {}", group), *level_),
                      {through, maps_->stretch(mesh_), halved, through},
                      {.from = full_size_, .to = squares_});
      through = halved;
    }

    const std::string name = fmt::format("add transmitted {}", group);
    add<AddTransmitted>(name, {light_.blurred, light_.start, through},
                        {.squares = squares_, .next_step = light_.next_step});
    add<Gutters>(name + " gutters", {through}, {.squares = squares_});
    light_.blurred = light_.start = through;
  }

  const FrameSettings* settings_;
  const LightMaps* maps_;
  std::uint32_t mesh_;
  std::vector<MapSquare> full_size_, squares_;  // squares_: on level_
  const Level* level_;                          // the maps in which the next step blurs
  ChainLight light_;                            // what it blurs
  double total_mm2_ = 0;                        // of all steps so far
  Chain chain_;
};

// Returns the name of the step that comes next. All meshes wait for each other where masks are made.
const std::string& next_name(const std::vector<Chain>& chains) {
  const auto is_open = [](const Chain& chain) { return !chain.empty(); };
  const auto may_go_on = [&](const Chain& chain) {
    return is_open(chain) && !std::holds_alternative<Masks>(chain.front().does);
  };
  auto next = std::ranges::find_if(chains, may_go_on);
  if (next == chains.end()) next = std::ranges::find_if(chains, is_open);
  return next->front().name;
}

std::vector<MeshStep> take_steps(std::vector<Chain>& chains, const std::string& name) {
  std::vector<MeshStep> steps;
  for (Chain& chain : chains)
    if (!chain.empty() && chain.front().name == name) {
      steps.push_back(std::move(chain.front()));
      chain.pop_front();
    }
  return steps;
}

template <class Pass>
void add_together(passes::FramePlan& plan, const LightMaps& maps, std::vector<MeshStep>& steps,
                  const Member<Pass>&) {
  typename Together<Pass>::In in;
  for (MeshStep& step : steps) in.members.push_back(std::move(std::get<Member<Pass>>(step.does)));
  plan.add<Together<Pass>>(maps.name(steps.front().name), in);
}

void add_masks(LightMaps& maps, const std::vector<MeshStep>& steps) {
  std::vector<MapSquare> all;
  for (const MeshStep& step : steps) {
    const std::vector<MapSquare>& squares = std::get<Masks>(step.does).squares;
    all.insert(all.end(), squares.begin(), squares.end());
  }
  maps.add_masks(*std::get<Masks>(steps.front().does).level, all);
}

}  // namespace

void add_convolution(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                     const std::vector<MapSquare>& squares) {
  std::vector<Chain> chains;
  for (const std::uint32_t mesh : meshes_of(squares))
    chains.push_back(MakeChain(settings, maps, of_mesh(squares, mesh)).make());

  while (!std::ranges::all_of(chains, &Chain::empty)) {
    std::vector<MeshStep> steps = take_steps(chains, std::string(next_name(chains)));
    if (std::holds_alternative<Masks>(steps.front().does))
      add_masks(maps, steps);
    else
      std::visit(
          [&](const auto& first) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(first)>, Masks>)
              add_together(plan, maps, steps, first);
          },
          steps.front().does);
  }
}

}  // namespace dermis::techniques
