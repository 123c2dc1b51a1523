// SPDX-License-Identifier: MIT
// Follows light through simple bodies and writes what leaves them over the position, with its noise, and how
// far a blur of the profile is from it, without and with the laws of shape.
//   shapes_bench OUT.json WALKS MEDIUM SHAPE:SIZE[:ANGLE]...
// MEDIUM: a preset ("skin2"), "melanin=0.1" (spectral skin), or "sigma_a=... sigma_s=... g=... eta=..." per
// mm. SHAPE: sphere, cylinder, bowl, groove (radius in mm), saddle (both radii), slab (thickness) or wedge
// (distance from its edge, and its angle in degrees).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "base/core/error.h"
#include "tissue/gaussians/scatter_profile.h"
#include "tissue/profile/shape_laws.h"
#include "truth/reference/shape_prediction.h"
#include "truth/reference/shapes.h"

namespace {

using namespace dermis;
using Json = nlohmann::ordered_json;
using reference::Body;
using reference::Shape;
using reference::ShapeLight;

/// Lights every 10 degrees to both sides stand for positions on a sphere or a cylinder under one light.
std::vector<double> lights_of(Shape shape) {
  if (shape == Shape::slab) return {0, 180};
  std::vector<double> degrees;
  for (int i = 0; i <= 18; ++i) degrees.push_back(10 * i);
  return degrees;
}

Coefficients coefficients(const std::string& text) {
  return *optics::coefficients_of(optics::parse_coefficients(text, "medium"));
}

ScatterProfile profile_of(const std::string& medium) {
  const std::string melanin = "melanin=";
  if (medium.starts_with(melanin))
    return profile_of_skin({.melanin = std::stod(medium.substr(melanin.size()))});
  if (medium.find('=') != std::string::npos) return profile_of_coefficients(coefficients(medium));
  return profile_of_preset(medium);
}

Body body_of(const std::string& text) {
  const auto names = reference::shape_names();
  const std::size_t colon = text.find(':');
  const auto found = std::find(names.begin(), names.end(), text.substr(0, colon));
  if (found == names.end() || colon == std::string::npos)
    throw input_error("", "'{}': expected SHAPE:SIZE, with one of {}", text, fmt::join(names, ", "));

  Body body{.shape = static_cast<Shape>(found - names.begin())};
  const std::string numbers = text.substr(colon + 1);
  const std::size_t second = numbers.find(':');
  body.size_mm = std::stod(numbers);
  if (second != std::string::npos) body.angle_deg = std::stod(numbers.substr(second + 1));
  return body;
}

/// Share of the positions that a light stands for: rings of a sphere are longer at its equator.
double share_of(Shape shape, double light_deg) {
  const bool round = shape == Shape::sphere || shape == Shape::bowl;
  return round ? std::sin(light_deg * std::numbers::pi / 180) + 1e-9 : 1;
}

/// Root of the mean squared error over that of the truth, per cent.
template <class Predict>
optics::Rgb rms_percent(const Body& body, const std::vector<ShapeLight>& lights, const Predict& predict) {
  optics::Rgb out{};
  for (std::size_t c = 0; c < 3; ++c) {
    double error = 0, truth = 0;
    for (const ShapeLight& light : lights) {
      const double share = share_of(body.shape, light.light_deg);
      error += share * std::pow(predict(light)[c] - light.exitance[c], 2);
      truth += share * light.exitance[c] * light.exitance[c];
    }
    out[c] = 100 * std::sqrt(error / truth);
  }
  return out;
}

Json errors_json(const Body& body, const ScatterProfile& profile, const std::vector<ShapeLight>& lights) {
  const auto lambert = [&](const ShapeLight& light) {
    const double lit = std::max(std::cos(light.light_deg * std::numbers::pi / 180), 0.0);
    return optics::Rgb{lit, lit, lit};
  };
  const auto blur = [&](const ShapeLight& light) { return blurred(body, profile, light.light_deg); };
  const auto with_laws = [&](const ShapeLight& light) {
    optics::Rgb value = blur(light);
    const optics::Rgb factor = shape_factor(body, profile, light.light_deg);
    for (std::size_t c = 0; c < 3; ++c) value[c] *= factor[c];
    return value;
  };
  const auto noise = [&](const ShapeLight& light) {
    optics::Rgb value = light.exitance;
    for (std::size_t c = 0; c < 3; ++c) value[c] += light.exitance_error[c];
    return value;
  };
  return {{"lambert", rms_percent(body, lights, lambert)},
          {"blurred", rms_percent(body, lights, blur)},
          {"with laws", rms_percent(body, lights, with_laws)},
          {"noise", rms_percent(body, lights, noise)}};
}

Json run(const std::string& text, const ScatterProfile& profile, std::uint64_t walks) {
  const Body body = body_of(text);
  const std::vector<ShapeLight> lights = reference::follow(
      body, optics::rgb_medium(*profile.medium), {.walks = walks, .lights_deg = lights_of(body.shape)});

  Json rows = Json::array();
  for (const ShapeLight& light : lights)
    rows.push_back({{"light_deg", light.light_deg},
                    {"exitance", light.exitance},
                    {"exitance_error", light.exitance_error},
                    {"blurred", blurred(body, profile, light.light_deg)},
                    {"factor", shape_factor(body, profile, light.light_deg)},
                    {"radiance", light.radiance},
                    {"radiance_error", light.radiance_error}});
  const Json errors = errors_json(body, profile, lights);
  fmt::print("{:<14} {}\n", text, errors.dump());
  std::fflush(stdout);
  return {{"body", text}, {"rms_percent", errors}, {"lights", rows}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: shapes_bench OUT.json WALKS MEDIUM SHAPE:SIZE[:ANGLE]...\n");
    return 2;
  }
  try {
    const ScatterProfile profile = gaussians::checked_profile(profile_of(argv[3]));
    std::string command = "shapes_bench";
    for (int i = 1; i < argc; ++i) command += fmt::format(" '{}'", argv[i]);
    Json out{{"command", command},
             {"medium", argv[3]},
             {"walks", std::stoull(argv[2])},
             {"bodies", Json::array()}};
    for (int i = 4; i < argc; ++i) out["bodies"].push_back(run(argv[i], profile, std::stoull(argv[2])));
    std::ofstream(argv[1]) << out.dump(1) << "\n";
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
