// SPDX-License-Identifier: MIT
// `dermis profile` as its callback sees it: exit status 2 is a CLI::ParseError here, 1 an InputError.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/profile_command.h"
#include "core/error.h"
#include "gaussians/json.h"

namespace dermis {
namespace {

/// Runs the command and returns what it printed.
std::string run(std::vector<std::string> arguments) {
  CLI::App app{"test"};
  app.require_subcommand(1);
  int status = 0;
  cli::add_profile_command(app, status);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes a vector from its end
  arguments.emplace_back("profile");
  ::testing::internal::CaptureStdout();
  try {
    app.parse(arguments);
  } catch (...) {
    ::testing::internal::GetCapturedStdout();
    throw;
  }
  return ::testing::internal::GetCapturedStdout();
}

std::string message_of(const std::vector<std::string>& arguments) {
  try {
    run(arguments);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

class ProfileCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("dermis_profile_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

TEST_F(ProfileCommand, WritesWhatRenderTakes) {
  const std::string text = run({"--preset", "skin1", "--model", "dipole", "--gaussians", "6", "--plot", path("a.svg"), "--swatches",
                                path("s.png"), "-o", path("a.json"), "--compare", "skin"});
  for (const char* word :
       {"skin1: dipole", "error, %", "total reflectance", "mean free path, mm", "diffuse m.f.p., mm", "difference from skin, %"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  const auto sum = gaussians::load_json(path("a.json"));
  EXPECT_EQ(sum.terms.size(), 6u);
  EXPECT_NEAR(sum.total_reflectance[0], 0.4360, 1e-4);
  EXPECT_GT(std::filesystem::file_size(path("a.svg")), 10'000u);
  EXPECT_GT(std::filesystem::file_size(path("s.png")), 500u);
}

TEST_F(ProfileCommand, OnlyJsonGoesToStandardOutput) {
  const auto shared = nlohmann::json::parse(run({"--preset", "marble", "--model", "dipole", "--gaussians", "4", "-o", "-"}));
  EXPECT_EQ(shared["variances_mm2"].size(), 4u);
  const auto each =
      nlohmann::json::parse(run({"--preset", "marble", "--model", "dipole", "--gaussians", "4", "--variances", "per-channel", "-o", "-"}));
  EXPECT_EQ(each["variances_mm2"][0].size(), 3u);
  EXPECT_NEAR(each["error_percent"][1].get<double>(), 1.2535, 2e-3);
  EXPECT_NEAR(each["variances_mm2"][3][1].get<double>(), 7.0, 0.05);
  const auto unity = nlohmann::json::parse(run({"--preset", "marble", "--model", "dipole", "--export", "unity"}));
  EXPECT_EQ(unity["system"], "unity");
}

TEST_F(ProfileCommand, LayersKeepTheIndexOfTheirSurface) {
  std::ofstream(path("l.json")) << R"([{"sigma_a_per_mm":0.01,"sigma_s_reduced_per_mm":2,"thickness_mm":2,"eta":1.33},
                                       {"sigma_a_per_mm":0.02,"sigma_s_reduced_per_mm":3}])";
  const auto cycles =
      nlohmann::json::parse(run({"--layers", path("l.json"), "--model", "multipole", "--gaussians", "2", "--export", "cycles"}));
  EXPECT_EQ(cycles["parameters"]["IOR"], 1.33);
}

TEST_F(ProfileCommand, EverySourceYieldsAProfile) {
  std::ofstream(path("l.json"))
      << R"([{"sigma_a_per_mm":[0.02,0.1,0.2],"sigma_s_reduced_per_mm":5,"thickness_mm":0.5},{"sigma_a_per_mm":0.05,"sigma_s_reduced_per_mm":2}])";
  std::ofstream(path("r.csv")) << "r_mm,R,G,B\n0,0.1,0.1,0.1\n0.5,0.05,0.04,0.03\n2,0,0,0\n";
  const std::vector<std::vector<std::string>> sources{
      {"--coefficients", "sigma_a=0.03,0.17,0.48 sigma_s=0.74,0.88,1.01 g=0 eta=1.3", "--model", "better"},
      {"--preset", "skin2", "--model", "beam"},
      {"--preset", "skin2", "--photons", "2000"},
      {"--layers", path("l.json"), "--model", "multipole"},
      {"--burley", "reflectance=0.5 dmfp_mm=3,1,0.5"},
      {"--csv", path("r.csv")},
      {"--melanin", "0.02", "--hemoglobin", "0.02", "--blend", "0.5", "--oxygenation", "0.9", "--model", "multipole"},
      {"--colour", "#c58c85", "--model", "multipole"},
      {"--import", "unity reflectance=0.8,0.5,0.4 scattering_distance=0.76,0.32,0.2"}};
  for (auto source : sources) {
    source.insert(source.end(), {"-o", "-", "--gaussians", "4"});
    EXPECT_NO_THROW(gaussians::parse_json(run(source), source[0])) << source[0] << " " << source[1];
  }
}

TEST_F(ProfileCommand, MistakesEndInTheRightWay) {
  EXPECT_THROW(run({}), CLI::ParseError);
  EXPECT_THROW(run({"--preset", "skin1", "--burley", "x"}), CLI::ParseError);
  EXPECT_THROW(run({"--preset", "skin1", "--gaussians", "six"}), CLI::ParseError);
  EXPECT_THROW(run({"--preset", "skin1", "--no-such-option"}), CLI::ParseError);
  EXPECT_THROW(run({"--blend", "0.2"}), CLI::ParseError);
  EXPECT_NE(message_of({"--preset", "skin3"}).find("known: apple, chicken1"), std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=-1 sigma_s=1"}).find("sigma_a must be"), std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=1 sigma_s=1 g=1"}).find("g must be"), std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=1 sigma_s=1 eta=0.5"}).find("eta must be"), std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--gaussians", "9"}).find("1 to 8"), std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--model", "tripole"}).find("known: dipole, better"), std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--variances", "some"}).find("shared, per-channel"), std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--model", "dipole", "--export", "maya"}).find("known: separable"), std::string::npos);
  EXPECT_NE(message_of({"--layers", path("none.json")}).find("none.json"), std::string::npos);
  EXPECT_NE(message_of({"--melanin", "0.02", "--model", "dipole"}).find("knows no layers"), std::string::npos);
  EXPECT_NE(message_of({"--csv", path("none.csv"), "--model", "beam"}).find("brings its own profile"), std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--model", "dipole", "-o", path("no/such/a.json")}).find("no/such"), std::string::npos);
  EXPECT_NE(message_of({"--burley", "reflectance=1 mfp_mm=1e-300"}).find("1e-6 to 1e6 mm"), std::string::npos);
  EXPECT_NE(message_of({"--burley", "reflectance=0.5 mfp_mm=-1"}).find("mfp_mm must be above 0, got -1"), std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=1 sigma_s=1,0,1", "--model", "dipole"}).find("--coefficients: green: reflects nothing"),
            std::string::npos);
  EXPECT_NE(message_of({"--import", "cycles color=0.5 radius=1"}).find("as metres it is 1000"), std::string::npos);
  EXPECT_NE(message_of({"--import", "radius=1"}).find("could be a mean free path, a diffuse mean free path"), std::string::npos);
  std::ofstream(path("layers.json")) << R"([{"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":1,"depth_mm":1}])";
  EXPECT_NE(message_of({"--layers", path("layers.json")}).find("unknown key 'depth_mm'; known: sigma_a_per_mm"), std::string::npos);
  std::ofstream(path("unsorted.csv")) << "r_mm,R,G,B\n1,1,1,1\n0.5,1,1,1\n";
  EXPECT_NE(message_of({"--csv", path("unsorted.csv")}).find("line 3: radii must rise"), std::string::npos);
  std::ofstream(path("empty.csv")) << "";
  EXPECT_NE(message_of({"--csv", path("empty.csv")}).find("empty"), std::string::npos);
  std::ofstream(path("big.csv")) << "r_mm,R,G,B\n0,1,1,1\n5,1,1,1\n";
  EXPECT_NE(message_of({"--csv", path("big.csv")}).find("times what enters"), std::string::npos);
}

}  // namespace
}  // namespace dermis
