// SPDX-License-Identifier: MIT
// What the tests of whole pictures share: one renderer, the heads that are at hand, sums over pixels.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/scene.h"

namespace dermis::tests {

/// One renderer for the whole process: pipelines are made once.
Renderer& renderer();

/// One with the validation layers for the whole process, so its messages may be of a test before; null where
/// they are not installed. Any other trouble is thrown.
Renderer* validated_renderer();

/// A picture small enough for a software driver.
RenderSettings small_settings(const std::string& technique);

/// The same under white light from everywhere: what is skin must be 1.
RenderSettings furnace_settings(const std::string& technique, bool specular);

/// A scene made in memory.
Scene wrap(scene::Scene data);

/// Six charts, radius in metres.
Scene sphere(double radius_m);
Scene sheared_plane();

/// The sphere under one directional light that shines where the framing camera looks.
Scene sphere_lit_from_the_camera(double radius_m);

/// A head by name; open() reads it once. Its files may not be there: then `missing` says what to do.
struct Subject {
  std::string name;
  std::function<Scene()> open;
  std::string missing;
};
const std::vector<Subject>& subjects();
const Subject& subject(const std::string& name);  ///< one of them
std::vector<std::string> subject_names();

/// Of a technique or a head: what GoogleTest takes for a name.
std::string test_name_of(std::string name);

/// Pixels that are wholly skin.
struct SkinRange {
  std::size_t pixels = 0;
  float low = 1e30f, high = -1e30f;
  std::array<double, 3> mean{};
};
SkinRange skin_range(const Picture& picture);

/// Sum of red, green and blue over all pixels.
std::array<double, 3> sum(const Picture& picture);

}  // namespace dermis::tests
