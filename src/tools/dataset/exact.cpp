// SPDX-License-Identifier: MIT
#include "tools/dataset/exact.h"

#include <array>
#include <cmath>

namespace dermis::dataset {
namespace {

constexpr double ln2 = 0.693147180559945309417;

template <std::size_t n>
double polynomial(const std::array<double, n>& c, double x) {
  double sum = c[0];
  for (std::size_t i = 1; i < n; ++i) sum = sum * x + c[i];
  return sum;
}

}  // namespace

double exact_log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // 0.5 to 1
  if (m < 0.70710678118654752) m *= 2, --exponent;
  const double y = (m - 1) / (m + 1), y2 = y * y;  // |y| < 0.172
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * y2 + 1.0 / k;
  return 2 * y * sum + exponent * ln2;
}

double exact_exp(double x) {
  const double whole = std::floor(x / ln2 + 0.5), rest = x - whole * ln2;  // |rest| < 0.35
  double sum = 1;
  for (int k = 16; k >= 1; --k) sum = 1 + rest / k * sum;
  return std::ldexp(sum, static_cast<int>(whole));
}

double normal_quantile(double p) {
  constexpr std::array a{-3.969683028665376e+01, 2.209460984245205e+02,  -2.759285104469687e+02,
                         1.383577518672690e+02,  -3.066479806614716e+01, 2.506628277459239e+00};
  constexpr std::array b{-5.447609879822406e+01, 1.615858368580409e+02,  -1.556989798598866e+02,
                         6.680131188771972e+01,  -1.328068155288572e+01, 1.0};
  constexpr std::array c{-7.784894002430293e-03, -3.223964580411365e-01, -2.400758277161838e+00,
                         -2.549732539343734e+00, 4.374664141464968e+00,  2.938163982698783e+00};
  constexpr std::array d{7.784695709041462e-03, 3.224671290700398e-01, 2.445134137142996e+00,
                         3.754408661907416e+00, 1.0};
  constexpr double tail = 0.02425;
  if (p < tail || p > 1 - tail) {
    const double q = std::sqrt(-2 * exact_log(p < tail ? p : 1 - p)), z = polynomial(c, q) / polynomial(d, q);
    return p < tail ? z : -z;
  }
  const double q = p - 0.5, r = q * q;
  return polynomial(a, r) * q / polynomial(b, r);
}

}  // namespace dermis::dataset
