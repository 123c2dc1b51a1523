// SPDX-License-Identifier: MIT
#include "techniques/texture_space/mesh_steps.h"

#include <algorithm>

namespace dermis::techniques {

void add_steps(passes::FramePlan& plan, const LightMaps& maps, std::vector<MeshSteps> meshes) {
  const auto steps_left = [](const MeshSteps& mesh) { return mesh.steps_.size(); };
  while (!meshes.empty()) {
    // Meshes with fewer steps wait for the one that has most left.
    const MeshSteps& longest = *std::ranges::max_element(meshes, {}, steps_left);
    if (longest.steps_.empty()) return;
    const std::string name = longest.steps_.front().name;

    const auto add = [&]<class Pass>(const frame::Member<Pass>&) {
      typename frame::Together<Pass>::In in;
      for (MeshSteps& mesh : meshes) {
        if (mesh.steps_.empty() || mesh.steps_.front().name != name) continue;
        in.members.push_back(std::get<frame::Member<Pass>>(std::move(mesh.steps_.front().does)));
        mesh.steps_.pop_front();
      }
      plan.add<frame::Together<Pass>>(maps.name(name), in);
    };
    const auto does = longest.steps_.front().does;  // a copy: the step itself is taken out
    std::visit(add, does);
  }
}

}  // namespace dermis::techniques
