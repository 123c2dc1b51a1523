// SPDX-License-Identifier: MIT
/// From what the device has written to what the caller of a session reads.
#pragma once

#include <cstdint>
#include <memory>

#include "api/readbacks.h"
#include "dermis/outputs.h"

namespace dermis::api {

/// The LABEL_... bits of render/passes/pixels/labels.
std::uint32_t label_bits(Outputs wanted);
ReadbackSizes readback_sizes(Outputs wanted, std::uint64_t pixels);
/// Spans over the memory of `readback`, which they keep.
Results results_of(Outputs wanted, int width, int height, const std::shared_ptr<Readback>& readback);

}  // namespace dermis::api
