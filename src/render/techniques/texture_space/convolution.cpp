// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/convolution.h"

#include <string>
#include <utility>

#include "render/passes/light_map/transmission.h"
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
        squares_(squares),
        light_{.blurred = maps.light(), .start = maps.light()} {}

  MeshSteps make() {
    const SkinMesh& part = settings_->skin[mesh_];
    const std::vector<std::size_t> groups = part.through_groups();
    std::size_t term = 0;
    bool term_ended = false;

    for (const passes::BlurStep& step :
         passes::blur_steps(part.mapped(), settings_->chain_texels_per_mm(part))) {
      // A group of terms begins: its transmitted light joins before its first step.
      for (std::size_t g = 1; term_ended && settings_->translucency && g < groups.size(); ++g)
        if (groups[g] == term) add_transmitted(g);

      add_step(step, term);
      term_ended = step.ends_term;
      if (term_ended) ++term;
    }
    return std::move(steps_);
  }

 private:
  // Blurs along both axes into the map of the term, then refreshes the gutters. A step that does not end the
  // term is written there, too: the one that ends it overwrites it.
  void add_step(const passes::BlurStep& step, std::size_t term) {
    Blur::Settings blur{
        .squares = squares_, .variance_mm2 = step.variance_mm2, .texel_averaged = light_.next_step == 0};
    total_mm2_ += step.variance_mm2;
    const std::uint32_t number = light_.next_step++;
    blur.chain = passes::ChainStep{.number = number, .total_mm2 = total_mm2_};
    const std::string name = fmt::format("blur {}", number);
    const frame::TextureId stretch = maps_->stretch(mesh_), target = maps_->blurred()[term];
    steps_.add<Blur>(name + " u", {light_.blurred, stretch, maps_->scratch(), maps_->tiles(), light_.start},
                     blur);
    blur.axis = 1;
    steps_.add<Blur>(name + " v", {maps_->scratch(), stretch, target, maps_->tiles()}, blur);
    steps_.add<Gutters>(name + " gutters", {target}, {.squares = squares_, .step = number});

    light_.blurred = target;
    if (!settings_->mixes()) light_.start = target;
  }

  // Adds the light that the terms from here on bring through the body to what the terms before have spread;
  // see render/passes/light_map/transmission.h.
  void add_transmitted(std::size_t group) {
    const frame::TextureId through = maps_->transmitted()[group - 1];
    const std::string name = fmt::format("add transmitted {}", group);
    steps_.add<AddTransmitted>(name, {light_.blurred, light_.start, through},
                               {.squares = squares_, .next_step = light_.next_step});
    steps_.add<Gutters>(name + " gutters", {through}, {.squares = squares_});
    light_.blurred = light_.start = through;
  }

  const FrameSettings* settings_;
  const LightMaps* maps_;
  std::uint32_t mesh_;
  std::vector<MapSquare> squares_;
  ChainLight light_;      // input of the next step
  double total_mm2_ = 0;  // of all steps so far
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
