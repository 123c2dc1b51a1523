// SPDX-License-Identifier: MIT
#include "render/passes/screen/disc_gather/disc_gather.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/passes/screen/disc_gather/disc_gather_io.h"

namespace dermis::passes {
namespace {

io::DiscProfileIo profile_io(const Disc& disc) {
  const auto& [r, g, b] = disc.burley_mm;
  io::DiscProfileIo io{.mm_per_unit = static_cast<float>(disc.mm_per_unit),
                       .reach_mm = static_cast<float>(disc.reach_mm),
                       .distance_mm = glm::vec3(r, g, b),
                       .terms = static_cast<std::uint32_t>(disc.profile.terms.size()),
                       .widest = static_cast<std::uint32_t>(gaussians::widest_channel(disc.profile)),
                       .variance_mm2 = {},
                       .weight = {}};
  DERMIS_ASSERT_LE(disc.profile.terms.size(), std::size_t{MOST_TERMS});
  for (std::size_t i = 0; i < disc.profile.terms.size(); ++i) {
    const Gaussian& term = disc.profile.terms[i];
    const glm::dvec3 weight(term.weight[0], term.weight[1], term.weight[2]);
    io.variance_mm2[i] = static_cast<float>(term.variance_mm2);
    io.weight[i] = glm::vec3(weight / (2 * std::numbers::pi * term.variance_mm2));
  }
  return io;
}

std::vector<float> radii_of(const Disc& disc) {
  std::vector<float> radii(DISC_RADII);
  if (disc.reach_mm > 0)
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const double t = DISC_MOST_SHARE * static_cast<double>(i) / (DISC_RADII - 1);
      radii[i] = static_cast<float>(gaussians::disc_reach_mm(disc.profile, -std::expm1(-t * t)));
    }
  return radii;
}

}  // namespace

DiscGather::Out DiscGather::declare(frame::Declare& d) {
  DERMIS_ASSERT(!settings.discs.empty());
  const std::size_t taps = settings.discs.front().taps.size();
  for (const Disc& disc : settings.discs) DERMIS_ASSERT_EQ(disc.taps.size(), taps);
  compute(d, "disc_gather.comp",
          {{"tap_count", static_cast<std::uint32_t>(taps)},
           {"burley", settings.burley ? 1u : 0u},
           {"ue", settings.ue ? 1u : 0u}});

  const gpu::TextureDesc desc = d.desc(in.surface.light);
  out_.light = d.create("blurred light", screen_light(desc.width, desc.height));
  d.read(in.surface.light);
  d.read(in.surface.depth_mm);
  d.read(in.surface.surface);
  d.sample(in.surface.leaving);
  d.write(out_.light);
  return out_;
}

void DiscGather::prepare(gpu::PipelineLibrary& library) {
  ComputePass::prepare(library);
  std::vector<io::DiscProfileIo> profiles;
  std::vector<io::DiscTapIo> taps;
  std::vector<float> radii;
  for (const Disc& disc : settings.discs) {
    profiles.push_back(profile_io(disc));
    for (const gaussians::DiscTap& tap : disc.taps)
      taps.push_back({.offset_mm = glm::vec2(tap.x_mm, tap.y_mm),
                      .per_density_mm2 = static_cast<float>(tap.per_density_mm2)});
    if (!settings.ue) continue;
    const std::vector<float> more = radii_of(disc);
    radii.insert(radii.end(), more.begin(), more.end());
  }
  constexpr VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  profiles_ = gpu::make_buffer(library.device(), "disc profiles",
                               std::span<const io::DiscProfileIo>(profiles), usage);
  radii_ = gpu::make_buffer(library.device(), "disc radii", std::span<const float>(radii), usage);
  taps_ = gpu::make_buffer(library.device(), "disc taps", std::span<const io::DiscTapIo>(taps), usage);
}

void DiscGather::record(gpu::Cmd& cmd, const frame::Resources& resources, const FrameData& frame) const {
  Bindings()
      .add("Frame", frame.frame_io)
      .add("light", resources.storage(in.surface.light))
      .add("depth_of_skin", resources.storage(in.surface.depth_mm))
      .add("surface_of_skin", resources.storage(in.surface.surface))
      .add("leaving_skin", resources.nearest(in.surface.leaving))
      .add("Profiles", profiles_)
      .add("Taps", taps_)
      .add("Radii", radii_)
      .add("target", resources.storage(out_.light))
      .bind(cmd, pipeline());
  const io::ScreenIo io = screen_io(resources.texture(out_.light).desc(), in.surface, frame);
  dispatch(cmd, io, io.size);
}

}  // namespace dermis::passes
