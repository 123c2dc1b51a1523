// SPDX-License-Identifier: MIT
// Reads meshes: the accessors of each primitive; checks that their formats and counts agree.
#include <algorithm>

#include "scene/gltf/document.h"

namespace dermis::scene::gltf {

namespace {

/// A set of component types, normalised or plain.
struct Formats {
  bool float32 = false;
  bool int8_plain = false, int8_norm = false, uint8_plain = false, uint8_norm = false;
  bool int16_plain = false, int16_norm = false, uint16_plain = false, uint16_norm = false;

  bool holds(const Accessor& a) const {
    switch (a.component) {
      case Component::float32: return float32;
      case Component::int8: return a.normalized ? int8_norm : int8_plain;
      case Component::uint8: return a.normalized ? uint8_norm : uint8_plain;
      case Component::int16: return a.normalized ? int16_norm : int16_plain;
      case Component::uint16: return a.normalized ? uint16_norm : uint16_plain;
      default: return false;
    }
  }
};

constexpr Formats floats{.float32 = true};
constexpr Formats unit_values{.float32 = true, .uint8_norm = true, .uint16_norm = true};
constexpr Formats joint_numbers{.uint8_plain = true, .uint16_plain = true};
constexpr Formats quantized_vectors{.float32 = true, .int8_norm = true, .int16_norm = true};
constexpr Formats quantized_any{true, true, true, true, true, true, true, true, true};
constexpr Formats quantized_deltas{
    .float32 = true, .int8_plain = true, .int8_norm = true, .int16_plain = true, .int16_norm = true};

struct Rule {
  Formats formats;
  int least, most;  ///< components
};

/// Returns what glTF (and KHR_mesh_quantization) allow for an attribute; nothing if we do not read it.
std::optional<Rule> rule_for(const std::string& semantic, bool quantized) {
  if (semantic == "POSITION") return Rule{quantized ? quantized_any : floats, 3, 3};
  if (semantic == "NORMAL") return Rule{quantized ? quantized_vectors : floats, 3, 3};
  if (semantic == "TANGENT") return Rule{quantized ? quantized_vectors : floats, 4, 4};
  if (semantic == "TEXCOORD_0" || semantic == "TEXCOORD_1")
    return Rule{quantized ? quantized_any : unit_values, 2, 2};
  if (semantic == "COLOR_0") return Rule{unit_values, 3, 4};
  if (semantic == "JOINTS_0" || semantic == "JOINTS_1") return Rule{joint_numbers, 4, 4};
  if (semantic == "WEIGHTS_0" || semantic == "WEIGHTS_1") return Rule{unit_values, 4, 4};
  return std::nullopt;
}

std::optional<Rule> target_rule(const std::string& semantic, bool quantized) {
  if (semantic == "POSITION") return Rule{quantized ? quantized_deltas : floats, 3, 3};
  if (semantic == "NORMAL" || semantic == "TANGENT")
    return Rule{quantized ? quantized_vectors : floats, 3, 3};
  return std::nullopt;
}

void check_format(const Value& where, const std::string& semantic, const Accessor& a, const Rule& rule) {
  const bool shape = a.columns == 1 && a.rows >= rule.least && a.rows <= rule.most;
  if (shape && rule.formats.holds(a)) return;
  where.fail("{} cannot be made of {} x {}{} ({})", semantic.substr(0, 40), a.components(),
             a.normalized ? "normalized " : "", name_of(a.component), a.place);
}

Attributes read_attributes(const Document& document, const Value& value) {
  Attributes attributes;
  for (const std::string& semantic : value.keys()) {
    attributes[semantic] = value.index(semantic.c_str(), document.accessors.size(), "accessor");
  }
  return attributes;
}

void check_attributes(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  std::uint64_t count = 0;
  const auto position = primitive.attributes.find("POSITION");
  if (position != primitive.attributes.end()) count = document.accessors[position->second].count;

  for (const auto& [semantic, index] : primitive.attributes) {
    const Accessor& accessor = document.accessors[index];
    if (count == 0) count = accessor.count;
    if (accessor.count != count)
      value.fail("{} has {} elements, others have {}", semantic.substr(0, 40), accessor.count, count);
    if (const auto rule = rule_for(semantic, document.quantized))
      check_format(value, semantic, accessor, *rule);
  }

  for (const char* set : {"0", "1"}) {
    const bool joints = primitive.attributes.contains(std::string("JOINTS_") + set);
    const bool weights = primitive.attributes.contains(std::string("WEIGHTS_") + set);
    if (joints != weights)
      value.fail("has {}_{} without {}_{}", joints ? "JOINTS" : "WEIGHTS", set, joints ? "WEIGHTS" : "JOINTS",
                 set);
  }
}

Attributes read_target(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  Attributes target = read_attributes(document, value);
  for (const auto& [semantic, index] : target) {
    const std::optional<Rule> rule = target_rule(semantic, document.quantized);
    const auto base = primitive.attributes.find(semantic);
    // Morphed texture coordinates and colours are ignored.
    if (!rule) continue;
    if (base == primitive.attributes.end())
      value.fail("morphs {}, which the primitive does not have", semantic);
    const Accessor& accessor = document.accessors[index];
    check_format(value, semantic, accessor, *rule);
    const std::uint64_t expected = document.accessors[base->second].count;
    if (accessor.count != expected)
      value.fail("{} has {} elements, the primitive {}", semantic, accessor.count, expected);
  }
  return target;
}

DracoData read_draco(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  DracoData draco;
  draco.view = value.index("bufferView", document.views.size(), "bufferView");
  const Value attributes = value.at("attributes");
  for (const std::string& semantic : attributes.keys()) {
    draco.attributes[semantic] = static_cast<std::uint32_t>(attributes.at(semantic).count(0, 0xFFFFFFFF));
    if (!primitive.attributes.contains(semantic))
      attributes.fail("{} is not an attribute of the primitive", semantic.substr(0, 40));
  }
  if (!draco.attributes.contains("POSITION")) attributes.fail("'POSITION' is missing");
  return draco;
}

void check_indices(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  if (primitive.indices < 0) return;
  const Accessor& a = document.accessors[primitive.indices];
  const bool integer =
      a.component == Component::uint8 || a.component == Component::uint16 || a.component == Component::uint32;
  if (a.components() != 1 || !integer || a.normalized)
    value.fail("indices cannot be {} x {} ({})", a.components(), name_of(a.component), a.place);
  if (a.view >= 0 && document.views[a.view].stride != 0)
    value.fail("the bufferView of the indices has a byteStride");
  if (a.view < 0 && !primitive.draco) value.fail("the indices' accessor has no bufferView");
}

MeshPrimitive read_primitive(const Document& document, const Value& value) {
  MeshPrimitive primitive;
  primitive.place = value.place();
  primitive.mode = static_cast<int>(value.count_or("mode", 4, 0, 6));
  primitive.material = value.index_or_none("material", document.materials.size(), "material");
  primitive.indices = value.index_or_none("indices", document.accessors.size(), "accessor");
  const Value attributes = value.at("attributes");
  if (attributes.keys().empty()) attributes.fail("is empty");
  primitive.attributes = read_attributes(document, attributes);
  check_attributes(document, value, primitive);
  if (const auto draco = extension(value, "KHR_draco_mesh_compression"))
    primitive.draco = read_draco(document, *draco, primitive);
  check_indices(document, value, primitive);
  value.for_each("targets", [&](const Value& target) {
    primitive.targets.push_back(read_target(document, target, primitive));
  });
  return primitive;
}

// A convention of the glTF specification (3.7.2.2), not a rule: what is no list of names is left alone.
std::vector<std::string> read_target_names(const Value& mesh, std::size_t targets) {
  const auto extras = mesh.find("extras");
  if (!extras || !extras->is_object()) return {};
  const auto list = extras->find("targetNames");
  if (!list || !list->is_array() || list->array_size(0) != targets) return {};

  std::vector<std::string> names;
  for (std::size_t i = 0; i < targets; ++i) {
    if (!list->element(i).is_text()) return {};
    names.push_back(list->element(i).text());
  }
  return names;
}

}  // namespace

void read_meshes(Document& document, const Value& root) {
  root.for_each("meshes", [&](const Value& value) {
    Mesh mesh;
    mesh.name = value.text_or("name", value.place());
    value.at("primitives");
    value.for_each("primitives", [&](const Value& primitive) {
      mesh.primitives.push_back(read_primitive(document, primitive));
      const std::size_t first = mesh.primitives.front().targets.size(),
                        here = mesh.primitives.back().targets.size();
      if (here != first) primitive.fail("has {} morph targets, the mesh's first primitive {}", here, first);
    });
    mesh.weights = value.numbers("weights", 0);
    const std::size_t targets = mesh.primitives.front().targets.size();
    if (!mesh.weights.empty() && mesh.weights.size() != targets)
      value.fail("has {} weights for {} morph targets", mesh.weights.size(), targets);
    mesh.target_names = read_target_names(value, targets);
    document.meshes.push_back(std::move(mesh));
  });
}

}  // namespace dermis::scene::gltf
