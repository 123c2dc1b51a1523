// SPDX-License-Identifier: MIT
#include "head/builtin_head/kept.h"

#include <fmt/format.h>

#include <cstring>
#include <span>
#include <string>

#include "base/core/cache.h"
#include "head/builtin_head/openings.h"

namespace dermis::builtin_head {
namespace {

// The file: a line of text that names code and size, positions, normals and chart of the net's nodes, then
// of each map the channels that it uses.
std::string first_line(int map_size) { return fmt::format("dermis built-in {} {}\n", code_hash(), map_size); }

constexpr std::size_t nodes = std::size_t{Openings::columns + 1} * (Openings::rows + 1);
constexpr std::size_t net_bytes = nodes * (2 * sizeof(vec3) + sizeof(vec2));
constexpr std::size_t channels[] = {3, 3, 2};     // of colour, normal, reflection
constexpr std::uint8_t unused[] = {255, 255, 0};  // the blue of the reflection

template <class MapsOrConst>
auto maps_of(MapsOrConst& maps) {
  return std::array{&maps.colour, &maps.normal, &maps.reflection};
}

std::size_t bytes_of(int map_size) {
  const std::size_t texels = static_cast<std::size_t>(map_size) * static_cast<std::size_t>(map_size);
  return first_line(map_size).size() + net_bytes + texels * (channels[0] + channels[1] + channels[2]);
}

template <class Vector>
bool take(const std::byte*& from, std::vector<Vector>& values) {
  values.resize(nodes);
  std::memcpy(values.data(), from, nodes * sizeof(Vector));
  from += nodes * sizeof(Vector);
  for (const Vector& v : values)
    if (!std::isfinite(glm::dot(v, v))) return false;
  return true;
}

}  // namespace

std::filesystem::path kept_file(const std::filesystem::path& folder, Tone tone, int map_size) {
  if (folder.empty()) return {};
  return folder / fmt::format("built-in-{}-{}-{}.bin", tone_names[static_cast<std::size_t>(tone)], map_size,
                              code_hash());
}

std::optional<Baked> kept(const std::filesystem::path& file, int map_size) {
  const auto bytes = cache::read(file, bytes_of(map_size));
  const std::string line = first_line(map_size);
  if (!bytes || bytes->size() != bytes_of(map_size) ||
      std::memcmp(bytes->data(), line.data(), line.size()) != 0)
    return std::nullopt;
  const std::byte* from = bytes->data() + line.size();

  Baked baked;
  Net& net = baked.net;
  net.columns = Openings::columns;
  net.rows = Openings::rows;
  if (!take(from, net.at_mm) || !take(from, net.normal) || !take(from, net.chart)) return std::nullopt;

  const std::size_t texels = static_cast<std::size_t>(map_size) * static_cast<std::size_t>(map_size);
  for (std::size_t k = 0; image::Image8 * map : maps_of(baked.maps)) {
    map->width = map->height = map_size;
    map->rgba.assign(4 * texels, 255);
    for (std::size_t i = 0; i < texels; ++i) {
      map->rgba[4 * i + 2] = unused[k];
      std::memcpy(&map->rgba[4 * i], from, channels[k]);
      from += channels[k];
    }
    ++k;
  }
  return baked;
}

void keep(const std::filesystem::path& file, const Baked& baked) {
  if (file.empty()) return;
  const int map_size = baked.maps.colour.width;
  const std::string line = first_line(map_size);
  std::vector<std::byte> bytes;
  bytes.reserve(bytes_of(map_size));
  const auto add = [&](std::span<const std::byte> part) {
    bytes.insert(bytes.end(), part.begin(), part.end());
  };
  add(std::as_bytes(std::span(line)));
  add(std::as_bytes(std::span(baked.net.at_mm)));
  add(std::as_bytes(std::span(baked.net.normal)));
  add(std::as_bytes(std::span(baked.net.chart)));

  for (std::size_t k = 0; const image::Image8* map : maps_of(baked.maps)) {
    for (std::size_t i = 0; i < map->rgba.size(); i += 4)
      add(std::as_bytes(std::span(&map->rgba[i], channels[k])));
    ++k;
  }
  cache::write(file, std::move(bytes));
}

}  // namespace dermis::builtin_head
