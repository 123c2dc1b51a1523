// SPDX-License-Identifier: MIT
// Decodes the pictures of a file: headers first, then as large as the budget allows.
#include <condition_variable>
#include <map>
#include <mutex>
#include <new>
#include <set>
#include <string>
#include <tuple>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/one_line.h"
#include "base/core/parallel.h"
#include "head/scene/gltf/finish.h"
#include "head/scene/gltf/lenient.h"
#include "head/scene/import/kept_pictures.h"
#include "head/scene/import/texture_budget.h"
#include "image/codec.h"

namespace dermis::scene::gltf {

namespace {

// The most that decoders may hold at a time beside the pictures that they return.
constexpr std::uint64_t passing_limit_bytes = 1'000'000'000;

/// A picture before it is decoded.
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
  if (!image.fault.empty()) return {image.fault, -1, 0, 0};
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

/// Returns the pictures that skin cannot do without: its colour, and what extras.dermis names.
std::set<int> needed_pictures(const AssetData& scene) {
  std::set<int> needed;
  for (const Material& m : scene.materials) {
    if (!m.skin) continue;
    const SkinMaterial& skin = m.skin_settings;
    for (const MapRef* map :
         {&m.base_colour_map, &skin.specular, &skin.roughness, &skin.displacement, &skin.detail})
      if (map->present()) needed.insert(map->image);
  }
  return needed;
}

/// Warns of a picture that cannot be read, and that nothing needs. Else throws InputError.
void leave_out(const Document& document, int source, bool needed, const std::string& fault) {
  if (needed) check_fault(fault);
  warn_of_fault(document.file, "pictures that cannot be read are left out", document.images[source].name,
                fault, "the maps that it is for are left out");
}

/// The pictures of a scene, each once.
struct Pictures {
  std::map<int, Header> headers;  ///< by source
  std::set<int> needed;           ///< sources
};

/// Reads the headers of all pictures that materials use, and points the maps of equal pictures at the first
/// of them: exporters write an image for each texture.
Pictures read_headers(const Document& document, Bytes& bytes, const image::DecodeLimits& limits,
                      AssetData& scene) {
  const std::set<int> needed = needed_pictures(scene);
  Pictures pictures;
  std::map<PictureKey, int> by_bytes;
  std::map<ImagePlace, int> by_place;  // pictures named twice are read once
  std::map<int, int> first;
  const auto read = [&](int source) {
    const EncodedImage encoded = bytes.image(source);
    const PictureKey key = key_of(encoded.bytes());
    if (const auto same = by_bytes.find(key); same != by_bytes.end()) return same->second;
    pictures.headers[source] = {image::read_header8(encoded.bytes(), name_of(document, source), limits), key};
    return by_bytes[key] = source;
  };

  for (const MapUse& use : map_uses(scene)) {
    if (first.contains(use.source)) continue;
    const bool is_needed = needed.contains(use.source);
    const auto entry = by_place.try_emplace(place_of(document, use.source), -1);
    int& same = entry.first->second;
    // One that failed where nothing needed it fails again where something does.
    if (entry.second || (same < 0 && is_needed)) {
      const std::string fault = fault_of([&] { same = read(use.source); });
      if (!fault.empty()) leave_out(document, use.source, is_needed, fault);
    }
    first[use.source] = same;
    if (is_needed) pictures.needed.insert(same);
  }
  point_maps_at_first(first, scene);
  return pictures;
}

/// Removes pictures that could not be decoded.
void drop_undecoded(AssetData& scene, std::vector<MapUse>& uses) {
  std::vector<int> number(scene.images.size(), -1);
  std::vector<MapImage> kept;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    if (!scene.images[i].pixels) continue;
    number[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(scene.images[i]));
  }
  scene.images = std::move(kept);
  for (MapUse& use : uses) use.image = number[static_cast<std::size_t>(use.image)];
}

}  // namespace

void decode_images(const Document& document, Bytes& bytes, const ImageLimits& limits, AssetData& scene) {
  image::DecodeLimits decode;
  decode.max_side = limits.max_side;
  const Pictures pictures = read_headers(document, bytes, decode, scene);
  std::vector<MapUse> uses = map_uses(scene);
  for (MapUse& use : uses) {
    const image::PictureHeader& header = pictures.headers.at(use.source).picture;
    use.name = document.images[use.source].name;
    use.full_width = header.width;
    use.full_height = header.height;
    use.deep = use.deep && header.bits == 16;
  }
  fit_to_budget(document.file, limits.budget_bytes, uses);
  const std::vector<const MapUse*> decoded = number_images(uses);

  Gate gate;
  scene.images.resize(decoded.size());
  std::vector<std::string> faults(decoded.size());
  Steps images("reading maps", decoded.size());
  parallel_for(decoded.size(), [&](std::size_t i) {
    const MapUse& use = *decoded[i];
    const Header& header = pictures.headers.at(use.source);
    const std::string where = name_of(document, use.source);
    const image::Shrink shrink = use.shrink();
    const auto decode_picture = [&] {
      const Pass pass(gate, header.key.bytes + image::passing_bytes(header.picture, shrink));
      const EncodedImage encoded = bytes.image(use.source);
      return image::decode_image8(encoded.bytes(), where, decode, shrink);
    };
    try {
      faults[i] = fault_of([&] {
        scene.images[i] = {use.name, kept_picture(header.key, shrink, decode_picture)};
      });
    } catch (const std::bad_alloc&) {
      throw input_error(
          where, "needs more memory than there is for {} x {} pixels; a smaller texture_budget_mb takes less",
          use.width(), use.height());
    }
    images.done();
  });

  for (std::size_t i = 0; i < faults.size(); ++i)
    if (!faults[i].empty())
      leave_out(document, decoded[i]->source, pictures.needed.contains(decoded[i]->source), faults[i]);
  drop_undecoded(scene, uses);
  point_maps_at_images(uses, scene);
}

}  // namespace dermis::scene::gltf
