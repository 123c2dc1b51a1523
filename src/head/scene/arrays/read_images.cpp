// SPDX-License-Identifier: MIT
#include "head/scene/arrays/read_images.h"

#include <map>
#include <memory>
#include <new>
#include <span>
#include <tuple>
#include <vector>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/parallel.h"
#include "head/scene/arrays/check.h"
#include "head/scene/import/kept_pictures.h"
#include "head/scene/import/texture_budget.h"
#include "image/shrink.h"

namespace dermis::scene::arrays {

namespace {

/// Expands one row to RGBA as a decoder does: grey is copied to R, G and B, a missing alpha is 255.
void expand(const std::uint8_t* from, int width, int channels, std::uint8_t* rgba) {
  const int green = channels < 3 ? 0 : 1, blue = channels < 3 ? 0 : 2;
  const bool alpha = channels == 2 || channels == 4;
  for (int x = 0; x < width; ++x, from += channels, rgba += 4) {
    rgba[0] = from[0];
    rgba[1] = from[green];
    rgba[2] = from[blue];
    rgba[3] = alpha ? from[channels - 1] : std::uint8_t{255};
  }
}

image::Image8 read(const AssetImage& given, const image::Shrink& shrink) {
  image::Shrinking picture(given.width, given.height, shrink);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(given.width) * 4);
  const std::size_t stride = static_cast<std::size_t>(given.width) * static_cast<std::size_t>(given.channels);
  for (int y = 0; y < given.height; ++y) {
    expand(&given.pixels[static_cast<std::size_t>(y) * stride], given.width, given.channels, rgba.data());
    picture.row8(y, rgba.data(), given.width);
    picture.done_to(y);
  }
  return picture.take();
}

/// Points the maps of equal images at the first of them, as for a file.
void merge_equal(const AssetArrays& arrays, AssetData& scene) {
  std::map<std::tuple<int, int, int, PictureKey>, int> known;
  std::map<int, int> first;
  for (const MapUse& use : map_uses(scene)) {
    const AssetImage& image = arrays.images[static_cast<std::size_t>(use.source)];
    if (first.contains(use.source)) continue;
    const auto key =
        std::tuple(image.width, image.height, image.channels, key_of(std::as_bytes(std::span(image.pixels))));
    first[use.source] = known.try_emplace(key, use.source).first->second;
  }
  point_maps_at_first(first, scene);
}

}  // namespace

void read_images(const AssetArrays& arrays, std::uint64_t budget_bytes, AssetData& scene) {
  merge_equal(arrays, scene);
  std::vector<MapUse> uses = map_uses(scene);
  for (MapUse& use : uses) {
    const AssetImage& image = arrays.images[static_cast<std::size_t>(use.source)];
    use.name = image.name;
    use.full_width = image.width;
    use.full_height = image.height;
    use.deep = false;  // arrays have 8 bits
  }
  fit_to_budget(name_of(arrays), budget_bytes, uses);
  const std::vector<const MapUse*> kept = number_images(uses);

  scene.images.resize(kept.size());
  Steps images("reading maps", kept.size());
  parallel_for(kept.size(), [&](std::size_t i) {
    const MapUse& use = *kept[i];
    try {
      auto pixels = std::make_shared<const image::Image8>(
          read(arrays.images[static_cast<std::size_t>(use.source)], use.shrink()));
      scene.images[i] = {use.name, std::move(pixels)};
    } catch (const std::bad_alloc&) {
      throw input_error(
          name_of(arrays) + ": " + place_of("image", static_cast<std::size_t>(use.source), use.name),
          "needs more memory than there is for {} x {} pixels; a smaller texture_budget_mb takes less",
          use.width(), use.height());
    }
    images.done();
  });
  point_maps_at_images(uses, scene);
}

}  // namespace dermis::scene::arrays
