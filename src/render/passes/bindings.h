// SPDX-License-Identifier: MIT
// Bindings by their names in the shaders. A pass offers all that it has; each shader takes what it uses.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "base/core/assert.h"
#include "gpu/cmd.h"

namespace dermis::passes {

class Bindings {
 public:
  Bindings& add(std::string_view name, const gpu::Binding& binding) {
    entries_.emplace_back(name, binding);
    return *this;
  }
  Bindings& add(std::string_view name, const gpu::Buffer& buffer) {
    return add(name, gpu::BufferBinding{&buffer});
  }

  /// Binds what the pipeline's shaders use, in their order. A name that was not offered is our bug.
  void bind(gpu::Cmd& cmd, const gpu::Pipeline& pipeline) const {
    std::vector<gpu::Binding> ordered;
    for (const gpu::BindingSlot& slot : pipeline.interface.bindings) {
      const gpu::Binding* found = nullptr;
      for (const auto& [name, binding] : entries_)
        if (name == slot.name) found = &binding;
      if (!found) assertion_failed("binding offered", slot.name + " of " + pipeline.name, __FILE__, __LINE__);
      ordered.push_back(*found);
    }
    cmd.bind(pipeline, ordered);
  }

 private:
  std::vector<std::pair<std::string_view, gpu::Binding>> entries_;
};

}  // namespace dermis::passes
