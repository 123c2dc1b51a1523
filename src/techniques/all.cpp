// SPDX-License-Identifier: MIT
#include <array>

#include "core/error.h"
#include "techniques/lambert/lambert.h"
#include "techniques/screen.h"
#include "techniques/technique.h"
#include "techniques/texture_space/texture_space.h"

namespace dermis::techniques {
namespace {

constexpr std::array all{
    Technique{.name = "texture-space",
              .summary = "light blurred in the head's texture by a sum of Gaussians (d'Eon et al. 2007)",
              .uses_profile = true,
              .has_light_maps = true,
              .build = build_texture_space,
              .report = report_texture_space,
              .gutters = gutters_of_texture_space},
    Technique{.name = "lambert",
              .summary = "the same lights and specular without scattering",
              .uses_profile = false,
              .has_light_maps = false,
              .build = build_lambert,
              .report = screen_report,
              .gutters = no_gutters},
};

}  // namespace

std::span<const Technique> techniques() { return all; }

const Technique& find_technique(std::string_view name) {
  std::string names;
  for (const Technique& t : all) {
    if (t.name == name) return t;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", t.name);
  }
  throw input_error("technique", "'{}' is not known; there are: {}", name, names);
}

}  // namespace dermis::techniques
