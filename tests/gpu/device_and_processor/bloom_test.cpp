// SPDX-License-Identifier: MIT
// Bloom against its definition: the picture without it, filtered by the two Gaussians at full size in double
// precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"

namespace dermis::tests {
namespace {

// One channel.
struct Plane {
  int width = 0, height = 0;
  std::vector<double> values;
  double at(int x, int y) const {
    return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
  }
};

Plane green_of(const Picture& picture) {
  Plane plane{static_cast<int>(picture.width), static_cast<int>(picture.height), {}};
  for (std::size_t i = 1; i < picture.linear_rgba.size(); i += 4)
    plane.values.push_back(picture.linear_rgba[i]);
  return plane;
}

Plane blurred(const Plane& plane, double sigma) {
  const int reach = static_cast<int>(std::ceil(4 * sigma));
  const auto along = [&](const Plane& from, int dx, int dy) {
    Plane to = from;
    for (int y = 0; y < from.height; ++y)
      for (int x = 0; x < from.width; ++x) {
        double sum = 0, total = 0;
        for (int k = -reach; k <= reach; ++k) {
          const double w = std::exp(-0.5 * k * k / (sigma * sigma));
          sum += w * from.at(x + k * dx, y + k * dy);
          total += w;
        }
        to.values[static_cast<std::size_t>(y * from.width + x)] = sum / total;
      }
    return to;
  };
  return along(along(plane, 1, 0), 0, 1);
}

double mean_of(const Plane& plane) {
  double sum = 0;
  for (const double v : plane.values) sum += v;
  return sum / static_cast<double>(plane.values.size());
}

// GPU Gems 3, ch. 14.3.4, with d a twelfth of the height.
Plane bloom_of(const Plane& sharp) {
  const double d = sharp.height / 12.0;
  const Plane narrow = blurred(sharp, std::sqrt(0.008) * d), wide = blurred(sharp, std::sqrt(0.0576) * d);
  Plane sum = sharp;
  for (std::size_t i = 0; i < sum.values.size(); ++i)
    sum.values[i] = (0.0174 * narrow.values[i] + 0.192 * wide.values[i]) / (0.0174 + 0.192);
  return sum;
}

struct Case {
  std::uint32_t width, height;
};

class Bloom : public ::testing::TestWithParam<Case> {};

// Narrow and wide Gaussian on the half-size picture; the wide one on a quarter; the narrow one on a quarter
// and the wide one on an eighth. Odd sizes, whose halves reach over the last pixel.
INSTANTIATE_TEST_SUITE_P(Sizes, Bloom, ::testing::Values(Case{120, 135}, Case{640, 600}, Case{801, 1401}));

TEST_P(Bloom, IsTwoGaussians) {
  const Scene scene = sphere_lit_from_the_camera(0.1);
  RenderSettings s;
  s.technique = "lambert";
  s.output.width = GetParam().width;
  s.output.height = GetParam().height;
  s.quality.shadow_size = 256;
  s.camera.distance = 16;  // nothing is near the border, beyond which nothing is known
  s.output.bloom = 0;
  const Plane sharp = green_of(renderer().render(scene, s));
  s.output.bloom = 1;
  const Plane found = green_of(renderer().render(scene, s)), wanted = bloom_of(sharp);

  double worst = 0;
  const double greatest = *std::ranges::max_element(wanted.values);
  for (std::size_t i = 0; i < found.values.size(); ++i)
    worst = std::max(worst, std::abs(found.values[i] - wanted.values[i]) / greatest);
  std::printf("%u x %u: at most %.4f of the brightest\n", GetParam().width, GetParam().height, worst);
  EXPECT_GT(greatest, 0.05);
  EXPECT_LT(worst, 0.006);
  EXPECT_NEAR(mean_of(found) / mean_of(wanted), 1, 2e-3);
}

}  // namespace
}  // namespace dermis::tests
