// SPDX-License-Identifier: MIT
// What is written: complete or not at all, and only JSON where JSON was asked for. Too little memory ends as
// any other error.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Output : public Program {
 protected:
  std::string head() const { return file("head.gltf", tiny_gltf()); }
};

TEST_F(Output, FoldersAndEndings) {
  const std::string scene = head();
  expect_refused(run({"render", scene, "-o", (folder() / "none" / "a.png").string()}), "does not exist");
  expect_refused(run({"render", scene, "-o", (folder() / "a.bmp").string()}), ".bmp");
  expect_refused(run({"render", scene, "-o", (folder() / "a").string()}), ".png or .exr");
  expect_refused(run({"render", scene, "-o", "-"}), ".png or .exr");
  expect_refused(run({"render", scene, "-o", ""}), ".png or .exr");
  fs::create_directory(folder() / "folder.png");
  expect_refused(run({"render", scene, "-o", (folder() / "folder.png").string()}), "is a directory");
  expect_refused(render({scene, "--stats", (folder() / "none" / "s.json").string()}), "does not exist");
  expect_refused(render({scene, "--stats", picture().string()}), "a file of its own");
  expect_refused(run({"plan", scene, "-o", (folder() / "none" / "p.txt").string()}), "does not exist");
}

// The cache, too, cannot be written: a warning comes before the error.
TEST_F(Output, AFullDiskIsAnErrorThatLeavesNothing) {
  const std::string scene = head();
  expect_refused(render({scene}, {.file_bytes = 600}), "picture.png: cannot be written");
  expect_refused(run({"plan", scene, "-o", (folder() / "p.txt").string()}, {.file_bytes = 600}),
                 "p.txt: cannot be written");
  EXPECT_FALSE(fs::exists(folder() / "p.txt"));

  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  expect_refused(run({"plan", scene, "-o", "/dev/full"}), "/dev/full: cannot be written");
}

TEST_F(Output, EndingsInCapitalsAndNamesAsLongAsTheyMayBe) {
  const std::string scene = head();
  for (const std::string& name :
       {std::string("A.PNG"), std::string("A.Exr"), std::string(251, 'a') + ".png"}) {
    const Result result = run({"render", scene, "--size", "32x32", "-o", (folder() / name).string()});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(fs::exists(folder() / name)) << name;
  }
}

TEST_F(Output, ALinkStaysAndWhatItNamesIsWritten) {
  const std::string scene = head();
  fs::create_directory(folder() / "store");
  fs::create_symlink(fs::path("store") / "real.png", folder() / "there.png");
  fs::create_symlink("there.png", picture());
  ASSERT_TRUE(expect_rendered(render({scene})));
  EXPECT_TRUE(fs::is_symlink(picture()) && fs::is_symlink(folder() / "there.png"));
  EXPECT_TRUE(fs::is_regular_file(folder() / "store" / "real.png"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder() / "store"), {}), 1) << "nothing unfinished";

  fs::create_symlink("round.png", folder() / "round.png");
  const Result round = run({"render", scene, "-o", (folder() / "round.png").string()});
  EXPECT_EQ(round.status, 1);
  EXPECT_NE(round.err.find("round.png: cannot be written"), std::string::npos) << round.err;
}

TEST_F(Output, StandardOutputThatTakesNothingIsAnError) {
  for (const Arguments& arguments :
       {Arguments{"info"}, Arguments{"--help"}, Arguments{"render", "--help"}, Arguments{"--version"}})
    EXPECT_EQ(run(arguments, {.file_bytes = 1}).status, 1) << arguments[0];
}

// A lamp in candela, as a file of another program may have it: a white picture says which exposure it needs.
TEST_F(Output, APictureOverWhiteNamesTheExposure) {
  const Result white = render({head(), "--light", "0,10,2000"});
  ASSERT_TRUE(expect_rendered(white));
  const std::string says = "of the skin is over white: output.exposure_ev (--exposure) ";
  const std::size_t at = white.err.find(says);
  ASSERT_NE(at, std::string::npos) << white.err;
  const std::string exposure =
      white.err.substr(at + says.size(), white.err.find(' ', at + says.size()) - at - says.size());
  EXPECT_NEAR(std::stod(exposure), std::log2(0.4 / 2000), 3) << "an albedo of 0.1 to 1 under 2000";

  const Result right = render({head(), "--light", "0,10,2000", "--exposure", exposure});
  ASSERT_TRUE(expect_rendered(right));
  EXPECT_EQ(right.err, "");
  EXPECT_EQ(run({"render", head(), "--light", "0,10,2000", "--size", "48x48", "-o",
                 (folder() / "linear.exr").string()})
                .err,
            "");
}

TEST_F(Output, APictureWithoutSkinSaysSo) {
  const Result away = render({head(), "--eye", "0,0,1", "--target", "0,0,2"});
  ASSERT_TRUE(expect_rendered(away));
  EXPECT_NE(away.err.find("no skin is in the picture: camera.orbit_deg (--orbit)"), std::string::npos)
      << away.err;
  EXPECT_EQ(render({head()}).err, "");
}

