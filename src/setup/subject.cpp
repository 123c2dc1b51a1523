// SPDX-License-Identifier: MIT
#include "setup/subject.h"

#include "core/error.h"
#include "core/hooks.h"
#include "core/warnings.h"
#include "scene/coverage.h"
#include "scene/framing.h"

namespace dermis::setup {

Subject examine(std::shared_ptr<const scene::Scene> scene) {
  const WarningGroup group;
  Subject subject;
  subject.skin = scene::skin_meshes(*scene);
  Steps steps("measuring the unwrap", subject.skin.size());
  for (const scene::SkinMesh& mesh : subject.skin) {
    scene::warn_overlap(mesh);
    subject.densities.push_back(scene::unwrap_density(mesh, scene->mm_per_unit));
    steps.done();
  }

  subject.sphere = scene::skin_sphere(*scene);
  if (!(subject.sphere.radius_m > 0))
    throw input_error(scene->name, "has nothing to see: all its triangles lie at one point");

  subject.box = {glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  for (const scene::SkinMesh& mesh : subject.skin)
    for (const std::uint32_t index : mesh.indices) {
      const glm::vec3& p = mesh.vertices[index].position_m;
      subject.box = {glm::min(subject.box.low, p), glm::max(subject.box.high, p)};
    }

  subject.casters = scene::bounding_sphere(*scene, [](const scene::Primitive&) { return true; });
  subject.scene = std::move(scene);
  return subject;
}

}  // namespace dermis::setup
