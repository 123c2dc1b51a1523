// SPDX-License-Identifier: MIT
// Counts reads of transmitted light that found nothing. Needs skin_through.glsl.
layout(constant_id = 9) const uint slot = 0;
layout(binding = 25, scalar) buffer Counters { uint counters[]; };

// Returns for how many lights that a point faces away from the position is outside the light's map, or
// entering light was not stored although there is a surface.
uint misses_at(ShadingPoint s) {
  uint misses = 0u;
  for (uint k = nothing(); k < frame.light_count; ++k) {
    const LightIo light = light_at(k);
    const Arriving a = arriving_light(light, s.position_m);
    const float cosine_here = dot(s.normal, a.to_light);
    const LightRead read = read_light(light, a, s, cosine_here);
    if (cosine_here <= 0.0 && light.shadow_layers > 0u && !(read.inside && read.shaded)) ++misses;
  }
  return misses;
}
