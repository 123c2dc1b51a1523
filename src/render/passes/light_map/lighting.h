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

  void offer(Bindings& bindings, const FrameData& frame, const Instance& instance,
             const gpu::Texture& shadow) const {
    bindings.add("Lamps", frame.lamps)
        .add("shadow_depths", gpu::SampledBinding{&shadow, depths_})
        .add("directional_albedo", gpu::SampledBinding{&instance.asset->directional_albedo, table_})
        .add("environment_map",
             gpu::SampledBinding{frame.environment ? frame.environment : &instance.asset->white(), sky_});
  }
  /// Offers what skin mesh `number` of the instance's asset sees of the environment.
  void offer_sky(Bindings& bindings, const Instance& instance, std::size_t number) const {
    const GpuMesh& mesh = instance.asset->skin[number];
    const bool sky = number < instance.sky.size();
    const gpu::Texture *bent_normal = mesh.bent_normal ? &mesh.bent_normal : &instance.asset->white(),
                       *light = sky ? &instance.sky[number].light : &instance.asset->white_layers();

    if (sky && instance.posed && number < instance.posed->sky.size()) {
      const PosedShape::Sky& turned = instance.posed->sky[number];
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
