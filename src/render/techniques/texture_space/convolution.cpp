// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/convolution.h"

#include <string>
#include <utility>

#include "base/core/assert.h"
#include "render/passes/light_map/transmission.h"
#include "render/techniques/mapped_terms.h"
#include "render/techniques/texture_space/mesh_steps.h"

namespace dermis::techniques {
namespace {

using passes::AddTransmitted;
using passes::Blur;
using passes::Gutters;
using passes::MapSquare;

// Where the light of a skin mesh is between two steps of its chain of blurs. Heads enter the chain at
// different steps: see passes::MappedTerms.
struct ChainLight {
  frame::TextureId blurred;  // of heads that have entered
  frame::TextureId start;    // of the others; the same before the first step, and where all enter there
};

// A step of passes::blur_steps(), and the term of whose map it is.
struct Step {
  std::uint32_t number = 0;
  std::size_t term = 0;
  double variance_mm2 = 0;
  double total_mm2 = 0;  // of all steps so far
};

// Makes the chain of blurs of one skin mesh: knows in which map the light is that the next step blurs.
class MakeChain {
 public:
  MakeChain(const FrameSettings& settings, const LightMaps& maps, const std::vector<MapSquare>& squares)
      : settings_(&settings),
        maps_(&maps),
        mesh_(squares.front().mesh),
        squares_(squares),
        light_{.blurred = maps.light(), .start = maps.light()} {}

  MeshSteps make() {
    const PlannedMesh& part = settings_->skin[mesh_];
    const std::vector<std::size_t> groups = part.through_groups();
    const std::vector<passes::BlurStep> steps =
        passes::blur_steps(part.mapped(), settings_->chain_texels_per_mm(part));
    const std::size_t direct = direct_steps(*settings_, part);
    std::vector<Step> round;
    Step step;

    for (std::size_t i = 0; i < steps.size(); ++i) {
      // A group of terms begins: its transmitted light joins before its first step.
      const bool term_ended = i > 0 && steps[i - 1].ends_term;
      for (std::size_t g = 1; term_ended && settings_->translucency && g < groups.size(); ++g)
        if (groups[g] == step.term) add_transmitted(g, step.number);

      step.variance_mm2 = steps[i].variance_mm2;
      step.total_mm2 += step.variance_mm2;
      round.push_back(step);
      if (i + 1 >= direct) {
        add_round(round);
        round.clear();
      }
      ++step.number;
      if (steps[i].ends_term) ++step.term;
    }
    return std::move(steps_);
  }

 private:
  static passes::ChainStep chain_step(const Step& step) { return {step.number, step.total_mm2}; }

  // Blurs along both axes into the maps of the terms, then refreshes the gutters. Several steps are each
  // from the light before any blur. One that does not end its term is written to its map, too: the one that
  // ends it overwrites it.
  void add_round(const std::vector<Step>& round) {
    DERMIS_ASSERT_LE(round.size(), 2u);
    const std::string name = fmt::format("blur {}", round.front().number);
    const frame::TextureId stretch = maps_->stretch(mesh_);
    const auto target = [&](const Step& step) { return maps_->blurred()[step.term]; };

    const bool from_light = round.front().number == 0 || round.size() > 1;
    const auto settings_of = [&](const Step& step, std::uint32_t axis) {
      return Blur::Settings{.squares = squares_,
                            .variance_mm2 = from_light ? step.total_mm2 : step.variance_mm2,
                            .axis = axis,
                            .texel_averaged = from_light,
                            .chain = chain_step(step),
                            .narrower = {}};
    };

    // Both terms that start from the light share its reads.
    const Step& wide = round.back();
    const std::vector<frame::TextureId>& scratch = maps_->scratch();
    Blur::Settings along_u = settings_of(wide, 0);
    if (round.size() > 1) along_u.narrower = chain_step(round.front());
    steps_.add<Blur>(name + " u",
                     {.light = light_.blurred,
                      .stretch = stretch,
                      .target = scratch[round.size() - 1],
                      .lists = maps_->tiles(),
                      .start = light_.start,
                      .narrower = round.size() > 1 ? scratch[0] : frame::TextureId{}},
                     along_u);
    for (std::size_t i = 0; i < round.size(); ++i)
      steps_.add<Blur>(name + " v", {scratch[i], stretch, target(round[i]), maps_->tiles()},
                       settings_of(round[i], 1));
    for (const Step& step : round)
      steps_.add<Gutters>(name + " gutters", {target(step)}, {.squares = squares_, .step = step.number});

    light_.blurred = target(round.back());
    if (!settings_->mixes()) light_.start = light_.blurred;
  }

  // Adds the light that the terms from here on bring through the body to what the terms before have spread;
  // see render/passes/light_map/transmission.h.
  void add_transmitted(std::size_t group, std::uint32_t next_step) {
    const frame::TextureId through = maps_->transmitted()[group - 1];
    const std::string name = fmt::format("add transmitted {}", group);
    steps_.add<AddTransmitted>(name, {light_.blurred, light_.start, through},
                               {.squares = squares_, .next_step = next_step});
    steps_.add<Gutters>(name + " gutters", {through}, {.squares = squares_});
    light_.blurred = light_.start = through;
  }

  const FrameSettings* settings_;
  const LightMaps* maps_;
  std::uint32_t mesh_;
  std::vector<MapSquare> squares_;
  ChainLight light_;  // input of the next step
  MeshSteps steps_;
};

}  // namespace

void add_convolution(passes::FramePlan& plan, const FrameSettings& settings, LightMaps& maps,
                     const std::vector<MapSquare>& squares) {
  std::vector<MeshSteps> meshes;
  for (const std::uint32_t mesh : meshes_of(squares))
    meshes.push_back(MakeChain(settings, maps, of_mesh(squares, mesh)).make());
  add_steps(plan, maps, std::move(meshes));
}

}  // namespace dermis::techniques
