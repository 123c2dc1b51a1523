// SPDX-License-Identifier: MIT
#include "cli/scene_comparison.h"

#include <string>

#include "cli/progress.h"

namespace dermis::cli {
namespace {

// Rows of the library are named by settings.
void name_by_options(std::string& name) {
  const std::string setting = ", optimise ";
  const std::size_t at = name.find(setting);
  if (at != std::string::npos) name.replace(at, setting.size(), ", --optimise ");
}

}  // namespace

SceneComparison compare_scene_here(const Scene& scene, const SceneComparisonSettings& settings) {
  SceneComparison found = compare_scene(scene, settings);
  show_line("");
  for (ComparedTechnique& technique : found.techniques) name_by_options(technique.name);
  return found;
}

}  // namespace dermis::cli
