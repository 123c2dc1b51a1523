// SPDX-License-Identifier: MIT
// Profiles of other systems, by the public header alone.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "dermis/error.h"
#include "dermis/profile_exchange.h"

namespace dermis {
namespace {

using nlohmann::json;

template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InputError& error) { return error.what(); }
  return "nothing was refused";
}

const ScatterProfile& skin1() {
  static const ScatterProfile skin = profile_of_preset("skin1", {.model = ProfileModel::dipole});
  return skin;
}

TEST(PublicExchange, EverySystemNamesItselfAndItsLosses) {
  EXPECT_EQ(exchange_systems().size(), 6u);
  for (const std::string& system : exchange_systems()) {
    const json exported = json::parse(export_profile(skin1(), system));
    EXPECT_EQ(exported.at("system"), system);
    EXPECT_EQ(exported.at("name"), "skin1");
    EXPECT_FALSE(exported.at("parameters").empty());
    EXPECT_FALSE(exported.at("lost").empty());
  }
  EXPECT_NE(refusal([] { export_profile(skin1(), "unitty"); }).find("did you mean 'unity'"),
            std::string::npos);
}

// Burley's d of a curve depends on where its transform falls to half: a fit of six Gaussians keeps that.
TEST(PublicExchange, AProfileThatWasReadIsItsGaussians) {
  ScatterProfile read = skin1();
  read.model_curves = nullptr;
  const auto length_mm = [](const ScatterProfile& profile) {
    const json p = json::parse(export_profile(profile, "unity")).at("parameters");
    return p.at("scatteringDistance")[1].get<double>() * p.at("scatteringDistanceMultiplier").get<double>();
  };
  EXPECT_NEAR(length_mm(read) / length_mm(skin1()), 1, 0.05);
  const ScatterProfile published = load_profile("skin");
  EXPECT_GT(length_mm(published), 0.1);
}

TEST(PublicExchange, ParametersOfUnityComeBack) {
  const ScatterProfile p =
      profile_of_import("unity reflectance=0.8,0.5,0.4 scattering_distance=0.76,0.32,0.2", {.gaussians = 4});
  EXPECT_NEAR(p.total_reflectance[0], 0.8, 1e-3);
  const json out = json::parse(export_profile(p, "unity")).at("parameters");
  const double multiplier = out.at("scatteringDistanceMultiplier");
  EXPECT_NEAR(out.at("scatteringDistance")[0].get<double>() * multiplier, 0.76, 2e-3);
  EXPECT_NEAR(out.at("scatteringDistance")[2].get<double>() * multiplier, 0.2, 1e-3);
  EXPECT_NE(refusal([] { profile_of_import("unity radius=1"); }), "nothing was refused");
}

TEST(PublicExchange, ATableOfAGaussianIsThatGaussian) {
  std::vector<double> r_mm;
  std::vector<std::array<double, 3>> values;
  const double variance_mm2 = 0.7;
  for (int i = 0; i <= 600; ++i) {
    const double r = i * 0.01;
    const double g = std::exp(-r * r / (2 * variance_mm2)) / (2 * std::numbers::pi * variance_mm2);
    r_mm.push_back(r);
    values.push_back({0.6 * g, 0.4 * g, 0.2 * g});
  }
  const ScatterProfile p = profile_of_table("measured", r_mm, values, {.gaussians = 1});
  ASSERT_EQ(p.terms.size(), 1u);
  EXPECT_NEAR(p.terms[0].variance_mm2, variance_mm2, 1e-3);
  EXPECT_NEAR(p.total_reflectance[1], 0.4, 1e-4);

  values.pop_back();
  EXPECT_EQ(refusal([&] { profile_of_table("measured", r_mm, values); }),
            "measured: reflectance_per_mm2 must have as many rows as r_mm, 601, has 600");
  values.push_back({10, 10, 10});
  for (auto& row : values) row[0] *= 4;
  EXPECT_NE(refusal([&] { profile_of_table("measured", r_mm, values); }).find("R in 1/mm^2"),
            std::string::npos);
  r_mm[1] = -1;
  EXPECT_NE(refusal([&] { profile_of_table("measured", r_mm, values); }).find("measured"), std::string::npos);
}

TEST(PublicExchange, KernelsAreWholeFiles) {
  for (const std::string& name : kernel_names()) {
    const ProfileKernel kernel = export_kernel(skin1(), name);
    EXPECT_TRUE(json::parse(kernel.json).is_object()) << name;
    EXPECT_NE(kernel.c.find('{'), std::string::npos);
    EXPECT_NE(kernel.glsl.find("const"), std::string::npos);
  }
  EXPECT_NE(refusal([] { export_kernel(skin1(), "separable-kernel", 4); }), "nothing was refused");
  EXPECT_NE(refusal([] { export_kernel(skin1(), "gauss"); }).find("separable-kernel"), std::string::npos);
}

}  // namespace
}  // namespace dermis
