// SPDX-License-Identifier: MIT
// What is made of shards: boxes, a page, a job script, a benchmark.
#include <cmath>

#include "gpu/dataset/small_set.h"
#include "support/thrown.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

class Pages : public SmallSet {};

// A square of 0.2 m that faces the camera: its box follows from K and the distance.
TEST_F(Pages, BoxesAreThoseOfTheProjection) {
  recipe["size"] = {64, 48};
  recipe["identities"].erase(1);
  recipe["test_share"] = 0;
  recipe["samples"] = 4;
  recipe["settings"]["camera"] = {{"fov_deg", {{"uniform", {20, 60}}}}, {"distance", 8}};
  recipe["head"] = Tree::object();
  const fs::path set = prepared("set");
  write(set, {}, quiet);
  const Tree found = Tree::parse(coco(set));
  ASSERT_EQ(found["images"].size(), 4u);
  ASSERT_EQ(found["annotations"].size(), 4u);
  EXPECT_EQ(found["images"][2]["file_name"], "train-000000.tar/000002.png");
  EXPECT_EQ(found["licenses"][0]["name"], "MIT, A");

  const double distance_m = 8 * std::sqrt(0.02);  // of the sphere around the square
  for (int i = 0; i < 4; ++i) {
    const Tree sample = Tree::parse(recipe_of(set).parameters(static_cast<std::uint64_t>(i)));
    const double fov = sample["settings"]["camera"]["fov_deg"].get<double>() * 3.14159265358979 / 180;
    const double side = 0.2 / distance_m * 24 / std::tan(fov / 2);
    const Tree& box = found["annotations"][static_cast<std::size_t>(i)];
    EXPECT_EQ(box["image_id"], i);
    EXPECT_EQ(box["category_id"], 1);
    EXPECT_NEAR(box["bbox"][2].get<double>(), side, 1.01) << i;
    EXPECT_NEAR(box["bbox"][0].get<double>() + box["bbox"][2].get<double>() / 2, 32, 1) << i;
    EXPECT_NEAR(box["area"].get<double>(), side * side, 2.5 * side) << i;
  }
}

TEST_F(Pages, KeypointsAreOfTheHead) {
  recipe.update(Tree::parse(R"({
    "samples": 2, "samples_per_shard": 2, "test_share": 0, "size": [64, 64],
    "labels": ["instance", "region", "landmarks"], "identities": [{"asset": "built-in:ita-tan"}],
    "pose": {"weights": {"jaw open": {"uniform": [0, 1]}}}})"));
  const fs::path set = prepared("set");
  write(set, {}, quiet);
  EXPECT_EQ(verify(set, 1, quiet).faults, std::vector<std::string>{}) << "the same points when drawn again";

  const Tree found = Tree::parse(coco(set));
  ASSERT_EQ(found["categories"][0]["keypoints"].size(), 70u);
  for (int image = 0; image < 2; ++image) {
    SCOPED_TRACE(image);
    Tree head, nose;
    for (const Tree& one : found["annotations"])
      if (one["image_id"] == image)
        (one["category_id"] == 1 ? head : nose) = one["category_id"] == 3 ? nose : one;
    ASSERT_EQ(head["keypoints"].size(), 210u);
    EXPECT_EQ(head["num_keypoints"], 70);
    constexpr std::size_t tip = 30;  // of the nose
    const double x = head["keypoints"][3 * tip], y = head["keypoints"][3 * tip + 1];
    EXPECT_EQ(head["keypoints"][3 * tip + 2], 2);
    EXPECT_NEAR(x, nose["bbox"][0].get<double>() + nose["bbox"][2].get<double>() / 2,
                nose["bbox"][2].get<double>() / 2 + 1);
    EXPECT_NEAR(y, nose["bbox"][1].get<double>() + nose["bbox"][3].get<double>() / 2,
                nose["bbox"][3].get<double>() / 2 + 1);
  }
}

TEST_F(Pages, LandmarksNeedAHeadThatHasThem) {
  recipe["labels"] = {"landmarks"};
  EXPECT_NE(tests::thrown<InputError>([&] { prepared("set"); }).find("has no landmarks"), std::string::npos);
}

TEST_F(Pages, BoxesNeedALabel) {
  recipe["labels"] = {"depth"};
  const fs::path set = prepared("set");
  EXPECT_NE(tests::thrown<InputError>([&] { coco(set); }).find("its recipe has neither"), std::string::npos);
}

