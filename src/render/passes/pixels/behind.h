// SPDX-License-Identifier: MIT
// The background, where no surface covers a pixel.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace dermis::passes {

struct Behind {
  enum class Kind : std::uint8_t {
    black,
    studio,       ///< light: a grey wall, render/passes/pixels/background/README.md
    environment,  ///< light: the picture of the surroundings; uniform without one
    colour        ///< no light, but a colour of the display, which no tone map changes
  };
  Kind kind = Kind::black;
  glm::vec3 srgb{0};  ///< of Kind::colour, display values 0..1
  bool is_light() const { return kind == Kind::studio || kind == Kind::environment; }
  bool operator==(const Behind&) const = default;
};

}  // namespace dermis::passes
