// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "base/core/one_line.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/optics/inversion.h"
#include "tissue/optics/key_values.h"
#include "tissue/profile/burley.h"

namespace dermis::gaussians {
namespace {

using optics::Rgb;
using Values = std::map<std::string, Rgb>;
using profile::Burley;

const Rgb& need(const Values& values, const char* key, const std::string& where) {
  const auto found = values.find(key);
  if (found == values.end()) throw input_error(where, "'{}' is missing", key);
  return found->second;
}

Rgb product(const Rgb& a, const Rgb& b, double factor = 1) {
  return {a[0] * b[0] * factor, a[1] * b[1] * factor, a[2] * b[2] * factor};
}
Rgb single(double value) { return {value, value, value}; }

std::string shown(const Rgb& mm) { return fmt::format("{:.4g},{:.4g},{:.4g} mm", mm[0], mm[1], mm[2]); }

void check_reflectance(const Rgb& total, const std::string& where) {
  for (const double value : total)
    if (!(value > 0 && value <= 1))
      throw input_error(where, "reflectance must be above 0 and at most 1, got {}", value);
}

Imported burley_of(const char* name, const Rgb& total, const Rgb& shape_mm, const std::string& where) {
  check_reflectance(total, where);
  for (int c = 0; c < 3; ++c) Burley(total[c], shape_mm[c], where);  // checks the length
  return {
      .name = name, .total_reflectance = total, .burley_shape_mm = shape_mm, .medium = {}, .is_burley = true};
}

Imported medium_of(const char* name, const Rgb& total, const Rgb& mfp_mm, double eta,
                   const std::string& where) {
  check_reflectance(total, where);
  Imported imported{
      .name = name, .total_reflectance = total, .burley_shape_mm = {}, .medium = {}, .is_burley = false};
  for (int c = 0; c < 3; ++c)
    imported.medium[c] =
        optics::medium_from_reflectance(total[c], optics::MeanFreePath(mfp_mm[c]), eta, where);
  return imported;
}

/// A value that the system has once, not per channel.
double one_value(const Values& values, const char* key, const std::string& where) {
  const Rgb& v = values.at(key);
  if (v[1] != v[0] || v[2] != v[0])
    throw input_error(where, "{} is one number for all channels, got {},{},{}", key, v[0], v[1], v[2]);
  return v[0];
}

void check_lengths(const Rgb& mm, const char* what, const std::string& where) {
  for (const double length_mm : mm)
    if (!(length_mm > 0)) throw input_error(where, "{} must be above 0, got {} mm", what, length_mm);
}

/// The size of a scene unit in mm, without which a length in scene units means nothing.
double scene_unit_mm(const Values& values, const Rgb& lengths, const std::string& where) {
  const auto found = values.find("scene_unit_mm");
  if (found == values.end())
    throw input_error(where,
                      "the length is in scene units, whose size is not given: as metres it is {}, as "
                      "centimetres {}, as millimetres {}; "
                      "add scene_unit_mm=1000, 10 or 1",
                      shown(product(lengths, single(1000))), shown(product(lengths, single(10))),
                      shown(lengths));
  return one_value(values, "scene_unit_mm", where);
}

Imported unity(const std::string& text, const std::string& where) {
  const Values v =
      optics::parse_key_values(text, {"reflectance", "scattering_distance", "multiplier"}, where);
  // Always mm: the asset's world scale tells the renderer how large a unit is.
  const Rgb shape = product(need(v, "scattering_distance", where),
                            v.contains("multiplier") ? v.at("multiplier") : single(1));
  return burley_of("unity", need(v, "reflectance", where), shape, where);
}

Imported unreal(const std::string& text, const std::string& where) {
  const Values v = optics::parse_key_values(
      text, {"surface_albedo", "mean_free_path_color", "mean_free_path_distance", "enable_mean_free_path"},
      where);

  const Rgb& total = need(v, "surface_albedo", where);
  check_reflectance(total, where);
  // from cm
  const Rgb length_mm =
      product(need(v, "mean_free_path_color", where), need(v, "mean_free_path_distance", where), 10);
  check_lengths(length_mm, "mean_free_path_color * mean_free_path_distance", where);

  Rgb as_mean{}, as_diffuse{};
  for (int c = 0; c < 3; ++c) {
    // the engine's own factor
    as_mean[c] = Burley::shape_mm(total[c], optics::MeanFreePath(length_mm[c] / 0.6));
    as_diffuse[c] = Burley::shape_mm(total[c], optics::DiffuseMeanFreePath(length_mm[c]));
  }

  if (!v.contains("enable_mean_free_path"))
    throw input_error(where,
                      "mean_free_path_distance has two readings: with bEnableMeanFreePath a mean free path "
                      "(Burley's d {}), without it, as "
                      "before 5.1, a diffuse one (d {}); add enable_mean_free_path=1 or 0",
                      shown(as_mean), shown(as_diffuse));

  const double mean = one_value(v, "enable_mean_free_path", where);
  if (mean != 0 && mean != 1) throw input_error(where, "enable_mean_free_path must be 0 or 1, got {}", mean);
  return burley_of("unreal", total, mean == 1 ? as_mean : as_diffuse, where);
}

Imported cycles(const std::string& text, const std::string& where) {
  const Values v = optics::parse_key_values(text, {"color", "radius", "scale", "scene_unit_mm"}, where);
  const Rgb& total = need(v, "color", where);
  check_reflectance(total, where);
  Rgb radius = product(need(v, "radius", where), v.contains("scale") ? v.at("scale") : single(1));
  radius = product(radius, single(scene_unit_mm(v, radius, where)));
  check_lengths(radius, "radius * scale", where);
  Rgb shape{};
  for (int c = 0; c < 3; ++c)
    shape[c] =
        Burley::shape_all_angles_mm(total[c], optics::MeanFreePath(radius[c] / (4 * std::numbers::pi)));
  return burley_of("cycles", total, shape, where);
}

Imported openpbr(const std::string& text, const std::string& where) {
  const Values v = optics::parse_key_values(
      text,
      {"subsurface_color", "subsurface_radius", "subsurface_radius_scale", "specular_ior", "scene_unit_mm"},
      where);
  const Rgb radius =
      product(need(v, "subsurface_radius", where),
              v.contains("subsurface_radius_scale") ? v.at("subsurface_radius_scale") : Rgb{1, 0.5, 0.25});
  const Rgb mfp_mm = product(radius, single(scene_unit_mm(v, radius, where)));
  return medium_of("openpbr", need(v, "subsurface_color", where), mfp_mm,
                   v.contains("specular_ior") ? one_value(v, "specular_ior", where) : 1.5, where);
}

Imported gltf(const std::string& text, const std::string& where) {
  const Values v = optics::parse_key_values(
      text, {"multiscatter_color", "attenuation_color", "attenuation_distance", "ior"}, where);
  const Rgb &colour = need(v, "attenuation_color", where),
            &distance_m = need(v, "attenuation_distance", where);
  Rgb mfp_mm{};
  for (int c = 0; c < 3; ++c) {
    if (!(colour[c] > 0 && colour[c] < 1))
      throw input_error(where, "attenuation_color must be above 0 and below 1, got {}", colour[c]);
    mfp_mm[c] = 1000 * distance_m[c] / -std::log(colour[c]);
  }
  return medium_of("gltf", need(v, "multiscatter_color", where), mfp_mm,
                   v.contains("ior") ? one_value(v, "ior", where) : 1.5, where);
}

[[noreturn]] void no_system(const std::string& text, const std::string& where) {
  throw input_error(
      where,
      "'{}' names no system. A bare radius could be a mean free path, a diffuse mean free path or Burley's "
      "d, in mm, cm or scene units. "
      "Start with a system ({}), or describe normalised diffusion with mfp_mm, dmfp_mm or shape_mm",
      text, listed_names(text.substr(0, text.find(' ')), exchange_names()));
}

Imported parse(const std::string& text, const std::string& where) {
  const std::size_t space = text.find(' ');
  const std::string system = text.substr(0, space),
                    rest = space == std::string::npos ? "" : text.substr(space + 1);
  const std::string place = where + " " + system;
  if (system == "unity") return unity(rest, place);
  if (system == "unreal") return unreal(rest, place);
  if (system == "cycles") return cycles(rest, place);
  if (system == "openpbr") return openpbr(rest, place);
  if (system == "gltf") return gltf(rest, place);
  if (system == "separable")
    throw input_error(
        place,
        "sssWidth, falloff and strength do not say a profile: the width is in world units of unknown size, "
        "and strength mixes in unblurred light. Import the kernel's profile as a table of r_mm,R,G,B");
  no_system(text, where);
}

}  // namespace

Imported parse_import(const std::string& text, const std::string& where) {
  return with_one_line_errors([&] { return parse(text, where); });
}

}  // namespace dermis::gaussians
