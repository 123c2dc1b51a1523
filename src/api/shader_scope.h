// SPDX-License-Identifier: MIT
// Shaders in the place of dermis's own, for who edits them while a program runs.
#pragma once

#include "gpu/pipelines.h"

namespace dermis::api {

/// Renderers that this thread makes as long as the scope lives draw with these shaders, by name
/// ("blur.comp"); an empty span keeps ours. The spans must stay valid as long as the renderers. Calls that
/// make a pipeline of a shader whose interface differs throw InputError. Scopes nest.
class ShaderScope {
 public:
  explicit ShaderScope(gpu::ShaderSource shaders);
  ~ShaderScope();
  ShaderScope(const ShaderScope&) = delete;
  ShaderScope& operator=(const ShaderScope&) = delete;

  /// Returns those of the innermost scope of this thread; empty outside of any.
  static gpu::ShaderSource current();

 private:
  gpu::ShaderSource shaders_;
  const ShaderScope* outer_;
};

}  // namespace dermis::api
