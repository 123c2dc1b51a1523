// SPDX-License-Identifier: MIT
#include "tissue/gaussians/kernel_export.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "tissue/gaussians/pre_integrated.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::gaussians {
namespace {

using Ordered = nlohmann::ordered_json;

// Rows of numbers, each with as many.
struct NumberArray {
  std::string name, comment;
  int width = 3;  // or 4
  std::vector<double> numbers;
};

// Content of all files of a kernel.
struct KernelText {
  std::vector<std::pair<std::string, double>> constants;
  std::vector<NumberArray> arrays;
  std::string units;
  std::vector<std::string> lost;
};

std::string header_of(const KernelText& kernel, std::string_view name, const std::string& profile) {
  // A name may hold anything, also the end of a comment.
  std::string safe;
  for (const char c : profile) safe += c >= ' ' && c < 127 ? c : '?';
  return fmt::format("// {} of the profile: {}\n// {}\n", name, safe, kernel.units);
}

std::string constant_name(std::string name) {
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

// Always with a point: an integer would be another type in GLSL. Floats do not reach below 1e-38.
std::string number(double value) {
  std::string text = fmt::format("{:.9g}", std::abs(value) < 1e-30 ? 0.0 : value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string c_text(const KernelText& kernel, std::string_view name, const std::string& profile) {
  const std::string prefix = constant_name(std::string(name));
  std::string text = header_of(kernel, name, profile) + "#pragma once\n\n";
  for (const auto& [constant, value] : kernel.constants)
    text += fmt::format("static const float {}_{} = {}f;\n", prefix, constant, number(value));
  for (const NumberArray& array : kernel.arrays) {
    const std::size_t rows = array.numbers.size() / static_cast<std::size_t>(array.width);
    text += fmt::format("\n// {}\nstatic const float {}_{}[{}][{}] = {{\n", array.comment, prefix, array.name,
                        rows, array.width);
    for (std::size_t i = 0; i < array.numbers.size(); ++i) {
      const bool first = i % static_cast<std::size_t>(array.width) == 0,
                 last = (i + 1) % static_cast<std::size_t>(array.width) == 0;
      text += fmt::format("{}{}f{}", first ? "    {" : "", number(array.numbers[i]), last ? "},\n" : ", ");
    }
    text += "};\n";
  }
  return text;
}

std::string glsl_text(const KernelText& kernel, std::string_view name, const std::string& profile) {
  const std::string prefix = constant_name(std::string(name));
  std::string text = header_of(kernel, name, profile) + "\n";
  for (const auto& [constant, value] : kernel.constants)
    text += fmt::format("const float {}_{} = {};\n", prefix, constant, number(value));
  for (const NumberArray& array : kernel.arrays) {
    const std::size_t rows = array.numbers.size() / static_cast<std::size_t>(array.width);
    text += fmt::format("\n// {}\nconst vec{} {}_{}[{}] = vec{}[](\n", array.comment, array.width, prefix,
                        array.name, rows, array.width);
    for (std::size_t row = 0; row < rows; ++row) {
      text += fmt::format("    vec{}(", array.width);
      for (std::size_t i = 0; i < static_cast<std::size_t>(array.width); ++i)
        text += (i > 0 ? ", " : "") + number(array.numbers[row * static_cast<std::size_t>(array.width) + i]);
      text += row + 1 < rows ? "),\n" : "));\n";
    }
  }
  return text;
}

std::string json_text(const KernelText& kernel, std::string_view name, const std::string& profile) {
  Ordered root{{"name", profile}, {"system", name}, {"parameters", Ordered::object()}};
  for (const auto& [constant, value] : kernel.constants) root["parameters"][constant] = value;
  for (const NumberArray& array : kernel.arrays) {
    Ordered rows = Ordered::array();
    for (std::size_t i = 0; i < array.numbers.size(); i += static_cast<std::size_t>(array.width))
      rows.push_back(
          std::vector<double>(array.numbers.begin() + static_cast<std::ptrdiff_t>(i),
                              array.numbers.begin() + static_cast<std::ptrdiff_t>(i) + array.width));
    root["parameters"][array.name] = std::move(rows);
    root["columns"][array.name] = array.comment;
  }
  root["units"] = kernel.units;
  root["lost"] = kernel.lost;
  return root.dump(2, ' ', false, Ordered::error_handler_t::replace) + "\n";
}

// One row, or rows of `width`.
KernelPicture picture_of(const NumberArray& array, int width) {
  return {.name = array.name,
          .width = width,
          .height = static_cast<int>(array.numbers.size()) / (array.width * width),
          .channels = array.width,
          .values = std::vector<float>(array.numbers.begin(), array.numbers.end())};
}

void add_gaussians(KernelText& kernel, const ScatterProfile& profile) {
  NumberArray terms{"gaussians", "variance in mm^2, weights of red, green and blue", 4, {}};
  for (const Gaussian& term : profile.terms)
    terms.numbers.insert(terms.numbers.end(),
                         {term.variance_mm2, term.weight[0], term.weight[1], term.weight[2]});
  kernel.arrays.push_back(std::move(terms));
}

KernelText separable_kernel(const ScatterProfile& profile, int taps) {
  KernelText kernel;
  NumberArray array{"taps", "weights of red, green and blue, offset in mm; the middle first", 4, {}};
  for (const LineTap& tap : line_spread_kernel(profile, taps))
    array.numbers.insert(array.numbers.end(), {tap.weight[0], tap.weight[1], tap.weight[2], tap.offset});
  kernel.constants = {{"reach_mm", line_kernel_reach_mm(profile)}};
  kernel.arrays = {std::move(array)};
  kernel.units =
      "offsets are mm on the skin, along rows and then columns. A mm is height / (2 tan(fov / 2) distance) "
      "pixels, where the distance is in mm. Weights of a channel sum to 1";
  kernel.lost = {
      "a sum of Gaussians is not separable: straight edges along the axes are right, spots below 1 mm "
      "spread too far"};
  return kernel;
}

KernelText disc_kernel(const ScatterProfile& profile, int taps) {
  KernelText kernel;
  NumberArray places{
      "taps", "x, y and radius in mm in the plane that faces the camera, 1 / density in mm^2", 4, {}},
      weights{
          "weights", "weights of red, green and blue where the skin faces the camera; they sum to 1", 3, {}};
  Rgb sum{};
  for (const DiscTap& tap : disc_taps(profile, taps)) {
    places.numbers.insert(places.numbers.end(), {tap.x_mm, tap.y_mm, tap.radius_mm, tap.per_density_mm2});
    for (std::size_t c = 0; c < 3; ++c) {
      double weight = 0;
      for (const Gaussian& term : profile.terms)
        weight += term.weight[c] * std::exp(-tap.radius_mm * tap.radius_mm / (2 * term.variance_mm2)) /
                  (2 * std::numbers::pi * term.variance_mm2);
      weights.numbers.push_back(weight * tap.per_density_mm2);
      sum[c] += weights.numbers.back();
    }
  }
  for (std::size_t i = 0; i < weights.numbers.size(); ++i)
    if (sum[i % 3] > 0) weights.numbers[i] /= sum[i % 3];

  kernel.constants = {{"reach_mm", disc_reach_mm(profile, 0.997)}};
  kernel.arrays = {std::move(places), std::move(weights)};
  add_gaussians(kernel, profile);
  kernel.units =
      "a tap weighs by R(r') times 1 / density, r' its distance in space. R(r) = sum w exp(-r^2 / 2v) / (2 "
      "pi v), in 1/mm^2. Divide the light by the sum of the weights";
  kernel.lost = {"few taps show as rings: the pattern is the same for every pixel"};
  return kernel;
}

NumberArray of_table(std::string name, std::string comment, const LightTable& table) {
  NumberArray array{std::move(name), std::move(comment), 3, {}};
  for (const Rgb& light : table.light) array.numbers.insert(array.numbers.end(), light.begin(), light.end());
  return array;
}

constexpr int exported_columns = 128, exported_lit_rows = 32, exported_shadow_columns = 64,
              exported_shadow_rows = 16;

KernelText pre_integrated_tables(const ScatterProfile& profile) {
  LightTable lit = lit_table(profile, exported_columns, exported_lit_rows);
  for (std::size_t i = 0; i < lit.light.size(); ++i) {
    const double cosine = -1 + 2.0 * static_cast<double>(i % exported_columns) / (exported_columns - 1);
    for (double& light : lit.light[i]) light += std::max(cosine, 0.0);
  }
  KernelText kernel;
  kernel.constants = {{"lit_columns", exported_columns},
                      {"lit_rows", exported_lit_rows},
                      {"most_curvature_per_mm", most_curvature_per_mm},
                      {"shadow_columns", exported_shadow_columns},
                      {"shadow_rows", exported_shadow_rows},
                      {"shadow_filter_mm", shadow_filter_mm(profile)}};
  kernel.arrays = {
      of_table("lit",
               "light of red, green and blue. Column i of n: the cosine -1 + 2 i / (n - 1) of normal and "
               "light. Row j of m: the curvature most_curvature_per_mm (j / (m - 1))^2",
               lit),
      of_table("shadow",
               "light of red, green and blue. Column i of n: the filtered shadow i / (n - 1), 1 lit. Row j "
               "of m: the cosine (j + 1) / m",
               shadow_table(profile, exported_shadow_columns, exported_shadow_rows))};
  kernel.units =
      "curvature in 1/mm, positive where skin bulges; shadows are filtered over a disc of shadow_filter_mm "
      "that faces "
      "the light; white light 1";
  kernel.lost = {"light that crosses edges of albedo, or comes from around a fold",
                 "skin is taken for a ball of its curvature; hollows for a plane"};
  return kernel;
}

}  // namespace

std::vector<std::string_view> kernel_names() {
  return {"separable-kernel", "burley-disc", "pre-integrated-tables"};
}

void check_kernel_taps(std::string_view kernel, std::optional<int> taps) {
  if (!taps) return;
  if (kernel == "pre-integrated-tables") throw input_error(std::string(kernel), "tables have no taps");
  const bool line = kernel == "separable-kernel";
  const int least = line ? least_line_taps : 1, most = line ? most_line_taps : 4096;
  if (*taps < least || *taps > most || (line && *taps % 2 == 0))
    throw input_error(std::string(kernel), "it has {} to {} taps{}, got {}", least, most,
                      line ? ", an odd number" : "", *taps);
}

ExportedKernel export_kernel(std::string_view name, const ScatterProfile& profile, std::optional<int> taps) {
  check_kernel_taps(name, taps);
  KernelText kernel;
  std::vector<int> widths;
  if (name == "separable-kernel") {
    kernel = separable_kernel(profile, taps.value_or(25));
  } else if (name == "burley-disc") {
    kernel = disc_kernel(profile, taps.value_or(64));
  } else if (name == "pre-integrated-tables") {
    kernel = pre_integrated_tables(profile);
    widths = {exported_columns, exported_shadow_columns};
  } else {
    throw input_error("export", "{}", unknown_name(name, kernel_names()));
  }

  ExportedKernel exported{.json = json_text(kernel, name, profile.name),
                          .c = c_text(kernel, name, profile.name),
                          .glsl = glsl_text(kernel, name, profile.name),
                          .pictures = {}};
  for (std::size_t i = 0; i < kernel.arrays.size(); ++i) {
    const NumberArray& array = kernel.arrays[i];
    const auto rows = static_cast<int>(array.numbers.size()) / array.width;
    exported.pictures.push_back(picture_of(array, i < widths.size() ? widths[i] : rows));
  }
  return exported;
}

}  // namespace dermis::gaussians