TEST_F(Output, StatisticsAloneOnStandardOutput) {
  const Result result = render({head(), "--stats", "-"});
  ASSERT_TRUE(expect_rendered(result));
  const json statistics = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(statistics.is_object()) << result.out;
  EXPECT_EQ(statistics.at("size"), json({48, 48}));
  const Result devices = run({"info", "--json"});
  EXPECT_TRUE(json::accept(devices.out)) << devices.out;
}

TEST_F(Output, TheCacheSaysWhatItHoldsAndIsCleared) {
  const fs::path cache = folder() / "kept" / "dermis";
  fs::create_directories(cache);
  const Surroundings here{.variables = {"XDG_CACHE_HOME=" + (folder() / "kept").string()}};
  std::ofstream(cache / "occlusion-1.bin") << "12345";
  std::ofstream(cache / "mine.txt") << "stays";

  const auto kinds = [&](const Arguments& arguments) {
    const json said = json::parse(run(arguments, here).out, nullptr, false);
    EXPECT_EQ(said.at("cache").at("folder"), cache.string());
    return said.at("cache").at("kinds");
  };

  EXPECT_EQ(kinds({"info", "--cache", "--json"}).at("occlusion"), json({{"files", 1}, {"bytes", 5}}));
  EXPECT_NE(run({"info", "--cache"}, here).out.find("limit 1000 MB"), std::string::npos);
  EXPECT_EQ(kinds({"info", "--clear-cache", "--json"}).at("occlusion").at("files"), 1);
  EXPECT_EQ(kinds({"info", "--cache", "--json"}).at("occlusion").at("files"), 0);
  EXPECT_TRUE(fs::exists(cache / "mine.txt"));

  // Without a home nothing is kept, and nothing is wrong.
  const Result homeless = run({"info", "--cache"}, {.variables = {"XDG_CACHE_HOME=", "HOME="}});
  EXPECT_EQ(homeless.status, 0);
  EXPECT_NE(homeless.out.find("nothing is kept"), std::string::npos);
}

TEST_F(Output, StatisticsInAFileAndASummaryForPeople) {
  const Result result = render({head(), "--stats", (folder() / "s.json").string(), "--frames", "2"});
  ASSERT_TRUE(expect_rendered(result));
  EXPECT_EQ(json::parse(read_text(folder() / "s.json")).at("frame_ms").at("frames"), 2);
  EXPECT_NE(result.out.find("irradiance"), std::string::npos);
  EXPECT_EQ(result.err, "") << "no progress when piped, no warning for a whole head";
}

TEST_F(Output, ExrIsLinearAndTheSameEachTime) {
  const std::string scene = head(), first = (folder() / "a.exr").string(),
                    second = (folder() / "b.exr").string();
  for (const std::string& name : {first, second})
    ASSERT_EQ(run({"render", scene, "-o", name, "--size", "48x48", "--map-size", "64", "--shadow-size", "64"})
                  .status,
              0);
  const std::string bytes = read_text(first);
  EXPECT_TRUE(bytes.starts_with("\x76\x2f\x31\x01"));
  EXPECT_EQ(bytes, read_text(second));
}

// An old picture survives a run that fails, and one that is killed.
TEST_F(Output, AnOldFileSurvives) {
  const std::string scene = head();
  const auto old_is_there = [&] { return read_text(picture()) == "the old picture"; };
  file("picture.png", "the old picture");
  EXPECT_EQ(render({(folder() / "missing.glb").string()}).status, 1);
  EXPECT_TRUE(old_is_there());
  EXPECT_EQ(render({scene, "--map-size", "zero"}).status, 2);
  EXPECT_EQ(render({scene, "--bloom", "2"}).status, 1);
  EXPECT_TRUE(old_is_there());
  EXPECT_EQ(render({scene, "--frames", "1000000"}, {.variables = {}, .kill_after_s = 1.5}).status, 128 + 9);
  EXPECT_TRUE(old_is_there());
  EXPECT_TRUE(expect_rendered(render({scene})));
  EXPECT_FALSE(old_is_there());
}

// 64 shadow maps of 16384 x 16384: 64 GiB, more than a device has, or more layers than it takes. Said before
// any work on the scene.
// A map that is shown is as large as it may be, also in a small picture.
TEST_F(Output, TooLittleDeviceMemory) {
  expect_refused(render({head(), "--shadow-size", "16384", "--lights", "64", "--show", "shadow:0"}),
                 "shadow");
}

// Without a device in between: drivers may fall over when the system has no memory left, our own code must
// not. Less than these and the libraries do not even load.
TEST_F(Output, TooLittleMemory) {
  int refused = 0;
  for (const std::uint64_t mib : {100, 120, 140}) {
    SCOPED_TRACE(mib);
    const Result result = run({"plan", "-o", (folder() / "plan.txt").string()},
                              {.variables = {}, .address_space_bytes = mib << 20});
    if (result.status == 0) continue;
    expect_refused(result, "memory");
    EXPECT_FALSE(fs::exists(folder() / "plan.txt"));
    ++refused;
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace dermis::tests
