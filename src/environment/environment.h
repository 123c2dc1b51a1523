// SPDX-License-Identifier: MIT
/// Light from all directions: a picture of the environment, prepared for skin. No device here.
///
/// Directions: the middle of the picture lies at -Z, behind the head, where a camera in front of the head
/// sees it. Its upper edge is at +Y, and +X to the right of the middle. Turned about +Y by `rotation_deg`
/// when used, from the head's front (+Z) towards its left (+X), as lights are.
#pragma once

#include <array>
#include <cstdint>
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

/// Loads Radiance .hdr or OpenEXR, at most 16384 pixels per side. Pictures of more than 4096 x 2048 pixels
/// are downsampled by 2 while they are read, with a note. Throws InputError if missing, damaged or too large.
/// Warns about infinite, NaN and negative pixels (taken as 0) and about a picture that is not twice as wide
/// as high (stretched over the sphere).
Environment load(const std::filesystem::path& path);

/// Eight times the resolution that skin or its reflections need, in 100 MB.
inline constexpr std::uint64_t most_pixels = 4096 * 2048;

/// Takes negative radiance as 0, and warns of what load() names. `where` names the picture in warnings.
Environment checked(Environment environment, const std::string& where);

/// Returns the built-in studio: a large soft light at the left front, a weaker one at the right, a strip from
/// behind, a grey room. Its mean radiance over the sphere is 0.5 to 0.6.
Environment studio();

/// Throws InputError unless there are 1 to 4096 x 2048 pixels of three values each.
void check_size(const std::string& name, int width, int height, std::size_t values);

/// Returns the environment of pixels in memory. Throws InputError: see check_size(), or a value that is not
/// finite. Warns as load().
Environment from_pixels(const std::string& name, int width, int height, const std::vector<float>& rgb);

/// Loads a file, or makes "studio".
Environment from_name_or_file(const std::string& name);

/// Return the unit direction of a place (u, v) of the picture, 0..1 with v down, and the place of a
/// direction.
glm::dvec3 direction_of(double u, double v);
glm::dvec2 place_of(const glm::dvec3& direction);

/// Returns the radiance at a place 0..1 x 0..1, bilinear between pixel centres; wraps in u, clamps at the
/// poles.
glm::dvec3 radiance_at(const image::ImageF& picture, const glm::dvec2& place);

/// Irradiance as a polynomial of the normal, nine terms 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2.
/// Based on: Ramamoorthi, Hanrahan: An Efficient Representation for Irradiance Environment Maps. SIGGRAPH
/// 2001 (order 2; the error is below 1 % of the mean on average, up to 9 % under a single point of light).
using Irradiance = std::array<glm::dvec3, 9>;
Irradiance irradiance_of(const Environment& environment);
glm::dvec3 evaluate(const Irradiance& irradiance, const glm::dvec3& normal);

/// Returns radiance averaged over lobes of growing roughness. Level 0 is the picture; levels 1 to 5 are
/// Beckmann lobes of m = 1/16, 1/8, 1/4, 1/2, 1 around the mirrored direction, each half as wide. Sizes
/// 512x256 to 16x8, 3 channels. Based on: Karis: Real Shading in Unreal Engine 4. SIGGRAPH 2013 course
/// (normal = view = mirrored direction while averaging).
inline constexpr int prefilter_levels = 6;
inline constexpr int prefilter_width = 512;
std::vector<image::ImageF> prefilter(const Environment& environment);

}  // namespace dermis::environment
