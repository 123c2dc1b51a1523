// SPDX-License-Identifier: MIT
// The rig of the built-in head: expressions do what they are called, joints turn what hangs on them, and the
// clip begins and ends at rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

#include "head/builtin_head/builtin_head.h"
#include "head/builtin_head/openings.h"
#include "head/scene/rig/rig.h"
#include "support/built_in.h"

namespace dermis::builtin_head {
namespace {

using scene::AssetData;
using scene::Pose;

const AssetData& head() { return tests::built_in_head(); }
const scene::Rig& rig() { return *head().rig; }

AssetData posed(const Pose& pose) {
  AssetData moved = head();
  scene::take_pose(rig(), scene::posed(rig(), pose, "built-in"), moved);
  return moved;
}

Pose with_weight(std::string_view name, double weight) {
  Pose pose = rig().rest;
  for (std::size_t node = 0; node < rig().nodes.size(); ++node) {
    const std::vector<std::string>& names = rig().nodes[node].weights;
    if (const auto found = std::find(names.begin(), names.end(), name); found != names.end()) {
      pose[node].weights[static_cast<std::size_t>(found - names.begin())] = weight;
      return pose;
    }
  }
  ADD_FAILURE() << "no expression " << name;
  return pose;
}

// A node of the skin's net, mm.
vec3 node(const AssetData& scene, int column, int row) {
  const auto k = static_cast<std::size_t>(row * (Openings::columns + 1) + column);
  return scene.primitives.front().vertices[k].position_m * 1000.0f;
}

// Height of an opening in its middle, mm.
float gap(const AssetData& scene, const Opening& o, bool left = true) {
  const int middle = (o.from + o.to) / 2, column = left ? middle : Openings::columns - middle;
  return node(scene, column, o.middle + Openings::half).y - node(scene, column, o.middle - Openings::half).y;
}

float furthest(const AssetData& a, const AssetData& b) {
  float most = 0;
  for (std::size_t p = 0; p < a.primitives.size(); ++p) {
    for (std::size_t v = 0; v < a.primitives[p].vertices.size(); ++v) {
      most = std::max(most, 1000.0f * glm::distance(a.primitives[p].vertices[v].position_m,
                                                    b.primitives[p].vertices[v].position_m));
    }
  }
  return most;
}

TEST(Motion, AtRestNothingMoves) { EXPECT_LT(furthest(posed(rig().rest), head()), 1e-3f); }

TEST(Motion, ABlinkClosesItsOwnEye) {
  ASSERT_GT(gap(head(), Openings::eye), 9);
  const AssetData left = posed(with_weight("blink left", 1)), right = posed(with_weight("blink right", 1));
  EXPECT_LT(gap(left, Openings::eye, true), 1.5f);
  EXPECT_GT(gap(left, Openings::eye, false), 9);
  EXPECT_LT(gap(right, Openings::eye, false), 1.5f);
  EXPECT_GT(gap(right, Openings::eye, true), 9);
}

TEST(Motion, TheMouthOpensSmilesAndPurses) {
  constexpr Opening mouth = Openings::mouth;
  const auto width = [&](const AssetData& scene) {
    return node(scene, mouth.to, mouth.middle).x - node(scene, mouth.from, mouth.middle).x;
  };
  const auto corner = [&](const AssetData& scene) { return node(scene, mouth.to, mouth.middle).y; };
  EXPECT_LT(gap(head(), mouth), 1);

  EXPECT_GT(gap(posed(with_weight("jaw open", 1)), mouth), 14);
  const AssetData smile = posed(with_weight("smile", 1)), pucker = posed(with_weight("pucker", 1));
  EXPECT_GT(width(smile), width(head()) + 6);
  EXPECT_GT(corner(smile), corner(head()) + 3);
  EXPECT_LT(width(pucker), width(head()) - 8);
  EXPECT_LT(gap(smile, mouth), 2) << "lips stay together";
}

TEST(Motion, OnlyLowerTeethFollowTheJaw) {
  const AssetData open = posed(with_weight("jaw open", 1));
  for (std::size_t p = 0; p < open.primitives.size(); ++p) {
    const auto& now = open.primitives[p].vertices;
    const auto& before = head().primitives[p].vertices;
    const float moved = 1000.0f * glm::distance(now.front().position_m, before.front().position_m);
    if (open.primitives[p].name == "lower teeth") { EXPECT_GT(moved, 10); }
    if (open.primitives[p].name == "upper teeth") { EXPECT_LT(moved, 1e-3f); }
  }
}

TEST(Motion, TheClipOfSixSecondsBeginsAndEndsAtRest) {
  ASSERT_EQ(head().clips.size(), 1u);
  ASSERT_EQ(rig().clips.size(), 1u);
  const scene::Clip& clip = rig().clips.front().clip;
  EXPECT_EQ(clip.name, head().clips.front());
  EXPECT_DOUBLE_EQ(clip.end_s(), 6);

  const auto at = [&](double seconds) {
    Pose pose = rig().rest;
    scene::play(clip, seconds, pose);
    return posed(pose);
  };
  EXPECT_LT(furthest(at(0), head()), 1e-2f);
  EXPECT_LT(furthest(at(6), head()), 1e-2f);
  EXPECT_LT(gap(at(0.6), Openings::eye), 2) << "blinks";
  EXPECT_GT(furthest(at(2.6), head()), 10) << "turns";
  EXPECT_GT(gap(at(3.6), Openings::mouth), 10) << "opens the mouth";
}

TEST(Motion, TheClipUsesEveryExpressionAndJoint) {
  const scene::Clip& clip = rig().clips.front().clip;
  Pose most = rig().rest;
  std::vector<double> turned(most.size(), 0);
  for (double seconds = 0; seconds < 6; seconds += 0.05) {
    Pose pose = rig().rest;
    scene::play(clip, seconds, pose);
    for (std::size_t node = 0; node < pose.size(); ++node) {
      for (std::size_t k = 0; k < pose[node].weights.size(); ++k)
        most[node].weights[k] = std::max(most[node].weights[k], pose[node].weights[k]);
      const double cosine = glm::dot(pose[node].transform.rotation, rig().rest[node].transform.rotation);
      turned[node] = std::max(turned[node], 1 - std::abs(cosine));
    }
  }
  for (std::size_t node = 0; node < most.size(); ++node) {
    const std::string& name = rig().nodes[node].name;
    for (std::size_t k = 0; k < most[node].weights.size(); ++k)
      EXPECT_GT(most[node].weights[k], 0.8) << rig().nodes[node].weights[k];
    // The jaw opens by an expression, which carries the lips with it.
    if (name == "body" || name == "jaw") continue;
    EXPECT_GT(turned[node], 1e-4) << name;
  }
}

}  // namespace
}  // namespace dermis::builtin_head
