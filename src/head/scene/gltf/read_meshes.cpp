// SPDX-License-Identifier: MIT
// Reads meshes: the accessors of each primitive; checks that their formats and counts agree.
#include <algorithm>

#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"

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

/// Throws InputError for another shape. Numbers of another type are read all the same.
void check_format(const Value& where, const std::string& semantic, const Accessor& a, const Rule& rule) {
  check_fault(a.fault);
  const bool shape = a.columns == 1 && a.rows >= rule.least && a.rows <= rule.most;
  if (!shape)
    where.fail("{} cannot be made of {} x {}{} ({})", semantic.substr(0, 40), a.components(),
               a.normalized ? "normalized " : "", name_of(a.component), a.place);
  if (!rule.formats.holds(a))
    warn_at(where, fmt::format("{} should not be made of {}{}, and is read all the same", semantic,
                               a.normalized ? "normalized " : "", name_of(a.component)));
}

bool is_of_joints(const std::string& semantic) {
  return semantic.starts_with("JOINTS_") || semantic.starts_with("WEIGHTS_");
}

/// Returns the attributes that can be read; of the others, those that the triangles can do without are left
/// out. Throws InputError for a fault of the positions; that of joints and weights is kept.
template <class Check>
Attributes read_attributes(const Document& document, const Value& value, std::string& joints_fault,
                           const Check& check) {
  Attributes attributes;
  for (const std::string& semantic : value.keys()) {
    int accessor = -1;
    const std::string fault = fault_of([&] {
      accessor = value.index(semantic.c_str(), document.accessors.size(), "accessor");
      check(semantic, document.accessors[static_cast<std::size_t>(accessor)]);
    });
    if (fault.empty())
      attributes[semantic] = accessor;
    else if (semantic == "POSITION")
      check_fault(fault);
    else if (is_of_joints(semantic))
      joints_fault = fault;
    else
      warn_at(value, fmt::format("{} cannot be read, and is left out", semantic.substr(0, 40)));
  }
  return attributes;
}

Attributes read_vertices(const Document& document, const Value& value, std::string& joints_fault) {
  const std::optional<Value> position = value.find("POSITION");
  std::uint64_t count = 0;
  if (position) {
    const int accessor = value.index("POSITION", document.accessors.size(), "accessor");
    count = document.accessors[static_cast<std::size_t>(accessor)].count;
  }

  Attributes attributes =
      read_attributes(document, value, joints_fault, [&](const std::string& semantic, const Accessor& a) {
        const auto rule = rule_for(semantic, document.quantized);
        if (!rule) return;
        check_format(value, semantic, a, *rule);
        if (position && a.count != count)
          value.fail("{} has {} elements, others have {}", semantic.substr(0, 40), a.count, count);
      });
  for (const std::string set : {"0", "1"}) {
    const bool joints = attributes.contains("JOINTS_" + set), weights = attributes.contains("WEIGHTS_" + set);
    if (joints == weights) continue;
    if (joints_fault.empty())
      warn_at(value, fmt::format("has {}_{} without {}_{}, which is left out", joints ? "JOINTS" : "WEIGHTS",
                                 set, joints ? "WEIGHTS" : "JOINTS", set));
    attributes.erase((joints ? "JOINTS_" : "WEIGHTS_") + set);
  }
  return attributes;
}

Attributes read_target(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  Attributes target;
  for (const std::string& semantic : value.keys()) {
    const std::optional<Rule> rule = target_rule(semantic, document.quantized);
    const auto base = primitive.attributes.find(semantic);
    // Morphed texture coordinates and colours are ignored, and directions that are made anew.
    if (!rule || base == primitive.attributes.end()) {
      if (rule) warn_at(value, fmt::format("morphs {}, which the primitive does not have", semantic));
      continue;
    }
    int accessor = -1;
    const std::string fault = fault_of([&] {
      accessor = value.index(semantic.c_str(), document.accessors.size(), "accessor");
      const Accessor& a = document.accessors[static_cast<std::size_t>(accessor)];
      check_format(value, semantic, a, *rule);
      const std::uint64_t expected = document.accessors[static_cast<std::size_t>(base->second)].count;
      if (a.count != expected)
        value.fail("{} has {} elements, the primitive {}", semantic, a.count, expected);
    });
    if (fault.empty())
      target[semantic] = accessor;
    else
      warn_at(value, fmt::format("its morphed {} cannot be read, and is left out", semantic));
  }
  return target;
}

