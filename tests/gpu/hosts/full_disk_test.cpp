// SPDX-License-Identifier: MIT
// A full disk costs a warning, never a result, and nothing half-written stays.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "dermis/error.h"
#include "dermis/reference.h"
#include "dermis/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "support/files.h"
#include "support/full_disk.h"
#include "support/thrown.h"
#include "support/variable.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

std::size_t files_below(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file();
  return count;
}

// Pipelines and what the skin sees of the studio cannot be kept.
TEST(AFullDisk, CostsARendererOneWarning) {
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  const TempFolder folder;
  const Variable cache("XDG_CACHE_HOME", folder.path().string()), driver("MESA_SHADER_CACHE_DISABLE", "true");
  std::vector<std::string> lines;
  const Hooks hooks{.log = [&](LogLevel, const std::string& line) { lines.push_back(line); }};
  RenderSettings s = small_settings("texture-space", 48, 64);
  s.lighting.environment = "studio";
  Picture picture;
  {
    const FullDisk full;
    Renderer own({.hooks = hooks});
    picture = own.render(scene, s);
    EXPECT_EQ(files_below(folder.path()), 0u) << "something half-written is left";
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_NE(lines[0].find("not kept for the next run"), std::string::npos) << lines[0];

    // The picture itself is told to whoever saves it, and is still there.
    EXPECT_NE(thrown<InputError>([&] { picture.save(folder.path() / "a.png"); }).find("cannot be written"),
              std::string::npos);
    EXPECT_EQ(files_below(folder.path()), 0u);
  }

  picture.save(folder.path() / "a.png");
  EXPECT_TRUE(Renderer({.hooks = hooks}).render(scene, s).linear_rgba == picture.linear_rgba);
  EXPECT_GE(files_below(folder.path()), 3u) << "the picture, pipelines, occlusion";
  EXPECT_EQ(lines.size(), 1u);
}

TEST(AFullDisk, CostsGroundTruthItsCheckpointOnly) {
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  const TempFolder folder;
  RenderSettings s = small_settings("lambert", 8, 64);
  s.output.exposure_ev = 0;
  std::vector<std::string> lines;
  int samples = 0;
  Hooks hooks{.log = [&](LogLevel, const std::string& line) { lines.push_back(line); },
              .progress = [&](const WorkProgress&) { return samples < 3; }};
  ReferenceSettings r{.samples = 1000, .checkpoint = folder.path() / "a.resume"};
  r.after_sample = [&](const ReferenceProgress& p) { samples = p.samples; };

  const FullDisk full;
  const ReferencePicture truth = render_reference(scene, s, r, hooks);
  EXPECT_EQ(truth.samples, 3);
  EXPECT_FALSE(truth.complete);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NE(lines[0].find("no checkpoint to resume from"), std::string::npos) << lines[0];
  EXPECT_EQ(files_below(folder.path()), 0u);
}

}  // namespace
}  // namespace dermis::tests
