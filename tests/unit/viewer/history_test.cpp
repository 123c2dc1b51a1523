// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "unit/viewer/documents.h"
#include "viewer/model/animation.h"

namespace dermis::viewer {
namespace {

void set_bloom(History& history, double bloom, std::uint64_t gesture = 0) {
  Document next = history.now();
  next.settings.output.bloom = bloom;
  history.take(std::move(next), "bloom", gesture);
}

double bloom(const History& history) { return history.now().settings.output.bloom; }

TEST(History, EveryChangeIsUndoneAndRedone) {
  History history(tests::square_document());
  const double first = bloom(history);
  EXPECT_FALSE(history.can_undo());
  for (const double value : {0.1, 0.2, 0.3}) set_bloom(history, value);
  history.undo();
  EXPECT_EQ(bloom(history), 0.2);
  EXPECT_EQ(history.undo_name(), "bloom");
  history.undo();
  history.undo();
  EXPECT_EQ(bloom(history), first);
  EXPECT_FALSE(history.can_undo());
  history.undo();
  for (int i = 0; i < 3; ++i) history.redo();
  EXPECT_EQ(bloom(history), 0.3);
  EXPECT_FALSE(history.can_redo());
}

TEST(History, ADragIsOneChange) {
  History history(tests::square_document());
  for (int i = 0; i < 50; ++i) set_bloom(history, 0.01 * i, 7);
  set_bloom(history, 0.9, 8);
  history.undo();
  EXPECT_EQ(bloom(history), 0.01 * 49);
  history.undo();
  EXPECT_FALSE(history.can_undo());
}

TEST(History, ANewChangeEndsWhatCouldBeRedone) {
  History history(tests::square_document());
  set_bloom(history, 0.1);
  set_bloom(history, 0.2);
  history.undo();
  set_bloom(history, 0.7);
  EXPECT_FALSE(history.can_redo());
  history.undo();
  EXPECT_EQ(bloom(history), 0.1);
}

TEST(History, RevisionsGrowWithEachStep) {
  History history(tests::square_document());
  std::uint64_t last = history.revision();
  set_bloom(history, 0.1);
  EXPECT_GT(history.revision(), last);
  last = history.revision();
  history.undo();
  EXPECT_GT(history.revision(), last);
  last = history.revision();
  history.undo();  // nothing there
  EXPECT_EQ(history.revision(), last);
}

TEST(History, ASkinIsSeenWhenItsProfileIsThere) {
  History history(tests::square_document());
  const std::uint64_t first = history.revision();
  Document next = history.now();
  next.skin.kind = SkinKind::spectral;
  ++next.skin.serial;
  history.take(next, "skin");
  EXPECT_EQ(history.revision(), first);
  EXPECT_TRUE(history.can_undo());

  history.amend(next);
  EXPECT_GT(history.revision(), first);
  next.skin.kind = SkinKind::scene;
  ++next.skin.serial;
  const std::uint64_t amended = history.revision();
  history.take(next, "skin");
  EXPECT_GT(history.revision(), amended);
}

TEST(History, ForgetsTheOldest) {
  History history(tests::square_document());
  for (std::size_t i = 0; i < 2 * most_undo; ++i) set_bloom(history, 1e-3 * static_cast<double>(i));
  std::size_t steps = 0;
  for (; history.can_undo(); ++steps) history.undo();
  EXPECT_EQ(steps, most_undo);
}

TEST(Contents, AreEqualUntilSomethingIsEdited) {
  const Document document = tests::square_document();
  Scene copy = document.scene;
  EXPECT_TRUE(same_contents(document.scene, copy));
  copy.add_light({});
  EXPECT_FALSE(same_contents(document.scene, copy));
  copy = document.scene;
  copy.set_mix(copy.instances().front(), 0.3);
  EXPECT_FALSE(same_contents(document.scene, copy));
  copy = document.scene;
  copy.set_environment(SceneEnvironment{.file = "studio"});
  EXPECT_FALSE(same_contents(document.scene, copy));
}

TEST(Weights, AreSetByName) {
  RigPose pose;
  EXPECT_TRUE(is_rest(pose));
  EXPECT_EQ(weight_of(pose, "smile"), 0);
  set_weight(pose, "smile", 0.5);
  set_weight(pose, "frown", 0.1);
  set_weight(pose, "smile", 0.7);
  EXPECT_EQ(weight_of(pose, "smile"), 0.7);
  EXPECT_EQ(pose.weights.size(), 2u);
  EXPECT_FALSE(is_rest(pose));
}

}  // namespace
}  // namespace dermis::viewer
