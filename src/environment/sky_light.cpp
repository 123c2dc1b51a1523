// SPDX-License-Identifier: MIT
#include "base/core/assert.h"
#include "base/core/parallel.h"
#include "environment/occlusion.h"
#include "image/colour.h"

namespace dermis::environment {
namespace {

constexpr std::size_t shares_open = bounced_terms - 1;  // behind the harmonics of what is reflected

}  // namespace

int occlusion_side(std::size_t meshes) {
  constexpr std::size_t most_texels = 4 * 512 * 512;
  std::size_t side = 512;
  while (side > 64 && meshes > most_texels / (side * side)) side /= 2;
  return static_cast<int>(side);
}

SkyLight sky_light(const Occlusion& occlusion, const SkyHarmonics& sky, const SkyHarmonics& bounced_sky) {
  const auto side = static_cast<std::size_t>(occlusion.side);
  DERMIS_ASSERT_EQ(occlusion.transfer.size(), side * side * harmonic_terms);
  DERMIS_ASSERT_EQ(occlusion.bounced.size(), side * side * bounced_terms);

  // Returns the product of transfer and radiance, at least 0: the truncated series may ring.
  const auto product = [](const std::uint16_t* transfer, const SkyHarmonics& radiance, std::size_t terms) {
    glm::vec3 e(0);
    for (std::size_t k = 0; k < terms; ++k) e += image::half_to_float(transfer[k]) * glm::vec3(radiance[k]);
    return glm::max(e, glm::vec3(0));
  };

  SkyLight out{.direct = std::vector<float>(4 * side * side), .bounced = std::vector<float>(4 * side * side)};
  parallel_for(side, [&](std::size_t row) {
    for (std::size_t i = row * side; i < (row + 1) * side; ++i) {
      const std::uint16_t* hidden = &occlusion.bounced[i * bounced_terms];
      const glm::vec3 direct = product(&occlusion.transfer[i * harmonic_terms], sky, harmonic_terms),
                      bounced = product(hidden, bounced_sky, shares_open);

      for (glm::length_t c = 0; c < 3; ++c) {
        out.direct[4 * i + static_cast<std::size_t>(c)] = direct[c];
        out.bounced[4 * i + static_cast<std::size_t>(c)] = bounced[c];
      }
      out.direct[4 * i + 3] = 1;
      out.bounced[4 * i + 3] = image::half_to_float(hidden[shares_open]);
    }
  });
  return out;
}

}  // namespace dermis::environment
