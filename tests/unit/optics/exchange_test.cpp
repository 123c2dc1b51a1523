// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/core/error.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/gaussians/fit.h"
#include "tissue/gaussians/known.h"
#include "tissue/optics/presets.h"
#include "tissue/profile/beam.h"
#include "tissue/profile/burley.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/equivalent.h"

namespace dermis {
namespace {

using Json = nlohmann::json;
using optics::Rgb;
const Rgb totals{0.7, 0.4, 0.2}, shapes{0.8, 0.35, 0.2};

gaussians::Exported burley_skin() {
  gaussians::Exported input{.name = "test", .profiles = {}, .terms = {}, .medium = {}};
  for (int c = 0; c < 3; ++c) {
    input.profiles[c] = std::make_shared<profile::Burley>(totals[c], shapes[c], "test");
    input.medium[c] = profile::equivalent_medium(*input.profiles[c], 1.4);
    const auto fit = gaussians::fit_channel(*input.profiles[c], 4);
    for (const auto& term : fit.terms)
      input.terms[c].push_back({term.variance_mm2, term.weight / fit.weight_sum()});
  }
  return input;
}

/// Each value within 1e-5 of what the formula of docs/exports.md gives by hand.
void expect_triple(const Json& values, const Rgb& by_hand, const char* what) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(values[c].get<double>() / by_hand[c], 1, 1e-5) << what << c;
}

// d = 0.8, 0.35, 0.2 mm and A = 0.7, 0.4, 0.2 in each system's own numbers. Nothing here shares a factor with
// the code.
TEST(Exchange, NumbersByHandOfBurleySystems) {
  const auto input = burley_skin();
  const Json unity = Json::parse(gaussians::export_text("unity", input))["parameters"];
  EXPECT_NEAR(unity["scatteringDistanceMultiplier"].get<double>(), 0.8, 1e-5);  // d in mm
  expect_triple(unity["scatteringDistance"], {1, 0.4375, 0.25}, "unity");
  // mfp_cm = 0.06 s d, s = 1.85 - A + 7 |A - 0.8|^3 = 1.157, 1.898, 3.162; the smallest distance is 0.1
  const Json unreal = Json::parse(gaussians::export_text("unreal", input))["parameters"];
  EXPECT_NEAR(unreal["MeanFreePathDistance"].get<double>(), 0.1, 1e-12);
  expect_triple(unreal["MeanFreePathColor"], {0.55536, 0.39858, 0.37944}, "unreal");
  expect_triple(unreal["SurfaceAlbedo"], totals, "unreal");
  // radius = 4 pi s d, s = 1.9 - A + 3.5 (A - 0.8)^2 = 1.235, 2.06, 2.96: 12.41557, 9.060353, 7.439291 mm
  const Json cycles = Json::parse(gaussians::export_text("cycles", input))["parameters"];
  EXPECT_NEAR(cycles["Scale"].get<double>(), 0.01241557, 1e-7);
  expect_triple(cycles["Radius"], {1, 0.7297570, 0.5991900}, "cycles");
}

// skin1: sigma_t' = 0.772, 1.05, 1.49 per mm; one term as wide as the published skin's widest.
TEST(Exchange, NumbersByHandOfMediaAndKernels) {
  gaussians::Exported input{
      .name = "skin1", .profiles = {}, .terms = {}, .medium = optics::find_material("skin1")->medium()};
  for (int c = 0; c < 3; ++c) {
    input.profiles[c] = std::make_shared<profile::Dipole>(input.medium[c]);
    input.terms[c] = {{7.41, 1}};
  }

  const Json pbr = Json::parse(gaussians::export_text("openpbr", input))["parameters"];
  EXPECT_NEAR(pbr["subsurface_radius"].get<double>(), 1.295337e-3, 1e-8);  // 1 / 0.772 mm, in metres
  expect_triple(pbr["subsurface_radius_scale"], {1, 0.7352381, 0.5181208}, "openpbr");
  EXPECT_EQ(pbr["specular_ior"], 1.3);

  const Json gltf = Json::parse(gaussians::export_text("gltf", input))["parameters"]["extensions"];
  // 1 / 1.49 mm, in metres
  EXPECT_NEAR(gltf["KHR_materials_volume"]["attenuationDistance"].get<double>(), 6.711409e-4, 1e-9);
  // e^{-sigma_t' / 1.49}
  expect_triple(gltf["KHR_materials_volume"]["attenuationColor"], {0.5956386, 0.4942580, 0.3678794}, "gltf");
  EXPECT_EQ(gltf["KHR_materials_ior"]["ior"], 1.3);

  // 1.5 sqrt(7.41) mm in metres; taps of a unit Gaussian between +-1/96, and from there to 5/96
  const Json separable = Json::parse(gaussians::export_text("separable", input))["parameters"];
  EXPECT_NEAR(separable["sssWidth"].get<double>(), 4.083197e-3, 1e-8);
  ASSERT_EQ(separable["kernel"].size(), 25u);
  EXPECT_NEAR(separable["kernel"][0][0].get<double>(), 0.00833365, 1e-7);
  EXPECT_NEAR(separable["kernel"][12][3].get<double>(), -3.0 / 144, 1e-12);
  EXPECT_NEAR(separable["kernel"][12][1].get<double>(), 0.01665825, 1e-7);
}

// What one number cannot hold is said.
TEST(Exchange, SaysWhatIsMergedAndCut) {
  gaussians::Exported input = burley_skin();
  const auto lost = [&](const char* system) {
    return Json::parse(gaussians::export_text(system, input))["lost"].dump();
  };
  EXPECT_EQ(lost("unreal").find("the red one"), std::string::npos);
  EXPECT_EQ(lost("unreal").find("cut to 1"), std::string::npos);
  input.medium[2].eta = 1.5;
  for (const char* system : {"unity", "unreal", "gltf", "openpbr", "cycles"})
    EXPECT_NE(lost(system).find("(1.4, 1.4, 1.5): the red one stands for all"), std::string::npos) << system;
  input.profiles[0] = std::make_shared<profile::PhotonBeam>(optics::Medium{0.001, 0.999, 0, 1});
  EXPECT_NE(lost("cycles").find("cut to 1, the model gives 1.005"), std::string::npos);
}

std::string triple(const Json& values) {
  return fmt::format("{},{},{}", values[0].get<double>(), values[1].get<double>(), values[2].get<double>());
}
std::string number(const Json& value) { return fmt::format("{}", value.get<double>()); }

void expect_shapes(const gaussians::Imported& imported) {
  ASSERT_TRUE(imported.is_burley);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(imported.burley_shape_mm[c] / shapes[c], 1, 1e-3) << imported.name << c;
    EXPECT_NEAR(imported.total_reflectance[c], totals[c], 1e-6);
  }
}

