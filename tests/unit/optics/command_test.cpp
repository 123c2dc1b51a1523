// SPDX-License-Identifier: MIT
// `dermis profile` as its callback sees it: exit status 2 is a CLI::ParseError here, 1 an InputError.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/core/error.h"
#include "cli/profile_command.h"
#include "tissue/gaussians/json.h"

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
    folder_ =
        std::filesystem::temp_directory_path() /
        ("dermis_profile_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  std::filesystem::path folder_;
};

TEST_F(ProfileCommand, ExportsKernels) {
  const std::vector<std::string> skin{"--preset", "skin1", "--model", "dipole"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), skin.begin(), skin.end());
    return more;
  };

  const auto printed =
      nlohmann::json::parse(run(with({"--export", "separable-kernel", "--export-taps", "11"})));
  EXPECT_EQ(printed.at("parameters").at("taps").size(), 11u);

  const std::string said = run(with({"--export", "pre-integrated-tables", "--export-to", path("tables/")}));
  for (const char* name :
       {"pre-integrated-tables.json", "pre-integrated-tables.h", "pre-integrated-tables.glsl",
        "pre-integrated-tables-lit.exr", "pre-integrated-tables-shadow.exr"}) {
    EXPECT_GT(std::filesystem::file_size(path("tables") + "/" + name), 1000u) << name;
    EXPECT_NE(said.find(name), std::string::npos);
  }

  // One variance per channel and term: each still sums to 1.
  const auto apart = nlohmann::json::parse(
      run(with({"--export", "burley-disc", "--variances", "per-channel", "--gaussians", "3"})));
  double red = 0;
  for (const auto& term : apart.at("parameters").at("gaussians")) red += term[1].get<double>();
  EXPECT_NEAR(red, 1, 1e-6);

  EXPECT_NE(message_of(with({"--export", "separable-kernel", "--export-taps", "12"})).find("an odd number"),
            std::string::npos);
  EXPECT_NE(message_of(with({"--export", "pre-integrated-tables", "--export-taps", "12"})).find("no taps"),
            std::string::npos);
  EXPECT_NE(message_of(with({"--export", "unity", "--export-to", path("x")})).find("a kernel alone"),
            std::string::npos);
  EXPECT_NE(message_of(with({"--export", "burley-disc", "--export-to", path("no/such")})).find("no"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path("no")));
}

