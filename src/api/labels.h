// SPDX-License-Identifier: MIT
/// From what the pass of labels writes to what the caller gets.
#pragma once

#include <cstddef>
#include <span>

#include "dermis/session.h"

namespace dermis::api {

/// `surface`: LabelSurfaceIo, `names`: LabelNamesIo, `body`: LabelBodyIo of each pixel.
Labels labels_of(int width, int height, std::span<const std::byte> surface, std::span<const std::byte> names,
                 std::span<const std::byte> motion, std::span<const std::byte> body);

}  // namespace dermis::api
