// SPDX-License-Identifier: MIT
#include "tissue/optics/observer.h"

#include <cmath>
#include <vector>

namespace dermis::optics {
namespace {

struct ObserverRow {
  double nm, x, y, z, d65;
};
constexpr ObserverRow rows[] = {
#include "tissue/optics/observer.inc"
};

// IEC 61966-2-1: linear Rec.709 from XYZ, and back.
constexpr double to_linear[3][3] = {{3.2406255, -1.5372080, -0.4986286},
                                    {-0.9689307, 1.8757561, 0.0415175},
                                    {0.0557101, -0.2040211, 1.0569959}};
constexpr double from_linear[3][3] = {
    {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};

struct Tables {
  std::vector<double> nm;
  std::vector<Rgb> weights;
};

const Tables& tables() {
  static const Tables made = [] {
    Tables t;
    Rgb white{};

    for (const ObserverRow& row : rows) {
      t.nm.push_back(row.nm);
      Rgb weight{};
      for (int c = 0; c < 3; ++c) {
        weight[c] = row.d65 * (to_linear[c][0] * row.x + to_linear[c][1] * row.y + to_linear[c][2] * row.z);
        white[c] += weight[c];
      }
      t.weights.push_back(weight);
    }

    // The matrix is printed for a rounded white. Division by the white of the tables makes a white surface
    // white.
    for (Rgb& weight : t.weights)
      for (int c = 0; c < 3; ++c) weight[c] /= white[c];
    return t;
  }();
  return made;
}

Xyz white_xyz() { return xyz_from_linear({1, 1, 1}); }

/// CIE 015 sec. 8: f(t) = t^(1/3) above (6/29)^3, else t / (3 (6/29)^2) + 4/29.
double lab_curve(double t) {
  constexpr double d = 6.0 / 29;
  return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
}
double lab_curve_inverse(double f) {
  constexpr double d = 6.0 / 29;
  return f > d ? f * f * f : 3 * d * d * (f - 4.0 / 29);
}

}  // namespace

std::span<const double> wavelengths_nm() { return tables().nm; }
std::span<const Rgb> rec709_weights() { return tables().weights; }

Xyz xyz_from_linear(const Rgb& linear) {
  Xyz xyz{};
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 3; ++c) xyz[i] += from_linear[i][c] * linear[c];
  return xyz;
}

Lab lab_from_linear(const Rgb& linear) {
  const Xyz xyz = xyz_from_linear(linear), white = white_xyz();
  const double fx = lab_curve(xyz[0] / white[0]), fy = lab_curve(xyz[1] / white[1]),
               fz = lab_curve(xyz[2] / white[2]);
  // L* = 116 f(Y/Yn) - 16, a* = 500 (f(X/Xn) - f(Y/Yn)), b* = 200 (f(Y/Yn) - f(Z/Zn)).
  return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Rgb linear_from_lab(const Lab& lab) {
  const Xyz white = white_xyz();
  const double fy = (lab.l + 16) / 116;
  const Xyz xyz{white[0] * lab_curve_inverse(fy + lab.a / 500), white[1] * lab_curve_inverse(fy),
                white[2] * lab_curve_inverse(fy - lab.b / 200)};
  Rgb linear{};
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) linear[c] += to_linear[c][i] * xyz[i];
  return linear;
}

double delta_e76(const Lab& a, const Lab& b) {
  return std::sqrt((a.l - b.l) * (a.l - b.l) + (a.a - b.a) * (a.a - b.a) + (a.b - b.b) * (a.b - b.b));
}

}  // namespace dermis::optics
