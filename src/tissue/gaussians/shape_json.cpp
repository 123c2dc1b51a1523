// SPDX-License-Identifier: MIT
#include "tissue/gaussians/shape_json.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/core/error.h"
#include "tissue/optics/media.h"
#include "tissue/profile/shape_laws.h"

namespace dermis::gaussians {
namespace {

/// A member of ShapeLaws and its range. Lengths are those of media that fill a room or less.
struct LawMember {
  const char* name;
  Rgb ShapeLaws::*values;
  double least, most;
};

constexpr double most_mm = 1e6;
constexpr std::array law_members{
    LawMember{"curvature_mm", &ShapeLaws::curvature_mm, 0, most_mm},
    LawMember{"convex_mm", &ShapeLaws::convex_mm, -most_mm, most_mm},
    LawMember{"concave_mm", &ShapeLaws::concave_mm, -most_mm, most_mm},
    LawMember{"difference_mm", &ShapeLaws::difference_mm, -most_mm, most_mm},
    LawMember{"difference_mm2", &ShapeLaws::difference_mm2, -most_mm* most_mm, most_mm* most_mm},
    LawMember{"front_share", &ShapeLaws::front_share, 0, 1},
    LawMember{"front_mm", &ShapeLaws::front_mm, 1e-12, most_mm},
    LawMember{"exit_grazing", &ShapeLaws::exit_grazing, 0, 2},
    LawMember{"exit_normal", &ShapeLaws::exit_normal, 0, 2},
    LawMember{"exit_offset_mm", &ShapeLaws::exit_offset_mm, 0, most_mm}};

Rgb three(const json::Value& value, double least, double most) {
  if (!value.is_array() || value.array_size(0) != 3)
    value.fail("must be a list of three numbers (red, green, blue)");
  Rgb result{};
  for (std::size_t c = 0; c < 3; ++c) result[c] = value.element(c).number(least, most);
  return result;
}

Coefficients read_medium(const json::Value& json) {
  json.only_keys({"sigma_a_per_mm", "sigma_s_per_mm", "g", "eta"});
  constexpr double any = json::max_number;
  const Coefficients medium{.sigma_a_per_mm = three(json.at("sigma_a_per_mm"), -any, any),
                            .sigma_s_per_mm = three(json.at("sigma_s_per_mm"), -any, any),
                            .g = json.at("g").number(),
                            .eta = json.at("eta").number()};
  optics::check(optics::rgb_medium(medium), json.file() + ": " + json.place());
  return medium;
}

/// `laws` are those of the medium: files of earlier versions have no exit_offset_mm.
ShapeLaws read_laws(const json::Value& json, ShapeLaws laws) {
  std::vector<std::string_view> names;
  for (const LawMember& member : law_members) names.push_back(member.name);
  json.only_keys(names);

  for (const LawMember& member : law_members)
    if (member.values != &ShapeLaws::exit_offset_mm || json.find(member.name))
      laws.*member.values = three(json.at(member.name), member.least, member.most);
  return laws;
}

}  // namespace

void read_shape(const json::Value& profile, ScatterProfile& sum) {
  const auto medium = profile.find("medium"), shape = profile.find("shape");
  if (shape && !medium) shape->fail("needs the medium that it is of: \"medium\"");
  if (!medium) return;
  sum.medium = read_medium(*medium);
  sum.shape = profile::shape_laws(optics::rgb_medium(*sum.medium));
  if (shape) sum.shape = read_laws(*shape, *sum.shape);
}

void write_shape(nlohmann::ordered_json& profile, const ScatterProfile& sum) {
  if (!sum.medium) return;
  profile["medium"] = {{"sigma_a_per_mm", sum.medium->sigma_a_per_mm},
                       {"sigma_s_per_mm", sum.medium->sigma_s_per_mm},
                       {"g", sum.medium->g},
                       {"eta", sum.medium->eta}};
  if (!sum.shape) return;
  for (const LawMember& member : law_members) profile["shape"][member.name] = (*sum.shape).*member.values;
}

void check_shape(const ShapeLaws& shape, const std::string& where) {
  for (const LawMember& member : law_members)
    for (const double value : shape.*member.values)
      if (!(value >= member.least && value <= member.most))
        throw input_error(where, "shape.{} must be {} to {}, got {}", member.name, member.least, member.most,
                          value);
}

}  // namespace dermis::gaussians
