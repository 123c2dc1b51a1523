// SPDX-License-Identifier: MIT
#include <array>

#include "fixture.h"
#include "gpu/timer.h"

namespace dermis::gpu {
namespace {

constexpr VkExtent2D extent{16, 16};
constexpr float red[3] = {1, 0, 0}, green[3] = {0, 1, 0};

struct Vertex {
  float position[3];
  float colour[3];
};

/// A counter-clockwise triangle (with +Y up) over the lower left half of the picture, at one depth.
std::vector<Vertex> lower_left(float depth, const float (&c)[3]) {
  return {{{-1, -1, depth}, {c[0], c[1], c[2]}},
          {{1, -1, depth}, {c[0], c[1], c[2]}},
          {{-1, 1, depth}, {c[0], c[1], c[2]}}};
}

struct Pixel {
  std::uint8_t r, g, b, a;
  bool operator==(const Pixel&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Pixel& p) {
  return out << int{p.r} << ' ' << int{p.g} << ' ' << int{p.b} << ' ' << int{p.a};
}

class Draw : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    if (IsSkipped()) return;
    const float tint[] = {1, 1, 1, 1};
    tint_ = make_buffer<float>(device(), "tint", tint, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  }
  void TearDown() override {
    tint_ = {};
    GpuTest::TearDown();
  }

  static GraphicsDesc base() {
    GraphicsDesc desc;
    desc.vertex = "triangle.vert";
    desc.fragment = "triangle.frag";
    desc.colour_formats = {VK_FORMAT_R8G8B8A8_UNORM};
    return desc;
  }

