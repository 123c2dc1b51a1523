// SPDX-License-Identifier: MIT
// KHR_draco_mesh_compression. The library checks its input but takes as much memory as the header claims, so
// the header is compared with the primitive's accessors first.
#include <cstring>

// The library's headers do not pass our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <draco/compression/decode.h>
#include <draco/mesh/mesh.h>
#pragma GCC diagnostic pop

#include "base/core/hooks.h"
#include "head/scene/gltf/mesh.h"

namespace dermis::scene::gltf {

namespace {

struct Damaged {};  // thrown by the header reader

/// Reads what the header and the connectivity header claim; Draco bitstream specification, sections 2 and 3.
class HeaderReader {
 public:
  explicit HeaderReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  struct Claim {
    std::uint64_t faces = 0;
    bool known = false;  ///< false: an older bitstream, whose counts stand elsewhere
  };
  Claim read() {
    if (std::memcmp(take(5).data(), "DRACO", 5) != 0) throw Damaged{};
    const unsigned major = byte(), minor = byte();
    const unsigned encoder = byte(), method = byte();
    const unsigned flags = byte() | byte() << 8;
    if (encoder != 1) throw Damaged{};  // 1: triangular mesh
    if (major < 2 || (major == 2 && minor < 2)) return {};
    if ((flags & 0x8000u) != 0) skip_metadata();
    if (method == 1) {  // edgebreaker: traversal type, vertices, faces
      byte();
      varint();
    }
    return {varint(), true};
  }

 private:
  std::span<const std::byte> take(std::uint64_t size) {
    if (size > bytes_.size() - at_) throw Damaged{};
    const auto part = bytes_.subspan(at_, size);
    at_ += size;
    return part;
  }
  unsigned byte() { return std::to_integer<unsigned>(take(1)[0]); }
  std::uint64_t varint() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const unsigned b = byte();
      value |= std::uint64_t{b & 0x7Fu} << shift;
      if ((b & 0x80u) == 0) return value;
    }
    throw Damaged{};
  }
  void skip_metadata() {
    for (std::uint64_t attributes = varint(); attributes > 0; --attributes) {
      varint();
      skip_metadata_element(0);
    }
    skip_metadata_element(0);
  }
  void skip_metadata_element(int depth) {
    if (depth > 16) throw Damaged{};
    for (std::uint64_t entries = varint(); entries > 0; --entries) {
      take(byte());    // key
      take(varint());  // value
    }
    for (std::uint64_t children = varint(); children > 0; --children) {
      take(byte());  // name
      skip_metadata_element(depth + 1);
    }
  }
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

constexpr std::uint64_t max_faces_per_byte = 256, free_faces = 4096;

void check_claim(std::span<const std::byte> compressed, std::uint64_t faces, const std::string& where) {
  try {
    const HeaderReader::Claim claim = HeaderReader(compressed).read();
    if (claim.known && claim.faces != faces)
      throw input_error(where, "the Draco data holds {} triangles, the accessor of the indices says {}",
                        claim.faces, faces);
    if (faces > compressed.size() * max_faces_per_byte + free_faces)
      throw input_error(where, "{} bytes of Draco data cannot hold {} triangles", compressed.size(), faces);
  } catch (const Damaged&) { throw input_error(where, "the Draco data is damaged"); }
}

std::vector<float> read_attribute(const draco::Mesh& mesh, std::uint32_t id, const Accessor& accessor,
                                  const std::string& where) {
  const draco::PointAttribute* stored = mesh.GetAttributeByUniqueId(id);
  if (stored == nullptr) throw input_error(where, "the Draco data has no attribute {}", id);

  const int components = accessor.components();
  if (stored->num_components() != components)
    throw input_error(where, "Draco attribute {} has {} components, the accessor {}", id,
                      static_cast<int>(stored->num_components()), components);

  // We use the accessor's "normalized", not the one in the compressed data.
  draco::GeometryAttribute attribute = *stored;
  attribute.set_normalized(accessor.normalized);
  std::vector<float> out(std::size_t{mesh.num_points()} * components);
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex value = stored->mapped_index(point);
    float* to = out.data() + std::size_t{point.value()} * components;
    if (value.value() >= stored->size() ||
        !attribute.ConvertValue<float>(value, static_cast<std::int8_t>(components), to))
      throw input_error(where, "the Draco data is damaged: attribute {} has no value for vertex {}", id,
                        point.value());
  }
  return out;
}

}  // namespace

DracoMesh decode_draco(const Document& document, Bytes& bytes, const MeshPrimitive& primitive) {
  const std::string where = fmt::format("{}: {}", document.file, primitive.place);
  if (primitive.indices < 0) throw input_error(where, "Draco compression needs an accessor for the indices");
  const std::uint64_t corners = document.accessors[primitive.indices].count;
  const std::span<const std::byte> compressed = bytes.view(primitive.draco->view);
  check_claim(compressed, corners / 3, where);

  Steps steps("decoding", 2 + primitive.draco->attributes.size());
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(compressed.data()), compressed.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    throw input_error(where, "the Draco data is damaged: {}", decoded.status().error_msg_string());
  const draco::Mesh& mesh = *decoded.value();
  steps.done();

  DracoMesh out;
  out.vertices = mesh.num_points();
  if (out.vertices != claimed_vertices(document, primitive) || std::uint64_t{mesh.num_faces()} * 3 != corners)
    throw input_error(where, "the Draco data holds {} vertices and {} triangles, the accessors say {} and {}",
                      out.vertices, mesh.num_faces(), claimed_vertices(document, primitive), corners / 3);

  for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
    for (int corner = 0; corner < 3; ++corner) out.indices.push_back(mesh.face(face)[corner].value());
  steps.done();

  for (const auto& [semantic, id] : primitive.draco->attributes) {
    out.attributes[semantic] =
        read_attribute(mesh, id, document.accessors[primitive.attributes.at(semantic)], where);
    steps.done();
  }
  return out;
}

}  // namespace dermis::scene::gltf
