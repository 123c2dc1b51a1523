// SPDX-License-Identifier: MIT
// Decodes the pictures of a file: headers first, then as large as the budget allows.
#include <condition_variable>
#include <map>
#include <mutex>
#include <new>
#include <string>
#include <tuple>

#include "core/error.h"
#include "core/hooks.h"
#include "core/one_line.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "scene/gltf/finish.h"
#include "scene/kept_pictures.h"
#include "scene/texture_budget.h"

namespace dermis::scene::gltf {

namespace {

// The most that decoders may hold at a time beside the pictures that they return.
constexpr std::uint64_t passing_limit_bytes = 1'000'000'000;

/// What is known of a picture before it is decoded.
struct Header {
  image::PictureHeader picture;
  PictureKey key;
};

std::string name_of(const Document& document, int source) {
  return fmt::format("{}: image '{}'", document.file, one_line(document.images[source].name, 80));
}

/// Where a picture lies: a uri, or a part of a buffer.
using ImagePlace = std::tuple<std::string, int, std::uint64_t, std::uint64_t>;
ImagePlace place_of(const Document& document, int source) {
  const ImageSource& image = document.images[source];
  if (image.view < 0) return {*image.uri, -1, 0, 0};
  const BufferView& view = document.views[image.view];
  if (view.meshopt) return {"", -1 - image.view, 0, 0};
  return {"", view.buffer, view.offset, view.length};
}

/// Admits threads while the bytes that they hold together are within the limit; always admits one alone.
class Gate {
 public:
  void enter(std::uint64_t bytes) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return held_ == 0 || held_ + bytes <= passing_limit_bytes; });
    held_ += bytes;
  }
  void leave(std::uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    held_ -= bytes;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t held_ = 0;
};

/// Holds a share of the gate and returns it at the end of its scope.
class Pass {
 public:
  Pass(Gate& gate, std::uint64_t bytes) : gate_(gate), bytes_(bytes) { gate_.enter(bytes_); }
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;
  ~Pass() { gate_.leave(bytes_); }

 private:
  Gate& gate_;
  std::uint64_t bytes_;
};

/// Reads the headers of all pictures that materials use, and points the maps of equal pictures at the first
/// of them: exporters write an image for each texture.
std::map<int, Header> read_headers(const Document& document, Bytes& bytes, const image::DecodeLimits& limits,
                                   Scene& scene) {
  std::map<int, Header> headers;
  std::map<PictureKey, int> by_bytes;
  std::map<ImagePlace, int> by_place;  // what is named twice is read once
  std::map<int, int> first;
  for (const MapUse& use : map_uses(scene)) {
    if (first.contains(use.source)) continue;
    const auto [place, is_new] = by_place.try_emplace(place_of(document, use.source), use.source);
    if (is_new) {
      const EncodedImage encoded = bytes.image(use.source);
      const PictureKey key = key_of(encoded.bytes());
      const auto [same, is_first] = by_bytes.try_emplace(key, use.source);
      place->second = same->second;
      if (is_first)
        headers[use.source] = {image::read_header8(encoded.bytes(), name_of(document, use.source), limits),
                               key};
    }
    first[use.source] = place->second;
  }

  point_maps_at_first(first, scene);
  return headers;
}

}  // namespace

void decode_images(const Document& document, Bytes& bytes, const ImageLimits& limits, Scene& scene) {
  image::DecodeLimits decode;
  decode.max_side = limits.max_side;
  const std::map<int, Header> headers = read_headers(document, bytes, decode, scene);
  std::vector<MapUse> uses = map_uses(scene);
  for (MapUse& use : uses) {
    const image::PictureHeader& header = headers.at(use.source).picture;
    use.name = document.images[use.source].name;
    use.full_width = header.width;
    use.full_height = header.height;
  }
  fit_to_budget(document.file, limits.budget_bytes, uses);
  const std::vector<const MapUse*> decoded = number_images(uses);

  Gate gate;
  scene.images.resize(decoded.size());
  Steps images("reading maps", decoded.size());
  parallel_for(decoded.size(), [&](std::size_t i) {
    const MapUse& use = *decoded[i];
    const Header& header = headers.at(use.source);
    const std::string where = name_of(document, use.source);
    const image::Shrink shrink{.halvings = use.halvings, .srgb = use.colour};
    try {
      scene.images[i] = {use.name, kept_picture(header.key, shrink, [&] {
                           const Pass pass(gate,
                                           header.key.bytes + image::passing_bytes(header.picture, shrink));
                           const EncodedImage encoded = bytes.image(use.source);
                           return image::decode_image8(encoded.bytes(), where, decode, shrink);
                         })};
    } catch (const std::bad_alloc&) {
      throw input_error(
          where, "needs more memory than there is for {} x {} pixels; a smaller texture_budget_mb takes less",
          use.width(), use.height());
    }
    images.done();
  });
  point_maps_at_images(uses, scene);
}

}  // namespace dermis::scene::gltf
