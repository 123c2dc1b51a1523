// SPDX-License-Identifier: MIT
#include "base/core/error.h"
#include "base/core/file.h"
#include "dermis/renderer.h"
#include "image/codec.h"

namespace dermis {

void Picture::save(const std::filesystem::path& path) const {
  const std::string ending = ending_of(path);
  if (ending == ".png")
    return image::save_png(path, {.width = width, .height = height, .rgba = display_rgba});
  if (ending == ".exr")
    return image::save_exr(path, {.width = width, .height = height, .channels = 4, .values = linear_rgba});
  throw input_error(path.string(), "pictures are written as .png or .exr, not as '{}'", ending);
}

}  // namespace dermis
