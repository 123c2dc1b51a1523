// SPDX-License-Identifier: MIT
#include "techniques/texture_space/cascade.h"

#include <algorithm>
#include <string>
#include <utility>

#include "techniques/texture_space/mesh_steps.h"

namespace dermis::techniques {
namespace {

using passes::CascadeStep;
using passes::Gutters;
using passes::MapSquare;

// Makes the cascade of one skin mesh: knows how far down the pyramid the light is that has spread.
class Cascade {
 public:
  Cascade(const FrameSettings& settings, const LightMaps& maps, const std::vector<MapSquare>& squares)
      : settings_(&settings),
        maps_(&maps),
        mesh_(squares.front().mesh),
        squares_(squares),
        cascade_(cascade_plan(settings, settings.skin[mesh_])),
        coarsest_(settings.translucency ? cascade_.groups.size() : 1, 0) {
    for (const CascadeStep& step : cascade_.steps) {
      coarsest_[0] = std::max(coarsest_[0], step.halvings);
      if (!step.term || !settings_->translucency) continue;
      std::uint32_t& of_group = coarsest_[cascade_.group_of(step)];
      of_group = std::max(of_group, step.halvings);
    }
  }

  std::uint32_t coarsest() const { return coarsest_[0]; }  ///< halvings of its last level
  const std::vector<MapSquare>& squares() const { return squares_; }

  /// Returns the steps after the pyramid of the light itself.
  MeshSteps make() {
    if (settings_->translucency) add_transmitted();
    add_pyramids();

    for (std::size_t i = cascade_.steps.size(); i-- > 0;) {
      const CascadeStep& step = cascade_.steps[i];
      const bool widest = i + 1 == cascade_.steps.size();
      if (widest)
        halvings_ = step.halvings;
      else
        climb(step.halvings, static_cast<std::uint32_t>(i) + 1);
      add_step(static_cast<std::uint32_t>(i), widest);
    }
    if (!cascade_.steps.empty()) climb(0, 0);
    add_sum();
    return std::move(steps_);
  }

 private:
  const Level& level(std::uint32_t halvings) const { return maps_->levels()[halvings]; }
  frame::TextureId spread(std::uint32_t halvings) const { return level(halvings).blurred.front(); }
  std::vector<MapSquare> on(std::uint32_t halvings) const { return on_level(squares_, level(halvings)); }

  // Light of a group is what the group before has, and what its terms bring through the body beyond that.
  void add_transmitted() {
    for (std::size_t g = 1; g < cascade_.groups.size(); ++g) {
      const frame::TextureId before = maps_->unspread(g - 1, 0), through = maps_->unspread(g, 0);
      const std::string name = fmt::format("add transmitted {}", g);
      steps_.add<passes::AddTransmitted>(name, {before, before, through}, {.squares = squares_});
      steps_.add<Gutters>(name + " gutters", {through}, {.squares = squares_});
    }
  }

  // Adds the pyramids of the further groups of light.
  void add_pyramids() {
    for (std::size_t g = 1; g < coarsest_.size(); ++g)
      for (std::uint32_t halvings = 1; halvings <= coarsest_[g]; ++halvings) {
        const frame::TextureId larger = maps_->unspread(g, halvings - 1),
                               smaller = maps_->unspread(g, halvings);
        const std::string name = fmt::format("joining {}", g);
        steps_.add<passes::Downsample>(at("downsample " + name, level(halvings)),
                                       {larger, maps_->stretch(mesh_), smaller},
                                       {.from = on(halvings - 1), .to = on(halvings)});
        if (is_sparse(*settings_))
          steps_.add<passes::Dilate>(at("dilate " + name, level(halvings)),
                                     {smaller, maps_->stretch(mesh_), level(halvings).border},
                                     {on(halvings)});
      }
  }

  frame::TextureId unspread(const CascadeStep& step) const { return unspread(step, step.halvings); }
  frame::TextureId unspread(const CascadeStep& step, std::uint32_t halvings) const {
    return maps_->unspread(settings_->translucency ? cascade_.group_of(step) : 0, halvings);
  }