  struct Options {
    bool y_down = false;
    float clear_depth = 0;
    float opacity = 1;
  };
  /// Draws all triangles with one pipeline and returns the (resolved) picture; row 0 is the top.
  std::vector<Pixel> draw(const GraphicsDesc& desc, const std::vector<Vertex>& vertices,
                          const Options& options) {
    const Buffer pulled =
        make_buffer<Vertex>(device(), "vertices", vertices, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    const TextureDesc plain{.width = extent.width,
                            .height = extent.height,
                            .format = VK_FORMAT_R8G8B8A8_UNORM,
                            .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT};
    TextureDesc many = plain;
    many.samples = desc.samples;
    TextureDesc depth_desc = many;
    depth_desc.format = VK_FORMAT_D32_SFLOAT;
    depth_desc.usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    const Texture resolved(device(), "resolved", plain);
    const Texture sampled = desc.samples > 1 ? Texture(device(), "sampled", many) : Texture();
    const Texture depth(device(), "depth", depth_desc);
    const Texture& target = sampled ? sampled : resolved;
    const Pipeline& pipeline = library().graphics(desc);
    device().run([&](VkCommandBuffer commands) {
      Cmd cmd(device(), commands);
      transition(cmd, resolved, VK_IMAGE_LAYOUT_UNDEFINED, colour_target_layout);
      if (sampled) transition(cmd, sampled, VK_IMAGE_LAYOUT_UNDEFINED, colour_target_layout);
      transition(cmd, depth, VK_IMAGE_LAYOUT_UNDEFINED, depth_target_layout);
      const ColourTarget colour{&target, 0, std::array<float, 4>{0, 0, 1, 1}, sampled ? &resolved : nullptr};
      std::optional<DepthTarget> depth_target;
      if (desc.depth_format != VK_FORMAT_UNDEFINED)
        depth_target = DepthTarget{&depth, 0, options.clear_depth, false};
      cmd.begin_rendering(std::span(&colour, 1), depth_target, extent, options.y_down);
      cmd.bind(pipeline, std::array<Binding, 2>{BufferBinding{&pulled}, BufferBinding{&tint_}});
      cmd.push(pipeline, options.opacity);
      cmd.draw(static_cast<std::uint32_t>(vertices.size()));
      cmd.end_rendering();
    });
    return as<Pixel>(read_back(device(), resolved, colour_target_layout));
  }
  static Pixel at(const std::vector<Pixel>& picture, std::uint32_t x, std::uint32_t y) {
    return picture[y * extent.width + x];
  }
  static bool drawn(const std::vector<Pixel>& picture) {
    return std::ranges::any_of(picture, [](const Pixel& p) { return p != Pixel{0, 0, 255, 255}; });
  }
  Buffer tint_;
};

constexpr Pixel blue{0, 0, 255, 255};

TEST_F(Draw, UpIsUpUnlessAskedOtherwise) {
  const auto up = draw(base(), lower_left(0.5f, red), {});
  EXPECT_EQ(at(up, 1, 14), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(at(up, 14, 1), blue);
  EXPECT_EQ(at(up, 0, 2), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(at(up, 14, 12), blue);
  const auto down = draw(base(), lower_left(0.5f, red), {.y_down = true});
  EXPECT_EQ(at(down, 1, 1), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(at(down, 14, 14), blue);
  EXPECT_EQ(at(down, 14, 0), (Pixel{255, 0, 0, 255}));
}

TEST_F(Draw, BackIsClockwiseAsSeen) {
  GraphicsDesc desc = base();
  const auto seen = [&](Cull cull, std::uint32_t mirrored, bool y_down) {
    desc.cull = cull;
    desc.constants = {{"mirrored", mirrored}};
    return drawn(draw(desc, lower_left(0.5f, red), {.y_down = y_down}));
  };
  EXPECT_TRUE(seen(Cull::back, 0, false));
  EXPECT_FALSE(seen(Cull::front, 0, false));
  EXPECT_FALSE(seen(Cull::back, 1, false));
  EXPECT_TRUE(seen(Cull::front, 1, false));
  EXPECT_FALSE(seen(Cull::back, 0, true));
  EXPECT_TRUE(seen(Cull::none, 1, false));
}

TEST_F(Draw, FourSamplesAreAveragedAndTheNearerWins) {
  GraphicsDesc desc = base();
  desc.samples = 4;
  desc.depth_format = VK_FORMAT_D32_SFLOAT;
  desc.depth_test = desc.depth_write = true;

  // Reversed Z: 0.8 is nearer than 0.3, whichever is drawn first.
  for (const bool near_first : {true, false}) {
    std::vector<Vertex> vertices = lower_left(near_first ? 0.8f : 0.3f, near_first ? green : red);
    const auto second = lower_left(near_first ? 0.3f : 0.8f, near_first ? red : green);
    vertices.insert(vertices.end(), second.begin(), second.end());

    const auto picture = draw(desc, vertices, {});
    EXPECT_EQ(at(picture, 2, 12), (Pixel{0, 255, 0, 255})) << near_first;
    EXPECT_EQ(at(picture, 12, 2), blue);

    // The diagonal runs through these pixels: some of the four samples are green and the rest blue, and their
    // sum is one.
    int mixed = 0;
    for (std::uint32_t i = 0; i < extent.width; ++i) {
      const Pixel p = at(picture, i, i);
      EXPECT_NEAR(p.g + p.b, 255, 1);
      if (p.g > 32 && p.g < 224) ++mixed;
    }
    EXPECT_GE(mixed, 14);
  }
}

TEST_F(Draw, DepthIsWrittenWithoutBeingTested) {
  GraphicsDesc desc = base();
  desc.depth_format = VK_FORMAT_D32_SFLOAT;
  desc.depth_write = true;
  std::vector<Vertex> vertices = lower_left(0.8f, green);
  const auto farther = lower_left(0.3f, red);
  vertices.insert(vertices.end(), farther.begin(), farther.end());
  EXPECT_EQ(at(draw(desc, vertices, {.clear_depth = 1}), 2, 12), (Pixel{255, 0, 0, 255}));
}

TEST_F(Draw, OverBlendsPremultiplied) {
  GraphicsDesc desc = base();
  desc.blend = Blend::over;
  const Pixel p = at(draw(desc, lower_left(0.5f, red), {.opacity = 0.5f}), 2, 12);
  EXPECT_NEAR(p.r, 128, 1);
  EXPECT_NEAR(p.b, 128, 1);
  EXPECT_EQ(p.a, 255);
}

TEST_F(Draw, ConstantsReachTheStageThatDeclaresThem) {
  GraphicsDesc desc = base();
  desc.constants = {{"gain", bits(0.5f)}, {"mirrored", 1}};
  const auto picture = draw(desc, lower_left(0.5f, red), {});
  EXPECT_NEAR(at(picture, 14, 13).r, 128, 1);
  EXPECT_EQ(at(picture, 1, 1), blue);
}

TEST_F(Draw, ClampKeepsWhatLiesOutsideTheDepthRange) {
  GraphicsDesc desc = base();
  EXPECT_FALSE(drawn(draw(desc, lower_left(1.5f, red), {})));
  desc.depth_clamp = true;
  EXPECT_TRUE(drawn(draw(desc, lower_left(1.5f, red), {})));
}

TEST_F(Draw, DepthOnlyThenSampledByComparison) {
  const auto vertices = lower_left(0.5f, red);
  const Buffer pulled =
      make_buffer<Vertex>(device(), "vertices", vertices, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const Texture shadow(device(), "shadow",
                       {.width = 16,
                        .height = 16,
                        .layers = 2,
                        .format = VK_FORMAT_D32_SFLOAT,
                        .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT});
  const Texture single(device(), "single",
                       {.width = 16,
                        .height = 16,
                        .format = VK_FORMAT_D32_SFLOAT,
                        .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  const Buffer out(device(), "out", {.bytes = 16, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});

  GraphicsDesc desc;
  desc.vertex = "triangle.vert";
  desc.depth_format = VK_FORMAT_D32_SFLOAT;
  desc.depth_test = desc.depth_write = true;
  desc.depth_bias = 1;

  const Pipeline& pipeline = library().graphics(desc);
  const Pipeline& compare = library().compute("shadow.comp");
  const VkSampler sampler = library().sampler({.compare_greater = true});

  const auto lit = [&](float x, float y, float depth) {
    device().run([&](VkCommandBuffer commands) {
      Cmd cmd(device(), commands);
      for (const auto& [texture, layer] : {std::pair{&shadow, 1u}, {&single, 0u}}) {
        transition(cmd, *texture, VK_IMAGE_LAYOUT_UNDEFINED, depth_target_layout);
        cmd.begin_rendering({}, DepthTarget{texture, layer, 0.0f}, extent);
        cmd.bind(pipeline, std::array<Binding, 1>{BufferBinding{&pulled}});
        cmd.push(pipeline, 1.0f);
        cmd.draw(3);
        cmd.end_rendering();
      }

      transition(cmd, single, depth_target_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
      cmd.bind(compare, std::array<Binding, 2>{SampledBinding{&single, sampler}, BufferBinding{&out}});
      const float place[] = {x, y, depth};
      cmd.push(compare, place);
      cmd.dispatch(1, 1);
    });
    return values_of<float>(out)[0];
  };

  EXPECT_EQ(lit(0.2f, 0.8f, 0.6f), 1);  // nearer than the triangle
  EXPECT_EQ(lit(0.2f, 0.8f, 0.4f), 0);  // behind it
  EXPECT_EQ(lit(0.8f, 0.2f, 0.4f), 1);  // beside it
}

TEST_F(Draw, IndexedAndTimed) {
  const auto vertices = lower_left(0.5f, red);
  const Buffer pulled =
      make_buffer<Vertex>(device(), "vertices", vertices, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const std::uint32_t order[] = {7, 7, 7, 0, 1, 2};
  const Buffer indices =
      make_buffer<std::uint32_t>(device(), "indices", order, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  const Pipeline& pipeline = library().graphics(base());
  Timer timer(device(), 4);
  for (int turn = 0; turn < 2; ++turn) {
    const Texture target(device(), "target",
                         {.width = 16,
                          .height = 16,
                          .format = VK_FORMAT_R8G8B8A8_UNORM,
                          .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});

    device().run([&](VkCommandBuffer commands) {
      Cmd cmd(device(), commands);
      timer.reset(commands);
      timer.begin(commands, "all");
      timer.begin(commands, "clear");
      device().begin_label(commands, "clear");
      transition(cmd, target, VK_IMAGE_LAYOUT_UNDEFINED, colour_target_layout);
      const ColourTarget cleared{.texture = &target, .clear = std::array{0.0f, 0.0f, 1.0f, 1.0f}};
      cmd.begin_rendering(std::span(&cleared, 1), std::nullopt, extent);
      cmd.end_rendering();
      device().end_label(commands);
      timer.end(commands);

      timer.begin(commands, "draw");
      const ColourTarget colour{&target};
      cmd.begin_rendering(std::span(&colour, 1), std::nullopt, extent);
      cmd.bind(pipeline, std::array<Binding, 2>{BufferBinding{&pulled}, BufferBinding{&tint_}});
      cmd.push(pipeline, 1.0f);
      cmd.draw_indexed({&indices}, 3, 3);
      cmd.end_rendering();
      timer.end(commands);
      timer.end(commands);
      EXPECT_EQ(cmd.recorded().renderings, 2u);
      EXPECT_EQ(cmd.recorded().draws, 1u);
      EXPECT_EQ(cmd.recorded().cleared_pixels, std::uint64_t{extent.width} * extent.height);
    });

    const auto picture = as<Pixel>(read_back(device(), target, colour_target_layout));
    EXPECT_EQ(at(picture, 1, 14), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(at(picture, 14, 1), blue);

    const auto times = timer.read();
    ASSERT_EQ(times.size(), 3u);
    EXPECT_EQ(times[0].name, "all");
    EXPECT_EQ(times[1].name, "clear");
    EXPECT_EQ(times[2].name, "draw");
    if (!device().limits().timestamps) continue;
    EXPECT_GT(times[0].ms, 0);
    EXPECT_LT(times[0].ms, 10000);
    EXPECT_GE(times[0].ms + 1e-6, times[1].ms + times[2].ms);
  }
}

}  // namespace
}  // namespace dermis::gpu
