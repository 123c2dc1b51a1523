// SPDX-License-Identifier: MIT
/// The automatic exposure: one for the light that falls on the skin, whatever the skin's own colour.
#pragma once

#include <functional>
#include <optional>
#include <span>

namespace dermis::api {

/// White skin would show this on average: the mean luminance over the skin in the picture lands at this share
/// of its reflectance. Skin under twice the mean light then still shows its own colour, below white.
inline constexpr double exposed_light = 0.5;

/// Mean Rec.709 luminance of a linear RGBA picture, each pixel weighted by its alpha, the share of it that is
/// skin. None: no skin.
std::optional<double> mean_skin_luminance(std::span<const float> rgba);

/// The exposure, EV, under which the mean light on the skin is exposed_light, to two decimals, -64 to 64.
/// mean_at(ev) measures that mean in a frame exposed by 2^ev; it is called again where the answer is too far
/// from there for half floats. None: no skin, or no light on it.
std::optional<double> choose_exposure(const std::function<std::optional<double>(double ev)>& mean_at);

}  // namespace dermis::api
