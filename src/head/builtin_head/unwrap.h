// SPDX-License-Identifier: MIT
// The chart of the net: where each of its nodes lies on the square that the maps are painted on.
#pragma once

#include <vector>

#include "head/builtin_head/wrap.h"

namespace dermis::builtin_head {

/// Returns a place for every node of the net, (0, 0) to (1, 1), v upwards. The sides of the net lie on the
/// sides of the square, and no triangle is turned over, so that none overlap. Within that the chart is as
/// little stretched as it can be (symmetric Dirichlet energy: Smith, Schaefer: Bijective parameterization
/// with free boundaries, ACM Transactions on Graphics 34, 2015), against a metric that gives face and ears
/// more room. The same bits on every run.
std::vector<vec2> unwrap(const Net& net, const Frame& ear);

}  // namespace dermis::builtin_head
