// SPDX-License-Identifier: MIT
// The colours of one complexion around its mean, by a table that is quicker than the spectral one.
#pragma once

#include <vector>

#include "head/builtin_head/clay.h"
#include "head/builtin_head/complexion.h"

namespace dermis::builtin_head {

/// Albedos (linear Rec.709) over what differs from the mean: natural logarithms of melanin (-0.7 to 2) and
/// haemoglobin (-1.2 to 3), and how much less oxygenated it is (0 to 0.5). Linear between nodes, which are
/// 0.1 apart in the logarithms: within 0.1 % of optics::SkinTable.
class Tints {
 public:
  explicit Tints(const optics::Pigments& mean);
  /// Values out of range are clamped.
  vec3 at(float log_melanin, float log_blood, float less_oxygen) const;

 private:
  std::vector<vec3> albedo_;
};

}  // namespace dermis::builtin_head
