// SPDX-License-Identifier: MIT
#include "cli/bench/pictures.h"

#include <algorithm>
#include <utility>

#include "image/compare_exposed.h"
#include "image/resize.h"

namespace dermis::cli::bench {
namespace {

constexpr int page_width = 960;  // pixels that a picture takes on the page
constexpr int tiny_width = 480;  // narrower ones are enlarged if a whole factor fits
constexpr int map_side = 480;    // of a light map on the page
constexpr int room = 12;         // around the skin

image::ImageF super_sampled(Renderer& renderer, const Scene& scene, RenderSettings s, double d_ref,
                            int samples) {
  s.output.width *= samples, s.output.height *= samples;
  s.quality.samples = 1;
  s.output.bloom = 0;
  s.quality.d_ref = d_ref;
  Picture fine = renderer.prepare(scene, s).picture();
  return image::downsample_box(
      {.width = fine.width, .height = fine.height, .channels = 4, .values = std::move(fine.linear_rgba)},
      samples);
}

struct Box {
  int left, top, right, bottom;  // right and bottom are outside
};

Box skin_box(const Picture& a, const Picture& b) {
  Box box{a.width, a.height, 0, 0};
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const std::size_t alpha =
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) + static_cast<std::size_t>(x)) *
              4 +
          3;
      if (a.linear_rgba[alpha] <= 0 && b.linear_rgba[alpha] <= 0) continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
             std::max(box.bottom, y + 1)};
    }
  if (box.right == 0) return {0, 0, a.width, a.height};
  return {std::max(box.left - room, 0), std::max(box.top - room, 0), std::min(box.right + room, a.width),
          std::min(box.bottom + room, a.height)};
}

// `shrink` pixels along each axis become one, then each becomes `grow`; display values, as a browser would
// scale them.
image::Image8 cut(const Picture& picture, const Box& box, int shrink, int grow) {
  const int width = (box.right - box.left) / shrink, height = (box.bottom - box.top) / shrink;
  image::Image8 out{.width = width * grow, .height = height * grow, .rgba = {}};
  out.rgba.resize(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (int v = 0; v < shrink; ++v)
          for (int u = 0; u < shrink; ++u) {
            const auto row = static_cast<std::size_t>(box.top + y / grow * shrink + v);
            const auto column = static_cast<std::size_t>(box.left + x / grow * shrink + u);
            sum += picture.display_rgba[(row * static_cast<std::size_t>(picture.width) + column) * 4 +
                                        static_cast<std::size_t>(c)];
          }
        out.at(x, y)[c] = static_cast<std::uint8_t>((sum + shrink * shrink / 2) / (shrink * shrink));
      }
  return out;
}

image::Image8 whole(const Picture& picture, int widest) {
  const int shrink = std::max((picture.width + widest - 1) / widest, 1);
  return cut(picture, {0, 0, picture.width, picture.height},
             std::min({shrink, picture.width, picture.height}), 1);
}

Picture show(Renderer& renderer, const Scene& scene, RenderSettings s, const std::string& what) {
  s.output.show = what;
  return renderer.prepare(scene, s).picture();
}

}  // namespace

std::map<std::string, PictureDifference> picture_differences(Renderer& renderer, const Scene& scene,
                                                             const Cell& cell, double d_ref, int samples) {
  // One after the other: each may take much of the device.
  const RenderSettings& baseline = cell.of(baseline_key).variant.settings;
  const image::ImageF published = super_sampled(renderer, scene, baseline, d_ref, samples);

  std::map<std::string, PictureDifference> differences;
  for (const Measured& m : cell.measured) {
    if (!m.variant.compared) continue;
    image::ImageF compared = super_sampled(renderer, scene, m.variant.settings, d_ref, samples);
    if (const auto found = image::compare_exposed(published, std::move(compared), baseline.output.tone_map))
      differences[m.variant.key] = {.psnr_db = found->psnr_db,
                                    .flip_mean = found->flip_mean,
                                    .pixels = found->pixels,
                                    .samples = samples};
  }
  return differences;
}

CellPictures cut_to_skin(const Picture& baseline, const Picture& optimised) {
  const Box box = skin_box(baseline, optimised);
  const int width = box.right - box.left, height = box.bottom - box.top;
  const int shrink = std::min((width + page_width - 1) / page_width, height);
  const int grow = std::clamp(tiny_width / width, 1, 8);
  return {cut(baseline, box, shrink, grow), cut(optimised, box, shrink, grow)};
}

MapPictures map_pictures(Renderer& renderer, const Scene& scene, const RenderSettings& baseline,
                         const RenderSettings& optimised) {
  return {.heads = optimised.camera.heads,
          .distance = optimised.camera.distance.value_or(0),
          .irradiance = whole(show(renderer, scene, baseline, "irradiance"), map_side),
          .visibility = whole(show(renderer, scene, optimised, "visibility"), map_side),
          .picture = whole(show(renderer, scene, optimised, "picture"), page_width)};
}

}  // namespace dermis::cli::bench