TEST_F(Pages, TheSheetShowsWhatWasDrawn) {
  recipe["name"] = "squares <of> skin";
  recipe["about"] = "For a test.";
  const fs::path set = prepared("set");
  EXPECT_NE(tests::thrown<InputError>([&] { sheet(set); }).find("holds no shard yet"), std::string::npos);
  write(set, {}, quiet);
  const std::string page = sheet(set, 9);
  for (const char* text :
       {"squares &lt;of&gt; skin", "For a test.", "3 to train, 1 to test, of 4", "18 of 18",
        "settings.camera.orbit_deg[1]", "settings.lighting.rig_lights", "head.turn_deg[2]",
        "morphs of free.gltf.grow", "CC-BY-4.0", "made here", "000016 region", "ITA class of the skin"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  std::size_t pictures = 0;
  for (std::size_t at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1))
    ++pictures;
  EXPECT_EQ(pictures, 9u + 4 * 3 + 5)
      << "nine samples; of four all three labels that are PNG, of the rest one mask";
}

TEST_F(Pages, TheSheetHasTheMaskThatSaysMostAndTheLandmarks) {
  recipe.update(Tree::parse(R"({
    "samples": 5, "views_per_identity": 1, "test_share": 0, "size": [48, 48],
    "labels": ["instance", "region", "part", "landmarks"], "identities": [{"asset": "built-in:ita-tan"}]})"));
  const fs::path set = prepared("set");
  write(set, {}, quiet);
  const std::string page = sheet(set, 5);
  EXPECT_NE(page.find("000000 instance"), std::string::npos);
  EXPECT_NE(page.find("000004 part"), std::string::npos);
  EXPECT_EQ(page.find("000004 region"), std::string::npos);
  EXPECT_NE(page.find("000004 landmarks"), std::string::npos);
  const std::size_t tones = page.find("ITA class of the skin");
  EXPECT_NE(page.rfind("5 samples", tones), std::string::npos) << "all are tan";
}

TEST_F(Pages, TheDatasheetSaysWhatIsInTheSetAndWhatIsNot) {
  recipe["name"] = "squares | *of* <skin>";
  recipe["about"] = "For a test.";
  recipe["identities"][0]["asset"] = "built-in:ita-brown";
  recipe["identities"][0].erase("licence");
  const fs::path set = prepared("set");
  EXPECT_NE(tests::thrown<InputError>([&] { datasheet(set); }).find("holds no shard yet"), std::string::npos);
  const std::vector<std::uint64_t> two{0, 1};
  write(set, two, quiet);
  const std::string text = datasheet(set);
  for (const char* line :
       {"# Datasheet: squares \\| \\*of\\* &lt;skin>\n", "For a test.\n",
        "- 18 samples, of which 8 are drawn", "- 4 identities: 3 to train, 1 to test",
        "| `settings.camera.orbit_deg` | `[{\"uniform\":[-40,40]},",
        "| `settings.technique` | `\"lambert\"` |",
        "| `identities[1].morphs.grow` | `{\"uniform\":[0,0.3]}` |", "| `region` |",
        "| free.gltf | CC-BY-4.0 | A. Author, CC BY 4.0 | free.gltf | none |", "| built-in:ita-brown | MIT |",
        "Nobody has a skin of the classes: light, intermediate, tan, dark.",
        "4 identities do not show how people differ", "| free.gltf | "})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;

  // Identities and samples of all rows are those of the recipe.
  std::uint64_t people = 0, samples = 0;
  for (const char* tone : {"very light", "brown"}) {
    const std::size_t at = text.find(std::string("\n| ") + tone + " |");
    ASSERT_NE(at, std::string::npos) << tone << "\n" << text;
    unsigned train = 0, test = 0, drawn = 0;
    ASSERT_EQ(
        std::sscanf(text.c_str() + at + 5 + std::string(tone).size(), "%u | %u | %u", &train, &test, &drawn),
        3);
    people += train + test;
    samples += drawn;
  }
  EXPECT_EQ(people, 4u);
  EXPECT_EQ(samples, 18u);
}

TEST_F(Pages, TheBenchmarkCountsAndLeavesNothing) {
  const Benchmark b = bench(write_recipe(), 18, quiet);
  EXPECT_EQ(b.samples, 18u);
  EXPECT_GT(b.total_s, 0);
  EXPECT_GT(b.bare_s, 0);
  EXPECT_GT(b.encoding_s, 0);
  EXPECT_GT(b.bytes, 18u * 3 * 512);
  EXPECT_NEAR(b.setting_s + b.drawing_s + b.waiting_s + b.writing_s, b.total_s, 0.3 * b.total_s);
  EXPECT_EQ(files_of(folder()), (std::vector<std::string>{"free.gltf", "plain.gltf", "recipe.json"}));
}

// Time per sample is that of the data set only if heads are loaded as rarely as in it.
TEST_F(Pages, TheBenchmarkLoadsNoMoreHeadsThanTheSet) {
  recipe["samples"] = 64;
  recipe["test_share"] = 0;
  recipe["identities"][1]["count"] = 1;  // two people of 32 samples each
  EXPECT_EQ(bench(write_recipe(), 20, quiet).heads, 0u);
  const Benchmark whole = bench(write_recipe(), 1000, quiet);
  EXPECT_EQ(whole.samples, 64u);
  EXPECT_EQ(whole.heads, 1u) << "the second";
}

TEST_F(Pages, JobScriptsRefuseWhatTheyCannotHold) {
  const fs::path set = prepared("set");
  EXPECT_NE(slurm_script(set).find("#SBATCH --array=0-4\n"), std::string::npos);
  EXPECT_NE(slurm_script(set, {.most_tasks = 2}).find("shards=5 run=3\n"), std::string::npos);
  const auto refused = [&](const SlurmOptions& options) {
    return tests::thrown<InputError>([&] { slurm_script(set, options); });
  };
  EXPECT_NE(refused({.minutes = 1}).find("2 to 525600"), std::string::npos);
  EXPECT_NE(refused({.most_tasks = 0}).find("1 to 1000000"), std::string::npos);
  EXPECT_NE(refused({.partition = "a\n#SBATCH --uid=0"}).find("partition"), std::string::npos);
  const fs::path odd = prepared("odd\nname");
  EXPECT_NE(tests::thrown<InputError>([&] { slurm_script(odd); }).find("folder"), std::string::npos);
}

}  // namespace
}  // namespace dermis::dataset
