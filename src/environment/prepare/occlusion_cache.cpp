// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <span>

#include "base/core/cache.h"
#include "environment/occlusion.h"
#include "image/colour.h"

namespace dermis::environment {
namespace {

// FNV-1a from two different starts: 128 bits, so that no two heads share a file by chance.
class Hash {
 public:
  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    for (const std::byte b : std::as_bytes(values))
      for (std::uint64_t& h : state_) h = (h ^ static_cast<std::uint64_t>(b)) * 0x100000001B3u;
  }
  template <class T>
  void add(const T& value) {
    add(std::span<const T>(&value, 1));
  }
  const std::array<std::uint64_t, 2>& state() const { return state_; }

 private:
  std::array<std::uint64_t, 2> state_{0xCBF29CE484222325u, 0x9E3779B97F4A7C15u};
};

constexpr std::uint32_t version = 5;  // of bake_occlusion and of the file layout
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31;

// Adds all that decides the alpha test of a primitive.
void add_alpha(Hash& hash, const scene::AssetData& scene, const scene::Primitive& primitive,
               const scene::Material& material) {
  hash.add(material.alpha_cutoff);
  hash.add(material.base_colour.a);
  for (const scene::Vertex& v : primitive.vertices) {
    hash.add(v.uv0);
    hash.add(v.uv1);
    hash.add(v.colour.a);
  }
  const scene::MapRef& map = material.base_colour_map;
  if (!map.present()) return;
  hash.add(map.uv_set);
  hash.add(map.transform);
  hash.add(map.wrap_u);
  hash.add(map.wrap_v);
  hash.add(map.nearest);
  const image::Image8& pixels = *scene.images[static_cast<std::size_t>(map.image)].pixels;
  hash.add(pixels.width);
  hash.add(pixels.height);
  for (std::size_t i = 3; i < pixels.rgba.size(); i += 4) hash.add(pixels.rgba[i]);
}

Hash hash_of(const scene::AssetData& scene, const scene::SkinMesh& mesh, const OcclusionSettings& settings) {
  Hash hash;
  hash.add(version);
  hash.add(settings.side);
  hash.add(settings.rays);
  for (const scene::Vertex& v : mesh.vertices) {
    hash.add(v.position_m);
    hash.add(v.normal);
  }
  hash.add(std::span<const glm::vec2>(mesh.unwrap));
  hash.add(std::span<const std::uint32_t>(mesh.indices));
  hash.add(std::span<const std::uint16_t>(mesh.triangle_chart));
  for (const scene::Primitive& p : scene.primitives) {
    const scene::Material& material = scene.materials[static_cast<std::size_t>(p.material)];
    hash.add(static_cast<int>(material.alpha_mode));
    hash.add(material.skin);
    for (const scene::Vertex& v : p.vertices) hash.add(v.position_m);
    if (material.alpha_mode == AssetAlpha::mask) add_alpha(hash, scene, p, material);
    hash.add(std::span<const std::uint32_t>(p.indices));
    for (const scene::Placement& placement : p.placements) hash.add(placement.world_from_mesh);
  }
  return hash;
}

struct Header {
  char magic[8] = {'d', 'e', 'r', 'm', 'i', 's', 'o', 'c'};
  std::uint64_t hash[2] = {};
  std::uint32_t side = 0, unused = 0;
};

std::vector<std::byte> write(const Occlusion& occlusion, const Hash& hash) {
  Header header;
  header.side = static_cast<std::uint32_t>(occlusion.side);
  header.hash[0] = hash.state()[0];
  header.hash[1] = hash.state()[1];
  const std::size_t values = occlusion.values.size() * 2, transfer = occlusion.transfer.size() * 2,
                    bounced = occlusion.bounced.size() * 2;
  std::vector<std::byte> bytes(sizeof header + values + transfer + bounced);
  std::memcpy(bytes.data(), &header, sizeof header);
  for (std::size_t i = 0; i < occlusion.values.size(); ++i) {
    const std::uint16_t half = image::float_to_half(occlusion.values[i]);
    std::memcpy(bytes.data() + sizeof header + 2 * i, &half, 2);
  }
  std::memcpy(bytes.data() + sizeof header + values, occlusion.transfer.data(), transfer);
  std::memcpy(bytes.data() + sizeof header + values + transfer, occlusion.bounced.data(), bounced);
  return bytes;
}

// Returns the result; empty if the bytes are not what write() made for this hash and size.
Occlusion read(std::span<const std::byte> bytes, const Hash& hash, int side) {
  const std::size_t texels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                    count = 4 * texels, transfer = harmonic_terms * texels, bounced = bounced_terms * texels;

  Header header, expected;
  if (bytes.size() != sizeof header + 2 * (count + transfer + bounced)) return {};
  std::memcpy(&header, bytes.data(), sizeof header);
  if (std::memcmp(header.magic, expected.magic, sizeof header.magic) != 0 ||
      header.side != static_cast<std::uint32_t>(side) || header.hash[0] != hash.state()[0] ||
      header.hash[1] != hash.state()[1])
    return {};

  Occlusion out{.side = side,
                .values = {},
                .transfer = std::vector<std::uint16_t>(transfer),
                .bounced = std::vector<std::uint16_t>(bounced)};
  for (std::size_t i = 0; i < count; ++i) {
    std::uint16_t half = 0;
    std::memcpy(&half, bytes.data() + sizeof header + 2 * i, 2);
    const float value = image::half_to_float(half);
    if (!(value >= -2 && value <= 2)) return {};
    out.values.push_back(value);
  }

  std::memcpy(out.transfer.data(), bytes.data() + sizeof header + 2 * count, 2 * transfer);
  std::memcpy(out.bounced.data(), bytes.data() + sizeof header + 2 * (count + transfer), 2 * bounced);
  for (const auto* values : {&out.transfer, &out.bounced})
    for (const std::uint16_t half : *values)
      if (!(std::abs(image::half_to_float(half)) <= 8)) return {};
  return out;
}

// Rounds as a file does, so that the first picture and later ones are equal to the bit.
void round_to_half(Occlusion& occlusion) {
  for (float& value : occlusion.values) value = image::half_to_float(image::float_to_half(value));
}

}  // namespace

Occlusion cached_occlusion(const scene::AssetData& scene, const scene::SkinMesh& mesh,
                           const std::filesystem::path& folder, const OcclusionSettings& settings) {
  const Hash hash = hash_of(scene, mesh, settings);
  const std::filesystem::path file =
      folder.empty() ? folder : folder / fmt::format("occlusion-{:016x}.bin", hash.state()[0]);
  if (const auto bytes = cache::read(file, most_bytes))
    if (Occlusion found = read(*bytes, hash, settings.side); found.side > 0) return found;

  Occlusion made = bake_occlusion(scene, mesh, settings);
  round_to_half(made);
  if (!file.empty()) cache::write(file, write(made, hash));
  return made;
}

}  // namespace dermis::environment
