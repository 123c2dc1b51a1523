// SPDX-License-Identifier: MIT
#include "gaussians/json.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/one_line.h"
#include "gaussians/known.h"

namespace dermis::gaussians {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array known_keys = {"name",
                                   "model",
                                   "variances_mm2",
                                   "weights",
                                   "error_percent",
                                   "total_reflectance",
                                   "mean_free_path_mm",
                                   "diffuse_mean_free_path_mm"};
constexpr std::array channel_names = {"red", "green", "blue"};
constexpr double weight_tolerance = 1e-3;
constexpr std::uint64_t max_file_bytes = std::uint64_t{1} << 20;
constexpr int max_depth = 8;

/// Refuses what the library lets through: nesting that would exhaust the stack and keys given twice, of which
/// it silently keeps one.
class Guard {
 public:
  explicit Guard(const std::string& where) : where_(where) {}

  bool operator()(int depth, Json::parse_event_t event, Json& value) {
    if (depth > max_depth) throw input_error(where_, "profile is nested more than {} deep", max_depth);
    if (event == Json::parse_event_t::key && depth == 1 && !keys_.insert(value.get<std::string>()).second) {
      throw input_error(where_, "key '{}' is given twice", value.get<std::string>());
    }
    return true;
  }

 private:
  const std::string& where_;
  std::set<std::string> keys_;
};

Json parse_text(std::string_view text, const std::string& where) {
  try {
    // A reference: the parser copies its callback.
    Guard guard(where);
    return Json::parse(text, std::ref(guard));
  } catch (const Json::exception& error) { throw input_error(where, "is not valid JSON: {}", error.what()); }
}

double number(const Json& value, const std::string& name, const std::string& where) {
  if (!value.is_number()) throw input_error(where, "{} must be a number, got {}", name, value.type_name());
  const double x = value.get<double>();
  if (!std::isfinite(x)) throw input_error(where, "{} must be finite", name);
  return x;
}

double not_negative(const Json& value, const std::string& name, const std::string& where) {
  const double x = number(value, name, where);
  if (x < 0) throw input_error(where, "{} must be >= 0, got {}", name, x);
  return x;
}

Rgb rgb(const Json& value, const std::string& name, const std::string& where) {
  if (!value.is_array() || value.size() != 3)
    throw input_error(where, "{} must be a list of three numbers (red, green, blue)", name);
  Rgb result{};
  for (std::size_t c = 0; c < 3; ++c)
    result[c] = not_negative(value[c], fmt::format("{}[{}]", name, c), where);
  return result;
}

const Json& list(const Json& root, const char* key, const std::string& where) {
  const auto found = root.find(key);
  if (found == root.end()) throw input_error(where, "key '{}' is missing", key);
  if (!found->is_array()) throw input_error(where, "{} must be a list, got {}", key, found->type_name());
  if (found->empty() || found->size() > max_terms)
    throw input_error(where, "{} must have 1 to {} terms, got {}", key, max_terms, found->size());
  return *found;
}

std::vector<Gaussian> read_terms(const Json& root, const std::string& where) {
  const Json& variances = list(root, "variances_mm2", where);
  const Json& weights = list(root, "weights", where);
  if (variances.size() != weights.size()) {
    throw input_error(where, "variances_mm2 has {} terms and weights has {}, expected as many",
                      variances.size(), weights.size());
  }

  std::vector<Gaussian> terms(variances.size());
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const std::string name = fmt::format("variances_mm2[{}]", i);
    if (variances[i].is_array())
      throw input_error(where,
                        "{} is a list: variances per channel cannot be blurred together; make the profile "
                        "with --variances shared",
                        name);
    terms[i].variance_mm2 = number(variances[i], name, where);
    if (!(terms[i].variance_mm2 > 0))
      throw input_error(where, "{} must be > 0 mm^2, got {}", name, terms[i].variance_mm2);
    terms[i].weight = rgb(weights[i], fmt::format("weights[{}]", i), where);
  }

