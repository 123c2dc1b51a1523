// SPDX-License-Identifier: MIT
#include <cstdint>

#include "base/core/error.h"
#include "base/core/one_line.h"
#include "head/scene/arrays/check.h"

namespace dermis::scene::arrays {

namespace {

void check_image(const std::string& where, const AssetImage& image, int max_side) {
  if (image.width < 1 || image.width > max_side || image.height < 1 || image.height > max_side)
    throw input_error(where, "is {} x {} pixels, expected 1 to {} each way", image.width, image.height,
                      max_side);
  if (image.channels < 1 || image.channels > 4)
    throw input_error(where, "channels must be 1 to 4, got {}", image.channels);

  const std::uint64_t bytes =
      std::uint64_t(image.width) * std::uint64_t(image.height) * std::uint64_t(image.channels);
  if (image.pixels.size() != bytes)
    throw input_error(where, "pixels has {} bytes, expected {} for {} x {} pixels of {} channels",
                      image.pixels.size(), bytes, image.width, image.height, image.channels);
}

}  // namespace

std::string name_of(const AssetArrays& arrays) {
  return arrays.name.empty() ? "asset" : one_line(arrays.name, 200);
}

std::string place_of(const char* kind, std::size_t number, const std::string& name) {
  if (name.empty()) return fmt::format("{} {}", kind, number);
  return fmt::format("{} {} '{}'", kind, number, one_line(name, 80));
}

void check_images(const AssetArrays& arrays, const LoadOptions& options) {
  for (std::size_t i = 0; i < arrays.images.size(); ++i)
    check_image(name_of(arrays) + ": " + place_of("image", i, arrays.images[i].name), arrays.images[i],
                options.max_map_side);
}

}  // namespace dermis::scene::arrays
