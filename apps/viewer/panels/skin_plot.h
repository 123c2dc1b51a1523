// SPDX-License-Identifier: MIT
/// R(r) of a skin and of its fit.
#pragma once

#include "viewer/model/skin_maker.h"

namespace dermis::viewer {

/// Draws 2 pi r^2 R(r) over ln r, whose area is what skin reflects: the model as a line with the noise of
/// Monte-Carlo around it, the fit as dots. With `terms`, each Gaussian is a point on the curve that can be
/// dragged: sideways its width, up and down its weight. Returns whether one was.
bool skin_plot(const SkinCurves& curves, ScatterProfile* terms);

}  // namespace dermis::viewer
