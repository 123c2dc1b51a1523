// SPDX-License-Identifier: MIT
#include "tissue/optics/media.h"

#include <cmath>
#include <map>

#include "base/core/channels.h"
#include "base/core/error.h"
#include "base/settings/check.h"
#include "base/settings/profile_fields.h"
#include "tissue/optics/key_values.h"

namespace dermis::optics {

double Medium::sigma_tr_per_mm() const {
  // the root of -0 is -0, whose inverse is -inf
  return std::sqrt(3 * std::abs(sigma_a_per_mm) * sigma_t_reduced_per_mm());
}

void check(const Medium& medium, const std::string& where) {
  check_member(&Coefficients::sigma_a_per_mm, medium.sigma_a_per_mm, where);
  check_member(&Coefficients::sigma_s_per_mm, medium.sigma_s_per_mm, where);
  check_member(&Coefficients::g, medium.g, where);
  check_member(&Coefficients::eta, medium.eta, where);
  if (!(medium.sigma_t_reduced_per_mm() > 0))
    throw input_error(where, "sigma_a and sigma_s are both 0: light would pass without a trace");
}

void check(const RgbMedium& medium, const std::string& where) {
  for (std::size_t c = 0; c < 3; ++c) check(medium[c], where + ": " + channel_names[c]);
}

RgbMedium rgb_medium(const Coefficients& coefficients) {
  RgbMedium medium;
  for (std::size_t c = 0; c < 3; ++c)
    medium[c] = {.sigma_a_per_mm = coefficients.sigma_a_per_mm[c],
                 .sigma_s_per_mm = coefficients.sigma_s_per_mm[c],
                 .g = coefficients.g,
                 .eta = coefficients.eta};
  return medium;
}

std::optional<Coefficients> coefficients_of(const RgbMedium& medium) {
  Coefficients out{.g = medium[0].g, .eta = medium[0].eta};
  for (std::size_t c = 0; c < 3; ++c) {
    if (medium[c].g != out.g || medium[c].eta != out.eta) return std::nullopt;
    out.sigma_a_per_mm[c] = medium[c].sigma_a_per_mm;
    out.sigma_s_per_mm[c] = medium[c].sigma_s_per_mm;
  }
  return out;
}

RgbMedium parse_coefficients(const std::string& text, const std::string& where) {
  std::map<std::string, Rgb> values = parse_key_values(text, {"sigma_a", "sigma_s", "g", "eta"}, where);
  for (const char* key : {"sigma_a", "sigma_s"})
    if (!values.contains(key))
      throw input_error(where, "'{}' is missing; write \"sigma_a=R,G,B sigma_s=R,G,B g=0 eta=1.4\", per mm",
                        key);
  RgbMedium medium;
  for (int c = 0; c < 3; ++c) {
    medium[c].sigma_a_per_mm = values["sigma_a"][c];
    medium[c].sigma_s_per_mm = values["sigma_s"][c];
    if (values.contains("g")) medium[c].g = values["g"][c];
    if (values.contains("eta")) medium[c].eta = values["eta"][c];
  }
  check(medium, where);
  return medium;
}

}  // namespace dermis::optics
