// SPDX-License-Identifier: MIT
/// Fineness of the light maps of a head, and the Gaussians of its profile that a skin mesh reads from them in
/// a frame. A head far away reads few or none: the others are lit at the pixel.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

#include "render/shared/terms_io.h"

namespace dermis::passes {

/// Fineness of the light maps and of the pixels of a head.
struct MapDetail {
  std::uint32_t side = 0;  ///< T, texels
  /// of the asset, where the head is nearest
  double pixels_per_mm = std::numeric_limits<double>::infinity();
  bool operator==(const MapDetail&) const = default;
};

/// A Gaussian of a profile whose light a map holds.
struct MapTerm {
  glm::vec3 weight{0};
  /// mm of the asset; 0: the light before any blur, for all narrower terms together. Such a one is the last.
  float sigma_mm = 0;
};

/// Data of a head and a frame, not of the plan: render/techniques/mapped_terms.h makes it. A map that is not
/// written is not read, nor multiplied by 0: it may hold anything. By default all terms are mapped.
struct MappedTerms {
  /// Some term is read. false: nothing is lit in texture space, and nothing blurred.
  bool any = true;
  /// The narrowest term that is read, and all after it are.
  std::uint32_t first_read = 0;
  /// The step of blur_steps() with which the chain starts, from the irradiance. It blurs by the variance of
  /// all steps up to it.
  std::uint32_t first_step = 0;
  /// The term of that step. Its map and all after it are written.
  std::uint32_t first_written = 0;

  /// The part of each term that is read from its map; the rest is lit at the pixel. After the mapped terms:
  /// of all narrower ones together, from the light before any blur.
  std::array<float, MOST_TERMS> shares = all_of_each();
  float shown_mm = 0;  ///< of the asset: by how much a pixel averages light, as a sigma
  bool operator==(const MappedTerms&) const = default;

 private:
  static constexpr std::array<float, MOST_TERMS> all_of_each() {
    std::array<float, MOST_TERMS> shares{};
    shares.fill(1);
    return shares;
  }
};

}  // namespace dermis::passes