  std::sort(terms.begin(), terms.end(),
            [](const Gaussian& a, const Gaussian& b) { return a.variance_mm2 < b.variance_mm2; });
  for (std::size_t i = 1; i < terms.size(); ++i) {
    if (terms[i].variance_mm2 == terms[i - 1].variance_mm2) {
      throw input_error(where, "variances_mm2 has {} twice, expected different ones", terms[i].variance_mm2);
    }
  }

  return terms;
}

void check_weights(std::vector<Gaussian>& terms, bool normalise, const std::string& where) {
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (const Gaussian& term : terms) sum += term.weight[c];
    if (!normalise) {
      if (std::abs(sum - 1) <= weight_tolerance) continue;
      throw input_error(where, "weights of {} sum to {:.6g}, expected 1 within {} (or have them normalised)",
                        channel_names[c], sum, weight_tolerance);
    }
    if (!(sum > 0) || !std::isfinite(sum))
      throw input_error(where, "weights of {} sum to {:.6g} and cannot be normalised", channel_names[c], sum);
    for (Gaussian& term : terms) term.weight[c] /= sum;
  }
}

void check_keys(const Json& root, const std::string& where) {
  if (!root.is_object()) throw input_error(where, "a profile must be an object, got {}", root.type_name());
  for (const auto& [key, value] : root.items()) {
    if (std::find(known_keys.begin(), known_keys.end(), key) != known_keys.end()) continue;
    throw input_error(where, "key '{}' is not known; known are: {}", key, fmt::join(known_keys, ", "));
  }
}

SumOfGaussians parse(std::string_view text, const std::string& where, bool normalise) {
  const Json root = parse_text(text, where);
  check_keys(root, where);

  SumOfGaussians sum;
  if (const auto name = root.find("name"); name != root.end()) {
    if (!name->is_string()) throw input_error(where, "name must be a text, got {}", name->type_name());
    sum.name = name->get<std::string>();
  }
  if (const auto model = root.find("model"); model != root.end()) {
    if (!model->is_string()) throw input_error(where, "model must be a text, got {}", model->type_name());
    sum.model = model->get<std::string>();
  }

  sum.terms = read_terms(root, where);
  check_weights(sum.terms, normalise, where);

  const auto optional_rgb = [&](const char* key, Rgb& target) {
    if (const auto found = root.find(key); found != root.end()) target = rgb(*found, key, where);
  };
  optional_rgb("error_percent", sum.error_percent);
  optional_rgb("total_reflectance", sum.total_reflectance);
  optional_rgb("mean_free_path_mm", sum.mean_free_path_mm);
  optional_rgb("diffuse_mean_free_path_mm", sum.diffuse_mean_free_path_mm);

  for (std::size_t c = 0; c < 3; ++c) {
    if (sum.total_reflectance[c] > 1)
      throw input_error(where, "total_reflectance[{}] must be 0 to 1, got {}", c, sum.total_reflectance[c]);
  }
  return sum;
}

}  // namespace

SumOfGaussians parse_json(std::string_view text, const std::string& where, bool normalise) {
  return with_one_line_errors([&] { return parse(text, where, normalise); });
}

SumOfGaussians load_json(const std::filesystem::path& path, bool normalise) {
  const std::vector<std::byte> bytes = read_file(path, max_file_bytes);
  return parse_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string(), normalise);
}

std::string to_json(const SumOfGaussians& sum) {
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
  // A name that is not UTF-8 is no reason to lose a profile: its odd bytes are replaced.
  return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

SumOfGaussians from_name_or_file(const std::string& name_or_path, bool normalise) {
  const std::vector<std::string_view> names = known_names();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) return known(name_or_path);
  std::error_code error;
  if (!std::filesystem::exists(name_or_path, error)) {
    throw input_error("", "profile '{}' is neither a file nor a published name; published are: {}",
                      name_or_path, fmt::join(names, ", "));
  }
  return load_json(name_or_path, normalise);
}

}  // namespace dermis::gaussians
