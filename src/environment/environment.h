// SPDX-License-Identifier: MIT
/// Light that arrives from everywhere: a picture of the surroundings, prepared for skin. No device here.
///
/// Directions: the middle of the picture lies at -Z (behind the head, as a camera before it sees it), its
/// upper rim at +Y, and +X to the right of the middle. Turned about +Y by `rotation_deg` when it is used,
/// from the head's front (+Z) towards its left (+X), as lights are.
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "image/image.h"

namespace dermis::environment {

/// Equirectangular radiance, linear Rec.709, finite and not negative; 3 channels.
struct Environment {
  std::string name;
  image::ImageF radiance;
};

/// Radiance .hdr or OpenEXR, at most 16384 pixels a side. More than 4096 x 2048 pixels are halved while they
/// are read, by the average of areas, with a note. InputError: missing, damaged, too large. Warnings: pixels
/// that are infinite or no numbers (0), negative ones (0), a picture that is not twice as wide as high
/// (stretched over the sphere all the same).
Environment load(const std::filesystem::path& path);

/// The studio that is built in: a large soft light at the left front, a weaker one at the right, a strip from
/// behind, a grey room. Its mean radiance over the sphere is 0.5 to 0.6.
Environment studio();

/// A file, or "studio".
Environment from_name_or_file(const std::string& name);

/// Middle of pixel (x, y) of a width x height picture as a unit direction, and where a direction lies, 0..1
/// (v down).
glm::dvec3 direction_of(double u, double v);
glm::dvec2 place_of(const glm::dvec3& direction);

/// The picture at a place 0..1 x 0..1, bilinear between the middles of pixels; goes round in u, stops at the
/// poles.
glm::dvec3 radiance_at(const image::ImageF& picture, const glm::dvec2& place);

/// Irradiance as a polynomial of the normal's components: nine terms 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2.
/// Based on: Ramamoorthi, Hanrahan: An Efficient Representation for Irradiance Environment Maps. SIGGRAPH
/// 2001 (order 2; on average within 1 % of the mean, up to 9 % under a single point).
using Irradiance = std::array<glm::dvec3, 9>;
Irradiance irradiance_of(const Environment& environment);
glm::dvec3 evaluate(const Irradiance& irradiance, const glm::dvec3& normal);

/// Radiance averaged over lobes of growing roughness: level 0 as it is, then Beckmann lobes of m = 1/16, 1/8,
/// 1/4, 1/2, 1 around the mirrored direction, each half as wide. Sizes 512x256 to 16x8, 3 channels. Based on:
/// Karis: Real Shading in Unreal Engine 4. SIGGRAPH 2013 course (normal = view = mirrored direction while
/// averaging).
inline constexpr int prefilter_levels = 6;
inline constexpr int prefilter_width = 512;
std::vector<image::ImageF> prefilter(const Environment& environment);

}  // namespace dermis::environment
