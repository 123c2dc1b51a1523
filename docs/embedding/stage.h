// SPDX-License-Identifier: MIT
/// What the sample shows: two heads in the light of one lamp, seen by a camera that goes round. No Vulkan.
#pragma once

#include <dermis/asset.h>
#include <dermis/scene.h>
#include <dermis/settings.h>

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace stage {

/// A mesh as an engine has it in memory: for its own vertex buffers, and for dermis.
struct Head {
  std::vector<std::array<float, 3>> positions_m, normals;
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::uint32_t> indices;
};

/// What the host's own shaders need to know of the scene.
inline constexpr glm::vec3 lamp_direction{-0.55f, -0.6f, -0.75f};  ///< in which its light travels
inline constexpr glm::vec3 lamp_irradiance{2.4f, 2.2f, 2.0f};
inline constexpr glm::vec3 skin_albedo{0.76f, 0.52f, 0.42f};
inline constexpr float skin_roughness = 0.5f;
inline constexpr float floor_height_m = -0.125f;

struct Stage {
  Stage();
  /// Turns the heads to where they are in this frame.
  void turn(std::uint64_t frame);

  Head head;
  dermis::Scene scene;
  dermis::InstanceId left{}, right{};  ///< drawn by dermis, and by the host
};

/// Settings of all frames. Camera and size are those of a frame, and matter to Renderer::render() alone.
dermis::RenderSettings settings();
/// Reversed depth, infinite far plane, clip y down.
dermis::CameraMatrices camera(std::uint64_t frame, std::uint32_t width, std::uint32_t height);
glm::vec3 eye_m(std::uint64_t frame);
/// The host's shadow map of the lamp, around both heads: orthographic, near is 0, clip y down.
glm::dmat4 shadow_from_world();
std::array<double, 16> columns_of(const glm::dmat4& m);

glm::mat4 matrix_of(const std::array<double, 16>& columns);

}  // namespace stage
