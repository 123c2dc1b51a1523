// SPDX-License-Identifier: MIT
#include "cli/bench/passes.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/core/assert.h"
#include "cli/bench/statistics.h"

namespace dermis::cli::bench {
namespace {

// "blur 2 u batch 1 part 0" -> "blur 2 u".
std::string common_name(std::string name) {
  for (const std::string_view what : {" head ", " batch ", " part "}) {
    const std::size_t at = name.find(what);
    if (at == std::string::npos) continue;
    const std::size_t digits = at + what.size(),
                      end = std::min(name.find_first_not_of("0123456789", digits), name.size());
    if (end > digits) name.erase(at, end - at);
  }
  return name;
}

// By how the name of a pass begins; the first that fits. The last four are names in older records.
constexpr std::array<std::pair<std::string_view, std::size_t>, 37> beginnings{{
    {"shadow", 0},        {"entering", 0},        {"cull triangles", 1}, {"clear light", 1},
    {"clear tiles", 1},   {"seen tiles", 1},      {"tiles", 1},          {"tone map", 6},
    {"texel map", 1},     {"irradiance", 1},      {"stretch", 1},        {"turn sky", 1},
    {"depth mask", 2},    {"add transmitted", 3}, {"blur", 3},           {"final", 4},
    {"ids", 4},           {"entries", 4},         {"entry list", 4},     {"part ranges", 4},
    {"clear parts", 4},   {"shade", 4},           {"clear skin", 4},     {"separable", 3},
    {"disc", 3},          {"add scattered", 4},   {"surfaces", 5},       {"blended surfaces", 5},
    {"blended cover", 5}, {"open share", 6},      {"background", 6},     {"resolve", 6},
    {"bloom", 6},         {"halve", 3},           {"join", 3},           {"view", 6},
    {"gutter tiles", 1},
}};

}  // namespace

std::vector<PassStatistics> merge_passes(const std::vector<PassStatistics>& passes) {
  std::vector<PassStatistics> merged;
  for (const PassStatistics& pass : passes) {
    const std::string name = common_name(pass.name);
    const auto same = std::find_if(merged.begin(), merged.end(),
                                   [&](const PassStatistics& other) { return other.name == name; });
    if (same == merged.end()) {
      merged.push_back(pass);
      merged.back().name = name;
      continue;
    }
    same->ms += pass.ms;
    same->calls += pass.calls;
    same->texels += pass.texels;
    same->image_bytes += pass.image_bytes;
  }
  return merged;
}

const std::vector<std::string>& pass_groups() {
  static const std::vector<std::string> groups{
      "shadow maps",      "irradiance",     "masks and borders",  "convolutions",
      "sum and specular", "other surfaces", "bloom and tone map", "other"};
  return groups;
}

std::size_t group_of(std::string_view pass) {
  for (const auto& [beginning, group] : beginnings)
    if (pass.starts_with(beginning)) return group;
  return pass_groups().size() - 1;
}

std::vector<double> group_ms(const std::vector<PassStatistics>& passes) {
  std::vector<double> groups(pass_groups().size());
  for (const PassStatistics& pass : passes) groups[group_of(pass.name)] += pass.ms;
  return groups;
}

std::vector<PassStatistics> median_passes(const std::vector<std::vector<PassStatistics>>& frames) {
  if (frames.empty()) return {};
  std::vector<PassStatistics> medians = frames.front();
  for (std::size_t p = 0; p < medians.size(); ++p) {
    std::vector<double> times;
    for (const std::vector<PassStatistics>& frame : frames) {
      DERMIS_ASSERT_EQ(frame.size(), medians.size());
      times.push_back(frame[p].ms);
    }
    medians[p].ms = spread_of(times).median;
  }
  return medians;
}

}  // namespace dermis::cli::bench
