// SPDX-License-Identifier: MIT
#include "arrays.h"

#include <cstring>

namespace dermis::python {
namespace {

template <std::size_t n, class Array>
std::vector<std::array<float, n>> rows_of(const Array& array) {
  std::vector<std::array<float, n>> rows(array.shape(0));
  if (!rows.empty()) std::memcpy(rows.data(), array.data(), rows.size() * sizeof(rows[0]));
  return rows;
}

}  // namespace

int ArrayAsset::add_image(const std::string& name, const Bytes& pixels) {
  images_.push_back({.name = name,
                     .width = static_cast<int>(pixels.shape(1)),
                     .height = static_cast<int>(pixels.shape(0)),
                     .channels = static_cast<int>(pixels.shape(2)),
                     .pixels = {pixels.data(), pixels.data() + pixels.size()}});
  return static_cast<int>(images_.size()) - 1;
}

int ArrayAsset::add_material(const std::string& name, std::optional<bool> skin,
                             const std::array<float, 4>& base_colour, float roughness, float metallic,
                             int base_colour_image, int normal_image, int roughness_image,
                             bool double_sided) {
  materials_.push_back({.name = name,
                        .skin = skin,
                        .base_colour = base_colour,
                        .base_colour_map = {.image = base_colour_image},
                        .metallic = metallic,
                        .roughness = roughness,
                        .metallic_roughness_map = {.image = roughness_image},
                        .normal_map = {.image = normal_image},
                        .double_sided = double_sided});
  return static_cast<int>(materials_.size()) - 1;
}

void ArrayAsset::add_mesh(const std::string& name, int material, const Points& positions,
                          const std::optional<Whole>& indices, const std::optional<Points>& normals,
                          const std::optional<Coordinates>& uv, const std::optional<Colours>& colours) {
  Mesh& mesh = meshes_.emplace_back();
  mesh.name = name;
  mesh.material = material;
  mesh.positions = rows_of<3>(positions);
  if (indices) mesh.indices.assign(indices->data(), indices->data() + indices->shape(0));
  if (normals) mesh.normals = rows_of<3>(*normals);
  if (uv) mesh.uv = rows_of<2>(*uv);
  if (colours) mesh.colours = rows_of<4>(*colours);
}

AssetArrays ArrayAsset::arrays() const {
  AssetArrays out{.name = name_, .materials = materials_};
  for (const Mesh& mesh : meshes_)
    out.meshes.push_back({.name = mesh.name,
                          .material = mesh.material,
                          .positions_m = mesh.positions,
                          .normals = mesh.normals,
                          .uv0 = mesh.uv,
                          .colours = mesh.colours,
                          .indices = mesh.indices});
  for (const Image& image : images_)
    out.images.push_back({.name = image.name,
                          .width = image.width,
                          .height = image.height,
                          .channels = image.channels,
                          .pixels = image.pixels});
  return out;
}

}  // namespace dermis::python
