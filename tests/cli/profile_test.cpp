// SPDX-License-Identifier: MIT
// From tissue to picture by the program itself: `dermis profile` writes what `dermis render` takes.
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "cli/tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Profile : public Program {
 protected:
  Result profile(const Arguments& more) const {
    Arguments arguments{"profile", "--preset", "skin1", "--gaussians", "6", "--photons", "20000"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  std::string path(const std::string& name) const { return (folder() / name).string(); }
};

TEST_F(Profile, RenderTakesWhatItWrites) {
  const Result made = profile({"--plot", path("a.svg"), "-o", path("a.json")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.err, "") << "no progress when piped";
  EXPECT_TRUE(made.out.starts_with("skin1: Monte-Carlo\n")) << made.out;
  EXPECT_NE(made.out.find("model chosen: the lowest reduced albedo is 0.678 (blue)"), std::string::npos)
      << made.out;
  EXPECT_TRUE(read_text(path("a.svg")).starts_with("<svg "));
  const json written = json::parse(read_text(path("a.json")));
  EXPECT_EQ(written.at("name"), "skin1");
  EXPECT_LE(written.at("variances_mm2").size(), 6u);
  EXPECT_TRUE(expect_rendered(render({"--profile", path("a.json")}))) << "of the built-in head";
  // Not by the default profile: a head that is quickly loaded shows it.
  const std::string head = file("head.gltf", tiny_gltf());
  EXPECT_TRUE(expect_rendered(render({head, "--profile", path("a.json")})));
  const std::string ours = read_text(picture());
  EXPECT_TRUE(expect_rendered(render({head})));
  EXPECT_NE(ours, read_text(picture()));
}

TEST_F(Profile, VariancesPerChannelAreNotForRender) {
  ASSERT_EQ(profile({"--variances", "per-channel", "-o", path("each.json")}).status, 0);
  expect_refused(render({file("head.gltf", tiny_gltf()), "--profile", path("each.json")}),
                 "make the profile with shared ones");
}

TEST_F(Profile, ExitStatuses) {
  const Result piped = profile({"--model", "dipole", "-o", "-"});
  EXPECT_EQ(piped.status, 0);
  EXPECT_TRUE(json::accept(piped.out)) << piped.out;
  expect_not_understood(run({"profile"}), "--preset");
  expect_not_understood(run({"profile", "--preset", "skin1", "--melanin", "0.02"}), "--melanin");
  expect_not_understood(run({"profile", "--preset", ""}), "--preset");
  expect_not_understood(profile({"--seed", "-1"}), "--seed");
  expect_not_understood(run({"profile", "--preset", "skin1", "--gaussians", "six"}), "--gaussians");
  expect_refused(run({"profile", "--preset", "skin3"}), "skin2");
  expect_refused(run({"profile", "--preset", "skin1", "--gaussians", "9"}),
                 "gaussians (--gaussians) must be 1 to 8");
  expect_refused(run({"profile", "--melanin", "2"}), "melanin (--melanin) must be 0 to 0.5, got 2");
  expect_refused(run({"profile", "--melanin", "0.1", "--haemoglobin", "1"}),
                 "haemoglobin (--hemoglobin) must be");
  expect_refused(run({"profile", "--preset", "skin1", "--photons", "10"}), "photons (--photons) must be");
  expect_refused(profile({"-o", path("none/a.json")}), "does not exist");
  expect_refused(profile({"-o", path("a"), "--plot", path("a")}), "same file");
  EXPECT_FALSE(fs::exists(path("a")));
}

// A full disk behind standard output: the shell brings it there, as a user's would.
TEST_F(Profile, AFullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  for (const std::string& what : {std::string("-o -"), std::string("--export unity"), std::string()}) {
    const std::string line = std::string(DERMIS_PROGRAM) + " profile --preset skin1 --model dipole " + what +
                             " > /dev/full 2> " + path("said");
    const int status = std::system(line.c_str());
    EXPECT_EQ(status, 1 << 8) << what;  // as wait() packs exit status 1
    EXPECT_TRUE(read_text(path("said")).starts_with("dermis: standard output: cannot be written"))
        << what << read_text(path("said"));
  }
}

TEST_F(Profile, HelpNamesUnitsAndDefaults) {
  const Result help = run({"profile", "--help-all"});
  EXPECT_EQ(help.status, 0);
  for (const char* text : {"per mm", "1/mm^2", "=500000", "=6", "=shared", "(default 0.7",
                           "1000 to 1000000000", "0.01 to 2 mm", "terms of the sum, 1 to 8"})
    EXPECT_NE(help.out.find(text), std::string::npos) << text;
  EXPECT_EQ(help.out.find("=[]"), std::string::npos) << "an empty list is no default";
}

}  // namespace
}  // namespace dermis::tests
