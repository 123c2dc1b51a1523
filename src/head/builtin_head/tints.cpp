// SPDX-License-Identifier: MIT
#include "head/builtin_head/tints.h"

namespace dermis::builtin_head {
namespace {

constexpr float step = 0.1f, least_melanin = -0.7f, least_blood = -1.2f;
constexpr float oxygen_step = 0.25f;  // as skin_table() has its nodes
constexpr int melanins = 28, bloods = 43, oxygens = 3;

struct Place {
  int low = 0;
  float part = 0;
};
Place place_of(float x, int nodes) {
  const float t = std::clamp(x, 0.0f, static_cast<float>(nodes - 1));
  const int low = std::min(static_cast<int>(t), nodes - 2);
  return {low, t - static_cast<float>(low)};
}

}  // namespace

Tints::Tints(const optics::Pigments& mean) {
  const optics::SkinTable& table = skin_table();
  for (int o = 0; o < oxygens; ++o) {
    for (int b = 0; b < bloods; ++b) {
      for (int m = 0; m < melanins; ++m) {
        const std::array<float, 3> colour = table.at(
            {.melanin = mean.melanin * std::exp(double{least_melanin + step * static_cast<float>(m)}),
             .haemoglobin = mean.haemoglobin * std::exp(double{least_blood + step * static_cast<float>(b)}),
             .oxygenation = mean.oxygenation - double{oxygen_step} * o});
        albedo_.emplace_back(colour[0], colour[1], colour[2]);
      }
    }
  }
}

vec3 Tints::at(float log_melanin, float log_blood, float less_oxygen) const {
  const Place m = place_of((log_melanin - least_melanin) / step, melanins),
              b = place_of((log_blood - least_blood) / step, bloods),
              o = place_of(less_oxygen / oxygen_step, oxygens);
  const auto along = [&](int blood, int oxygen) {
    const vec3* at =
        &albedo_[static_cast<std::size_t>(((o.low + oxygen) * bloods + b.low + blood) * melanins + m.low)];
    return at[0] + m.part * (at[1] - at[0]);
  };
  const auto plane = [&](int oxygen) {
    const vec3 low = along(0, oxygen);
    return low + b.part * (along(1, oxygen) - low);
  };
  const vec3 low = plane(0);
  return o.part > 0 ? low + o.part * (plane(1) - low) : low;
}

}  // namespace dermis::builtin_head
