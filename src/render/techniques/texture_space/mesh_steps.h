// SPDX-License-Identifier: MIT
/// The steps that spread the light of one skin mesh, in their order, and how those of all meshes become
/// passes.
#pragma once

#include <deque>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "frame/together.h"
#include "render/passes/light_map/gutters/gutters.h"
#include "render/passes/pixels/add_transmitted/add_transmitted.h"
#include "render/passes/scatter/blur/blur.h"
#include "render/techniques/texture_space/light_maps.h"

namespace dermis::techniques {

class MeshSteps {
 public:
  template <class Pass>
  void add(std::string name, typename Pass::In in, typename Pass::Settings settings) {
    steps_.push_back({std::move(name), frame::Member<Pass>{std::move(in), std::move(settings)}});
  }

 private:
  friend void add_steps(passes::FramePlan& plan, const LightMaps& maps, std::vector<MeshSteps> meshes);

  template <class... Passes>
  using OneOf = std::variant<frame::Member<Passes>...>;
  struct Step {
    std::string name;
    OneOf<passes::AddTransmitted, passes::Blur, passes::Gutters> does;
  };
  static std::vector<Step> take_next(std::vector<MeshSteps>& meshes);

  std::deque<Step> steps_;
};

/// Next steps that have the same name become one pass, of all meshes. They are of one kind of pass.
void add_steps(passes::FramePlan& plan, const LightMaps& maps, std::vector<MeshSteps> meshes);

}  // namespace dermis::techniques
