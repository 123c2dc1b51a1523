// SPDX-License-Identifier: MIT
#include "cli/tiny_gltf.h"

#include <algorithm>
#include <cstring>

namespace dermis::tests {
namespace {

using nlohmann::json;

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  const std::size_t at = bytes.size();
  bytes.resize(at + values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(bytes.data() + at, values.data(), values.size() * sizeof(T));
}

}  // namespace

std::string data_uri(const std::string& type, const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = "data:" + type + ";base64,";
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) -> std::uint32_t {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u;
    };
    const std::uint32_t word = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    text += digits[word >> 18];
    text += digits[word >> 12 & 63];
    text += i + 1 < bytes.size() ? digits[word >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? digits[word & 63] : '=';
  }
  return text;
}

TinyMesh::TinyMesh() {
  constexpr int n = 8;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const float u = static_cast<float>(i) / n, v = static_cast<float>(j) / n;
      positions.insert(positions.end(), {0.2f * (u - 0.5f), 0.2f * (0.5f - v), 0});
      normals.insert(normals.end(), {0, 0, 1});
      uvs.insert(uvs.end(), {u, v});
    }
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      indices.insert(indices.end(), {a, c, d, a, d, b});
    }
}

std::string tiny_gltf(const TinyMesh& mesh, const std::function<void(json&)>& change) {
  std::string bytes;
  json views = json::array(), accessors = json::array();
  const auto add = [&](const auto& values, int component, const char* type, int width, json more) {
    if (values.empty()) return -1;
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * 4}});
    append(bytes, values);
    more.update({{"bufferView", views.size() - 1},
                 {"componentType", component},
                 {"type", type},
                 {"count", values.size() / static_cast<std::size_t>(width)}});
    accessors.push_back(more);
    return static_cast<int>(accessors.size()) - 1;
  };

  // Finds the bounds, which glTF asks of positions.
  std::vector<float> low{1e30f, 1e30f, 1e30f}, high{-1e30f, -1e30f, -1e30f};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], mesh.positions[i]);
    high[i % 3] = std::max(high[i % 3], mesh.positions[i]);
  }

  json attributes;
  if (const int a = add(mesh.positions, 5126, "VEC3", 3, {{"min", low}, {"max", high}}); a >= 0)
    attributes["POSITION"] = a;
  if (const int a = add(mesh.normals, 5126, "VEC3", 3, json::object()); a >= 0) attributes["NORMAL"] = a;
  if (const int a = add(mesh.uvs, 5126, "VEC2", 2, json::object()); a >= 0) attributes["TEXCOORD_0"] = a;
  json primitive{{"attributes", attributes}, {"material", 0}};
  if (const int a = add(mesh.indices, 5125, "SCALAR", 1, json::object()); a >= 0) primitive["indices"] = a;

  json root{
      {"asset", {{"version", "2.0"}}},
      {"scene", 0},
      {"scenes", {{{"nodes", {0}}}}},
      {"nodes", {{{"mesh", 0}}}},
      {"meshes", {{{"primitives", {primitive}}}}},
      {"materials", {{{"name", "skin"}}}},
      {"accessors", accessors},
      {"bufferViews", views},
      {"buffers", {{{"byteLength", bytes.size()}, {"uri", data_uri("application/octet-stream", bytes)}}}}};

  if (change) change(root);
  return root.dump();
}

}  // namespace dermis::tests
