// SPDX-License-Identifier: MIT
// Distributions within JSON. Where a value may stand, an object with one of these keys may stand in its
// place:
//
//   {"uniform": [low, high]}                    a number, low <= x < high
//   {"whole": [least, most]}                    a whole number, both included
//   {"log_uniform": [low, high]}                its logarithm is uniform; both above 0
//   {"normal": [mean, deviation], "within": [least, most]}   drawn again until it lies within
//   {"choice": [value, ...], "weights": [...]}  one of these, which may hold distributions; equally often
//   without
//   {"table": {"edges": [...], "weights": [...]}}   a histogram: one more edge than weights
//
// A path names the place of a distribution, "settings.camera.fov_deg", and its stream
// (tools/dataset/philox.h).
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/json/value.h"

namespace dermis::dataset {

using Json = nlohmann::ordered_json;

/// Returns whether an object stands for a value.
bool is_distribution(const Json& tree);

/// Throws InputError with the place if a distribution within a value is not as above.
void check_distributions(const json::Value& value);

/// Returns the number of the sample, or of what it shares with others, whose stream a path has.
using NumberOf = std::function<std::uint64_t(const std::string& path)>;

/// Returns `tree` with a value in place of each distribution. `path` is that of the tree.
Json drawn(const Json& tree, const std::string& path, std::uint32_t seed, const NumberOf& number_of);

/// Returns trees that between them have each choice, and of each number the least, the greatest and one
/// between. Throws InputError if there are more than `most`.
std::vector<Json> extremes(const Json& tree, const std::string& path, std::size_t most);

/// Returns the paths of all distributions.
std::vector<std::string> paths_of(const Json& tree, const std::string& path);

}  // namespace dermis::dataset
