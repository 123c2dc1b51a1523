// SPDX-License-Identifier: MIT
#include "tissue/profile/burley.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/core/error.h"
#include "tissue/optics/key_values.h"

namespace dermis::profile {

using std::numbers::pi;

Burley::Burley(double total_reflectance, double shape_mm, const std::string& where)
    : total_(total_reflectance), shape_mm_(shape_mm) {
  if (!(total_ >= 0 && total_ <= 1)) throw input_error(where, "reflectance must be 0 to 1, got {}", total_);
  if (!(shape_mm_ >= 1e-6 && shape_mm_ <= 1e6))
    throw input_error(where, "the length must give a shape d of 1e-6 to 1e6 mm, got a d of {} mm", shape_mm_);
}

double Burley::shape_mm(double a, optics::MeanFreePath length) {
  return length.mm / (1.85 - a + 7 * std::pow(std::abs(a - 0.8), 3));
}
double Burley::shape_mm(double a, optics::DiffuseMeanFreePath length) {
  return length.mm / (3.5 + 100 * std::pow(a - 0.33, 4));
}
double Burley::shape_all_angles_mm(double a, optics::MeanFreePath length) {
  return length.mm / (1.9 - a + 3.5 * (a - 0.8) * (a - 0.8));
}

double Burley::at(double radius_mm) const {
  const double t = radius_mm / shape_mm_;
  return total_ * (std::exp(-t) + std::exp(-t / 3)) / (8 * pi * shape_mm_ * radius_mm);
}

double Burley::hankel(double k_per_mm) const {
  // R^(k) = A/4 [ 1/sqrt(1 + (k d)^2) + 3/sqrt(1 + (3 k d)^2) ].
  const double kd = k_per_mm * shape_mm_;
  return total_ / 4 * (1 / std::hypot(1, kd) + 3 / std::hypot(1, 3 * kd));
}

double Burley::within(double radius_mm) const {
  const double t = radius_mm / shape_mm_;
  return total_ * (1 - std::exp(-t) / 4 - 3 * std::exp(-t / 3) / 4);
}

double Burley::quantile(double p) const {
  if (p <= 0) return 0;
  if (p >= 1) return std::numeric_limits<double>::infinity();
  // within(r) = p A is the cubic y^3 + 3 y = 4 u in y = e^{-r/(3d)}, with u = 1 - p. By Cardano y = z - 1/z,
  // z^3 = 2 u + sqrt(1 + 4 u^2). Here G = z^6, and 1/y = (y^2 + 3) / (4 u) = (1 + z^2 + z^-2) / (4 u).
  const double u = 1 - p;
  const double cube_root = std::cbrt(1 + 4 * u * (2 * u + std::sqrt(1 + 4 * u * u)));
  return 3 * shape_mm_ * std::log((1 + 1 / cube_root + cube_root) / (4 * u));
}

BurleyDescription parse_burley(const std::string& text, const std::string& where) {
  const auto values = optics::parse_key_values(text, {"reflectance", "mfp_mm", "dmfp_mm", "shape_mm"}, where);
  if (!values.contains("reflectance")) throw input_error(where, "'reflectance' is missing");
  if (values.size() != 2) throw input_error(where, "give exactly one length: mfp_mm, dmfp_mm or shape_mm");

  const char* key = values.contains("mfp_mm")    ? "mfp_mm"
                    : values.contains("dmfp_mm") ? "dmfp_mm"
                                                 : "shape_mm";
  BurleyDescription out{.total_reflectance = values.at("reflectance"), .shape_mm = {}};

  for (int c = 0; c < 3; ++c) {
    const double a = out.total_reflectance[c];
    if (!(a > 0 && a <= 1)) throw input_error(where, "reflectance must be above 0 and at most 1, got {}", a);
    const double length_mm = values.at(key)[c];
    if (!(length_mm > 0)) throw input_error(where, "{} must be above 0, got {}", key, length_mm);

    if (values.contains("mfp_mm"))
      out.shape_mm[c] = Burley::shape_mm(a, optics::MeanFreePath(length_mm));
    else if (values.contains("dmfp_mm"))
      out.shape_mm[c] = Burley::shape_mm(a, optics::DiffuseMeanFreePath(length_mm));
    else
      out.shape_mm[c] = length_mm;
    Burley(a, out.shape_mm[c], where);  // checks the length
  }

  return out;
}

}  // namespace dermis::profile