TEST_F(ProfileCommand, WritesWhatRenderTakes) {
  const std::string text =
      run({"--preset", "skin1", "--model", "dipole", "--gaussians", "6", "--plot", path("a.svg"),
           "--swatches", path("s.png"), "-o", path("a.json"), "--compare", "skin"});
  for (const char* word : {"skin1: dipole", "error, %", "total reflectance", "mean free path, mm",
                           "diffuse m.f.p., mm", "difference from skin, %"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  const auto sum = gaussians::load_json(path("a.json"));
  EXPECT_EQ(sum.terms.size(), 6u);
  EXPECT_NEAR(sum.total_reflectance[0], 0.4360, 1e-4);
  EXPECT_GT(std::filesystem::file_size(path("a.svg")), 10'000u);
  EXPECT_GT(std::filesystem::file_size(path("s.png")), 500u);
}

TEST_F(ProfileCommand, OnlyJsonGoesToStandardOutput) {
  const auto shared =
      nlohmann::json::parse(run({"--preset", "marble", "--model", "dipole", "--gaussians", "4", "-o", "-"}));
  EXPECT_EQ(shared["variances_mm2"].size(), 4u);
  const auto each = nlohmann::json::parse(run({"--preset", "marble", "--model", "dipole", "--gaussians", "4",
                                               "--variances", "per-channel", "-o", "-"}));
  EXPECT_EQ(each["variances_mm2"][0].size(), 3u);
  EXPECT_NEAR(each["error_percent"][1].get<double>(), 1.2535, 2e-3);
  EXPECT_NEAR(each["variances_mm2"][3][1].get<double>(), 7.0, 0.05);
  const auto unity =
      nlohmann::json::parse(run({"--preset", "marble", "--model", "dipole", "--export", "unity"}));
  EXPECT_EQ(unity["system"], "unity");
}

TEST_F(ProfileCommand, LayersKeepTheIndexOfTheirSurface) {
  std::ofstream(path("l.json"))
      << R"([{"sigma_a_per_mm":0.01,"sigma_s_reduced_per_mm":2,"thickness_mm":2,"eta":1.33},
                                       {"sigma_a_per_mm":0.02,"sigma_s_reduced_per_mm":3}])";
  const auto cycles = nlohmann::json::parse(
      run({"--layers", path("l.json"), "--model", "multipole", "--gaussians", "2", "--export", "cycles"}));
  EXPECT_EQ(cycles["parameters"]["IOR"], 1.33);
}

TEST_F(ProfileCommand, EverySourceYieldsAProfile) {
  std::ofstream(path("l.json"))
      << R"([{"sigma_a_per_mm":[0.02,0.1,0.2],"sigma_s_reduced_per_mm":5,"thickness_mm":0.5},
             {"sigma_a_per_mm":0.05,"sigma_s_reduced_per_mm":2}])";
  std::ofstream(path("r.csv")) << "r_mm,R,G,B\n0,0.1,0.1,0.1\n0.5,0.05,0.04,0.03\n2,0,0,0\n";

  const std::vector<std::vector<std::string>> sources{
      {"--coefficients", "sigma_a=0.03,0.17,0.48 sigma_s=0.74,0.88,1.01 g=0 eta=1.3", "--model", "better"},
      {"--preset", "skin2", "--model", "beam"},
      {"--preset", "skin2", "--photons", "2000"},
      {"--layers", path("l.json"), "--model", "multipole"},
      {"--burley", "reflectance=0.5 dmfp_mm=3,1,0.5"},
      {"--csv", path("r.csv")},
      {"--melanin", "0.02", "--hemoglobin", "0.02", "--blend", "0.5", "--oxygenation", "0.9", "--model",
       "multipole"},
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

  EXPECT_NE(message_of({"--preset", "skin3"}).find("'skin3' is not known; there are: apple, chicken1"),
            std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=-1 sigma_s=1"}).find("sigma_a_per_mm must be"),
            std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=1 sigma_s=1 g=1"}).find("g must be"), std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=1 sigma_s=1 eta=0.5"}).find("eta must be"),
            std::string::npos);

  EXPECT_NE(message_of({"--preset", "skin1", "--gaussians", "9"}).find("1 to 8"), std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--model", "tripole"}).find("there are: dipole, better"),
            std::string::npos);
  EXPECT_NE(message_of({"--preset", "skin1", "--variances", "some"}).find("shared, per-channel"),
            std::string::npos);
  EXPECT_NE(
      message_of({"--preset", "skin1", "--model", "dipole", "--export", "maya"}).find("there are: separable"),
      std::string::npos);

  EXPECT_NE(message_of({"--layers", path("none.json")}).find("none.json"), std::string::npos);
  EXPECT_NE(message_of({"--melanin", "0.02", "--model", "dipole"}).find("knows no layers"),
            std::string::npos);
  EXPECT_NE(message_of({"--csv", path("none.csv"), "--model", "beam"}).find("brings its own profile"),
            std::string::npos);
  EXPECT_NE(
      message_of({"--preset", "skin1", "--model", "dipole", "-o", path("no/such/a.json")}).find("no/such"),
      std::string::npos);

  EXPECT_NE(message_of({"--burley", "reflectance=1 mfp_mm=1e-300"}).find("1e-6 to 1e6 mm"),
            std::string::npos);
  EXPECT_NE(message_of({"--burley", "reflectance=0.5 mfp_mm=-1"}).find("mfp_mm must be above 0, got -1"),
            std::string::npos);
  EXPECT_NE(message_of({"--coefficients", "sigma_a=1 sigma_s=1,0,1", "--model", "dipole"})
                .find("--coefficients: green: reflects nothing"),
            std::string::npos);
  EXPECT_NE(message_of({"--import", "cycles color=0.5 radius=1"}).find("as metres it is 1000"),
            std::string::npos);
  EXPECT_NE(message_of({"--import", "radius=1"}).find("could be a mean free path, a diffuse mean free path"),
            std::string::npos);

  std::ofstream(path("layers.json")) << R"([{"sigma_a_per_mm":1,"sigma_s_reduced_per_mm":1,"depth_mm":1}])";
  EXPECT_NE(
      message_of({"--layers", path("layers.json")}).find("unknown key 'depth_mm'; there are: sigma_a_per_mm"),
      std::string::npos);
  std::ofstream(path("unsorted.csv")) << "r_mm,R,G,B\n1,1,1,1\n0.5,1,1,1\n";
  EXPECT_NE(message_of({"--csv", path("unsorted.csv")}).find("line 3: radii must rise"), std::string::npos);
  std::ofstream(path("empty.csv")) << "";
  EXPECT_NE(message_of({"--csv", path("empty.csv")}).find("empty"), std::string::npos);
  std::ofstream(path("big.csv")) << "r_mm,R,G,B\n0,1,1,1\n5,1,1,1\n";
  EXPECT_NE(message_of({"--csv", path("big.csv")}).find("times what enters"), std::string::npos);
}

