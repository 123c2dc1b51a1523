// SPDX-License-Identifier: MIT
#include "image/compare_exposed.h"

#include "base/core/assert.h"
#include "base/core/error.h"
#include "image/compare_flip.h"
#include "image/metrics.h"

namespace dermis::image {
namespace {

constexpr int most_steps = 40;  // up to a factor of 7e5 either way

double mean_over(const Image8& picture, const std::vector<std::uint8_t>& mask) {
  double sum = 0, values = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) {
      sum += picture.rgba[4 * i] + picture.rgba[4 * i + 1] + picture.rgba[4 * i + 2];
      values += 3 * 255.0;
    }
  return sum / values;
}

void expose(ImageF& picture, float factor) {
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    if (i % 4 != 3) picture.values[i] *= factor;
}

}  // namespace

std::optional<ExposedDifference> compare_exposed(ImageF reference, ImageF test, ToneMap tone_map) {
  DERMIS_ASSERT_EQ(reference.channels, 4);
  DERMIS_ASSERT_EQ(test.channels, 4);
  if (reference.width != test.width || reference.height != test.height)
    throw input_error("", "pictures of {}x{} and {}x{} pixels cannot be compared", reference.width,
                      reference.height, test.width, test.height);

  ExposedDifference found;
  std::vector<std::uint8_t> mask(reference.values.size() / 4);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    mask[i] = reference.values[4 * i + 3] > 0 || test.values[4 * i + 3] > 0;
    found.pixels += mask[i];
  }
  if (found.pixels == 0) return std::nullopt;

  // Exposes both equally until the reference has a mean display value of 0.25 to 0.5.
  Image8 shown;
  for (int step = 0; step < most_steps; ++step) {
    shown = to_display(reference, tone_map);
    found.mean_display = mean_over(shown, mask);
    if (found.mean_display >= 0.25 && found.mean_display <= 0.5) break;
    const float factor = found.mean_display < 0.25 ? 1.4f : 0.7f;
    expose(reference, factor);
    expose(test, factor);
  }

  const Image8 other = to_display(test, tone_map);
  found.psnr_db = psnr_db(shown, other, mask);
  found.flip_mean = mean_flip(shown, other, mask);
  return found;
}

}  // namespace dermis::image
