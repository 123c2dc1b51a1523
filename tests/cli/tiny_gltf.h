// SPDX-License-Identifier: MIT
// glTF files of a few triangles, whole or broken in one place, as text with everything inside.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace dermis::tests {

/// A square of side 0.2 m, 8 x 8 cells, facing +Z, with one material called "skin".
struct TinyMesh {
  std::vector<float> positions, normals, uvs;
  std::vector<std::uint32_t> indices;
  TinyMesh();
};

/// `change` may edit the JSON before it becomes text.
std::string tiny_gltf(const TinyMesh& mesh = {}, const std::function<void(nlohmann::json&)>& change = {});

std::string data_uri(const std::string& type, const std::string& bytes);

}  // namespace dermis::tests
