// SPDX-License-Identifier: MIT
#include "api/compare/quality_settings.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "base/settings/names.h"
#include "render/techniques/technique.h"

namespace dermis::api {
namespace {

constexpr std::array tap_counts{5, 7, 9, 13, 17, 25, 33, 64, 128, 256, 1024};
/// Fractions of the map size that is asked for.
constexpr std::array map_divisors{8, 4, 2, 1};

bool can_have(const techniques::TapRange& range, int taps) {
  const auto count = static_cast<std::uint32_t>(taps);
  return count >= range.least && count <= range.most && (!range.odd || count % 2 == 1);
}

bool has_kernel(const techniques::Technique& technique, ScreenKernel kernel) {
  return kernel != ScreenKernel::ue || technique.ue_kernel;
}

// The points of one kernel.
void add_curve(const RenderSettings& common, const techniques::Technique& technique,
               std::vector<QualitySetting>& to) {
  const std::string curve = fmt::format("{}, kernel {}", technique.name, name_of(common.quality.kernel));
  const std::uint32_t fixed = common.quality.kernel == ScreenKernel::published ? technique.taps.published : 0;

  for (const int taps : tap_counts) {
    if (!can_have(technique.taps, taps)) continue;
    if (fixed > 0 && static_cast<std::uint32_t>(taps) != fixed) continue;
    RenderSettings s = common;
    s.quality.taps = taps;
    to.push_back({.curve = curve, .label = fmt::format("{} taps", taps), .settings = std::move(s)});
  }
}

void add_taps(const RenderSettings& common, const techniques::Technique& technique,
              std::vector<QualitySetting>& to) {
  for (const ScreenKernel kernel : {ScreenKernel::profile, ScreenKernel::published, ScreenKernel::ue}) {
    if (!has_kernel(technique, kernel)) continue;
    RenderSettings s = common;
    s.quality.kernel = kernel;
    add_curve(s, technique, to);
  }
}

void add_maps(const RenderSettings& common, std::vector<QualitySetting>& to) {
  for (const int divisor : map_divisors) {
    RenderSettings s = common;
    s.quality.map_size = common.quality.map_size / divisor;
    to.push_back({.curve = common.technique,
                  .label = fmt::format("map of {}", s.quality.map_size),
                  .settings = std::move(s)});
  }
}

// Settings may not go together.
bool has_plan(const Scene& scene, const RenderSettings& settings) {
  try {
    describe_plan(scene, settings);
    return true;
  } catch (const InputError&) { return false; }
}

}  // namespace

std::vector<QualitySetting> quality_settings(const Scene& scene, const RenderSettings& common,
                                             const std::string& name) {
  const techniques::Technique& technique = techniques::find_technique(name);
  RenderSettings s = common;
  s.technique = name;

  std::vector<QualitySetting> wanted;
  if (technique.taps.most > 0) add_taps(s, technique, wanted);
  if (technique.has_light_maps) add_maps(s, wanted);
  if (wanted.empty()) wanted.push_back({.curve = name, .label = name, .settings = s});

  std::vector<QualitySetting> possible;
  for (QualitySetting& one : wanted)
    if (has_plan(scene, one.settings)) possible.push_back(std::move(one));
  return possible;
}

}  // namespace dermis::api
