// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/gtc/packing.hpp>
#include <stdexcept>

namespace host {
namespace {

std::runtime_error file_error(const std::string& path, const char* what) {
  return std::runtime_error(path + ": " + what);
}

void write(const std::string& path, const std::string& header, std::span<const char> bytes) {
  std::ofstream out(path, std::ios::binary);
  out << header;
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) throw file_error(path, "cannot be written");
}

std::uint8_t srgb_of(float linear) {
  const float c = std::clamp(linear, 0.0f, 1.0f);
  const float encoded = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

std::string size_of(const Picture& picture) {
  return std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n";
}

std::size_t row_of(const Picture& picture) { return std::size_t{3} * picture.width; }

}  // namespace

Picture picture_of_halves(std::uint32_t width, std::uint32_t height, std::span<const std::byte> texels) {
  Picture picture{width, height, {}};
  for (std::size_t at = 0; at < texels.size(); at += 8) {
    std::array<std::uint16_t, 3> halves{};
    std::memcpy(halves.data(), &texels[at], sizeof(halves));
    for (const std::uint16_t half : halves) picture.rgb.push_back(glm::unpackHalf1x16(half));
  }
  return picture;
}

void write_ppm(const std::string& path, const Picture& picture) {
  std::vector<char> bytes;
  for (const float value : picture.rgb) bytes.push_back(static_cast<char>(srgb_of(value)));
  write(path, "P6\n" + size_of(picture) + "255\n", bytes);
}

// A negative scale says little-endian; rows go from bottom to top.
void write_pfm(const std::string& path, const Picture& picture) {
  std::vector<char> bytes(picture.rgb.size() * sizeof(float));
  const std::size_t row = row_of(picture);
  for (std::size_t y = 0; y < picture.height; ++y)
    std::memcpy(&bytes[y * row * sizeof(float)], &picture.rgb[(picture.height - 1 - y) * row],
                row * sizeof(float));
  write(path, "PF\n" + size_of(picture) + "-1.0\n", bytes);
}

Picture read_pfm(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string kind, scale;
  Picture picture;
  in >> kind >> picture.width >> picture.height >> scale;
  in.get();
  constexpr std::uint32_t most = 16384;
  if (!in || kind != "PF" || scale != "-1.0" || picture.width - 1 >= most || picture.height - 1 >= most)
    throw file_error(path, "is not a float picture of these samples");

  const std::size_t row = row_of(picture);
  picture.rgb.resize(row * picture.height);
  for (std::size_t y = picture.height; y-- > 0;)
    in.read(reinterpret_cast<char*>(&picture.rgb[y * row]),
            static_cast<std::streamsize>(row * sizeof(float)));
  if (!in) throw file_error(path, "ends too early");
  return picture;
}

}  // namespace host
