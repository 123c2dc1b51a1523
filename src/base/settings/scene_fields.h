// SPDX-License-Identifier: MIT
// Members of instances and lights in a scene file, a row for each. Scene holds
// the ranges.
#pragma once

#include "base/core/fields.h"
#include "dermis/light.h"
#include "dermis/scene.h"

namespace dermis {

template <>
inline constexpr auto fields_of<Instance> = std::tuple{
    Field{"name", &Instance::name, {.help = "for messages, and for lights of its rig"}},
    Field{"world_from_asset",
          &Instance::world_from_asset,
          {.help = "transform, 4 x 4, column after column: a rotation, one positive scale, a shift"}},
    Field{"visible", &Instance::visible, {.help = "whether it is drawn"}},
    Field{"mix",
          &Instance::mix,
          {.help = "part of the albedo applied before the light scatters, 0 to 1", .none = "the material's"}},
    Field{"tint", &Instance::tint, {.help = "multiplies the skin's colour, 0 to 100 each"}}};

template <>
inline constexpr auto fields_of<Light> = std::tuple{
    Field{"name", &Light::name, {.help = "for messages"}},
    Field{"type", &Light::type, {.help = "where it comes from"}},
    Field{"colour",
          &Light::colour,
          {.help = "irradiance on a surface that faces it, red, green and blue, 0 to 1e9. Of a spot or point "
                   "at d metres it is divided by d^2"}},
    Field{"position_m", &Light::position_m, {.help = "of a spot or point", .unit = "m"}},
    Field{"direction",
          &Light::direction,
          {.help = "in which the light of a directional or spot travels, of any length but 0"}},
    Field{"range_m",
          &Light::range_m,
          {.help = "nothing arrives from further away, of a spot or point; 0: no limit", .unit = "m"}},
    Field{"inner_cone_deg",
          &Light::inner_cone_deg,
          {.help = "half angle within which a spot is even", .unit = "degrees"}},
    Field{"outer_cone_deg",
          &Light::outer_cone_deg,
          {.help = "half angle at which a spot ends, up to 90", .unit = "degrees"}},
    Field{"radius",
          &Light::radius,
          {.help = "of a disc that casts soft shadows, m; directional: tangent of its angular radius"}}};

}  // namespace dermis