std::string text_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// Nothing that is written may be something else that is written or read, by whatever name.
TEST_F(ProfileCommand, EveryOutputHasAFileOfItsOwn) {
  const std::string same = path("same"), table = "r_mm,R,G,B\n0,0.1,0.1,0.1\n2,0,0,0\n";
  std::ofstream(same) << table;
  std::filesystem::create_symlink(same, path("link"));
  const std::vector<std::string> dipole{"--preset", "skin1", "--model", "dipole"};
  for (std::vector<std::string> files :
       std::vector<std::vector<std::string>>{{"-o", same, "--plot", same},
                                             {"--plot", same, "--swatches", path("./same")},
                                             {"-o", path("link"), "--swatches", same},
                                             {"--compare", same, "-o", same},
                                             {"--compare", same, "--plot", path("link")}}) {
    files.insert(files.begin(), dipole.begin(), dipole.end());
    EXPECT_NE(message_of(files).find("name the same file"), std::string::npos) << files[4] << " " << files[6];
  }
  EXPECT_NE(message_of({"--csv", same, "-o", same}).find("-o and --csv name the same file"),
            std::string::npos);
  EXPECT_NE(message_of({"--layers", same, "--plot", same}).find("--plot and --layers"), std::string::npos);
  EXPECT_EQ(text_of(same), table) << "the input was touched";
}

TEST_F(ProfileCommand, NumbersThatWouldTurnIntoOthersAreRefused) {
  for (const char* option : {"--seed", "--photons"})
    for (const char* number : {"-1", "99999999999999999999", "1.5", "many", "", "1 "})
      EXPECT_THROW(run({"--preset", "skin1", option, number}), CLI::ParseError) << option << " " << number;
  for (const char* source :
       {"--preset", "--coefficients", "--layers", "--colour", "--burley", "--csv", "--import"})
    EXPECT_THROW(run({source, "", "--melanin", "0.02", "--model", "multipole"}), CLI::ParseError) << source;
  // The user's own number, before it is shared among 31 wavelengths.
  for (const char* photons : {"0", "10", "100000000000000000"})
    EXPECT_NE(message_of({"--melanin", "0.02", "--photons", photons})
                  .find("photons must be 1000 to 1000000000, got "),
              std::string::npos);
}

