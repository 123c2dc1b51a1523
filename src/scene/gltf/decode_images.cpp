// SPDX-License-Identifier: MIT
// Decodes the pictures of a file: headers first, then as large as the budget allows.
#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <new>
#include <queue>

#include "core/error.h"
#include "core/hooks.h"
#include "core/log.h"
#include "core/one_line.h"
#include "core/parallel.h"
#include "image/codec.h"
#include "image/shrink.h"
#include "scene/gltf/finish.h"

namespace dermis::scene::gltf {

namespace {

// The most that decoders may hold at a time beside the pictures that they return.
constexpr std::uint64_t passing_limit_bytes = 1'000'000'000;

/// Calls body(map, colour) for every map of a material; the only list of them.
template <class Body>
void for_each_map(Material& m, const Body& body) {
  for (MapRef* map : {&m.base_colour_map, &m.emissive_map, &m.specular_colour_map})
    if (map->present()) body(*map, true);
  for (MapRef* map : {&m.metallic_roughness_map, &m.normal_map, &m.occlusion_map, &m.specular_map})
    if (map->present()) body(*map, false);
  for (MapRef* map : {&m.skin_settings.specular, &m.skin_settings.roughness, &m.skin_settings.displacement})
    if (map->present()) body(*map, false);
}

/// One use of a picture of the file.
struct Use {
  int source = 0;  ///< index into Document::images
  bool colour = false;
  image::PictureHeader header;
  std::uint64_t encoded_bytes = 0;
  int halvings = 0;
  int image = -1;  ///< index into Scene::images

  std::pair<int, bool> key() const { return {source, colour}; }
  int width() const { return image::halved(header.width, halvings); }
  int height() const { return image::halved(header.height, halvings); }
  std::uint64_t bytes() const { return map_bytes(width(), height(), colour); }
  std::uint64_t passing_bytes() const {
    return encoded_bytes + image::passing_bytes(header, {.halvings = halvings});
  }
};

std::string place_of(const Document& document, int source) {
  return fmt::format("{}: image '{}'", document.file, one_line(document.images[source].name, 80));
}

/// Returns each pair of a picture and its use (colour or data) once, in the order of the file.
std::vector<Use> uses_of(Scene& scene) {
  std::map<std::pair<int, bool>, bool> found;
  for (Material& m : scene.materials)
    for_each_map(m, [&](const MapRef& map, bool colour) { found[{map.image, colour}] = true; });
  std::vector<Use> uses;
  for (const auto& [key, used] : found) uses.push_back({.source = key.first, .colour = key.second});
  return uses;
}

/// Halves the largest map (the first of equal ones) until all are within the budget.
void fit(const Document& document, std::uint64_t budget_bytes, std::vector<Use>& uses) {
  std::uint64_t wanted = 0;
  std::priority_queue<std::pair<std::uint64_t, std::size_t>> largest;  // bytes, uses from the end
  for (std::size_t i = 0; i < uses.size(); ++i) {
    wanted += uses[i].bytes();
    largest.emplace(uses[i].bytes(), uses.size() - i);
  }
  for (std::uint64_t sum = wanted; sum > budget_bytes;) {
    const auto [bytes, from_end] = largest.top();
    largest.pop();
    Use& use = uses[uses.size() - from_end];
    if (use.width() == 1 && use.height() == 1)
      throw input_error(document.file, "its {} maps do not fit into the texture budget of {} bytes",
                        uses.size(), budget_bytes);
    ++use.halvings;
    sum -= bytes - use.bytes();
    largest.emplace(use.bytes(), from_end);
  }

  constexpr std::size_t named = 3;
  std::vector<std::string> lines;
  std::size_t halved = 0;
  for (const Use& use : uses) {
    if (use.halvings == 0 || ++halved > named) continue;
    const std::string& name = document.images[use.source].name;
    lines.push_back(fmt::format("'{}' is {} x {} pixels, read as {} x {}", one_line(name, 80),
                                use.header.width, use.header.height, use.width(), use.height()));
  }
  if (halved > named) lines.push_back(fmt::format("and {} more", halved - named));
  if (halved > 0)
    note("{}: its maps would take {} MB, the texture budget is {} MB (texture_budget_mb): {}", document.file,
         wanted / 1'000'000, budget_bytes / 1'000'000, fmt::join(lines, "; "));
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

std::uint64_t map_bytes(int width, int height, bool colour) {
  const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  return pixels * 4 + pixels * (colour ? 8 : 4) * 4 / 3;
}

void decode_images(const Document& document, Bytes& bytes, const ImageLimits& limits, Scene& scene) {
  image::DecodeLimits decode;
  decode.max_side = limits.max_side;
  std::vector<Use> uses = uses_of(scene);
  for (Use& use : uses) {
    const EncodedImage encoded = bytes.image(use.source);
    use.header = image::read_header8(encoded.bytes(), place_of(document, use.source), decode);
    use.encoded_bytes = encoded.bytes().size();
  }
  fit(document, limits.budget_bytes, uses);

  // A picture of full size serves both as colour and as data; averages of a halved one differ.
  std::vector<const Use*> decoded;
  for (Use& use : uses) {
    const bool same = !decoded.empty() && decoded.back()->source == use.source &&
                      decoded.back()->halvings == 0 && use.halvings == 0;
    if (!same) decoded.push_back(&use);
    use.image = static_cast<int>(decoded.size()) - 1;
  }

  Gate gate;
  scene.images.resize(decoded.size());
  Steps images("reading maps", decoded.size());
  parallel_for(decoded.size(), [&](std::size_t i) {
    const Use& use = *decoded[i];
    const std::string where = place_of(document, use.source);
    const Pass pass(gate, use.passing_bytes());
    try {
      const EncodedImage encoded = bytes.image(use.source);
      auto pixels = std::make_shared<const image::Image8>(image::decode_image8(
          encoded.bytes(), where, decode, {.halvings = use.halvings, .srgb = use.colour}));
      scene.images[i] = {document.images[use.source].name, std::move(pixels)};
    } catch (const std::bad_alloc&) {
      throw input_error(
          where, "needs more memory than there is for {} x {} pixels; a smaller texture_budget_mb takes less",
          use.width(), use.height());
    }
    images.done();
  });
  for (Material& m : scene.materials)
    for_each_map(m, [&](MapRef& map, bool colour) {
      const auto use = std::ranges::lower_bound(uses, std::pair(map.image, colour), {}, &Use::key);
      map.image = use->image;
    });
}

}  // namespace dermis::scene::gltf
