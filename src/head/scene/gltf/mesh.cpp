// SPDX-License-Identifier: MIT
#include "head/scene/gltf/mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "head/scene/gltf/lenient.h"
#include "head/scene/import/limits.h"

namespace dermis::scene::gltf {

namespace {

constexpr int mode_triangles = 4, mode_strip = 5, mode_fan = 6;

std::uint64_t claimed_corners(const Document& document, const MeshPrimitive& primitive) {
  if (primitive.indices >= 0) return document.accessors[primitive.indices].count;
  return claimed_vertices(document, primitive);
}

/// Converts strips and fans to single triangles, all with equal winding (glTF 2.0, 3.7.2.1).
std::vector<std::uint32_t> as_triangles(std::vector<std::uint32_t> corners, int mode) {
  if (mode == mode_triangles) {
    corners.resize(corners.size() / 3 * 3);
    return corners;
  }
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i + 2 < corners.size(); ++i) {
    if (mode == mode_fan)
      triangles.insert(triangles.end(), {corners[i + 1], corners[i + 2], corners[0]});
    else
      triangles.insert(triangles.end(), {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
  }
  return triangles;
}

/// Reads a primitive's attributes: from Draco data those that it names, from accessors the rest.
class Source {
 public:
  Source(const Document& document, Bytes& bytes, const MeshPrimitive& primitive)
      : document_(document), bytes_(bytes), primitive_(primitive) {
    if (primitive.draco) draco_ = decode_draco(document, bytes, primitive);
  }
  std::vector<std::uint32_t> corners() {
    if (primitive_.draco) return std::move(draco_.indices);
    if (primitive_.indices >= 0) return bytes_.integers(primitive_.indices);
    std::vector<std::uint32_t> all(claimed_vertices(document_, primitive_));
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }

  std::vector<float> attribute(const std::string& name, int components,
                               const std::vector<std::uint32_t>& order) {
    const auto found = primitive_.attributes.find(name);
    if (found == primitive_.attributes.end()) return {};
    const auto compressed = draco_.attributes.find(name);
    if (compressed != draco_.attributes.end())
      return gather(std::move(compressed->second), components, order);
    return gather(bytes_.floats(found->second), components, order);
  }

  /// The same, with `otherwise` in place of what is not finite.
  std::vector<float> finite_or(float otherwise, const std::string& name, int components,
                               const std::vector<std::uint32_t>& order) {
    std::vector<float> values = attribute(name, components, order);
    bool whole = true;
    for (float& value : values) {
      if (std::isfinite(value)) continue;
      value = otherwise;
      whole = false;
    }
    if (!whole) warn_at(document_.file, primitive_.place, name + " is not finite everywhere");
    return values;
  }

  /// Returns weights of joints. Those below 0 become 0: a vertex stays within the places of its joints.
  std::vector<float> weights(const std::string& name, const std::vector<std::uint32_t>& order) {
    std::vector<float> values = finite_or(0, name, 4, order);
    bool negative = false;
    for (float& value : values) {
      negative |= value < 0;
      value = std::max(value, 0.0f);
    }
    if (negative) warn_at(document_.file, primitive_.place, name + " is below 0 somewhere, and counts as 0");
    return values;
  }

 private:
  const Document& document_;
  Bytes& bytes_;
  const MeshPrimitive& primitive_;
  DracoMesh draco_;
};

/// Gives vertices whose coordinates cannot be used those of a corner beside them, so that no triangle is
/// stretched over the map. Returns whether there were any.
bool repair_coordinates(const std::vector<std::uint32_t>& indices, std::vector<float>& uv) {
  const auto usable = [](float value) { return std::abs(value) <= largest_uv; };  // false for NaN
  std::vector<bool> bad(uv.size() / 2);
  for (std::size_t v = 0; v < bad.size(); ++v) bad[v] = !usable(uv[2 * v]) || !usable(uv[2 * v + 1]);
  if (std::find(bad.begin(), bad.end(), true) == bad.end()) return false;

  std::vector<std::uint32_t> from(bad.size(), 0);
  std::vector<bool> found(bad.size(), false);
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3)
    for (std::size_t k = 0; k < 9; ++k) {
      const std::uint32_t corner = indices[t + k / 3], other = indices[t + k % 3];
      if (!bad[corner] || found[corner] || bad[other]) continue;
      from[corner] = other;
      found[corner] = true;
    }
  for (std::size_t v = 0; v < bad.size(); ++v)
    for (std::size_t c = 0; c < 2 && bad[v]; ++c)
      uv[2 * v + c] = found[v] ? uv[2 * std::size_t{from[v]} + c] : 0;
  return true;
}

/// Adds alpha 1: COLOR_0 may lack alpha.
std::vector<float> with_alpha(const std::vector<float>& rgb) {
  std::vector<float> rgba;
  rgba.reserve(rgb.size() / 3 * 4);
  for (std::size_t i = 0; i + 2 < rgb.size(); i += 3)
    rgba.insert(rgba.end(), {rgb[i], rgb[i + 1], rgb[i + 2], 1.0f});
  return rgba;
}

}  // namespace

std::uint64_t claimed_vertices(const Document& document, const MeshPrimitive& primitive) {
  const auto position = primitive.attributes.find("POSITION");
  return position == primitive.attributes.end() ? 0 : document.accessors[position->second].count;
}

std::uint64_t claimed_triangles(const Document& document, const MeshPrimitive& primitive) {
  if (primitive.mode < mode_triangles || claimed_vertices(document, primitive) == 0) return 0;
  const std::uint64_t corners = claimed_corners(document, primitive);
  if (primitive.mode == mode_triangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

std::vector<float> gather(std::vector<float> values, int components,
                          const std::vector<std::uint32_t>& order) {
  if (order.empty()) return values;
  std::vector<float> out(order.size() * components);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int c = 0; c < components; ++c)
      out[i * components + c] = values[std::size_t{order[i]} * components + c];
  return out;
}

LocalMesh read_mesh(const Document& document, Bytes& bytes, const MeshPrimitive& primitive) {
  Source source(document, bytes, primitive);
  LocalMesh mesh;
  const std::size_t vertices = claimed_vertices(document, primitive);

  mesh.indices = source.corners();
  check_indices({document.file, primitive.place}, mesh.indices, vertices);
  // Draco data holds single triangles, whatever the mode says.
  mesh.indices = as_triangles(std::move(mesh.indices), primitive.draco ? mode_triangles : primitive.mode);
  mesh.original = drop_unused(mesh.indices, vertices);
  mesh.vertices = mesh.original.empty() && !mesh.indices.empty() ? vertices : mesh.original.size();
  if (mesh.indices.empty()) return mesh;

  const std::vector<std::uint32_t>& order = mesh.original;
  mesh.positions = source.attribute("POSITION", 3, order);
  check_finite({document.file, primitive.place}, "POSITION", mesh.positions, 3);
  mesh.normals = source.attribute("NORMAL", 3, order);
  mesh.tangents = source.attribute("TANGENT", 4, order);
  for (int set = 0; set < 2; ++set) {
    mesh.uvs[set] = source.attribute(fmt::format("TEXCOORD_{}", set), 2, order);
    mesh.joints[set] = source.finite_or(0, fmt::format("JOINTS_{}", set), 4, order);
    mesh.weights[set] = source.weights(fmt::format("WEIGHTS_{}", set), order);
    if (repair_coordinates(mesh.indices, mesh.uvs[set]))
      warn_at(document.file, primitive.place,
              "has texture coordinates that are not finite or out of range; they become those beside them");
  }

  if (const auto colour = primitive.attributes.find("COLOR_0"); colour != primitive.attributes.end()) {
    const int components = document.accessors[colour->second].rows;
    mesh.colours = source.finite_or(1, "COLOR_0", components, order);
    if (components == 3) mesh.colours = with_alpha(mesh.colours);
  }
  return mesh;
}

}  // namespace dermis::scene::gltf
