// SPDX-License-Identifier: MIT
// Shaders in the place of ours: of a host, or of a developer who edits them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace dermis::gpu {

/// Checks that other SPIR-V fits the draws of ours: it must declare the same things, but may leave some out.
/// Throws InputError: `where` it comes from, the shader, and what differs.
void check_replacement(const std::string& where, const std::string& name, std::span<const std::uint32_t> ours,
                       std::span<const std::uint32_t> other);

}  // namespace dermis::gpu
