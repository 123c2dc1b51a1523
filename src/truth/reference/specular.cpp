// SPDX-License-Identifier: MIT
#include "truth/reference/specular.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/optics/directional_albedo.h"
#include "truth/reference/axes.h"

namespace dermis::reference {
namespace {

using optics::directional_albedo_columns;
using optics::directional_albedo_min_m;
using optics::directional_albedo_rows;

/// Returns Beckmann's distribution without 1/pi: exp(-tan^2 / m^2) / (m^2 cos^4).
double beckmann(double n_h, double m) {
  const double c2 = std::max(n_h * n_h, 1e-6);
  return std::exp(-(1 - c2) / (c2 * m * m)) / (m * m * c2 * c2);
}

/// D F G / (4 n.l n.v) with Schlick's Fresnel, and G by Smith, correlated by height: [Hei14] eq. 99.
double specular_lobe(const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l, double m, double f0) {
  const glm::dvec3 h_raw = l + v;
  const double h2 = glm::dot(h_raw, h_raw);
  if (h2 < 1e-8) return 0;
  const glm::dvec3 h = h_raw / std::sqrt(h2);
  const double x = std::pow(std::clamp(1 - glm::dot(v, h), 0.0, 1.0), 5);
  const double n_v = std::max(glm::dot(n, v), 1e-4), n_l = std::max(glm::dot(n, l), 1e-4);
  const double masked = n_l * n_v + n_l * optics::cosine_lambda(n_v, m) + n_v * optics::cosine_lambda(n_l, m);
  return beckmann(std::max(glm::dot(n, h), 0.0), m) * (f0 + (1 - f0) * x) / (4 * masked);
}

/// Returns the probability of the first lobe.
double share_of_first(const SkinSpecular& s) {
  const double sum = s.weight[0] + s.weight[1];
  return sum > 0 ? s.weight[0] / sum : 1;
}

}  // namespace

double specular_brdf(const SkinSpecular& s, const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l) {
  return s.rho_s * (s.weight[0] * specular_lobe(n, v, l, s.m[0], s.f0) +
                    s.weight[1] * specular_lobe(n, v, l, s.m[1], s.f0));
}

glm::dvec3 lobe_drawn(const SkinSpecular& s, const glm::dvec3& n, const glm::dvec3& v, Random& random) {
  const double m = random.next() < share_of_first(s) ? s.m[0] : s.m[1];
  const double tan2 = -m * m * std::log(random.next());
  const glm::dvec3 h = around(n, 1 / std::sqrt(1 + tan2), 2 * std::numbers::pi * random.next());
  return glm::normalize(2 * glm::dot(v, h) * h - v);
}

double lobe_density(const SkinSpecular& s, const glm::dvec3& n, const glm::dvec3& v, const glm::dvec3& l) {
  const glm::dvec3 h_raw = l + v;
  const double length = glm::length(h_raw);
  if (length < 1e-6) return 0;
  const double n_h = glm::dot(n, h_raw) / length, v_h = glm::dot(v, h_raw) / length;
  if (n_h <= 0 || v_h <= 0) return 0;
  const double first = share_of_first(s);
  const double normals =
      (first * beckmann(n_h, s.m[0]) + (1 - first) * beckmann(n_h, s.m[1])) / std::numbers::pi;
  return normals * n_h / (4 * v_h);
}

ReflectanceTable::ReflectanceTable() : table_(optics::directional_albedo_table()) {}

double ReflectanceTable::lookup(const SkinSpecular& s, double column) const {
  const auto c0 = static_cast<std::size_t>(column);
  const double cx = column - static_cast<double>(c0);

  double sum = 0;
  for (std::size_t lobe = 0; lobe < 2; ++lobe) {
    if (s.weight[lobe] == 0) continue;
    const double row =
        std::clamp((s.m[lobe] - directional_albedo_min_m) / (1 - directional_albedo_min_m), 0.0, 1.0) *
        (directional_albedo_rows - 1);
    const auto r0 = static_cast<std::size_t>(row);
    const double ry = row - static_cast<double>(r0);
    const std::size_t r1 = std::min<std::size_t>(r0 + 1, directional_albedo_rows - 1);

    // Each entry begins with a factor of F0 and an addend.
    const auto rho = [&](std::size_t r, std::size_t c) {
      const std::size_t i = optics::directional_albedo_channels * (r * (directional_albedo_columns + 2) + c);
      return s.f0 * table_[i] + table_[i + 1];
    };
    const auto along = [&](std::size_t r) {
      return (1 - cx) * rho(r, c0) + (cx > 0 ? cx * rho(r, c0 + 1) : 0);
    };
    sum += s.weight[lobe] * ((1 - ry) * along(r0) + ry * along(r1));
  }

  return std::min(s.rho_s * sum, 0.9);
}

double ReflectanceTable::at(const SkinSpecular& s, double cosine) const {
  return s.rho_s == 0 ? 0 : lookup(s, std::clamp(cosine, 0.0, 1.0) * (directional_albedo_columns - 1));
}

double ReflectanceTable::mean(const SkinSpecular& s) const {
  return s.rho_s == 0 ? 0 : lookup(s, directional_albedo_columns);
}

}  // namespace dermis::reference
