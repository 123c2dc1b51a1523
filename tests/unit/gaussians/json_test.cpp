// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/core/error.h"
#include "tissue/gaussians/json.h"
#include "tissue/gaussians/known.h"

namespace dermis::gaussians {
namespace {

std::string error_of(const std::string& text, bool normalise = false) {
  try {
    parse_json(text, "p.json", normalise);
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

std::string two_terms(const std::string& variances, const std::string& weights,
                      const std::string& more = "") {
  return fmt::format(R"({{"variances_mm2": {}, "weights": {}{}}})", variances, weights, more);
}

const std::string good_weights = "[[0.25, 0.5, 1], [0.75, 0.5, 0]]";

TEST(ProfileJson, RoundTripKeepsEveryBit) {
  ScatterProfile sum = skin_six();
  sum.name = "a \"name\" with ä and \\ in it";
  sum.terms[0].variance_mm2 = 0.1 + 0.2;  // 17 digits
  sum.error_percent = {1.0 / 3, 0, 12.5};
  sum.total_reflectance = {0.1, 0.2, 0.3};
  sum.mean_free_path_mm = {1, 2, 3};
  sum.diffuse_mean_free_path_mm = {3.67, 1.37, 0.68};
  std::swap(sum.terms[0], sum.terms[1]);
  std::swap(sum.terms[0].variance_mm2, sum.terms[1].variance_mm2);

  const ScatterProfile back = parse_json(to_json(sum), "p.json");
  EXPECT_EQ(back.name, sum.name);
  ASSERT_EQ(back.terms.size(), sum.terms.size());

  for (const Gaussian& term : back.terms) {
    const auto same = [&](const Gaussian& g) {
      return g.variance_mm2 == term.variance_mm2 && g.weight == term.weight;
    };
    EXPECT_EQ(std::count_if(sum.terms.begin(), sum.terms.end(), same), 1) << term.variance_mm2;
  }

  EXPECT_EQ(back.error_percent, sum.error_percent);
  EXPECT_EQ(back.total_reflectance, sum.total_reflectance);
  EXPECT_EQ(back.mean_free_path_mm, sum.mean_free_path_mm);
  EXPECT_EQ(back.diffuse_mean_free_path_mm, sum.diffuse_mean_free_path_mm);
  EXPECT_EQ(to_json(back), to_json(parse_json(to_json(back), "p.json")));
}

TEST(ProfileJson, SortsNarrowToWideAndFillsDefaults) {
  const ScatterProfile sum = parse_json(two_terms("[2, 0.5]", good_weights), "p.json");
  ASSERT_EQ(sum.terms.size(), 2u);
  EXPECT_EQ(sum.terms[0].variance_mm2, 0.5);
  EXPECT_EQ(sum.terms[0].weight, (Rgb{0.75, 0.5, 0}));
  EXPECT_EQ(sum.terms[1].weight, (Rgb{0.25, 0.5, 1}));
  EXPECT_EQ(sum.name, "");
  EXPECT_EQ(sum.total_reflectance, (Rgb{1, 1, 1}));
  EXPECT_EQ(sum.mean_free_path_mm, (Rgb{}));
}

TEST(ProfileJson, EightTermsAreTheMost) {
  std::string variances, weights;
  for (int i = 1; i <= 9; ++i) {
    variances += fmt::format("{}{}", i == 1 ? "" : ",", i);
    weights += (i == 1 ? "[1,1,1]" : ",[0,0,0]");
    const std::string text = two_terms(fmt::format("[{}]", variances), fmt::format("[{}]", weights));
    if (i < 9) {
      EXPECT_EQ(parse_json(text, "p.json").terms.size(), static_cast<std::size_t>(i));
    } else {
      EXPECT_EQ(error_of(text), "p.json: variances_mm2: must have 1 to 8 elements, has 9");
    }
  }
  EXPECT_EQ(error_of(two_terms("[]", "[]")), "p.json: variances_mm2: must have 1 to 8 elements, has 0");
  EXPECT_EQ(error_of(two_terms("[1]", good_weights)),
            "p.json: variances_mm2 has 1 terms and weights has 2, expected as many");
}

TEST(ProfileJson, Variances) {
  EXPECT_EQ(error_of(two_terms("[-1, 2]", good_weights)),
            "p.json: variances_mm2[0]: must be > 0 mm^2, is -1");
  EXPECT_EQ(error_of(two_terms("[1, 0]", good_weights)), "p.json: variances_mm2[1]: must be > 0 mm^2, is 0");
  EXPECT_EQ(error_of(two_terms("[2, 2]", good_weights)),
            "p.json: variances_mm2: has 2 twice, expected different ones");
  EXPECT_NE(error_of(two_terms("[1, 1e999]", good_weights)).find("p.json: is not valid JSON"),
            std::string::npos);
  EXPECT_EQ(error_of(two_terms("[1, \"2\"]", good_weights)),
            "p.json: variances_mm2[1]: must be a number, is string");
  EXPECT_NE(
      error_of(two_terms("[[1, 1, 1], [2, 2, 2]]", good_weights)).find("make the profile with shared ones"),
      std::string::npos);
  EXPECT_EQ(error_of(two_terms("7", good_weights)), "p.json: variances_mm2: must be an array, is number");
}

TEST(ProfileJson, Weights) {
  const std::string off = "[[0.25, 0.5, 1], [0.75, 0.498, 0]]";
  EXPECT_EQ(error_of(two_terms("[1, 2]", off)),
            "p.json: weights of green sum to 0.998, expected 1 within 0.001 (or have them normalised)");
  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[0.25, 0.5, 1], [0.75, 0.4995, 0]]")), "no error");

  const ScatterProfile sum = parse_json(two_terms("[1, 2]", "[[1, 2, 3], [3, 2, 0]]"), "p.json", true);
  EXPECT_EQ(sum.terms[0].weight, (Rgb{0.25, 0.5, 1}));
  EXPECT_EQ(sum.terms[1].weight, (Rgb{0.75, 0.5, 0}));

  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[1, 0, 1], [0, 0, 0]]"), true),
            "p.json: weights of green sum to 0 and cannot be normalised");
  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[1.5, 1, 1], [-0.5, 0, 0]]")),
            "p.json: weights[1][0]: must be at least 0, is -0.5");
  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[1, 1, 1], [0, 0]]")),
            "p.json: weights[1]: must be a list of three numbers (red, green, blue)");
  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[1, 1, 1], 0]")),
            "p.json: weights[1]: must be a list of three numbers (red, green, blue)");
  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[1, 1, 1], [0, null, 0]]")),
            "p.json: weights[1][1]: must be a number, is null");
  EXPECT_EQ(error_of(two_terms("[1, 2]", "[[1e308, 1, 1], [1e308, 0, 0]]"), true),
            "p.json: weights of red sum to inf and cannot be normalised");
}

