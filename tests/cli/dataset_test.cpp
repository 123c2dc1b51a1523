// SPDX-License-Identifier: MIT
// `dermis dataset`: its statuses and its lines. tests/gpu/dataset holds what it does.
#include <nlohmann/json.hpp>

#include "program.h"
#include "tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

class Dataset : public Program {
 protected:
  Dataset() {
    file("square.gltf", tiny_gltf());
    recipe = nlohmann::json::parse(R"({
      "schema": 1, "name": "squares", "samples": 6, "samples_per_shard": 2, "size": [24, 20],
      "labels": ["instance", "depth"],
      "identities": [{"asset": "square.gltf", "licence": {"spdx": "MIT", "author": "A", "source": "here"}}],
      "settings": {"technique": "lambert", "quality": {"map_size": 64, "shadow_size": 64},
                   "camera": {"orbit_deg": [{"uniform": [-30, 30]}, 0]}, "output": {"exposure_ev": 0}}})");
  }
  Result dataset(const Arguments& arguments, const Surroundings& surroundings = {}) const {
    Arguments all{"dataset"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run(all, surroundings);
  }
  std::string set() const { return (folder() / "set").string(); }
  Result prepare() const { return dataset({"prepare", file("recipe.json", recipe.dump()), "-o", set()}); }

  nlohmann::json recipe;
};

TEST_F(Dataset, IsPreparedDrawnAndVerified) {
  Result result = prepare();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, set() + ": 6 samples of 1 identities in 3 shards\n");
  EXPECT_EQ(dataset({"missing", set()}).out, "0-2\n");
  EXPECT_EQ(dataset({"write", set(), "--shard", "1"}).status, 0);
  EXPECT_EQ(dataset({"missing", set()}).out, "0,2\n");
  EXPECT_EQ(dataset({"write", set()}).out,
            "2 shards drawn, 4 samples; 1 were there, 0 are drawn by other workers\n");
  EXPECT_EQ(dataset({"missing", set()}).out, "");

  result = dataset({"verify", set()});
  EXPECT_EQ(result.status, 0) << result.out;
  EXPECT_NE(result.out.find("3 shards, 6 samples, 1 drawn again, 0 faults"), std::string::npos) << result.out;
  fs::remove(fs::path(set()) / "train-000002.tar");
  result = dataset({"verify", set(), "--redraw", "0"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.out.find("fault: train-000002.tar: is missing"), std::string::npos) << result.out;

  result = dataset({"coco", set()});
  EXPECT_EQ(result.status, 0) << result.err;
  const auto coco = nlohmann::json::parse(result.out);
  EXPECT_EQ(coco["images"].size(), 4u);
  EXPECT_EQ(coco["annotations"].size(), 4u);
  EXPECT_EQ(dataset({"datasheet", set()}).out,
            "page: " + fs::absolute(fs::path(set()) / "datasheet.md").string() + "\n");
  EXPECT_NE(read_text(fs::path(set()) / "datasheet.md").find("| square.gltf | MIT | A | here | none |"),
            std::string::npos);
  EXPECT_EQ(dataset({"sheet", set()}).status, 0);
  EXPECT_NE(read_text(fs::path(set()) / "sheet.html").find("settings.camera.orbit_deg[0]"),
            std::string::npos);
}

TEST_F(Dataset, AFullDiskIsStatus75) {
  ASSERT_EQ(prepare().status, 0);
  const Result result = dataset({"write", set()}, {.file_bytes = 3000});
  EXPECT_EQ(result.status, 75);
  EXPECT_NE(result.err.find("cannot be written"), std::string::npos) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_EQ(dataset({"missing", set()}).out, "0-2\n");
}

TEST_F(Dataset, AnInterruptIsStatus75AndLeavesNothing) {
  recipe["samples"] = 4000;
  recipe["samples_per_shard"] = 2000;
  ASSERT_EQ(prepare().status, 0);
  Surroundings interrupted{.interrupt_after_s = 1};
  interrupted.from_file = fs::path(set()) / "recipe.lock.json";
  const Result result = dataset({"write", set()}, interrupted);
  EXPECT_EQ(result.status, 75) << result.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(set()), fs::directory_iterator()), 1);
}

TEST_F(Dataset, MistakesAreOneLine) {
  const auto says = [&](const Arguments& arguments, const std::string& text) {
    const Result result = dataset(arguments);
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  };
  says({"verifi", set()}, "did you mean 'verify'?");
  says({"write", set()}, "no prepared data set");
  says({"prepare", set()}, "no such file");
  says({"missing", set(), "--redraw", "1"}, "does not take it");
  says({"write", set(), "--shard", "3-1"}, "expected numbers and ranges");
  recipe["sampels"] = 3;
  says({"prepare", file("recipe.json", recipe.dump())}, "sampels");
  EXPECT_EQ(dataset({"write"}).status, 2);
}

TEST_F(Dataset, TheJobScriptIsOfItsFolder) {
  ASSERT_EQ(prepare().status, 0);
  const Result result = dataset({"slurm", set(), "--tasks", "2", "--partition", "night", "--minutes", "90"});
  EXPECT_EQ(result.status, 0) << result.err;
  for (const std::string& line : {std::string("#SBATCH --array=0-1\n"), std::string("#SBATCH -p night\n"),
                                  std::string("#SBATCH --time=90\n"),
                                  "folder='" + fs::weakly_canonical(set()).string() + "' shards=3 run=2\n"})
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  EXPECT_EQ(result.out.rfind('@'), result.out.find("@60")) << "nothing is left to fill in";
}

}  // namespace
}  // namespace dermis::tests