TEST_F(ProfileCommand, WhatIsWrongIsSaidBeforeTheLongWork) {
  const std::vector<std::string> long_work{"--preset",    "spectralon", "--model",
                                           "monte-carlo", "--photons",  "1000000000"};
  const auto refused = [&](std::vector<std::string> more) {
    more.insert(more.begin(), long_work.begin(), long_work.end());
    return message_of(more);
  };
  EXPECT_NE(refused({"--compare", path("none.json")}).find("neither a file nor a known name"),
            std::string::npos);
  EXPECT_NE(refused({"-o", path("no/such/a.json")}).find("no/such"), std::string::npos);
  std::ofstream(path("file")) << "x";
  EXPECT_NE(refused({"--cache", path("file")}).find("file: is a file; --cache needs a folder"),
            std::string::npos);
}

// A layer that no number holds: the fit comes back empty in one channel only.
TEST_F(ProfileCommand, AFitThatCannotBeUsedNamesItsChannel) {
  std::ofstream(path("oob.json"))
      << R"([{"sigma_a_per_mm":[0.1,0,0.1],"sigma_s_reduced_per_mm":1,"thickness_mm":1e300}])";
  for (const char* variances : {"shared", "per-channel"}) {
    std::string message;
    try {
      const auto json = nlohmann::json::parse(
          run({"--layers", path("oob.json"), "--model", "multipole", "--variances", variances, "-o", "-"}));
      for (const auto& row : json["weights"])
        for (const auto& weight : row) EXPECT_TRUE(weight.is_number()) << variances;  // null: not finite
    } catch (const InputError& error) {
      message = error.what();
      EXPECT_TRUE(message.find("green") != std::string::npos ||
                  message.find("thickness") != std::string::npos)
          << message;
    }
  }
}

TEST_F(ProfileCommand, TheTableSaysWhatANumberAloneDoesNot) {
  const std::string better = run({"--preset", "skin1", "--model", "better"});
  EXPECT_NE(better.find("scattered only once"), std::string::npos);
  EXPECT_NE(better.find("\nerror, %"), std::string::npos);
  EXPECT_EQ(better.find("noise"), std::string::npos);

  const std::string beam =
      run({"--coefficients", "sigma_a=0.001,0.1,0.1 sigma_s=0.999 eta=1", "--model", "beam"});
  EXPECT_NE(beam.find("red: this model gives back 1.00"), std::string::npos) << beam;
  EXPECT_EQ(beam.find("green: this model"), std::string::npos);
  EXPECT_NE(beam.find("error through a narrow beam, %"), std::string::npos);
  EXPECT_NE(beam.find("sigma of that beam, mm"), std::string::npos);

  const std::string endless =
      run({"--coefficients", "sigma_a=0,1,1 sigma_s=1", "--model", "monte-carlo", "--photons", "1000"});
  EXPECT_NE(endless.find("Monte-Carlo noise, %"), std::string::npos) << endless;
  EXPECT_NE(endless.find("% of the light is missing; Monte-Carlo gives photons up"), std::string::npos)
      << endless;
  EXPECT_NE(endless.find("    infinite"), std::string::npos) << endless;
  EXPECT_EQ(endless.find("green: "), std::string::npos) << "what is absorbed is not missing";

  const std::string spectral = run({"--melanin", "0.02", "--photons", "16000"});
  EXPECT_TRUE(spectral.starts_with("spectral skin, melanin 0.02: Monte-Carlo, 31 wavelengths\n")) << spectral;
  EXPECT_NE(spectral.find("Monte-Carlo noise, %"), std::string::npos);
}

TEST_F(ProfileCommand, NoLengthIsInventedWhereNothingAbsorbs) {
  const auto conservative =
      nlohmann::json::parse(run({"--coefficients", "sigma_a=0 sigma_s=1", "--model", "dipole", "-o", "-"}));
  EXPECT_EQ(conservative["diffuse_mean_free_path_mm"][0], 0);
  std::ofstream(path("c.json")) << R"([{"sigma_a_per_mm":0,"sigma_s_reduced_per_mm":1}])";
  const auto stack =
      nlohmann::json::parse(run({"--layers", path("c.json"), "--model", "multipole", "-o", "-"}));
  EXPECT_EQ(stack["diffuse_mean_free_path_mm"][0], 0);
  EXPECT_NE(run({"--layers", path("c.json"), "--model", "multipole"})
                .find("diffuse m.f.p. (equivalent), mm       infinite    infinite"),
            std::string::npos);
}

