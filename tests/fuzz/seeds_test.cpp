// SPDX-License-Identifier: MIT
// The fuzzer's own seeds and what it has found, through the functions that it calls: what was mended stays
// so, and the targets do not rot. A seed whose name begins with "refused-" is bad input that must end in an
// error.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/core/file.h"
#include "support/log_lines.h"
#include "targets.h"

namespace dermis::fuzz {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, bool (*)(Bytes)> targets = {{"gltf", gltf},
                                                        {"glb", glb},
                                                        {"png", png},
                                                        {"jpeg", jpeg},
                                                        {"hdr", hdr},
                                                        {"exr", exr},
                                                        {"scene_file", scene_file},
                                                        {"profile", profile},
                                                        {"layers", layers},
                                                        {"table", table},
                                                        {"exchange", exchange},
                                                        {"benchmark", benchmark},
                                                        {"checkpoint", checkpoint},
                                                        {"occlusion_cache", occlusion_cache},
                                                        {"monte_carlo_cache", monte_carlo_cache}};

fs::path seeds_folder() { return fs::path(DERMIS_SOURCE_DIR) / "tests" / "fuzz" / "seeds"; }

std::vector<fs::path> files_of(const std::string& target) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(seeds_folder() / target)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class Seeds : public testing::TestWithParam<std::string> {
 protected:
  tests::LogLines quiet_;
};

TEST_P(Seeds, AreAcceptedOrRefusedInOneLine) {
  bool (*const target)(Bytes) = targets.at(GetParam());
  bool any_accepted = false;

  for (const fs::path& file : files_of(GetParam())) {
    SCOPED_TRACE(file.filename().string());
    const bool accepted = target(read_file(file, std::uint64_t{1} << 20, true));
    const bool must_refuse = file.filename().string().starts_with("refused-");
    EXPECT_EQ(accepted, !must_refuse);
    any_accepted |= accepted;
  }
  EXPECT_TRUE(any_accepted) << "without a good seed a target reaches nothing";
}

INSTANTIATE_TEST_SUITE_P(Targets, Seeds, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& [name, target] : targets) names.push_back(name);
                           return names;
                         }()),
                         [](const auto& test) { return test.param; });

// A folder without a target, or a target without seeds, would be left out silently.
TEST(SeedFolders, HaveATarget) {
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(seeds_folder())) {
    EXPECT_TRUE(targets.contains(entry.path().filename().string())) << entry.path().filename();
    ++folders;
  }
  EXPECT_EQ(folders, targets.size());
}

}  // namespace
}  // namespace dermis::fuzz
