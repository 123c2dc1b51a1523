// SPDX-License-Identifier: MIT
// All shaders that techniques draw with, compiled at build time and embedded.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "render/passes/shaders.h"

namespace dermis::techniques {

/// Returns SPIR-V of the passes of a technique by its folder and file ("published/blur.frag"); empty if there
/// is none.
std::span<const std::uint32_t> find_shader(std::string_view name);

/// Returns SPIR-V of those or of src/render/passes ("blur.comp").
inline std::span<const std::uint32_t> find_any_shader(std::string_view name) {
  const std::span<const std::uint32_t> own = find_shader(name);
  return own.empty() ? passes::find_shader(name) : own;
}

}  // namespace dermis::techniques
