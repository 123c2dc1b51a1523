// SPDX-License-Identifier: MIT
#include "tissue/optics/skin_colour.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <mutex>
#include <vector>

#include "base/core/error.h"
#include "base/core/parallel.h"
#include "base/settings/check.h"
#include "tissue/optics/key_values.h"
#include "tissue/optics/radiative.h"
#include "tissue/optics/skin_table.h"

namespace dermis::optics {
namespace {

/// Integrates every `stride`-th sample of the tables. Stride 1 serves to state a colour; stride 2 with 8
/// directions serves to compare skins (0.2 dE).
Rgb integrate(const SpectralSkin& skin, std::size_t stride) {
  const auto nm = wavelengths_nm();
  const auto weights = rec709_weights();
  std::vector<double> totals(nm.size());
  if (stride == 1) {
    parallel_for(nm.size(),
                 [&](std::size_t i) { totals[i] = adding_doubling(skin_layers(skin, nm[i])).reflectance; });
  } else {
    // Short, and called by threads of a search.
    for (std::size_t i = 0; i < nm.size(); i += stride)
      totals[i] = adding_doubling_coarse(skin_layers(skin, nm[i])).reflectance;
  }

  Rgb sum{}, white{};
  for (std::size_t i = 0; i < nm.size(); i += stride)
    for (int c = 0; c < 3; ++c) {
      sum[c] += weights[i][c] * totals[i];
      white[c] += weights[i][c];
    }
  for (int c = 0; c < 3; ++c) sum[c] /= white[c];
  return sum;
}

Lab lab_of(const SpectralSkin& skin, std::size_t stride) {
  Rgb linear = integrate(skin, stride);
  const double enters = entering_part();
  for (double& value : linear) value *= enters;
  return lab_from_linear(linear);
}

/// A point of the search, in logarithms of both fractions, whose equal steps look about equal.
struct Candidate {
  std::array<double, 2> log_fraction{};  // melanin, haemoglobin
  Lab lab;
};

constexpr std::array<double, 2> log_low{-12.2, -12.2};  // 5e-6, practically none
const std::array<double, 2> log_high{std::log(most_melanin), std::log(most_blood)};

Candidate evaluate(SpectralSkin skin, std::array<double, 2> log_fraction, std::size_t stride) {
  for (int i = 0; i < 2; ++i) log_fraction[i] = std::clamp(log_fraction[i], log_low[i], log_high[i]);
  skin.melanin = std::exp(log_fraction[0]);
  skin.haemoglobin = std::exp(log_fraction[1]);
  return {log_fraction, lab_of(skin, stride)};
}

constexpr std::size_t grid_columns = 10, grid_rows = 7;

/// Returns 70 skins over the range to start from. Keeps the grid of the last fixed parameters, because
/// colours often come in series.
std::vector<Candidate> coarse_grid(const SpectralSkin& fixed) {
  static std::mutex mutex;
  static std::vector<Candidate> grid;
  static std::array<double, 3> made_for{};

  const std::array<double, 3> key{fixed.blend, fixed.oxygenation, fixed.epidermis_mm};
  const std::lock_guard lock(mutex);
  if (!grid.empty() && made_for == key) return grid;

  // The kept grid stays whole if the caller ends the work.
  std::vector<Candidate> made(grid_columns * grid_rows);
  parallel_for(made.size(), [&](std::size_t i) {
    const std::size_t column = i % grid_columns, row = i / grid_columns;
    const double m = static_cast<double>(column) / (grid_columns - 1),
                 h = static_cast<double>(row) / (grid_rows - 1);
    made[i] = evaluate(fixed,
                       {std::log(least_melanin) + m * std::log(most_melanin / least_melanin),
                        std::log(least_blood) + h * std::log(most_blood / least_blood)},
                       4);
  });

  grid = std::move(made);
  made_for = key;
  return grid;
}

/// Returns one damped Gauss-Newton step of the distance in L*a*b*, with slopes by finite differences.
std::array<double, 2> newton_step(const Lab& wanted, const SpectralSkin& fixed, const Candidate& here,
                                  double damping) {
  constexpr double h = 0.02;
  std::array<std::array<double, 3>, 2> slope{};
  for (int i = 0; i < 2; ++i) {
    std::array<double, 2> at = here.log_fraction;
    const double side = at[i] + h > log_high[i] ? -h : h;
    at[i] += side;
    const Lab there = evaluate(fixed, at, 2).lab;
    slope[i] = {(there.l - here.lab.l) / side, (there.a - here.lab.a) / side, (there.b - here.lab.b) / side};
  }

  const std::array<double, 3> off{wanted.l - here.lab.l, wanted.a - here.lab.a, wanted.b - here.lab.b};
  const auto dot = [](const auto& x, const auto& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
  // Normal equations of two unknowns, by Cramer's rule.
  const double a = dot(slope[0], slope[0]) * (1 + damping) + 1e-9, b = dot(slope[0], slope[1]),
               d = dot(slope[1], slope[1]) * (1 + damping) + 1e-9;
  const double p = dot(slope[0], off), q = dot(slope[1], off), determinant = a * d - b * b;
  return {std::clamp((d * p - b * q) / determinant, -1.0, 1.0),
          std::clamp((a * q - b * p) / determinant, -1.0, 1.0)};
}

/// Takes damped steps until the distance hardly falls.
Candidate descend(const Lab& wanted, const SpectralSkin& fixed, Candidate here) {
  double damping = 1e-3;
  for (int step = 0; step < 30 && damping < 1e3; ++step) {
    const auto change = newton_step(wanted, fixed, here, damping);
    const Candidate there =
        evaluate(fixed, {here.log_fraction[0] + change[0], here.log_fraction[1] + change[1]}, 2);
    const double before = delta_e76(here.lab, wanted), after = delta_e76(there.lab, wanted);
    if (after < before) here = there;
    damping = after < before ? damping / 4 : damping * 8;
    if (after < before && (before - after < 1e-3 || after < 1e-3)) break;
  }
  return here;
}

/// Returns the three nearest points of the grid of which no two are neighbours. Different skins can have the
/// same colour (yellow through little blood, or through much melanin), so the nearest point may lead to a
/// local minimum.
std::vector<Candidate> starts(std::vector<Candidate> grid, const Lab& wanted) {
  const auto apart = [](const Candidate& a, const Candidate& b) {
    const double melanin = std::log(most_melanin / least_melanin) / (grid_columns - 1),
                 blood = std::log(most_blood / least_blood) / (grid_rows - 1);
    return std::abs(a.log_fraction[0] - b.log_fraction[0]) > 1.5 * melanin ||
           std::abs(a.log_fraction[1] - b.log_fraction[1]) > 1.5 * blood;
  };
  std::sort(grid.begin(), grid.end(), [&](const Candidate& a, const Candidate& b) {
    return delta_e76(a.lab, wanted) < delta_e76(b.lab, wanted);
  });
  std::vector<Candidate> chosen;
  for (const Candidate& point : grid) {
    if (chosen.size() == 3) break;
    if (std::all_of(chosen.begin(), chosen.end(),
                    [&](const Candidate& other) { return apart(point, other); }))
      chosen.push_back(point);
  }
  return chosen;
}

}  // namespace

Rgb skin_reflectance(const SpectralSkin& skin) { return integrate(skin, 1); }

Rgb skin_colour(const SpectralSkin& skin) {
  Rgb linear = skin_reflectance(skin);
  const double enters = entering_part();
  for (double& value : linear) value *= enters;
  return linear;
}

SpectralSkin measured_skin() { return {.blend = 0.1, .epidermis_mm = 0.12}; }

SkinMatch nearest_skin(const Lab& wanted, const SpectralSkin& fixed) {
  check_ranges(fixed, "skin");
  std::vector<Candidate> ends = starts(coarse_grid(fixed), wanted);
  parallel_for(ends.size(), [&](std::size_t i) {
    ends[i] = descend(wanted, fixed, evaluate(fixed, ends[i].log_fraction, 2));
  });
  const Candidate here =
      *std::min_element(ends.begin(), ends.end(), [&](const Candidate& a, const Candidate& b) {
        return delta_e76(a.lab, wanted) < delta_e76(b.lab, wanted);
      });
  SkinMatch match{.skin = fixed, .lab = {}};
  match.skin.melanin = std::min(std::exp(here.log_fraction[0]), most_melanin);
  match.skin.haemoglobin = std::min(std::exp(here.log_fraction[1]), most_blood);
  match.lab = lab_of(match.skin, 1);
  match.delta_e = delta_e76(match.lab, wanted);
  return match;
}

Lab parse_colour(const std::string& text, const std::string& where) {
  const auto expected = [&] {
    return input_error(where, "expected #rrggbb (sRGB) or L,a,b (CIELAB), got '{}'", text);
  };

  if (!text.empty() && text[0] == '#') {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
    if (text.size() != 7 || error != std::errc() || end != text.data() + text.size()) throw expected();

    Rgb linear{};
    for (int c = 0; c < 3; ++c) {
      const double display = ((value >> (16 - 8 * c)) & 255) / 255.0;
      // IEC 61966-2-1
      linear[c] = display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);
    }
    return lab_from_linear(linear);
  }

  if (text.find(',') == std::string::npos || text.find_first_of(" =") != std::string::npos) throw expected();
  const Rgb lab = parse_key_values("lab=" + text, {"lab"}, where).at("lab");
  if (!(lab[0] >= 0 && lab[0] <= 100) || !(std::abs(lab[1]) <= 200 && std::abs(lab[2]) <= 200))
    throw input_error(where, "L must be 0 to 100, a and b -200 to 200, got '{}'", text);
  return {lab[0], lab[1], lab[2]};
}

}  // namespace dermis::optics
