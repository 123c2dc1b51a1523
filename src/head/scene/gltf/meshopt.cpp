// SPDX-License-Identifier: MIT
#include <meshoptimizer.h>

#include "head/scene/gltf/bytes.h"

namespace dermis::scene::gltf {

namespace {

// The highest density of the codec: 2 bits for 16 equal bytes. A larger size is false.
constexpr std::uint64_t max_expansion = 256, free_bytes = 65536;

int decode(const MeshoptView& v, std::span<const std::byte> compressed, std::byte* out) {
  const auto* from = reinterpret_cast<const unsigned char*>(compressed.data());
  switch (v.mode) {
    case MeshoptMode::attributes:
      return meshopt_decodeVertexBuffer(out, v.count, v.stride, from, compressed.size());
    case MeshoptMode::triangles:
      return meshopt_decodeIndexBuffer(out, v.count, v.stride, from, compressed.size());
    default: return meshopt_decodeIndexSequence(out, v.count, v.stride, from, compressed.size());
  }
}

}  // namespace

std::vector<std::byte> decode_meshopt(const MeshoptView& v, std::span<const std::byte> compressed,
                                      const std::string& where) {
  const std::uint64_t bytes = v.count * v.stride;
  if (bytes > compressed.size() * max_expansion + free_bytes)
    throw input_error(where, "{} compressed bytes cannot hold {} elements of {} bytes", compressed.size(),
                      v.count, v.stride);
  std::vector<std::byte> out(bytes);
  if (decode(v, compressed, out.data()) != 0) throw input_error(where, "the meshopt data is damaged");
  switch (v.filter) {
    case MeshoptFilter::octahedral: meshopt_decodeFilterOct(out.data(), v.count, v.stride); break;
    case MeshoptFilter::quaternion: meshopt_decodeFilterQuat(out.data(), v.count, v.stride); break;
    case MeshoptFilter::exponential: meshopt_decodeFilterExp(out.data(), v.count, v.stride); break;
    case MeshoptFilter::none: break;
  }
  return out;
}

}  // namespace dermis::scene::gltf
