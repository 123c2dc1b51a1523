// SPDX-License-Identifier: MIT
#include "setup/casters.h"

#include <algorithm>
#include <iterator>

namespace dermis::setup {
namespace {

std::vector<glm::vec3> placed(const std::vector<glm::vec3>& points_m, const Pose& pose) {
  std::vector<glm::vec3> out;
  out.reserve(points_m.size());
  std::transform(points_m.begin(), points_m.end(), std::back_inserter(out),
                 [&](const glm::vec3& p_m) { return pose.position(p_m); });
  return out;
}

}  // namespace

Casters::Casters(const Subject& subject, const PosedAsset* posed, const Pose& pose, bool deformed)
    : sphere_(pose.sphere(posed ? posed->all.sphere : subject.casters)) {
  if (deformed) return;
  if (!posed) {
    corners_m_ = placed(subject.caster_corners_m, pose);
    return;
  }

  corners_m_ = placed(posed->corners_m, pose);
  if (corners_m_.empty()) return;
  rest_corners_m_ = placed(subject.caster_corners_m, pose);
  rest_ = {pose.sphere(subject.casters), rest_corners_m_};
}

}  // namespace dermis::setup
