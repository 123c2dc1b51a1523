// SPDX-License-Identifier: MIT
#include "tissue/gaussians/json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/core/channels.h"
#include "base/core/error.h"
#include "base/core/known_names.h"
#include "base/json/document.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/shape_json.h"

namespace dermis::gaussians {

namespace {

constexpr double any = std::numeric_limits<double>::max();
constexpr std::uint64_t max_file_bytes = std::uint64_t{1} << 20;
constexpr json::Limits limits{.depth = 8, .values = 10'000};

Rgb rgb(const json::Value& value, double most = any) {
  if (!value.is_array() || value.array_size(0) != 3)
    value.fail("must be a list of three numbers (red, green, blue)");
  Rgb result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = value.element(c).number(0, most);
  return result;
}

double variance_mm2(const json::Value& value, LeastVariance least) {
  if (value.is_array())
    value.fail(
        "is a list: variances per channel cannot be blurred together; make the profile with shared ones");
  const double variance_mm2 = value.number(-any, any);
  const bool may_be_zero = least == LeastVariance::zero;
  if (!(variance_mm2 > 0) && !(may_be_zero && variance_mm2 == 0))
    value.fail("must be {} 0 mm^2, is {}", may_be_zero ? ">=" : ">", variance_mm2);
  return variance_mm2;
}

std::vector<Gaussian> read_terms(const json::Value& root, LeastVariance least) {
  const json::Value variances = root.at("variances_mm2"), weights = root.at("weights");
  std::vector<Gaussian> terms(variances.array_size(1, max_terms));
  if (weights.array_size(1, max_terms) != terms.size())
    root.fail("variances_mm2 has {} terms and weights has {}, expected as many", terms.size(),
              weights.array_size());

  for (std::size_t i = 0; i < terms.size(); ++i)
    terms[i] = {.variance_mm2 = variance_mm2(variances.element(i), least), .weight = rgb(weights.element(i))};

  std::sort(terms.begin(), terms.end(),
            [](const Gaussian& a, const Gaussian& b) { return a.variance_mm2 < b.variance_mm2; });
  for (std::size_t i = 1; i < terms.size(); ++i)
    if (terms[i].variance_mm2 == terms[i - 1].variance_mm2)
      variances.fail("has {} twice, expected different ones", terms[i].variance_mm2);
  return terms;
}

void check_weights(std::vector<Gaussian>& terms, bool normalise, const json::Value& root) {
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (const Gaussian& term : terms) sum += term.weight[c];
    if (!normalise) {
      if (std::abs(sum - 1) <= weight_tolerance) continue;
      root.fail("weights of {} sum to {:.6g}, expected 1 within {} (or have them normalised)",
                channel_names[c], sum, weight_tolerance);
    }
    if (!(sum > 0) || !std::isfinite(sum))
      root.fail("weights of {} sum to {:.6g} and cannot be normalised", channel_names[c], sum);
    for (Gaussian& term : terms) term.weight[c] /= sum;
  }
}

}  // namespace

ScatterProfile read_json(const json::Value& root, bool normalise, LeastVariance least) {
  root.only_keys({"name", "model", "variances_mm2", "weights", "error_percent", "total_reflectance",
                  "mean_free_path_mm", "diffuse_mean_free_path_mm", "medium", "shape"});

  ScatterProfile sum;
  sum.name = root.text_or("name", sum.name);
  sum.model = root.text_or("model", sum.model);
  sum.terms = read_terms(root, least);
  check_weights(sum.terms, normalise, root);

  if (const auto found = root.find("error_percent")) sum.error_percent = rgb(*found);
  if (const auto found = root.find("total_reflectance")) sum.total_reflectance = rgb(*found, 1);
  if (const auto found = root.find("mean_free_path_mm")) sum.mean_free_path_mm = rgb(*found);
  if (const auto found = root.find("diffuse_mean_free_path_mm")) sum.diffuse_mean_free_path_mm = rgb(*found);
  read_shape(root, sum);
  return sum;
}

ScatterProfile parse_json(std::string_view text, const std::string& where, bool normalise) {
  return read_json(json::Document(text, where, limits).root(), normalise);
}

ScatterProfile load_json(const std::filesystem::path& path, bool normalise, LeastVariance least) {
  return read_json(json::load(path, max_file_bytes, limits).root(), normalise, least);
}

std::string to_json(const ScatterProfile& sum) {
  using Json = nlohmann::ordered_json;
  Json root;
  root["name"] = sum.name;
  if (!sum.model.empty()) root["model"] = sum.model;
  root["variances_mm2"] = Json::array();
  root["weights"] = Json::array();
  for (const Gaussian& term : sum.terms) {
    root["variances_mm2"].push_back(term.variance_mm2);
    root["weights"].push_back(term.weight);
  }
  root["error_percent"] = sum.error_percent;
  root["total_reflectance"] = sum.total_reflectance;
  root["mean_free_path_mm"] = sum.mean_free_path_mm;
  root["diffuse_mean_free_path_mm"] = sum.diffuse_mean_free_path_mm;
  write_shape(root, sum);
  // A name that is not UTF-8 is no reason to lose a profile: its odd bytes are replaced.
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ScatterProfile from_name_or_file(const std::string& name_or_path, bool normalise, LeastVariance least) {
  const std::vector<std::string_view> names = known_names();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) return known(name_or_path);
  std::error_code error;
  if (!std::filesystem::exists(name_or_path, error)) {
    throw input_error("", "profile '{}' is neither a file nor a known name; {}", name_or_path,
                      listed_names(name_or_path, names));
  }
  return load_json(name_or_path, normalise, least);
}

}  // namespace dermis::gaussians
