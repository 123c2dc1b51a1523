// SPDX-License-Identifier: MIT
// Bindings of every lit pass, beside the frame and the head: lights, shadow maps, table of the directional
// albedo.
#pragma once

#include "render/passes/bindings.h"
#include "render/passes/frame_data.h"

namespace dermis::passes {

class LightingSamplers {
 public:
  LightingSamplers() = default;
  explicit LightingSamplers(gpu::PipelineLibrary& library)
      : depths_(library.sampler({.filter = gpu::Filter::nearest})),
        table_(library.sampler({.filter = gpu::Filter::linear})),
        sky_(library.sampler({.filter = gpu::Filter::linear, .u = gpu::Address::repeat})) {}

  void offer(Bindings& bindings, const FrameData& frame, const Head& head, const gpu::Texture& shadow) const {
    bindings.add("Lamps", frame.lamps)
        .add("shadow_depths", gpu::SampledBinding{&shadow, depths_})
        .add("directional_albedo", gpu::SampledBinding{&head.asset->directional_albedo, table_})
        .add("environment_map",
             gpu::SampledBinding{frame.environment ? frame.environment : &head.asset->white(), sky_});
  }
  /// Offers what skin mesh `number` of the head's asset sees of the environment.
  void offer_sky(Bindings& bindings, const Head& head, std::size_t number) const {
    const GpuMesh& mesh = head.asset->skin[number];
    const bool sky = number < head.sky.size();
    const gpu::Texture *bent_normal = mesh.bent_normal ? &mesh.bent_normal : &head.asset->white(),
                       *light = sky ? &head.sky[number].light : &head.asset->white_layers();

    if (sky && head.posed && number < head.posed->sky.size()) {
      const PosedShape::Sky& turned = head.posed->sky[number];
      bent_normal = &turned.bent_normal;
      light = &turned.light;
    }

    bindings.add("bent_normal", gpu::SampledBinding{bent_normal, table_})
        .add("sky_light", gpu::SampledBinding{light, table_});
  }

 private:
  VkSampler depths_ = VK_NULL_HANDLE, table_ = VK_NULL_HANDLE, sky_ = VK_NULL_HANDLE;
};

}  // namespace dermis::passes