TEST(ProfileJson, Keys) {
  EXPECT_EQ(error_of(two_terms("[1, 2]", good_weights, R"(, "wieghts": 3)")),
            "p.json: unknown key 'wieghts'; there are: name, model, variances_mm2, weights, "
            "error_percent, total_reflectance, "
            "mean_free_path_mm, diffuse_mean_free_path_mm, medium, shape; did you mean 'weights'?");
  EXPECT_EQ(error_of(R"({"weights": [[1,1,1]]})"), "p.json: 'variances_mm2' is missing");
  EXPECT_EQ(error_of(R"({"variances_mm2": [1]})"), "p.json: 'weights' is missing");
  EXPECT_EQ(error_of(R"({"variances_mm2": [1], "weights": [[1,1,1]], "variances_mm2": [2]})"),
            "p.json: key 'variances_mm2' is given twice");
  EXPECT_EQ(error_of(two_terms("[1, 2]", good_weights, R"(, "name": 3)")),
            "p.json: name: must be a string, is number");
  EXPECT_EQ(error_of(two_terms("[1, 2]", good_weights, R"(, "total_reflectance": [1, 2, 1])")),
            "p.json: total_reflectance[1]: must be 0 to 1, is 2");
  EXPECT_EQ(error_of(two_terms("[1, 2]", good_weights, R"(, "mean_free_path_mm": [1, -2, 1])")),
            "p.json: mean_free_path_mm[1]: must be at least 0, is -2");
  EXPECT_EQ(error_of(two_terms("[1, 2]", good_weights, R"(, "error_percent": 1)")),
            "p.json: error_percent: must be a list of three numbers (red, green, blue)");
}

const std::string medium =
    R"(, "medium": {"sigma_a_per_mm": [0.01, 0.07, 0.1], "sigma_s_per_mm": [1, 1.5, 2], "g": 0, "eta": 1.3})";

TEST(ProfileJson, KnowsItsMediumAndItsLaws) {
  const ScatterProfile sum = parse_json(two_terms("[1, 2]", good_weights, medium), "p.json");
  ASSERT_TRUE(sum.medium && sum.shape);
  EXPECT_EQ(sum.medium->sigma_a_per_mm, (Rgb{0.01, 0.07, 0.1}));
  EXPECT_EQ(sum.medium->eta, 1.3);
  EXPECT_GT(sum.shape->curvature_mm[0], sum.shape->curvature_mm[2]);
  EXPECT_EQ(parse_json(to_json(sum), "p.json"), sum) << "to the last bit";

  // Laws of a file are those that count.
  ScatterProfile other = sum;
  other.shape->curvature_mm = {3, 2, 1};
  EXPECT_EQ(parse_json(to_json(other), "p.json").shape->curvature_mm, (Rgb{3, 2, 1}));
  EXPECT_FALSE(parse_json(two_terms("[1, 2]", good_weights), "p.json").shape);
}

