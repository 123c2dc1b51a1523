// SPDX-License-Identifier: MIT
#include "render/passes/screen/screen_surface.h"

#include "render/passes/screen/clear_surface.h"
#include "render/passes/targets.h"

namespace dermis::passes {

gpu::TextureDesc screen_light(std::uint32_t width, std::uint32_t height) {
  return {.width = width, .height = height, .format = light_format};
}

ScreenSurface make_screen_surface(FramePlan& plan, std::uint32_t width, std::uint32_t height,
                                  std::uint32_t samples) {
  gpu::TextureDesc leaving = screen_light(width, height);
  leaving.layers = samples;
  leaving.array = true;
  const ScreenSurface made{
      .light = plan.texture("light of skin", screen_light(width, height)),
      .depth_mm =
          plan.texture("depth of skin", {.width = width, .height = height, .format = VK_FORMAT_R32_SFLOAT}),
      .surface =
          plan.texture("surface of skin", {.width = width, .height = height, .format = VK_FORMAT_R32_UINT}),
      .leaving = plan.texture("leaving skin", leaving)};
  plan.add<ClearSurface>("clear skin", {made.light, made.depth_mm, made.surface});
  return made;
}

PixelArea area_of(const ScreenSurface& surface, const FrameData& frame) {
  return surface.halved ? halved(frame.with_heads) : frame.with_heads;
}

// Rows of the matrix: clip x is dot(x, position), and clip w the distance along the view (of a matrix of any
// scale). The part of x across the line of sight is what a metre there adds.
io::ScreenIo screen_io(const gpu::TextureDesc& texture, const ScreenSurface& surface,
                       const FrameData& frame) {
  const glm::mat4 rows = glm::transpose(frame.camera.clip_from_world);
  const glm::vec3 w(rows[3]);
  const auto across = [&](const glm::vec3& row) {
    if (frame.camera.orthographic != 0) return glm::length(row);
    return glm::length(row - w * (glm::dot(row, w) / glm::dot(w, w))) / glm::length(w);
  };

  glm::vec2 picture_low(0), picture_size(texture.width, texture.height);
  if (frame.area) {
    const float halves = surface.halved ? 0.5f : 1.0f;
    const auto& [offset, extent] = *frame.area;
    picture_low = halves * glm::vec2(offset.x, offset.y);
    picture_size = glm::ceil(halves * glm::vec2(extent.width, extent.height));
  }
  const PixelArea area = area_of(surface, frame);
  return {.extent = {texture.width, texture.height},
          .picture_low = picture_low,
          .picture_size = picture_size,
          .low = area.low,
          .size = area.size(),
          .across = across(glm::vec3(rows[0])),
          .up = across(glm::vec3(rows[1]))};
}

}  // namespace dermis::passes
