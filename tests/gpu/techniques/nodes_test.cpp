// SPDX-License-Identifier: MIT
// Many nodes: what a frame takes follows from its meshes, not from how many nodes show them; and skin of many
// nodes shares a pool of light maps.
#include <malloc.h>

#include <glm/gtc/matrix_transform.hpp>

#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "support/written_out.h"

namespace dermis::tests {
namespace {

/// A row of shared octahedra-like balls before the camera, turned, stretched, every third one mirrored; none
/// is skin. `blended`: half transparent.
scene::AssetData shared_balls(int count, bool blended = false) {
  scene::AssetData made = scene::sphere(0.5, 4);
  made.materials[0].skin = false;
  made.materials[0].roughness = 0.4f;
  made.materials[0].base_colour = {0.8f, 0.4f, 0.2f, blended ? 0.5f : 1.0f};
  if (blended) made.materials[0].alpha_mode = AssetAlpha::blend;
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 at((i % side - 0.5 * side) * 0.2 / side, (i / side - 0.5 * side) * 0.2 / side,
                        0.01 * (i % 7));
    const bool mirrored = i % 3 == 1;
    glm::dmat4 m = glm::translate(glm::dmat4(1), at);
    m = glm::rotate(m, 0.3 * i, glm::dvec3(0.6, 0.8, 0));
    m = glm::scale(m, glm::dvec3(mirrored ? -1 : 1, 0.8, 0.9) * (0.18 / side));
    made.primitives[0].placements.push_back({glm::dmat4x3(m), i, mirrored});
  }
  return made;
}

/// The same with a mesh for each node.
scene::AssetData with_own_meshes(const scene::AssetData& shared) {
  scene::AssetData made = shared;
  made.primitives = scene::written_out(shared);
  return made;
}

double largest_difference(const Picture& a, const Picture& b) {
  EXPECT_EQ(a.linear_rgba.size(), b.linear_rgba.size());
  double largest = 0;
  for (std::size_t i = 0; i < a.linear_rgba.size(); ++i)
    largest = std::max(largest, std::abs(double(a.linear_rgba[i]) - b.linear_rgba[i]));
  return largest;
}

std::size_t different_pixels(const Picture& a, const Picture& b, double tolerance) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.linear_rgba.size(); i += 4) {
    double d = 0;
    for (std::size_t c = 0; c < 4; ++c)
      d = std::max(d, std::abs(double(a.linear_rgba[i + c]) - b.linear_rgba[i + c]));
    if (d > tolerance) ++count;
  }
  return count;
}

RenderSettings tiny_settings() {
  RenderSettings s = small_settings("texture-space", 96);
  s.quality.map_size = 64;
  s.output.bloom = 0;
  return s;
}

// Places are applied in floats on the device and in doubles on the processor. Light is then off by a step of
// half floats, of values below 2. And corners are off by 1.4e-5 pixels, where rasterisation rounds to 1/256:
// of 20 balls of 98 corners some 28 coordinates fall to the other side, and each moves 1/256 of a pixel along
// some 18 pixels of edges with 4 samples each. That makes 8 samples in all, and 8 + 4 sqrt(8) at most.
TEST(Nodes, SharedMeshesLookAsIfEachNodeHadItsOwn) {
  for (const bool blended : {false, true}) {
    const scene::AssetData shared = shared_balls(20, blended);
    const Picture a = renderer().render(wrap(shared), tiny_settings());
    const Picture b = renderer().render(wrap(with_own_meshes(shared)), tiny_settings());
    EXPECT_LE(different_pixels(a, b, 2 * half_rounding), 20u) << blended << ": " << largest_difference(a, b);
    EXPECT_GT(skin_range(a).pixels +
                  different_pixels(a, renderer().render(wrap(shared_balls(1)), tiny_settings()), 0.1),
              500u);
  }
}

TEST(Nodes, WhatAFrameTakesDoesNotGrowWithNodes) {
  const auto cost = [](int nodes) {
    Renderer fresh;
    return fresh.render(wrap(shared_balls(nodes)), tiny_settings()).statistics;
  };
  const Statistics one = cost(1), many = cost(2000);
  EXPECT_EQ(many.passes.size(), one.passes.size());
  EXPECT_EQ(many.image_bytes, one.image_bytes);
  EXPECT_LE(many.buffer_bytes, one.buffer_bytes + 2000 * 128);
}

/// Small balls of skin in a square, each a node with an unwrap of its own.
scene::AssetData skin_balls(int count) {
  scene::AssetData made = scene::sphere(0.02, 4);
  const scene::Primitive ball = made.primitives[0];
  made.primitives.clear();
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    scene::Primitive& p = made.primitives.emplace_back(ball);
    p.node = i;
    for (scene::Vertex& v : p.vertices)
      v.position_m += glm::vec3(0.045 * (i % side), 0.045 * (i / side), 0.003 * (i % 5));
  }
  return made;
}

// Squares lie elsewhere in the pool, where coordinates round differently: a read between two texels may move
// by a device's step, 1/256 of what they differ in. Such steps go either way, as roundings to half floats do.
void expect_alike(const Picture& a, const Picture& b) {
  EXPECT_EQ(different_pixels(a, b, 1.0 / 256), 0u) << largest_difference(a, b);
  EXPECT_NEAR(sum(a)[0] / sum(b)[0], 1, half_rounding);
}

TEST(Nodes, SkinOfManyNodesIsDrawnInBatchesUnderTheBudget) {
  RenderSettings s = tiny_settings();
  s.output.width = s.output.height = 64;
  s.quality.map_size = 32;
  s.quality.depth = false;
  s.skin.translucency = false;
  s.quality.map_budget_mb = 0.8;  // eight squares
  const Statistics st = renderer().render(wrap(skin_balls(65)), s).statistics;
  EXPECT_GT(st.skin_pixels, 500u);
  EXPECT_EQ(st.unshaded_reads, 0u);

  const auto images = [&](int nodes, double budget_mb) {
    Renderer fresh;
    RenderSettings other = s;
    other.quality.map_budget_mb = budget_mb;
    return fresh.render(wrap(skin_balls(nodes)), other).statistics.image_bytes;
  };
  EXPECT_LT(images(10, 0.4), images(10, 8));
}

std::size_t heap_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

// A software driver that compiles shaders for what uniform blocks hold keeps them for ever: see
// render/shaders/switches.glsl. Materials without maps leave it the most to compile for.
TEST(Nodes, FramesAndNodesLeaveNothingBehind) {
  RenderSettings s = tiny_settings();
  s.output.width = s.output.height = 48;
  s.quality.map_size = 32;
  PreparedFrame frame = renderer().prepare(wrap(skin_balls(8)), s);
  frame.draw();
  frame.draw();

  const std::size_t before = heap_bytes();
  for (int i = 0; i < 3; ++i) frame.draw();
  EXPECT_LT(heap_bytes(), before + 1'000'000) << "of 3 frames of 8 meshes";
}

TEST(Nodes, HeadsOfManySkinNodesKeepTheirPlaces) {
  RenderSettings s = tiny_settings();
  s.camera.heads = 2;
  const Scene scene = wrap(skin_balls(3));
  s.quality.map_budget_mb = 0.8;  // two squares: fewer than a head has
  const Picture some = renderer().render(scene, s);
  s.quality.map_budget_mb = 24;
  expect_alike(some, renderer().render(scene, s));
}

}  // namespace
}  // namespace dermis::tests
