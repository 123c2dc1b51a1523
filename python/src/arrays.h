// SPDX-License-Identifier: MIT
// Arrays of Python as assets. dermis/_arrays.py has made them contiguous, of the right type and shape.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dermis/asset_arrays.h"

namespace dermis::python {

using Points =
    nanobind::ndarray<const float, nanobind::shape<-1, 3>, nanobind::c_contig, nanobind::device::cpu>;
using Coordinates =
    nanobind::ndarray<const float, nanobind::shape<-1, 2>, nanobind::c_contig, nanobind::device::cpu>;
using Colours =
    nanobind::ndarray<const float, nanobind::shape<-1, 4>, nanobind::c_contig, nanobind::device::cpu>;
using Whole =
    nanobind::ndarray<const std::uint32_t, nanobind::ndim<1>, nanobind::c_contig, nanobind::device::cpu>;
using Pixels = nanobind::ndarray<const float, nanobind::ndim<3>, nanobind::c_contig, nanobind::device::cpu>;
using Bytes =
    nanobind::ndarray<const std::uint8_t, nanobind::ndim<3>, nanobind::c_contig, nanobind::device::cpu>;

/// AssetArrays with the memory that they point into.
class ArrayAsset {
 public:
  explicit ArrayAsset(std::string name) : name_(std::move(name)) {}

  /// Return the number of what was added.
  int add_image(const std::string& name, const Bytes& pixels);
  int add_material(const std::string& name, std::optional<bool> skin, const std::array<float, 4>& base_colour,
                   float roughness, float metallic, int base_colour_image, int normal_image,
                   int roughness_image, bool double_sided);
  void add_mesh(const std::string& name, int material, const Points& positions,
                const std::optional<Whole>& indices, const std::optional<Points>& normals,
                const std::optional<Coordinates>& uv, const std::optional<Colours>& colours);
  /// Valid as long as this object.
  AssetArrays arrays() const;

 private:
  struct Image {
    std::string name;
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint8_t> pixels;
  };
  struct Mesh {
    std::string name;
    int material = -1;
    std::vector<std::array<float, 3>> positions, normals;
    std::vector<std::array<float, 2>> uv;
    std::vector<std::array<float, 4>> colours;
    std::vector<std::uint32_t> indices;
  };
  std::string name_;
  std::vector<Image> images_;
  std::vector<AssetMaterial> materials_;
  std::vector<Mesh> meshes_;
};

}  // namespace dermis::python