TEST(Exchange, BurleySystemsGiveTheProfileBack) {
  const auto input = burley_skin();
  const Json unity = Json::parse(gaussians::export_text("unity", input))["parameters"];
  expect_shapes(gaussians::parse_import(
      "unity reflectance=0.7,0.4,0.2 scattering_distance=" + triple(unity["scatteringDistance"]) +
          " multiplier=" + number(unity["scatteringDistanceMultiplier"]),
      "--import"));
  const Json unreal = Json::parse(gaussians::export_text("unreal", input))["parameters"];
  expect_shapes(gaussians::parse_import(
      "unreal enable_mean_free_path=1 surface_albedo=" + triple(unreal["SurfaceAlbedo"]) +
          " mean_free_path_color=" + triple(unreal["MeanFreePathColor"]) +
          " mean_free_path_distance=" + number(unreal["MeanFreePathDistance"]),
      "--import"));
  const Json cycles = Json::parse(gaussians::export_text("cycles", input))["parameters"];
  expect_shapes(gaussians::parse_import("cycles scene_unit_mm=1000 color=" + triple(cycles["Color"]) +
                                            " radius=" + triple(cycles["Radius"]) +
                                            " scale=" + number(cycles["Scale"]),
                                        "--import"));
}

TEST(Exchange, MediumSystemsGiveTheMeanFreePathBack) {
  const auto input = burley_skin();
  const Json pbr = Json::parse(gaussians::export_text("openpbr", input))["parameters"];
  const auto a = gaussians::parse_import(
      "openpbr scene_unit_mm=1000 specular_ior=1.4 subsurface_color=" + triple(pbr["subsurface_color"]) +
          " subsurface_radius=" + number(pbr["subsurface_radius"]) +
          " subsurface_radius_scale=" + triple(pbr["subsurface_radius_scale"]),
      "--import");

  const Json gltf = Json::parse(gaussians::export_text("gltf", input))["parameters"]["extensions"];
  const auto b = gaussians::parse_import(
      "gltf ior=1.4 multiscatter_color=" + triple(gltf["KHR_materials_volume_scatter"]["multiscatterColor"]) +
          " attenuation_color=" + triple(gltf["KHR_materials_volume"]["attenuationColor"]) +
          " attenuation_distance=" + number(gltf["KHR_materials_volume"]["attenuationDistance"]),
      "--import");

  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(a.medium[c].mean_free_path().mm / input.medium[c].mean_free_path().mm, 1, 1e-6);
    EXPECT_NEAR(b.medium[c].mean_free_path().mm / input.medium[c].mean_free_path().mm, 1, 1e-6);
    EXPECT_NEAR(profile::Dipole(a.medium[c]).total(), totals[c], 1e-6);
  }
}