DracoData read_draco(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  DracoData draco;
  draco.view = value.index("bufferView", document.views.size(), "bufferView");
  const Value attributes = value.at("attributes");
  for (const std::string& semantic : attributes.keys()) {
    draco.attributes[semantic] = static_cast<std::uint32_t>(attributes.at(semantic).count(0, 0xFFFFFFFF));
    // One that the primitive does not name is not read.
    if (!primitive.attributes.contains(semantic)) draco.attributes.erase(semantic);
  }
  if (!draco.attributes.contains("POSITION")) attributes.fail("'POSITION' is missing");
  return draco;
}

void check_indices(const Document& document, const Value& value, const MeshPrimitive& primitive) {
  if (primitive.indices < 0) return;
  const Accessor& a = document.accessors[primitive.indices];
  const bool integer =
      a.component == Component::uint8 || a.component == Component::uint16 || a.component == Component::uint32;
  check_fault(a.fault);
  if (a.components() != 1 || !integer)
    value.fail("indices cannot be {} x {} ({})", a.components(), name_of(a.component), a.place);
  if (a.view < 0 && !primitive.draco) value.fail("the indices' accessor has no bufferView");
}

void read_primitive(const Document& document, const Value& value, MeshPrimitive& primitive) {
  primitive.mode = static_cast<int>(value.count_or("mode", 4, 0, 6));
  primitive.material = index_near(value, "material", document.materials.size(), "material");
  primitive.indices = value.index_or_none("indices", document.accessors.size(), "accessor");
  if (const auto attributes = value.find("attributes"))
    primitive.attributes = read_vertices(document, attributes->object(), primitive.joints_fault);
  else
    warn_at(value, "has no attributes, and shows nothing");
  if (const auto draco = extension(value, "KHR_draco_mesh_compression"))
    primitive.draco = read_draco(document, *draco, primitive);
  check_indices(document, value, primitive);
  value.for_each("targets", [&](const Value& target) {
    primitive.targets.push_back(read_target(document, target, primitive));
  });
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
    mesh.name = text_near(value, "name", value.place());
    if (!value.has("primitives")) warn_at(value, "has no primitives");
    mesh.fault = fault_of([&] {
      value.for_each("primitives", [&](const Value& part) {
        MeshPrimitive& primitive = mesh.primitives.emplace_back();
        primitive.place = part.place();
        primitive.fault = fault_of([&] { read_primitive(document, part, primitive); });
        mesh.targets = std::max(mesh.targets, primitive.targets.size());
      });
    });
    mesh.weights = read_weights(value, mesh.targets);
    mesh.target_names = read_target_names(value, mesh.targets);
    document.meshes.push_back(std::move(mesh));
  });
}

std::vector<double> read_weights(const Value& value, std::size_t targets) {
  const std::optional<Value> given = value.find("weights");
  if (!given || !given->is_array()) return {};
  std::vector<double> weights;
  for (std::size_t i = 0; i < given->array_size(0); ++i) {
    const Value weight = given->element(i);
    if (!weight.is_number()) warn_at(weight, "is no number, and counts as 0");
    weights.push_back(weight.is_number() ? weight.any_number() : 0);
  }
  if (weights.size() != targets)
    warn_at(value, fmt::format("has {} weights for {} morph targets", weights.size(), targets));
  weights.resize(targets);
  return weights;
}

}  // namespace dermis::scene::gltf
