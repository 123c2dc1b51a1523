// SPDX-License-Identifier: MIT
// The output of `dermis compare --scene` for a comparison with ground truth.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/settings/json.h"
#include "dermis/compare.h"

namespace dermis::cli {

/// compare_scene() with rows that are named by options of the program ("lambert, --optimise none"), and how
/// far it is on the terminal.
SceneComparison compare_scene_here(const Scene& scene, const SceneComparisonSettings& settings);

std::string scene_comparison_text(const SceneComparison& comparison);
/// `settings`: as they were given.
std::string scene_comparison_json(const SceneComparison& comparison, const SettingsFile& settings = {});
/// Without settings.
nlohmann::ordered_json scene_comparison_object(const SceneComparison& comparison);
/// Tables, error over cost, the reference, its regions, and for each technique a slider against it and a map
/// of the error, all maps on one scale.
std::string scene_comparison_page(const SceneComparison& comparison);
/// The same without the frame of a document. `id`: what the names of its pictures begin with.
std::string scene_comparison_body(const SceneComparison& comparison, const std::string& id);
/// A chart of the points of the curves, and of the techniques where there are none; empty without either.
std::string error_over_cost(const SceneComparison& comparison);

}  // namespace dermis::cli
