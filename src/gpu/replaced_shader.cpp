// SPDX-License-Identifier: MIT
#include "gpu/replaced_shader.h"

#include <algorithm>

#include "base/core/error.h"
#include "gpu/pipelines.h"

namespace dermis::gpu {
namespace {

ShaderInterface reflect_other(const std::string& where, std::span<const std::uint32_t> spirv,
                              const std::string& name) {
  try {
    return reflect(spirv, name);
  } catch (const InternalError& error) {
    throw input_error(where, "'{}' cannot be used: {}", name, error.what());
  }
}

}  // namespace

void check_replacement(const std::string& where, const std::string& name, std::span<const std::uint32_t> ours,
                       std::span<const std::uint32_t> other) {
  constexpr std::uint32_t magic = 0x07230203;
  if (other.front() != magic)
    throw input_error(where, "'{}' is not SPIR-V in this machine's byte order", name);
  const ShaderInterface expected = reflect(ours, name), has = reflect_other(where, other, name);

  if (has.push_bytes != 0 && has.push_bytes != expected.push_bytes)
    throw input_error(where, "'{}' has {} bytes of push constants, dermis's has {}", name, has.push_bytes,
                      expected.push_bytes);
  if (has.workgroup != expected.workgroup || has.workgroup_constants != expected.workgroup_constants)
    throw input_error(where, "'{}' has workgroups of another size than dermis's", name);
  for (const BindingSlot& slot : has.bindings) {
    const auto same = std::ranges::find(expected.bindings, slot.binding, &BindingSlot::binding);
    if (same == expected.bindings.end() || same->kind != slot.kind || same->count != slot.count ||
        same->name != slot.name)
      throw input_error(where, "'{}' has a binding {} '{}' that dermis's has not, or of another kind", name,
                        slot.binding, slot.name);
  }
  for (const auto& constant : expected.constants)
    if (std::ranges::find(has.constants, constant) == has.constants.end())
      throw input_error(where, "'{}' lacks dermis's specialisation constant {} '{}'", name, constant.second,
                        constant.first);
}

}  // namespace dermis::gpu
