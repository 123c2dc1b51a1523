// SPDX-License-Identifier: MIT
/// Labels in files: steps and offsets of PNG, names of layers, and their rows of a sheet.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "dermis/camera.h"
#include "dermis/landmarks.h"
#include "dermis/outputs.h"
#include "dermis/scene.h"

namespace dermis::api {

/// In PNG: value = round((number + offset) / step), and 0 where nothing is.
struct LabelForm {
  Output output{};
  std::array<const char*, 3> channels{};  ///< of its layer
  double step = 0;                        ///< in PNG; 0: a PNG does not hold it
  double offset = 0;                      ///< added to the number before
};
/// All labels but motion, which is since the frame before.
std::span<const LabelForm> label_forms();

const OutputRow& row_of(Output output);

/// Returns the values of a label as a PNG of 16 bits has them. Throws InputError: a number that it does not
/// hold.
std::vector<std::uint16_t> png_values(const Results& results, const LabelForm& form);

/// Returns meaning, unit and names of a label.
nlohmann::ordered_json label_json(const OutputRow& row);
/// Returns the same of a PNG, with the way from values to numbers.
nlohmann::ordered_json png_label_json(const LabelForm& form, const std::string& file);
/// Returns the camera of a picture in the conventions of OpenCV.
nlohmann::ordered_json camera_json(const ResolvedCamera& camera);

/// Returns the values of each landmark in a picture, null for what is no number.
nlohmann::ordered_json landmark_points_json(std::span<const Landmark> landmarks);
/// Returns names and units of these values.
nlohmann::ordered_json landmark_columns_json();
/// Returns the landmarks of each instance, with `results.depth_m`; null where it has none, null if none has.
nlohmann::ordered_json landmarks_json(const Scene& scene, const ResolvedCamera& camera,
                                      const Results& results);

}  // namespace dermis::api
