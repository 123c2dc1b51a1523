// SPDX-License-Identifier: MIT
// Way (v): the shape and the maps are the host's.
#include <cmath>
#include <cstring>

#include "dermis/asset_arrays.h"
#include "frame.h"
#include "gpu/support/pictures.h"
#include "head/scene/import/shapes.h"

namespace dermis::tests {
namespace {

using EmbeddedShape = WithHost;

// A ball as a host has it: arrays, and what it makes of them.
struct HostBall {
  explicit HostBall(bool with_normals = true) {
    const scene::AssetData made = scene::sphere(0.07);
    const scene::Primitive& primitive = made.primitives.front();
    for (const scene::Vertex& v : primitive.vertices) {
      positions_m.push_back({v.position_m.x, v.position_m.y, v.position_m.z});
      normals.push_back({v.normal.x, v.normal.y, v.normal.z});
      uv0.push_back({v.uv0.x, v.uv0.y});
    }
    indices = primitive.indices;
    AssetArrays arrays{.name = "ball"};
    arrays.materials.resize(1);
    arrays.materials[0].name = "skin";
    arrays.materials[0].metallic = 0;
    arrays.meshes = {{.name = "ball",
                      .material = 0,
                      .positions_m = positions_m,
                      .normals = with_normals ? normals : std::vector<std::array<float, 3>>{},
                      .uv0 = uv0,
                      .indices = indices}};
    asset.emplace(Asset::from_arrays(arrays));
  }
  Scene scene() const {
    Scene scene(*asset);
    scene.add_light({.light = {.colour = {2, 1.8, 1.6}, .direction = {0.5, -0.5, -0.7}}});
    return scene;
  }

  std::vector<std::array<float, 3>> positions_m, normals;
  std::vector<std::array<float, 2>> uv0;
  std::vector<std::uint32_t> indices;
  std::optional<Asset> asset;
};

// Turned by 90 degrees about +Y, then moved.
std::array<float, 3> turned(const std::array<float, 3>& v, float shift_m) {
  return {v[2] + shift_m, v[1], -v[0]};
}

TEST_F(EmbeddedShape, MovedVerticesAreWhereTheHostHasThem) {
  const HostBall ball;
  Scene scene = ball.scene();
  const InstanceId head = scene.instances().front();
  Frame frame;
  frame.frames->update(scene, frame_settings(), {.deformed = {head}});
  frame.draw();
  const Pixels at_rest = frame.colour();
  EXPECT_LE(largest_difference(rendered(scene, frame_settings()), at_rest), target_rounding());

  // Positions and normals of each vertex side by side, as an engine may have them.
  const std::uint64_t bytes = ball.positions_m.size() * 24;
  constexpr std::uint64_t first = 300;
  const HostBuffer buffer = frame.host.buffer(first + bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  for (std::size_t i = 0; i < ball.positions_m.size(); ++i) {
    const auto position = turned(ball.positions_m[i], 0.01f), normal = turned(ball.normals[i], 0);
    std::memcpy(buffer.mapped + first + 24 * i, position.data(), 12);
    std::memcpy(buffer.mapped + first + 12 + 24 * i, normal.data(), 12);
  }
  const vulkan::DeformedMesh mesh{.mesh = 0,
                                  .vertices = static_cast<std::uint32_t>(ball.positions_m.size()),
                                  .positions_m = {buffer.handle, first, 24},
                                  .normals = {buffer.handle, first + 12, 24}};
  frame.draw([&](VkCommandBuffer commands) {
    frame.frames->record_deformation(commands, head, std::span(&mesh, 1));
  });

  scene.set_transform(head, {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.01, 0, 0, 1});
  const double psnr = psnr_db(rendered(scene, frame_settings()), frame.colour());
  std::printf("PSNR %.1f dB, at rest %.1f dB\n", psnr, psnr_db(rendered(scene, frame_settings()), at_rest));
  EXPECT_GT(psnr, 60);
}

// Far from the sphere around its asset, which says where a head is seen otherwise.
TEST_F(EmbeddedShape, MovedVerticesAreSeenWhereverTheyAre) {
  const HostBall ball;
  const Scene scene = ball.scene();
  const InstanceId head = scene.instances().front();
  Frame frame;
  RenderSettings settings = frame_settings();
  settings.quality.skip_unseen_heads = false;
  frame.frames->update(scene, settings, {.deformed = {head}});

  const HostBuffer buffer =
      frame.host.buffer(ball.positions_m.size() * 12, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  for (std::size_t i = 0; i < ball.positions_m.size(); ++i) {
    std::array<float, 3> moved_m = ball.positions_m[i];
    for (float& x : moved_m) x *= 0.3f;
    moved_m[0] += 0.075f;
    std::memcpy(buffer.mapped + 12 * i, moved_m.data(), 12);
  }
  const vulkan::DeformedMesh mesh{.mesh = 0,
                                  .vertices = static_cast<std::uint32_t>(ball.positions_m.size()),
                                  .positions_m = {buffer.handle, 0, 12}};
  frame.draw([&](VkCommandBuffer commands) {
    frame.frames->record_deformation(commands, head, std::span(&mesh, 1));
  });
  EXPECT_GT(frame.colour().at(91, side / 2)[3], 0) << "nothing is seen beside the ball";
}

TEST_F(EmbeddedShape, AnImageOfTheHostIsTheColour) {
  const HostBall ball;
  const Scene scene = ball.scene();
  const InstanceId head = scene.instances().front();
  Frame frame;
  HostImage image = frame.host.image(VK_FORMAT_R8G8B8A8_UNORM, {8, 8}, 1,
                                     VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  frame.host.run([&](VkCommandBuffer commands) {
    frame.host.transition(commands, image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    frame.host.clear(commands, &image, {0.8f, 0.4f, 0.2f, 1}, nullptr, 0, {{0, 0}, {8, 8}});
    frame.host.transition(commands, image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  });

  // 0.8, 0.4 and 0.2 are whole 255ths.
  Scene tinted = scene;
  tinted.set_tint(head, {0.8, 0.4, 0.2});
  const RenderSettings settings = frame_settings();
  frame.frames->update(scene, settings,
                       {.images = {{.instance = head, .material = "skin", .view = image.view}}});
  frame.draw();
  EXPECT_LE(largest_difference(rendered(tinted, settings), frame.colour()), 4 * half_rounding);
}

}  // namespace
}  // namespace dermis::tests
