// SPDX-License-Identifier: MIT
// The names that the command line and JSON have for values of settings.
#pragma once

#include "base/core/names.h"
#include "dermis/light.h"
#include "dermis/profile.h"
#include "dermis/reference.h"
#include "dermis/settings.h"

namespace dermis {

template <>
inline constexpr std::array<std::string_view, 2> names_of<BlurMask>{"alpha", "depth"};

template <>
inline constexpr std::array<std::string_view, 3> names_of<ScreenKernel>{"profile", "published", "ue"};

template <>
inline constexpr std::array<std::string_view, 6> names_of<ToneMap>{"natural", "neutral", "agx",
                                                                   "filmic",  "srgb",    "linear"};

template <>
inline constexpr std::array<std::string_view, 3> names_of<LightType>{"directional", "spot", "point"};

template <>
inline constexpr std::array<std::string_view, 3> names_of<ReferenceModel>{"bssrdf", "volume", "gaussians"};

template <>
inline constexpr std::array<std::string_view, 6> names_of<ProfileModel>{"dipole", "better",      "multipole",
                                                                        "beam",   "monte-carlo", "auto"};

template <>
inline constexpr std::array<std::string_view, 2> names_of<ProfileFit>{"plane", "energy"};

}  // namespace dermis
