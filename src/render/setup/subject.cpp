// SPDX-License-Identifier: MIT
#include "render/setup/subject.h"

#include <utility>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/warnings.h"
#include "head/scene/framing.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/enclosure.h"

namespace dermis::setup {

SubjectPointer examine(std::shared_ptr<const scene::AssetData> asset) {
  const WarningGroup group;
  Subject subject;
  subject.skin = scene::skin_meshes(*asset);
  Steps steps("measuring the unwrap", subject.skin.size());
  for (const scene::SkinMesh& mesh : subject.skin) {
    scene::warn_overlap(mesh);
    subject.densities.push_back(scene::unwrap_density(mesh, asset->mm_per_unit));
    steps.done();
  }

  subject.bounds = scene::skin_bounds(*asset);
  if (!(subject.bounds.sphere.radius_m > 0))
    throw input_error(asset->name, "has nothing to see: all its triangles lie at one point");

  subject.casters = scene::bounding_sphere(*asset, [](const scene::Primitive&) { return true; });
  subject.caster_corners_m = scene::enclosing_corners(*asset);
  subject.asset = std::move(asset);
  return std::make_shared<const Subject>(std::move(subject));
}

}  // namespace dermis::setup
