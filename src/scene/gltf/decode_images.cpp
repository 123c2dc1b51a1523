// SPDX-License-Identifier: MIT
// Decodes the pictures of a file: headers first, then as large as the budget allows.
#include <condition_variable>
#include <map>
#include <mutex>
#include <new>

#include "core/error.h"
#include "core/hooks.h"
#include "core/one_line.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "scene/gltf/finish.h"
#include "scene/texture_budget.h"

namespace dermis::scene::gltf {

namespace {

// The most that decoders may hold at a time beside the pictures that they return.
constexpr std::uint64_t passing_limit_bytes = 1'000'000'000;

/// What the header of a picture says.
struct Header {
  image::PictureHeader picture;
  std::uint64_t encoded_bytes = 0;
};

std::string place_of(const Document& document, int source) {
  return fmt::format("{}: image '{}'", document.file, one_line(document.images[source].name, 80));
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

}  // namespace

void decode_images(const Document& document, Bytes& bytes, const ImageLimits& limits, Scene& scene) {
  image::DecodeLimits decode;
  decode.max_side = limits.max_side;
  std::vector<MapUse> uses = map_uses(scene);
  std::map<int, Header> headers;  // by source
  for (MapUse& use : uses) {
    const EncodedImage encoded = bytes.image(use.source);
    const image::PictureHeader header =
        image::read_header8(encoded.bytes(), place_of(document, use.source), decode);
    headers[use.source] = {header, encoded.bytes().size()};
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
    const std::string where = place_of(document, use.source);
    const image::Shrink shrink{.halvings = use.halvings, .srgb = use.colour};
    const Pass pass(gate, header.encoded_bytes + image::passing_bytes(header.picture, shrink));
    try {
      const EncodedImage encoded = bytes.image(use.source);
      auto pixels =
          std::make_shared<const image::Image8>(image::decode_image8(encoded.bytes(), where, decode, shrink));
      scene.images[i] = {use.name, std::move(pixels)};
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