TEST(ProfileJson, MediaAndLawsThatNothingCanBeMadeOf) {
  const auto error_with = [](const std::string& more) {
    return error_of(two_terms("[1, 2]", good_weights, more));
  };
  EXPECT_EQ(error_with(R"(, "shape": {})"), "p.json: shape: needs the medium that it is of: \"medium\"");
  EXPECT_EQ(
      error_with(medium + R"(, "shape": {"curvature": 1})"),
      "p.json: shape: unknown key 'curvature'; there are: curvature_mm, convex_mm, concave_mm, "
      "difference_mm, difference_mm2, front_share, front_mm, exit_grazing, exit_normal, exit_offset_mm; did "
      "you mean 'curvature_mm'?");
  EXPECT_EQ(error_with(medium + R"(, "shape": {"curvature_mm": [1, 2, -3]})"),
            "p.json: shape.curvature_mm[2]: must be 0 to 1000000, is -3");
  EXPECT_EQ(error_with(R"(, "medium": {"sigma_a_per_mm": [1, 1, 1]})"),
            "p.json: medium: 'sigma_s_per_mm' is missing");
  EXPECT_NE(error_with(
                R"(, "medium": {"sigma_a_per_mm": [0, 1, 1], "sigma_s_per_mm": [0, 1, 1], "g": 0, "eta": 1})")
                .find("sigma_a and sigma_s are both 0"),
            std::string::npos);
  EXPECT_NE(error_with(
                R"(, "medium": {"sigma_a_per_mm": [1, 1, 1], "sigma_s_per_mm": [1, 1, 1], "g": 1, "eta": 1})")
                .find("p.json: medium"),
            std::string::npos);
}

TEST(ProfileJson, BrokenText) {
  for (const char* text :
       {"", "{", "nonsense", "{\"variances_mm2\": [1,]}", "\xff\xfe", "{\"name\": \"\x01\"}", "{} {}"}) {
    const std::string error = error_of(text);
    EXPECT_EQ(error.find("p.json: is not valid JSON: "), 0u) << text << " -> " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_EQ(error_of("[]"), "p.json: the JSON must be an object, is array");
  EXPECT_EQ(error_of("3"), "p.json: the JSON must be an object, is number");
  EXPECT_EQ(error_of(std::string(200000, '[')), "p.json: the JSON is nested deeper than 8 levels");
  EXPECT_EQ(error_of(fmt::format(R"({{"name": {})", std::string(200000, '['))),
            "p.json: the JSON is nested deeper than 8 levels");
}

TEST(ProfileJson, EveryTruncationIsAnError) {
  const std::string text = to_json(skin_six());
  const std::size_t end = text.find_last_of('}');
  for (std::size_t length = 0; length <= end; ++length)
    EXPECT_EQ(error_of(text.substr(0, length)).find("p.json: is not valid JSON"), 0u) << length;
}

// A key stands in the message as it is read, and JSON may write a line feed into it.
TEST(ProfileJson, AnErrorIsOneLineWhateverTheKeysHold) {
  for (const std::string key : {R"(a\nb)", R"(a\u007fb)"}) {
    const std::string unknown = error_of("{\"" + key + "\": 1}");
    const std::string twice = error_of("{\"" + key + "\": 1, \"" + key + "\": 2}");
    EXPECT_NE(unknown.find("unknown key 'a?b'"), std::string::npos) << unknown;
    EXPECT_NE(twice.find("key 'a?b' is given twice"), std::string::npos) << twice;
  }
  EXPECT_LE(error_of("{\"" + std::string(100'000, 'k') + "\": 1}").size(), 2000u);
}

TEST(ProfileJson, NameOrFile) {
  EXPECT_EQ(from_name_or_file("skin").terms.size(), 6u);
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("dermis_profile_{}.json", ::getpid());
  std::ofstream(path) << two_terms("[1, 2]", "[[1, 2, 3], [3, 2, 0]]");
  EXPECT_EQ(from_name_or_file(path.string(), true).terms.size(), 2u);
  EXPECT_THROW(from_name_or_file(path.string()), InputError);
  std::filesystem::remove(path);
  try {
    from_name_or_file("no_such_profile");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_TRUE(
        std::string_view(error.what())
            .starts_with("profile 'no_such_profile' is neither a file nor a known name; there are: skin, "))
        << error.what();
  }
  EXPECT_THROW(from_name_or_file(std::filesystem::temp_directory_path().string()), InputError);
}

// Light that leaves where it entered: for those who can light it at the pixel.
TEST(ProfileJson, AVarianceOfZeroIsForThoseThatTakeIt) {
  const auto path = std::filesystem::temp_directory_path() / fmt::format("dermis-zero-{}.json", getpid());
  const auto read = [&](const char* variances, LeastVariance least) {
    std::ofstream(path) << two_terms(variances, good_weights);
    return load_json(path, false, least);
  };
  EXPECT_THROW(read("[1, 0]", LeastVariance::above_zero), InputError);
  EXPECT_THROW(read("[1, -0.5]", LeastVariance::zero), InputError);
  EXPECT_THROW(read("[0, 0]", LeastVariance::zero), InputError);
  const ScatterProfile sum = read("[1, 0]", LeastVariance::zero);
  EXPECT_EQ(sum.terms[0], (Gaussian{.variance_mm2 = 0, .weight = {0.75, 0.5, 0}}));
  EXPECT_EQ(sum.terms[1].variance_mm2, 1);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace dermis::gaussians