  // Moves what step `step` has spread to larger maps. On the last of them the light of the next step joins.
  void climb(std::uint32_t halvings, std::uint32_t step) {
    while (halvings_ > halvings) {
      const std::uint32_t to = halvings_ - 1;
      const CascadeStep* next = to == halvings && step > 0 ? &cascade_.steps[step - 1] : nullptr;
      const frame::TextureId joining = next ? unspread(*next) : level(to).light;
      const std::string name = at(fmt::format("upsample {}", step), level(to));
      steps_.add<passes::Upsample>(
          name,
          {spread(halvings_), joining, spread(to), maps_->stretch(mesh_), unspread(cascade_.steps[step], to)},
          {.from = on(halvings_),
           .to = on(to),
           .steps = cascade_.steps,
           .step = step,
           .next_step = to == halvings,
           .joins = next ? next->term : std::nullopt});
      // Heads whose narrower terms need no step climb as well.
      if (to > 0 || next) add_gutters(name, to, static_cast<std::uint32_t>(cascade_.steps.size()) - 1);
      halvings_ = to;
    }
  }

  void add_step(std::uint32_t number, bool widest) {
    const CascadeStep& step = cascade_.steps[number];
    const CascadeStep* next = number > 0 ? &cascade_.steps[number - 1] : nullptr;
    if (next && next->halvings != step.halvings) next = nullptr;
    const Level& here = level(step.halvings);
    const frame::TextureId stretch = maps_->stretch(mesh_);

    passes::CascadeBlur::Settings blur{
        .squares = on(step.halvings), .steps = cascade_.steps, .number = number, .axis = 0};
    const std::string name = fmt::format("cascade {}", number);
    steps_.add<passes::CascadeBlur>(
        name + " u", {widest ? unspread(step) : spread(step.halvings), stretch, here.scratch, here.lit},
        blur);

    blur.axis = 1;
    if (widest) blur.scales = step.term;
    if (next) blur.joins = next->term;
    steps_.add<passes::CascadeBlur>(name + " v",
                                    {here.scratch, stretch, spread(step.halvings), here.lit,
                                     blur.joins ? unspread(*next) : frame::TextureId{}},
                                    blur);
    if (step.halvings > 0 || number > 0) add_gutters(name, step.halvings, number);
  }

  void add_gutters(const std::string& name, std::uint32_t halvings, std::uint32_t step) {
    steps_.add<Gutters>(name + " gutters", {spread(halvings)}, {.squares = on(halvings), .step = step});
  }

  void add_sum() {
    passes::CascadeSum::In in{.light = level(0).light,
                              .stretch = maps_->stretch(mesh_),
                              .target = maps_->blurred().front(),
                              .lit = level(0).lit};
    passes::CascadeSum::Settings sum{
        .squares = squares_, .variances_mm2 = cascade_.variances_mm2, .steps = cascade_.steps};
    if (!cascade_.steps.empty()) {
      in.wide = spread(0);
      in.across = level(0).scratch;
    }
    if (settings_->translucency && cascade_.groups.size() > 1) {
      in.second = maps_->unspread(1, 0);
      sum.second_group = static_cast<std::uint32_t>(cascade_.groups[1]);
    }
    steps_.add<passes::CascadeSum>("cascade sum", in, sum);
    steps_.add<Gutters>("cascade sum gutters", {in.target}, {.squares = squares_});
  }

  const FrameSettings* settings_;
  const LightMaps* maps_;
  std::uint32_t mesh_;
  std::vector<MapSquare> squares_;  // on maps of T_max
  CascadePlan cascade_;
  std::vector<std::uint32_t> coarsest_;  // by group of light, halvings of the last level; [0]: of all groups
  std::uint32_t halvings_ = 0;           // of the maps in which the light is that has spread
  MeshSteps steps_;
};

}  // namespace

void add_cascade(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                 const std::vector<MapSquare>& squares) {
  std::vector<Cascade> cascades;
  for (const std::uint32_t mesh : meshes_of(squares))
    cascades.emplace_back(settings, maps, of_mesh(squares, mesh));

  // A level lists its tiles for all meshes at once.
  for (std::uint32_t halvings = 1; halvings < maps.levels().size(); ++halvings) {
    std::vector<MapSquare> all;
    for (const Cascade& cascade : cascades)
      if (cascade.coarsest() >= halvings)
        all.insert(all.end(), cascade.squares().begin(), cascade.squares().end());
    if (!all.empty()) maps.add_level(halvings, all);
  }

  std::vector<MeshSteps> meshes;
  for (Cascade& cascade : cascades) meshes.push_back(cascade.make());
  add_steps(plan, maps, std::move(meshes));
}

}  // namespace dermis::techniques
