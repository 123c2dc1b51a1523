// SPDX-License-Identifier: MIT
#include "render/techniques/texture_space/mesh_steps.h"

#include <algorithm>

namespace dermis::techniques {

// Takes the step of the mesh that has most left, and all next steps of its name; meshes with fewer steps
// wait. Returns none if all are done.
std::vector<MeshSteps::Step> MeshSteps::take_next(std::vector<MeshSteps>& meshes) {
  const auto steps_left = [](const MeshSteps& mesh) { return mesh.steps_.size(); };
  const auto longest = std::ranges::max_element(meshes, {}, steps_left);
  std::vector<Step> taken;
  if (longest == meshes.end() || longest->steps_.empty()) return taken;

  const std::string name = longest->steps_.front().name;
  for (MeshSteps& mesh : meshes) {
    while (!mesh.steps_.empty() && mesh.steps_.front().name == name) {
      taken.push_back(std::move(mesh.steps_.front()));
      mesh.steps_.pop_front();
    }
  }
  return taken;
}

void add_steps(passes::FramePlan& plan, const LightMaps& maps, std::vector<MeshSteps> meshes) {
  for (auto steps = MeshSteps::take_next(meshes); !steps.empty(); steps = MeshSteps::take_next(meshes)) {
    const auto add = [&]<class Pass>(const frame::Member<Pass>&) {
      typename frame::Together<Pass>::In in;
      for (MeshSteps::Step& step : steps)
        in.members.push_back(std::get<frame::Member<Pass>>(std::move(step.does)));
      plan.add<frame::Together<Pass>>(maps.name(steps.front().name), in);
    };
    std::visit(add, steps.front().does);
  }
}

}  // namespace dermis::techniques
