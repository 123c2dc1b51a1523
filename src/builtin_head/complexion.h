// SPDX-License-Identifier: MIT
// What the skins of the built-in head are made of: pigments of measured groups of people.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "optics/skin_table.h"

namespace dermis::builtin_head {

enum class Tone : std::uint8_t { light, medium, dark };

/// Colours that no pigment of skin gives, linear Rec.709.
struct Colouring {
  glm::vec3 hair{0}, iris_dark{0}, iris_light{0};
  float sclera = 1;  ///< how white the white of the eye is, against that of the light skin
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
