// SPDX-License-Identifier: MIT
// Kernels as files: each form has the same numbers, in the unit that it names.
#include "tissue/gaussians/kernel_export.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/core/error.h"
#include "tissue/gaussians/known.h"
#include "tissue/gaussians/pre_integrated.h"
#include "tissue/gaussians/screen_kernels.h"

namespace dermis::gaussians {
namespace {

using Numbers = std::vector<double>;

Numbers flattened(const nlohmann::json& rows) {
  Numbers all;
  for (const auto& row : rows)
    for (const auto& value : row) all.push_back(value);
  return all;
}

// The numbers between the brackets that follow a name: braces in C, vectors in GLSL.
Numbers numbers_after(const std::string& text, const std::string& name, char opens, char closes) {
  const std::size_t from = text.find(opens, text.find(name)), to = text.find(";", from);
  Numbers all;
  std::string digits;
  for (const char c : text.substr(from, to - from)) {
    if (std::string("0123456789.+-e").find(c) != std::string::npos) {
      digits += c;
      continue;
    }
    // "vec4" is no number, nor is the f behind one.
    if (c == ',' || c == closes || c == 'f') {
      if (digits.find('.') != std::string::npos) all.push_back(std::stod(digits));
    }
    digits.clear();
  }
  return all;
}

void expect_near(const Numbers& found, const Numbers& wanted, double relative) {
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_NEAR(found[i], wanted[i], relative * std::abs(wanted[i]) + 1e-30) << i;
}

void expect_everywhere(const ExportedKernel& kernel, const std::string& prefix, const std::string& array,
                       const Numbers& wanted) {
  SCOPED_TRACE(array);
  expect_near(flattened(nlohmann::json::parse(kernel.json).at("parameters").at(array)), wanted, 1e-12);
  expect_near(numbers_after(kernel.c, prefix + "_" + array + "[", '{', '}'), wanted, 1e-8);
  expect_near(numbers_after(kernel.glsl, prefix + "_" + array + "[", '(', ')'), wanted, 1e-8);
  for (const KernelPicture& picture : kernel.pictures) {
    if (picture.name != array) continue;
    EXPECT_EQ(picture.values.size(), static_cast<std::size_t>(picture.width) *
                                         static_cast<std::size_t>(picture.height) *
                                         static_cast<std::size_t>(picture.channels));
    expect_near(Numbers(picture.values.begin(), picture.values.end()), wanted, 1e-6);
  }
}

TEST(KernelExport, TheSeparableKernelIsThatOfTheTechnique) {
  Numbers wanted;
  for (const LineTap& tap : line_spread_kernel(skin_six(), 25))
    wanted.insert(wanted.end(), {tap.weight[0], tap.weight[1], tap.weight[2], tap.offset});
  const ExportedKernel kernel = export_kernel("separable-kernel", skin_six(), {});
  expect_everywhere(kernel, "separable_kernel", "taps", wanted);
  EXPECT_NE(kernel.glsl.find("const vec4 separable_kernel_taps[25] = vec4[]("), std::string::npos);
  EXPECT_NE(kernel.c.find("static const float separable_kernel_taps[25][4] = {"), std::string::npos);
  EXPECT_NE(kernel.c.find("mm"), std::string::npos);
}

// Weighed by their weights, the taps of a disc spread light as far as the profile.
TEST(KernelExport, TheDiscSpreadsAsFarAsTheProfile) {
  const ExportedKernel kernel = export_kernel("burley-disc", skin_six(), 1024);
  const nlohmann::json parameters = nlohmann::json::parse(kernel.json).at("parameters");
  const Numbers taps = flattened(parameters.at("taps")), weights = flattened(parameters.at("weights"));
  ASSERT_EQ(taps.size(), 4096u);
  Rgb moment{};
  for (std::size_t i = 0; i < 1024; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      moment[c] += weights[3 * i + c] * (taps[4 * i] * taps[4 * i] + taps[4 * i + 1] * taps[4 * i + 1]) / 2;
  const Rgb variance{1.3829, .0681, .0248};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(moment[c] / variance[c], 1, 0.01);
  expect_everywhere(kernel, "burley_disc", "taps", taps);
  expect_everywhere(kernel, "burley_disc", "weights", weights);
}

TEST(KernelExport, TablesHoldLight) {
  const ExportedKernel kernel = export_kernel("pre-integrated-tables", skin_six(), {});
  const nlohmann::json parameters = nlohmann::json::parse(kernel.json).at("parameters");
  const Numbers lit = flattened(parameters.at("lit"));
  const int columns = parameters.at("lit_columns"), rows = parameters.at("lit_rows");
  ASSERT_EQ(lit.size(), static_cast<std::size_t>(3 * columns * rows));
  const int column = 70, row = 9;
  const Rgb light = lit_arc(skin_six(), -1 + 2.0 * column / (columns - 1),
                            std::pow(static_cast<double>(row) / (rows - 1), 2));
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(lit[static_cast<std::size_t>(3 * (row * columns + column)) + c], light[c], 1e-12);
  expect_everywhere(kernel, "pre_integrated_tables", "lit", lit);
  expect_everywhere(kernel, "pre_integrated_tables", "shadow", flattened(parameters.at("shadow")));
  ASSERT_EQ(kernel.pictures.size(), 2u);
  EXPECT_EQ(kernel.pictures[0].width, columns);
  EXPECT_EQ(kernel.pictures[0].height, rows);
}

TEST(KernelExport, ANameCannotEndAComment) {
  ScatterProfile profile = skin_six();
  profile.name = "a\n#error b\x01";
  const ExportedKernel kernel = export_kernel("separable-kernel", profile, 3);
  EXPECT_EQ(kernel.c.find("\n#error"), std::string::npos);
  EXPECT_EQ(kernel.glsl.find("\n#error"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(kernel.json).at("name"), profile.name);
}

TEST(KernelExport, Refuses) {
  EXPECT_THROW(export_kernel("oil", skin_six(), {}), InputError);
  for (const int taps : {1, 4, 35, -3})
    EXPECT_THROW(export_kernel("separable-kernel", skin_six(), taps), InputError);
  for (const int taps : {0, 4097}) EXPECT_THROW(export_kernel("burley-disc", skin_six(), taps), InputError);
  EXPECT_THROW(export_kernel("pre-integrated-tables", skin_six(), 9), InputError);
}

}  // namespace
}  // namespace dermis::gaussians
