// SPDX-License-Identifier: MIT
#include "render/setup/turned_sky.h"

#include <cmath>

#include "base/core/assert.h"
#include "environment/texel_grid.h"

namespace dermis::setup {
namespace {

static_assert(environment::harmonic_terms == 2 * (SKY_TEXEL_BOUNCED - SKY_TEXEL_TRANSFER));
static_assert(environment::bounced_terms == BOUNCED_HARMONICS + 1);
static_assert(SKY_TEXEL_ROWS - SKY_TEXEL_BOUNCED == (environment::bounced_terms + 1) / 2);

std::uint32_t halves(std::uint16_t low, std::uint16_t high) {
  return std::uint32_t{low} | std::uint32_t{high} << 16;
}

std::uint32_t unorms(float low, float high) {
  const auto rounded = [](float value) { return static_cast<std::uint16_t>(std::lround(value * 65535)); };
  return halves(rounded(low), rounded(high));
}

}  // namespace

SkyTexels sky_texels(const scene::SkinMesh& mesh, const environment::Occlusion& occlusion) {
  const environment::TexelGrid grid = environment::dilated(environment::rasterise(mesh, occlusion.side));
  DERMIS_ASSERT_EQ(occlusion.transfer.size(), grid.texels.size() * environment::harmonic_terms);
  std::vector<std::uint32_t> covered;
  for (std::uint32_t i = 0; i < grid.texels.size(); ++i)
    if (grid.texels[i].covered()) covered.push_back(i);

  SkyTexels out{.count = static_cast<std::uint32_t>(covered.size()),
                .rows = std::vector<std::uint32_t>(covered.size() * SKY_TEXEL_ROWS)};
  const auto side = static_cast<std::uint32_t>(grid.side);
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const auto row = [&](std::size_t r) -> std::uint32_t& { return out.rows[r * covered.size() + i]; };
    const environment::GridTexel& texel = grid.texels[covered[i]];
    row(SKY_TEXEL_AT) = covered[i] % side | covered[i] / side << 16;
    for (std::size_t k = 0; k < 3; ++k)
      row(SKY_TEXEL_VERTICES + k) = mesh.indices[3 * std::size_t{texel.triangle} + k];
    row(SKY_TEXEL_WEIGHTS) = unorms(texel.u, texel.v);

    const std::uint16_t* transfer = &occlusion.transfer[covered[i] * environment::harmonic_terms];
    for (std::size_t k = 0; k < environment::harmonic_terms / 2; ++k)
      row(SKY_TEXEL_TRANSFER + k) = halves(transfer[2 * k], transfer[2 * k + 1]);
    const std::uint16_t* bounced = &occlusion.bounced[covered[i] * environment::bounced_terms];
    for (std::size_t k = 0; k < BOUNCED_HARMONICS / 2; ++k)
      row(SKY_TEXEL_BOUNCED + k) = halves(bounced[2 * k], bounced[2 * k + 1]);
    row(SKY_TEXEL_ROWS - 1) = bounced[BOUNCED_HARMONICS];
  }
  return out;
}

io::SkyHarmonicsIo sky_harmonics_io(const environment::SkyHarmonics& sky,
                                    const environment::SkyHarmonics& bouncing_sky) {
  io::SkyHarmonicsIo io{};
  for (std::size_t k = 0; k < sky.size(); ++k) io.sky[k] = glm::vec3(sky[k]);
  for (std::size_t k = 0; k < BOUNCED_HARMONICS; ++k) io.bouncing_sky[k] = glm::vec3(bouncing_sky[k]);
  return io;
}

}  // namespace dermis::setup
