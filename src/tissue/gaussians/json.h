// SPDX-License-Identifier: MIT
// The profile file: JSON with name, variances_mm2 [k], weights [k][3], and optionally model, error_percent,
// total_reflectance, mean_free_path_mm, diffuse_mean_free_path_mm, each [3]; and "medium" and "shape"
// (shape_json.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/json/value.h"
#include "tissue/gaussians/sum.h"

namespace dermis::gaussians {

/// The least variance that a term may have.
enum class LeastVariance : std::uint8_t {
  above_zero,
  zero  ///< light of that term leaves where it entered
};

/// Terms are sorted narrow to wide. InputError: a key that is not known (lists the known ones), a variance <
/// 0 (or 0, unless that may be), equal variances, a negative weight, 0 or more than 8 terms. Also weights
/// that do not sum to 1 within 1e-3 per channel, unless normalise divides them by their sum.
ScatterProfile read_json(const json::Value& profile, bool normalise = false,
                         LeastVariance least = LeastVariance::above_zero);
/// The same from a text, whose place is `where`.
ScatterProfile parse_json(std::string_view text, const std::string& where, bool normalise = false);
/// The same from a file of at most 1 MiB, whose name is the place; also InputError if it cannot be read.
ScatterProfile load_json(const std::filesystem::path& path, bool normalise = false,
                         LeastVariance least = LeastVariance::above_zero);
/// The text that parse_json() reads back to the last bit; bytes of the name that are not UTF-8 are replaced.
/// All numbers must be finite.
std::string to_json(const ScatterProfile& sum);

/// A name of known(), else a file. InputError lists the known names when it is neither.
ScatterProfile from_name_or_file(const std::string& name_or_path, bool normalise = false,
                                 LeastVariance least = LeastVariance::above_zero);

}  // namespace dermis::gaussians
