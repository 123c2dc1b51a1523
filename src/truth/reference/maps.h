// SPDX-License-Identifier: MIT
// Reads the maps of materials at a point, at full resolution. There are no mip
// levels, because a pixel is the mean of many points. A function of a map (a power of its colour, a highlight
// on its normals) differs from the function of its mean.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <utility>

#include "head/scene/asset_data.h"

namespace dermis::reference {

/// An image whose values are linear: sRGB is decoded before it is interpolated.
class MapPixels {
 public:
  MapPixels(image::Image8 pixels, bool srgb) : pixels_(std::move(pixels)), srgb_(srgb) {}
  glm::dvec4 bilinear(glm::dvec2 uv, const scene::MapRef& map) const;

 private:
  glm::dvec4 texel(int x, int y) const;

  image::Image8 pixels_;
  bool srgb_;
};

/// A map of a material: pixels, and how to find them from a point of the surface. Absent without pixels.
struct MapSlot {
  scene::MapRef map;
  std::shared_ptr<const MapPixels> pixels;

  bool present() const { return pixels != nullptr; }
  double channel(const std::array<glm::dvec2, 2>& uv) const { return read(uv)[map.channel]; }
  glm::dvec4 read(const std::array<glm::dvec2, 2>& uv) const;
};

}  // namespace dermis::reference
