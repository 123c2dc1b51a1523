// SPDX-License-Identifier: MIT
// What the viewer asks `dermis sequence` for.
#include "viewer/model/recording.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/viewer/documents.h"
#include "viewer/model/camera_moves.h"

namespace dermis::viewer {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

TEST(Recording, ATurntableFramesTheHeadAtTheHeightOfTheCamera) {
  Document document = tests::square_document();
  set_camera(document.settings, {.eye_m = {0, 1.5, 1}, .target_m = {0, 0.5, 0}, .fov_deg = 30});
  document.settings.output.exposure_ev = 1.5;
  const std::string line =
      joined(sequence_words({.fps = 12, .seconds = 3}, {"head.glb"}, document, "best", "out/turn"));
  EXPECT_TRUE(line.starts_with("sequence head.glb ")) << line;
  EXPECT_NE(line.find("--orbit 0,45..360,45 --fps 12 --to 3 --device best -o out/turn-%04d.png"),
            std::string::npos)
      << line;
  EXPECT_NE(line.find("--fov 30"), std::string::npos) << line;
  EXPECT_NE(line.find("--exposure 1.5"), std::string::npos) << line;
  EXPECT_EQ(line.find("--eye"), std::string::npos) << line;
}

TEST(Recording, ALampGoesAroundBeforeTheCameraThatStands) {
  Document document = tests::square_document();
  set_camera(document.settings, {.eye_m = {0, 0.5, 1}, .target_m = {0, 0.5, 0}, .fov_deg = 30});
  const std::string line = joined(
      sequence_words({.motion = RecordedMotion::lamp, .video = true}, {"a.json"}, document, "0", "lamp"));
  EXPECT_NE(line.find("--eye 0,0.5,1"), std::string::npos) << line;
  EXPECT_NE(line.find("--light-orbit 0,30..360,30 --fps 30 --to 4 --device 0 -o lamp.mp4"), std::string::npos)
      << line;
}

TEST(Recording, AClipIsAsLongAsItIs) {
  const Document document = tests::square_document();
  EXPECT_EQ(clip_of(document.scene), "");
  const std::string line =
      joined(sequence_words({.motion = RecordedMotion::clip}, {"a.json"}, document, "best", "clip"));
  EXPECT_EQ(line.find("--to"), std::string::npos) << line;
}

TEST(Recording, SaysWhatTheCommandSaid) {
  // The test's own folder has no program dermis: it cannot be started.
  EXPECT_THROW(record({"sequence"}, {}), InputError);
}

}  // namespace
}  // namespace dermis::viewer
