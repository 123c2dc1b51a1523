// SPDX-License-Identifier: MIT
// The shaders of all passes, compiled at build time and embedded, so that the program runs from any folder.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace dermis::passes {

/// Returns SPIR-V by file name ("blur.comp"); empty if there is none.
std::span<const std::uint32_t> find_shader(std::string_view name);

}  // namespace dermis::passes
