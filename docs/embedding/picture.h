// SPDX-License-Identifier: MIT
/// Pictures of the samples in files that need no library: linear floats, or eight bits for the eye.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace host {

/// Linear RGB, rows from top to bottom.
struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<float> rgb;
};

/// Returns the colour of texels of R16G16B16A16_SFLOAT.
Picture picture_of_halves(std::uint32_t width, std::uint32_t height, std::span<const std::byte> texels);

// All throw std::runtime_error: a file that cannot be read or written, or holds something else.

void write_ppm(const std::string& path, const Picture& picture);  ///< clamped, sRGB
void write_pfm(const std::string& path, const Picture& picture);  ///< portable float map
Picture read_pfm(const std::string& path);                        ///< as write_pfm() writes it

}  // namespace host
