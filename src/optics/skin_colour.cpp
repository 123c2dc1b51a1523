// SPDX-License-Identifier: MIT
#include "optics/skin_colour.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "optics/key_values.h"
#include "optics/radiative.h"

namespace dermis::optics {
namespace {

constexpr double least_melanin = 5e-4, most_melanin = 0.5, least_blood = 5e-4, most_blood = 0.1;

/// Every `stride`-th sample of the tables: 2, with 8 directions, is enough to compare skins (0.2 dE), 1 to state a colour.
Rgb integrate(const Skin& skin, std::size_t stride) {
  const auto nm = wavelengths_nm();
  const auto weights = rec709_weights();
  Rgb sum{}, white{};
  for (std::size_t i = 0; i < nm.size(); i += stride) {
    const Layers layers = skin_layers(skin, nm[i]);
    const double total = (stride == 1 ? adding_doubling(layers) : adding_doubling_coarse(layers)).reflectance;
    for (int c = 0; c < 3; ++c) sum[c] += weights[i][c] * total, white[c] += weights[i][c];
  }
  for (int c = 0; c < 3; ++c) sum[c] /= white[c];
  return sum;
}

Lab lab_of(const Skin& skin, std::size_t stride) {
  Rgb linear = integrate(skin, stride);
  const double enters = entering_part(skin);
  for (double& value : linear) value *= enters;
  return lab_from_linear(linear);
}

struct Candidate {
  double log_melanin, log_blood, delta_e;
};

double distance(const Lab& wanted, Skin skin, double log_melanin, double log_blood, std::size_t stride) {
  skin.melanin = std::exp(log_melanin);
  skin.haemoglobin = std::exp(log_blood);
  return delta_e76(lab_of(skin, stride), wanted);
}

Candidate coarse_best(const Lab& wanted, const Skin& fixed) {
  constexpr int columns = 10, rows = 7;
  std::vector<Candidate> grid(columns * rows);
  parallel_for(grid.size(), [&](std::size_t i) {
    const double m = static_cast<double>(i % columns) / (columns - 1), h = static_cast<double>(i / columns) / (rows - 1);
    Candidate& one = grid[i];
    one.log_melanin = std::log(least_melanin) + m * std::log(most_melanin / least_melanin);
    one.log_blood = std::log(least_blood) + h * std::log(most_blood / least_blood);
    one.delta_e = distance(wanted, fixed, one.log_melanin, one.log_blood, 4);
  });
  return *std::min_element(grid.begin(), grid.end(), [](const Candidate& a, const Candidate& b) { return a.delta_e < b.delta_e; });
}

}  // namespace

Rgb skin_reflectance(const Skin& skin) { return integrate(skin, 1); }

Rgb skin_colour(const Skin& skin) {
  Rgb linear = skin_reflectance(skin);
  const double enters = entering_part(skin);
  for (double& value : linear) value *= enters;
  return linear;
}

Skin measured_skin() { return {.blend = 0.1, .epidermis_mm = 0.12}; }

SkinMatch nearest_skin(const Lab& wanted, const Skin& fixed) {
  check(fixed, "skin");
  Candidate best = coarse_best(wanted, fixed);
  best.delta_e = distance(wanted, fixed, best.log_melanin, best.log_blood, 2);
  for (double step = 0.4; step > 0.01;) {  // pattern search: eight neighbours, half the step when none is nearer
    std::vector<Candidate> around(8);
    parallel_for(8, [&](std::size_t i) {
      constexpr int dx[] = {1, -1, 0, 0, 1, 1, -1, -1}, dy[] = {0, 0, 1, -1, 1, -1, 1, -1};
      Candidate& one = around[i];
      one.log_melanin = std::clamp(best.log_melanin + step * dx[i], std::log(least_melanin / 50), std::log(most_melanin));
      one.log_blood = std::clamp(best.log_blood + step * dy[i], std::log(least_blood / 50), std::log(most_blood));
      one.delta_e = distance(wanted, fixed, one.log_melanin, one.log_blood, 2);
    });
    const auto nearest =
        std::min_element(around.begin(), around.end(), [](const Candidate& a, const Candidate& b) { return a.delta_e < b.delta_e; });
    if (nearest->delta_e < best.delta_e)
      best = *nearest;
    else
      step /= 2;
  }
  SkinMatch match{.skin = fixed, .lab = {}};
  match.skin.melanin = std::min(std::exp(best.log_melanin), most_melanin);
  match.skin.haemoglobin = std::min(std::exp(best.log_blood), most_blood);
  match.lab = lab_of(match.skin, 1);
  match.delta_e = delta_e76(match.lab, wanted);
  return match;
}

Lab parse_colour(const std::string& text, const std::string& where) {
  const auto expected = [&] { return input_error(where, "expected #rrggbb (sRGB) or L,a,b (CIELAB), got '{}'", text); };
  if (!text.empty() && text[0] == '#') {
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
    if (text.size() != 7 || error != std::errc() || end != text.data() + text.size()) throw expected();
    Rgb linear{};
    for (int c = 0; c < 3; ++c) {
      const double display = ((value >> (16 - 8 * c)) & 255) / 255.0;
      linear[c] = display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);  // IEC 61966-2-1
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
