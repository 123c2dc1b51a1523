// SPDX-License-Identifier: MIT
// Bytes as messages say them.
#pragma once

#include <cstdint>

namespace dermis::gpu {

inline double mib(std::uint64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

}  // namespace dermis::gpu
