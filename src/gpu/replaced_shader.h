// SPDX-License-Identifier: MIT
// Shaders that a host puts in the place of ours.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace dermis::gpu {

/// Checks that a host's SPIR-V fits the draws of ours: it must declare the same things, but may leave some
/// out. Throws InputError that names the shader and what differs.
void check_replacement(const std::string& name, std::span<const std::uint32_t> ours,
                       std::span<const std::uint32_t> other);

}  // namespace dermis::gpu
