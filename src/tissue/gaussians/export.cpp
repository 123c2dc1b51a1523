// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/profile/burley.h"
#include "tissue/profile/equivalent.h"

namespace dermis::gaussians {
namespace {

using Json = nlohmann::ordered_json;
using optics::Rgb;
using std::numbers::pi;

constexpr std::string_view names[] = {"separable", "unity", "unreal", "gltf", "openpbr", "cycles"};

Rgb totals(const Exported& input) {
  Rgb total{};
  for (int c = 0; c < 3; ++c) total[c] = std::min(input.profiles[c]->total(), 1.0);
  return total;
}

/// Burley's d with the profile's half frequency; his R^ depends on k d alone.
Rgb burley_shape_mm(const Exported& input) {
  static const double unit = profile::half_frequency_per_mm(profile::Burley(1, 1, "unit"));
  Rgb shape{};
  for (int c = 0; c < 3; ++c) shape[c] = unit / profile::half_frequency_per_mm(*input.profiles[c]);
  return shape;
}

double largest(const Rgb& v) { return std::max({v[0], v[1], v[2]}); }
Rgb scaled(Rgb v, double by) {
  for (double& value : v) value *= by;
  return v;
}

Json unity(const Exported& input) {
  const Rgb d = burley_shape_mm(input);
  return {{"parameters",
           {{"scatteringDistance", scaled(d, 1 / largest(d))},
            {"scatteringDistanceMultiplier", largest(d)},
            {"worldScale", 1},
            {"ior", input.medium[0].eta}}},
          {"units", "scatteringDistance * multiplier = Burley's d in mm; worldScale = metres per scene unit"},
          {"lost",
           {"the profile's own shape: Burley's curve stands for it",
            "the reflectance: the material's base colour carries it"}}};
}

Json unreal(const Exported& input) {
  // Engine: dmfp = mfp / 0.6 * s_dmfp / s_mfp, d = dmfp / s_dmfp; so mfp = 0.6 s_mfp d whatever s_dmfp is.
  const Rgb total = totals(input), d = burley_shape_mm(input);
  Rgb mfp_cm{};
  for (int c = 0; c < 3; ++c)
    mfp_cm[c] = 0.1 * 0.6 * d[c] / profile::Burley::shape_mm(total[c], optics::MeanFreePath(1));
  const double distance_cm = std::max(largest(mfp_cm), 0.1);  // the editor's smallest

  return {{"parameters",
           {{"SurfaceAlbedo", total},
            {"MeanFreePathColor", scaled(mfp_cm, 1 / distance_cm)},
            {"MeanFreePathDistance", distance_cm},
            {"WorldUnitScale", 0.1},
            {"bEnableBurley", true},
            {"bEnableMeanFreePath", true},
            {"IOR", input.medium[0].eta}}},
          {"units",
           "MeanFreePathColor * MeanFreePathDistance in cm (WorldUnitScale 0.1, the default, leaves them as "
           "they are)"},
          {"lost",
           {"the profile's own shape: Burley's curve stands for it",
            "MeanFreePathColor under 0.009 is clamped by the engine"}}};
}

Json cycles(const Exported& input) {
  const Rgb total = totals(input), d = burley_shape_mm(input);
  Rgb radius_mm{};
  for (int c = 0; c < 3; ++c)
    radius_mm[c] = 4 * pi * d[c] / profile::Burley::shape_all_angles_mm(total[c], optics::MeanFreePath(1));
  return {{"parameters",
           {{"Falloff", "Christensen-Burley"},
            {"Color", total},
            {"Scale", largest(radius_mm) / 1000},
            {"Radius", scaled(radius_mm, 1 / largest(radius_mm))},
            {"IOR", input.medium[0].eta}}},
          {"units",
           "Scale * Radius in scene units, here metres; Cycles divides by 4 pi and by s(A) = 1.9 - A + 3.5 "
           "(A - 0.8)^2"},
          {"lost",
           {"the profile's own shape: Burley's curve stands for it, cut at 16 d",
            "the random-walk methods read Radius otherwise"}}};
}

Rgb mean_free_paths_mm(const Exported& input) {
  Rgb mfp{};
  for (int c = 0; c < 3; ++c) mfp[c] = input.medium[c].mean_free_path().mm;
  return mfp;
}

Json openpbr(const Exported& input) {
  const Rgb mfp = mean_free_paths_mm(input);
  return {
      {"parameters",
       {{"subsurface_weight", 1},
        {"subsurface_color", totals(input)},
        {"subsurface_radius", largest(mfp) / 1000},
        {"subsurface_radius_scale", scaled(mfp, 1 / largest(mfp))},
        {"subsurface_scatter_anisotropy", 0},
        {"specular_ior", input.medium[0].eta}}},
      {"units",
       "subsurface_radius in scene units, here metres; the mean free path 1/sigma_t, not the diffuse one"},
      {"lost",
       {"layers: one homogeneous medium stands for them",
        "the albedo that a renderer derives from subsurface_color need not be ours",
        "g: scattering is exported as isotropic (similarity)"}}};
}

Json gltf(const Exported& input) {
  const Rgb mfp = mean_free_paths_mm(input);
  const double distance_mm = std::min({mfp[0], mfp[1], mfp[2]});  // keeps the colours well inside 0..1

  Rgb colour{};
  // sigma_t = -ln(colour) / distance
  for (int c = 0; c < 3; ++c) colour[c] = std::exp(-distance_mm / mfp[c]);

  return {
      {"parameters",
       {{"extensions",
         {{"KHR_materials_volume_scatter", {{"multiscatterColor", totals(input)}, {"scatterAnisotropy", 0}}},
          {"KHR_materials_volume",
           {{"attenuationColor", colour},
            {"attenuationDistance", distance_mm / 1000},
            {"thicknessFactor", 1}}},
          {"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 1}}},
          {"KHR_materials_ior", {{"ior", input.medium[0].eta}}}}}}},
      {"units",
       "attenuationDistance in metres; sigma_t = -ln(attenuationColor) / attenuationDistance, scattering "
       "included"},
      {"lost",
       {"the extension is a draft and may still change", "layers: one homogeneous medium stands for them",
        "the single-scattering albedo follows from multiscatterColor by the extension's own formula"}}};
}

/// Part of a 1-D Gaussian of variance v between a and b.
double between(double a, double b, double v) {
  return (std::erf(b / std::sqrt(2 * v)) - std::erf(a / std::sqrt(2 * v))) / 2;
}

Json separable(const Exported& input) {
  constexpr int samples = 25;  // the author's quality 2: offsets from -3 to 3, spaced by squares
  constexpr double range = 3;

  double widest = 0;
  for (const auto& terms : input.terms)
    for (const auto& [variance, weight] : terms)
      if (weight > 1e-3) widest = std::max(widest, variance);
  const double mm_per_offset = std::sqrt(widest);  // the kernel reaches three sigmas of the widest term

  std::vector<double> offsets;
  for (int i = 0; i < samples; ++i) {
    const double o = -range + 2 * range * i / (samples - 1);
    offsets.push_back((o < 0 ? -1 : 1) * o * o / range);
  }

  // Weighs each tap by the light between the midpoints to its neighbours.
  std::vector<std::array<double, 4>> kernel;
  Rgb sum{};
  for (int i = 0; i < samples; ++i) {
    const double low = i == 0 ? offsets[0] : (offsets[i - 1] + offsets[i]) / 2,
                 high = i + 1 == samples ? offsets[i] : (offsets[i] + offsets[i + 1]) / 2;
    std::array<double, 4> tap{0, 0, 0, offsets[i]};
    for (int c = 0; c < 3; ++c) {
      for (const auto& [variance, weight] : input.terms[c])
        tap[c] += weight * between(low * mm_per_offset, high * mm_per_offset, variance);
      sum[c] += tap[c];
    }
    kernel.push_back(tap);
  }

  for (auto& tap : kernel)
    for (int c = 0; c < 3; ++c) tap[c] /= sum[c];
  // the centre comes first
  std::rotate(kernel.begin(), kernel.begin() + samples / 2, kernel.begin() + samples / 2 + 1);

  return {{"parameters",
           {{"SSSS_N_SAMPLES", samples}, {"kernel", kernel}, {"sssWidth", 1.5 * mm_per_offset / 1000}}},
          {"units",
           "kernel: R, G, B, offset; sssWidth in world units, here metres: the shader puts offset o at 2/3 o "
           "sssWidth"},
          {"lost",
           {"a sum of Gaussians is not separable: taps are the exact 1-D marginals, right for straight edges "
            "along the axes, not for diagonals",
            "falloff and strength are not used: the kernel holds them",
            "light beyond three sigmas of the widest term is folded in by normalising"}}};
}

/// Loss of every system with a total and an index.
void lose(Json& lost, std::string_view system, const Exported& input) {
  if (system == "separable") return;  // a kernel holds neither
  const auto& medium = input.medium;
  if (medium[1].eta != medium[0].eta || medium[2].eta != medium[0].eta)
    lost.push_back(fmt::format(
        "indices that differ between channels ({:.6g}, {:.6g}, {:.6g}): the red one stands for all",
        medium[0].eta, medium[1].eta, medium[2].eta));
  Rgb total{};
  for (int c = 0; c < 3; ++c) total[c] = input.profiles[c]->total();
  if (system != "unity" && largest(total) > 1 + 1e-6)  // a conservative medium may round past 1
    lost.push_back(
        fmt::format("light: the total reflectance is cut to 1, the model gives {:.6g}, {:.6g}, {:.6g}",
                    total[0], total[1], total[2]));
}

}  // namespace

std::vector<std::string_view> exchange_names() { return {std::begin(names), std::end(names)}; }

std::string export_text(std::string_view system, const Exported& input) {
  using Make = Json (*)(const Exported&);
  constexpr Make makers[] = {separable, unity, unreal, gltf, openpbr, cycles};  // in the order of names
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (names[i] != system) continue;
    Json root{{"name", input.name}, {"system", names[i]}};
    root.update(makers[i](input));
    lose(root["lost"], system, input);
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }
  throw input_error("export", "{}", unknown_name(system, names));
}

}  // namespace dermis::gaussians
