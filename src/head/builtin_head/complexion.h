// SPDX-License-Identifier: MIT
// Pigments of the skins of the built-in head: those of measured groups of
// people.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "tissue/optics/skin_table.h"

namespace dermis::builtin_head {

/// Three skins of groups of people, then one in each class of the individual typology angle of skin,
/// ITA = atan((L* - 50) / b*). Based on: Chardon, Cretois, Hourseau: Skin colour typology and suntanning
/// pathways. International Journal of Cosmetic Science 13, 1991
enum class Tone : std::uint8_t {
  light,
  medium,
  dark,
  ita_very_light,    ///< over 55 degrees
  ita_light,         ///< 41 to 55
  ita_intermediate,  ///< 28 to 41
  ita_tan,           ///< 10 to 28
  ita_brown,         ///< -30 to 10
  ita_dark           ///< under -30
};
/// In the order of Tone.
inline constexpr std::array tone_names{"light",          "medium",    "dark",
                                       "ita-very-light", "ita-light", "ita-intermediate",
                                       "ita-tan",        "ita-brown", "ita-dark"};

/// Colours that no pigment of skin gives, linear Rec.709.
struct Colouring {
  glm::vec3 hair{0}, iris_dark{0}, iris_light{0};
  float sclera = 1;  ///< whiteness of the white of the eye, against that of the light skin
};

/// Volume fractions that the spectral model has for measured colours (complexion.cpp says whose).
struct Complexion {
  optics::Pigments skin;  ///< of cheek and forehead, before what differs from place to place
  optics::Pigments lips;
  Colouring colours;
};
const Complexion& complexion(Tone tone);

/// Returns the table that the skin is painted with: of optics::measured_skin(), oxygenation 0.25 to 1. Made
/// at the first call, some 0.2 s.
const optics::SkinTable& skin_table();

}  // namespace dermis::builtin_head