TEST_F(ProfileCommand, ThePlotHoldsAndNamesEveryCurve) {
  std::ofstream(path("narrow.json"))
      << R"({"name":"a <narrow> one","variances_mm2":[0.05],"weights":[[1,1,1]]})";
  std::ofstream(path("wide.json")) << R"({"name":"wide","variances_mm2":[50],"weights":[[1,1,1]]})";
  // A name of bytes that are not UTF-8: latin-1, cut off, overlong, a surrogate, U+FFFF. An SVG with them is
  // no XML.
  const std::string odd = "gr\xFC\xDF \xE2\x82 \xC0\xAF \xED\xA0\x80 \xEF\xBF\xBF m\xC3\xBC";
  std::ofstream(path(odd + ".csv")) << "r_mm,R,G,B\n0,0.1,0.1,0.1\n1,0,0,0\n2,0,0,0\n";
  run({"--csv", path(odd + ".csv"), "--gaussians", "3", "--plot", path("a.svg"), "--compare",
       path("narrow.json"), "--compare", path("wide.json")});
  const std::string svg = text_of(path("a.svg"));
  EXPECT_NO_THROW(nlohmann::json(svg).dump()) << "not UTF-8";
  EXPECT_EQ(svg.find("\xEF\xBF\xBF"), std::string::npos);
  EXPECT_NE(svg.find("m\xC3\xBC"), std::string::npos) << "what is UTF-8 stays";
  for (const char* label : {">profile<", " Gaussian", ">a &lt;narrow&gt; one<", ">wide<"})
    EXPECT_NE(svg.find(label), std::string::npos) << label;
  // 50 is the top of the panel: a curve that touches it was cut.
  EXPECT_EQ(svg.find(",50.0 "), std::string::npos);
}

TEST_F(ProfileCommand, LabelsCountTheTermsThatThereAre) {
  // One Gaussian asked for six times is one.
  std::ofstream table(path("one.csv"));
  table << "r_mm,R,G,B\n";
  for (int i = 0; i <= 400; ++i) {
    const double r = 0.02 * i, value = 0.05 * std::exp(-r * r / 2);
    table << r << "," << value << "," << value << "," << value << "\n";
  }
  table.close();
  const auto json =
      nlohmann::json::parse(run({"--csv", path("one.csv"), "-o", "-", "--plot", path("a.svg")}));
  const std::size_t terms = json["variances_mm2"].size();
  const std::string label = ">" + std::to_string(terms) + (terms == 1 ? " Gaussian<" : " Gaussians<");
  EXPECT_NE(text_of(path("a.svg")).find(label), std::string::npos) << label;
}

TEST_F(ProfileCommand, TablesThatAreNoneAreQuotedWhole) {
  constexpr char header[] = "r_mm,R\0,G,B and more\n1,1,1,1\n", field[] = "r_mm,R,G,B\n0,1\0x,1,1\n";
  std::ofstream(path("zero.csv")) << std::string(header, sizeof header - 1);
  EXPECT_NE(message_of({"--csv", path("zero.csv")}).find("and more'"), std::string::npos)
      << "cut short by a byte 0";
  std::ofstream(path("field.csv")) << std::string(field, sizeof field - 1);
  EXPECT_NE(message_of({"--csv", path("field.csv")}).find("is not a number"), std::string::npos);
  std::ofstream(path("cr.csv")) << "r_mm,R,G,B\r0,0.1,0.1,0.1\r1,0,0,0\r";
  EXPECT_NE(message_of({"--csv", path("cr.csv")}).find("carriage return"), std::string::npos);
  std::ofstream(path("crlf.csv")) << "r_mm,R,G,B\r\n0,0.1,0.1,0.1\r\n1,0,0,0\r\n";
  EXPECT_EQ(message_of({"--csv", path("crlf.csv"), "--gaussians", "2"}), "no error");
}

}  // namespace
}  // namespace dermis