// A straight edge along an axis, blurred by the exported kernel at the scale that its units state.
TEST(Exchange, SeparableKernelBlursAnEdgeRight) {
  const auto input = burley_skin();
  const Json out = Json::parse(gaussians::export_text("separable", input))["parameters"];
  const double mm_per_offset = out["sssWidth"].get<double>() * 1000 * 2 / 3;
  double sum = 0;
  for (const double x_mm : {0.3, 1.0}) {
    double blurred = 0;
    sum = 0;
    for (const auto& tap : out["kernel"]) {
      sum += tap[0].get<double>();
      if (x_mm + tap[3].get<double>() * mm_per_offset < 0) blurred += tap[0].get<double>();
    }
    std::vector<gaussians::Term> terms;
    for (const auto& [variance, weight] : input.terms[0]) terms.push_back({variance, weight});
    EXPECT_NEAR(blurred, gaussians::edge_response(terms, x_mm), 0.05) << x_mm;  // 25 taps
  }
  EXPECT_NEAR(sum, 1, 1e-9);
}

std::string message_of(const char* text) {
  try {
    gaussians::parse_import(text, "--import");
  } catch (const InputError& error) { return error.what(); }
  return "no error";
}

TEST(Exchange, AmbiguousImportsAreRefusedWithTheirReadings) {
  EXPECT_NE(message_of("radius=1")
                .find("a mean free path, a diffuse mean free path or Burley's d, in mm, cm or scene units"),
            std::string::npos);
  EXPECT_NE(message_of("cycles color=0.8 radius=1,0.2,0.1")
                .find("as metres it is 1000,200,100 mm, as centimetres 10,2,1 mm"),
            std::string::npos);
  EXPECT_NE(message_of("openpbr subsurface_color=0.8 subsurface_radius=1").find("scene_unit_mm"),
            std::string::npos);
  EXPECT_NE(message_of("unreal surface_albedo=0.5 mean_free_path_color=1 mean_free_path_distance=1")
                .find("two readings"),
            std::string::npos);
  EXPECT_NE(message_of("unreal enable_mean_free_path=2 surface_albedo=0.5 mean_free_path_color=1 "
                       "mean_free_path_distance=1")
                .find("must be 0 or 1"),
            std::string::npos);

  EXPECT_NE(message_of("a\nb").find("'a?b' names no system"), std::string::npos);
  EXPECT_NE(message_of("separable width=1").find("do not say a profile"), std::string::npos);
  EXPECT_NE(message_of("unity reflectance=0.5 radius=1").find("there are: reflectance, scattering_distance"),
            std::string::npos);
  EXPECT_NE(message_of("unity reflectance=0 scattering_distance=1").find("above 0"), std::string::npos);
  EXPECT_NE(message_of("unity reflectance=0.5 scattering_distance=-1").find("1e-6 to 1e6 mm"),
            std::string::npos);
  EXPECT_NE(message_of("cycles scene_unit_mm=1 color=0.5 radius=-2")
                .find("radius * scale must be above 0, got -2 mm"),
            std::string::npos);

  // One number where the system has one
  for (const char* text :
       {"cycles scene_unit_mm=1000,1,1 color=0.5 radius=1",
        "openpbr scene_unit_mm=1,1,10 subsurface_color=0.5 subsurface_radius=1",
        "openpbr scene_unit_mm=1 specular_ior=1.3,1.4,1.5 subsurface_color=0.5 subsurface_radius=1",
        "gltf ior=1.3,1.4,1.5 multiscatter_color=0.5 attenuation_color=0.5 attenuation_distance=0.001",
        "unreal enable_mean_free_path=1,0,0 surface_albedo=0.5 mean_free_path_color=1 "
        "mean_free_path_distance=1"})
    EXPECT_NE(message_of(text).find("is one number for all channels"), std::string::npos) << text;

  EXPECT_THROW(gaussians::export_text("maya", burley_skin()), InputError);
}

TEST(Equivalent, DipolesGiveTheirOwnMediumBack) {
  for (const char* name : {"skin1", "cream", "ketchup"})
    for (const auto& medium : optics::find_material(name)->medium()) {
      const optics::Medium found = profile::equivalent_medium(profile::Dipole(medium), medium.eta);
      EXPECT_NEAR(found.mean_free_path().mm / medium.mean_free_path().mm, 1, 1e-4);
      EXPECT_NEAR(found.diffuse_mean_free_path().mm / medium.diffuse_mean_free_path().mm, 1, 1e-4);
    }
}

TEST(Sums, DifferenceAndEdge) {
  const std::vector<gaussians::Term> terms = gaussians::channel(gaussians::skin_six(), 0);
  EXPECT_NEAR(gaussians::difference_percent(terms, terms), 0, 1e-5);
  EXPECT_NEAR(gaussians::edge_response(terms, 0), 0.5, 1e-12);
}

}  // namespace
}  // namespace dermis
