// SPDX-License-Identifier: MIT
// A glTF file after reading: plain structs whose references are resolved and in range (-1 = none). Vertex
// data is not read yet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "head/scene/asset_data.h"
#include "head/scene/gltf/value.h"
#include "head/scene/import/material_source.h"
#include "head/scene/rig/animation.h"

namespace dermis::scene::gltf {

/// The parts of a file: the JSON text and, of a .glb, its binary chunk. Both point into `bytes`.
struct Container {
  std::vector<std::byte> bytes;
  std::string_view json;
  std::optional<std::span<const std::byte>> binary;
};

// `fault`: why an element cannot be used; empty if it can. Only what uses it is refused, or left out.

struct Buffer {
  std::uint64_t byte_length = 0;
  std::optional<std::string> uri;
  bool is_chunk = false;  ///< the binary chunk of the .glb
  bool fallback = false;  ///< EXT_meshopt_compression: has no bytes, its views are compressed elsewhere
};

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };
struct MeshoptView {
  int buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0, count = 0;
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;
};
struct BufferView {
  int buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0;  ///< bytes, 0 = packed
  std::optional<MeshoptView> meshopt;
  std::string fault{};
};

enum class Component : std::uint16_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};
std::uint64_t size_of(Component component);  ///< bytes
const char* name_of(Component component);

struct Sparse {
  std::uint64_t count = 0;
  int indices_view = 0, values_view = 0;
  std::uint64_t indices_offset = 0, values_offset = 0;
  Component indices_component = Component::uint32;
};
struct Accessor {
  int view = -1;  ///< -1: zeros (or Draco)
  std::uint64_t offset = 0, count = 0;
  Component component = Component::float32;
  bool normalized = false;
  int columns = 1, rows = 1;  ///< VEC3: 1 x 3, MAT4: 4 x 4
  std::optional<Sparse> sparse;
  std::string place;  ///< for messages
  std::string fault;
  int components() const { return columns * rows; }
};

struct ImageSource {
  std::string name;  ///< for messages
  std::optional<std::string> uri;
  int view = -1;
  std::string fault{};
};
struct Texture {
  int image = -1;  ///< -1: only an extension that is not read has one
  AssetWrap wrap_u = AssetWrap::repeat, wrap_v = AssetWrap::repeat;
  bool nearest = false;
};

/// from one column to the next
std::uint64_t column_bytes(const Accessor& accessor);
/// of one element, without padding at its end
std::uint64_t element_bytes(const Accessor& accessor);
/// from one element to the next
std::uint64_t stride_bytes(const Accessor& accessor, const BufferView& view);

using Attributes = std::map<std::string, int>;  ///< semantic -> accessor
struct DracoData {
  int view = 0;
  std::map<std::string, std::uint32_t> attributes;  ///< semantic -> id in the compressed data
};
struct MeshPrimitive {
  int mode = 4;
  int material = -1;
  int indices = -1;
  Attributes attributes;
  std::vector<Attributes> targets;
  std::optional<DracoData> draco;
  std::string place;
  std::string fault;
  std::string joints_fault;  ///< of its joints and weights: counts where the node has a skin
};
struct Mesh {
  std::string name;
  std::vector<MeshPrimitive> primitives;
  std::vector<double> weights;
  std::vector<std::string> target_names;  ///< extras.targetNames; empty: it has none that can be used
  std::size_t targets = 0;                ///< morph targets of the primitive that has most
  std::string fault;                      ///< of its list of primitives
};

struct Node {
  std::string name;
  glm::dmat4 local{1};
  std::optional<Transform> transform = Transform{};  ///< the parts of `local`; none: the file has a matrix
  int mesh = -1, skin = -1, camera = -1, light = -1;
  int parent = -1;
  std::vector<int> children;
  std::vector<double> weights;
  bool visible = true;  ///< with all below it
  std::string place;
  std::string fault;       ///< of its place: counts where something is shown below it
  std::string mesh_fault;  ///< of the numbers of its mesh and skin: counts where it is shown
};
struct Skin {
  int inverse_bind = -1;    ///< accessor
  std::vector<int> joints;  ///< -1: a node that is not there, on which nothing may hang
  std::string fault;
};

/// An animation whose key frames are not read yet.
struct AnimationSource {
  struct Sampler {
    int input = 0, output = 0;  ///< accessors
    Interpolation interpolation = Interpolation::linear;
  };
  struct Channel {
    int sampler = 0;
    int node = -1;                     ///< -1: of an extension
    std::optional<AnimatedPath> path;  ///< none: likewise
  };
  std::string name{};  ///< its number in the file if it has none
  std::vector<Sampler> samplers{};
  std::vector<Channel> channels{};
  std::string fault{};
};

struct Document {
  std::string file;              ///< for messages
  std::filesystem::path folder;  ///< external files are relative to it
  bool quantized = false;        ///< KHR_mesh_quantization is used
  std::vector<Buffer> buffers;
  std::vector<BufferView> views;
  std::vector<Accessor> accessors;
  std::vector<ImageSource> images;
  std::vector<Texture> textures;
  /// images of maps are indices into `images`; says_skin is extras.dermis: its `skin`, or true if it does
  /// not say
  std::vector<MaterialSource> materials;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Skin> skins;
  std::vector<AnimationSource> animations;
  std::vector<std::optional<Camera>> cameras;  ///< without a place in the world; none: it cannot be used
  std::vector<std::optional<Light>> lights;    ///< likewise
  std::vector<int> roots;                      ///< of the scene that is shown
};

/// Splits a .glb or .gltf. InputError: chunk framing, empty parts.
Container open_container(const std::filesystem::path& path);

/// Reads and checks the whole JSON. Warns of what is drawn although it differs from the specification.
/// InputError: version, required extensions, loops, what no picture can do without.
Document read_document(const Value& root, const Container& container, const std::filesystem::path& path);

/// Returns the nodes that are in no loop, parents first.
std::vector<int> parents_first(const Document& document);

// The parts of read_document, one file each.
void read_header(Document& document, const Value& root);
void read_buffers(Document& document, const Value& root, bool has_binary);
void read_accessors(Document& document, const Value& root);
void read_textures(Document& document, const Value& root);
void read_materials(Document& document, const Value& root);
void read_meshes(Document& document, const Value& root);
void read_nodes(Document& document, const Value& root);
void read_cameras(Document& document, const Value& root);
void read_lights(Document& document, const Value& root);
void read_animations(Document& document, const Value& root);

/// `weights` of a mesh or a node: one for each morph target, or none.
std::vector<double> read_weights(const Value& value, std::size_t targets);
/// A textureInfo object (index, texCoord, KHR_texture_transform, and `scale_key` if not null) as a map.
MapRef read_texture_info(const Document& document, const Value& info, const char* scale_key = nullptr);
/// The map of a texture with given coordinates' set and transform.
MapRef map_of_texture(const Document& document, int texture, const Value& where);
/// extras.dermis of a material. `shared` gives coordinates to maps that are named by number only.
void read_dermis_extras(const Document& document, const Value& extras, const MapRef& shared,
                        MaterialSource& into);

}  // namespace dermis::scene::gltf
