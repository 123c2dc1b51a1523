// SPDX-License-Identifier: MIT
// Whatever a host gives ends in an exception that names it, and the next good frame is as if nothing had
// been.
#include <cmath>
#include <limits>

#include "frame.h"
#include "gpu/support/pictures.h"
#include "gpu/support/scenes.h"
#include "head/scene/import/shapes.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

using EmbeddedHostility = WithHost;
const VkCommandBuffer no_commands = VK_NULL_HANDLE;

TEST_F(EmbeddedHostility, ARendererNeedsEveryHandle) {
  const Host host;
  using Change = void (*)(vulkan::Host&);
  const std::vector<std::pair<Change, std::string>> cases{
      {[](vulkan::Host& h) { h.get_instance_proc_addr = nullptr; }, "get_instance_proc_addr"},
      {[](vulkan::Host& h) { h.instance = VK_NULL_HANDLE; }, "instance"},
      {[](vulkan::Host& h) { h.physical_device = VK_NULL_HANDLE; }, "physical_device"},
      {[](vulkan::Host& h) { h.device = VK_NULL_HANDLE; }, "device"},
      {[](vulkan::Host& h) { h.queue = VK_NULL_HANDLE; }, "queue"},
      {[](vulkan::Host& h) { h.memory.free = [](const vulkan::MemoryRange&) {}; }, "memory"}};
  for (const auto& [change, name] : cases) {
    vulkan::Host wrong = host.vulkan();
    change(wrong);
    EXPECT_NE(thrown<InputError>([&] { Renderer renderer(wrong); }).find(name), std::string::npos);
  }
  vulkan::Host no_such_family = host.vulkan();
  no_such_family.queue_family = 77;
  EXPECT_THROW(Renderer{no_such_family}, DeviceError);
}

TEST_F(EmbeddedHostility, MemoryThatDoesNotSuitIsRefused) {
  Host host;
  vulkan::Host none = host.vulkan();
  none.memory = {.allocate = [](const vulkan::MemoryRequest&) { return std::nullopt; },
                 .free = [](const vulkan::MemoryRange&) {}};
  EXPECT_THROW(Renderer(none).render(lit_ball(), frame_settings()), DeviceError);

  vulkan::Host null = host.vulkan();
  null.memory = {.allocate = [](const vulkan::MemoryRequest&) { return vulkan::MemoryRange{}; },
                 .free = [](const vulkan::MemoryRange&) {}};
  EXPECT_THROW(Renderer(null).render(lit_ball(), frame_settings()), InputError);
  EXPECT_EQ(host.messages(), std::vector<std::string>{});
}

TEST_F(EmbeddedHostility, ReplacedShadersMustDeclareTheSame) {
  Host host;
  static const std::vector<std::uint32_t> text(64, 0x20202020), cut{0x07230203, 0x00010600, 0, 8, 0, 1};
  std::string last;
  vulkan::Host right = host.vulkan();
  right.find_shader = [&](std::string_view name) {
    last = name;
    return std::span<const std::uint32_t>();
  };
  Renderer(right).render(lit_ball(), frame_settings());
  ASSERT_NE(last, "");

  for (const std::vector<std::uint32_t>* code : {&text, &cut}) {
    vulkan::Host wrong = host.vulkan();
    wrong.find_shader = [&](std::string_view name) {
      return name == last ? std::span<const std::uint32_t>(*code) : std::span<const std::uint32_t>();
    };
    Renderer renderer(wrong);
    EXPECT_NE(thrown<InputError>([&] { renderer.render(lit_ball(), frame_settings()); }).find(last),
              std::string::npos);
  }
}

TEST_F(EmbeddedHostility, OptionsOutOfRange) {
  const Host host;
  const Renderer renderer(host.vulkan());
  using Options = vulkan::HostFrames::Options;
  constexpr VkExtent2D one{1, 1};
  const vulkan::PictureTargets picture{.largest = one};
  const std::vector<std::pair<Options, std::string>> cases{
      {Options{}, "way in"},
      {Options{.frames_in_flight = 0, .picture = picture}, "frames_in_flight"},
      {Options{.frames_in_flight = 1000000000, .picture = picture}, "frames_in_flight"},
      {Options{.picture = vulkan::PictureTargets{}}, "picture.largest"},
      {Options{.picture = vulkan::PictureTargets{.samples = 3, .largest = one}}, "samples"},
      {Options{.picture = vulkan::PictureTargets{.colour_format = VK_FORMAT_UNDEFINED}}, "colour_format"},
      {Options{.picture = vulkan::PictureTargets{.largest = {1000000000, 1}}}, "picture.largest"},
      {Options{.picture = vulkan::PictureTargets{.largest = {0, 600}}}, "picture.largest"},
      {Options{.picture = vulkan::PictureTargets{.colour_format = VK_FORMAT_D32_SFLOAT}}, "colour_format"},
      {Options{.picture = vulkan::PictureTargets{.depth_format = VK_FORMAT_R8G8B8A8_UNORM}}, "depth_format"},
      {Options{.depths = {{.format = VK_FORMAT_R32_SFLOAT}}}, "depths.format"},
      {Options{.depths = std::vector<vulkan::DepthTargets>(1000)}, "depth targets"}};
  for (const auto& [options, name] : cases)
    EXPECT_NE(thrown<InputError>([&] { vulkan::HostFrames(renderer, options); }).find(name),
              std::string::npos)
        << name;
}

// A ball whose halves share their texture coordinates: a picture of it is drawn, its light cannot be read.
TEST_F(EmbeddedHostility, LightOfChartsThatLieApartIsNotToBeRead) {
  scene::AssetData folded = scene::sphere(0.1, 12);
  for (scene::Vertex& vertex : folded.primitives.front().vertices)
    vertex.uv0.x = std::abs(2 * vertex.uv0.x - 1);
  const Scene scene = wrap(folded);

  const Host host;
  const Renderer renderer(host.vulkan());
  vulkan::HostFrames picture(renderer, {.picture = vulkan::PictureTargets{.largest = {64, 64}}});
  EXPECT_NO_THROW(picture.update(scene, frame_settings()));
  vulkan::HostFrames light(renderer, {.scattered = true});
  const Scene before = lit_ball();
  light.update(before, frame_settings());
  EXPECT_NE(thrown<InputError>([&] { light.update(scene, frame_settings()); }).find("charts"),
            std::string::npos);
  EXPECT_NO_THROW(light.record_of(before.instances().front())) << "all is as before";
}

TEST_F(EmbeddedHostility, UpdatesThatDoNotFit) {
  Frame frame;
  Scene scene = lit_ball();
  const InstanceId head = scene.instances().front(), none{12345};
  const LightId point = scene.add_light(
      {.light = {.type = LightType::point, .colour = {0.1, 0.1, 0.1}, .position_m = {0, 0.3, 0.3}}});
  const RenderSettings settings = frame_settings();
  frame.frames->update(scene, settings);

  RenderSettings automatic = settings, irradiance = settings, row = settings, lambert = settings;
  automatic.output.exposure_ev.reset();
  irradiance.output.show = "irradiance";
  row.camera.heads = 3;
  lambert.technique = "lambert";
  EXPECT_THROW(frame.frames->update(scene, automatic), InputError);
  EXPECT_THROW(frame.frames->update(scene, irradiance), InputError);
  EXPECT_THROW(frame.frames->update(scene, row), InputError);
  EXPECT_THROW(frame.frames->update(Scene(), settings), InputError);

  const VkImageView view = frame.depth_image.view;
  const LightId light = scene.lights().front();
  const std::array<double, 16> zero{};
  std::array<double, 16> nan = vulkan::clip_from_world(front_camera());
  nan[5] = std::numeric_limits<double>::quiet_NaN();
  const vulkan::LightShadow twice{.light = light,
                                  .depth = view,
                                  .extent = {64, 64},
                                  .clip_from_world = vulkan::clip_from_world(front_camera())};
  vulkan::LightShadow to_all_sides = twice;
  to_all_sides.light = point;
  const auto drawer = [](VkCommandBuffer, const vulkan::IrradianceTarget&) {};
  const std::vector<std::pair<vulkan::HostInputs, RenderSettings>> wrong{
      {{.drawn_by_host = {none}}, settings},
      {{.deformed = {none}}, settings},
      {{.images = {{.instance = none, .material = "skin", .view = view}}}, settings},
      {{.images = {{.instance = head, .material = "no such", .view = view}}}, settings},
      {{.images = {{.instance = head, .material = "skin"}}}, settings},
      {{.shadows = {{.light = LightId{99}, .depth = view, .extent = {1, 1}, .clip_from_world = nan}}},
       settings},
      {{.shadows = {{.light = light, .depth = view, .extent = {1, 1}, .clip_from_world = nan}}}, settings},
      {{.shadows = {{.light = light, .depth = view, .extent = {1, 1}, .clip_from_world = zero}}}, settings},
      {{.shadows = {{.light = light,
                     .depth = view,
                     .extent = {0, 1000000000},
                     .clip_from_world = vulkan::clip_from_world(front_camera())}}},
       settings},
      {{.shadows = {to_all_sides}}, settings},
      {{.shadows = {twice, twice}}, settings},
      {{.draw_irradiance = drawer}, lambert}};
  for (std::size_t i = 0; i < wrong.size(); ++i)
    EXPECT_THROW(frame.frames->update(scene, wrong[i].second, wrong[i].first), InputError) << i;

  frame.draw();
  EXPECT_LE(largest_difference(frame.colour(), rendered(scene, settings)), target_rounding());
}

TEST_F(EmbeddedHostility, FramesThatCannotBeRecorded) {
  Frame frame({.options = {.picture = vulkan::PictureTargets{}, .depths = {vulkan::DepthTargets{}}}});
  const Scene scene = lit_ball();
  vulkan::View good = frame.view();
  frame.host.run([&](VkCommandBuffer commands) {
    EXPECT_THROW(frame.frames->record(commands, std::span(&good, 1), {.frame = 1}), InputError)
        << "no update";
    EXPECT_THROW(frame.frames->record_of(scene.instances().front()), InputError);
  });
  frame.frames->update(scene, frame_settings());
  frame.draw();

  const double nan = std::numeric_limits<double>::quiet_NaN();
  frame.host.run([&](VkCommandBuffer commands) {
    const auto refused = [&](const char* what, const vulkan::View& view, const vulkan::FrameNumbers& n) {
      EXPECT_THROW(frame.frames->record(commands, std::span(&view, 1), n), InputError) << what;
    };
    const vulkan::FrameNumbers next{.frame = 2, .finished = 1};
    refused("runs back", good, {.frame = 1, .finished = 0});
    refused("zero", good, {.frame = 0, .finished = 0});
    refused("finished itself", good, {.frame = 2, .finished = 2});
    refused("finished later ones", good, {.frame = 2, .finished = ~std::uint64_t{0}});

    using Change = void (*)(vulkan::View&);
    const std::vector<std::pair<const char*, Change>> changes{
        {"no colour", [](vulkan::View& v) { v.colour = VK_NULL_HANDLE; }},
        {"no depth", [](vulkan::View& v) { v.depth = VK_NULL_HANDLE; }},
        {"no size", [](vulkan::View& v) { v.extent = {}; }},
        {"too large",
         [](vulkan::View& v) {
           v.extent = {1000000000, 1000000000};
         }},
        {"area outside",
         [](vulkan::View& v) {
           v.area = {{90, 0}, {10, 10}};
         }},
        {"area before",
         [](vulkan::View& v) {
           v.area = {{-1, 0}, {10, 10}};
         }},
        {"area wraps",
         [](vulkan::View& v) {
           v.area = {{1, 1}, {~0u, ~0u}};
         }},
        {"no camera", [](vulkan::View& v) { v.camera = {}; }},
        {"other depth", [](vulkan::View& v) { v.camera = front_camera(false); }}};
    for (const auto& [what, change] : changes) {
      vulkan::View wrong = good;
      change(wrong);
      refused(what, wrong, next);
    }
    for (const std::size_t i : {0u, 5u, 14u}) {
      vulkan::View wrong = good;
      wrong.camera.camera_from_world[i] = nan;
      refused("NaN", wrong, next);
    }

    const std::vector<vulkan::View> two{good, good};
    EXPECT_THROW(frame.frames->record(commands, two, next), InputError);
    EXPECT_THROW(frame.frames->record(commands, {}, next), InputError);
    EXPECT_THROW(frame.frames->record(no_commands, std::span(&good, 1), next), InputError);

    const auto matrix = vulkan::clip_from_world(front_camera());
    std::array<double, 16> wrong_matrix = matrix;
    wrong_matrix[3] = nan;
    const vulkan::DepthView depth{.depth = frame.depth_image.view, .extent = {side, side}};
    vulkan::DepthView no_image = depth, no_kind = depth;
    no_image.depth = VK_NULL_HANDLE;
    no_kind.targets = 1;
    EXPECT_THROW(frame.frames->record_depth(commands, wrong_matrix, depth), InputError);
    EXPECT_THROW(frame.frames->record_depth(commands, matrix, no_image), InputError);
    EXPECT_THROW(frame.frames->record_depth(commands, matrix, no_kind), InputError);
    EXPECT_THROW(frame.frames->record_depth(no_commands, matrix, depth), InputError);
    EXPECT_THROW(frame.frames->record_deformation(commands, scene.instances().front(), {}), InputError);
    EXPECT_THROW(frame.frames->record_of(scene.instances().front(), 1), InputError);
  });

  frame.draw();
  EXPECT_LE(largest_difference(frame.colour(), rendered(scene, frame_settings())), target_rounding());
}

TEST_F(EmbeddedHostility, MoreFramesThanMayBeInFlight) {
  Frame frame;
  frame.frames->update(lit_ball(), frame_settings());
  frame.draw();
  const vulkan::View view = frame.view();
  frame.host.run([&](VkCommandBuffer commands) {
    frame.host.transition(commands, frame.colour_image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    const auto record = [&](std::uint64_t number) {
      frame.frames->record(commands, std::span(&view, 1), {.frame = number, .finished = 1});
    };
    record(2);
    record(3);
    EXPECT_NE(thrown<InputError>([&] { record(4); }).find("frame 2"), std::string::npos);
  });
}

TEST_F(EmbeddedHostility, ShapesThatDoNotFit) {
  Frame frame;
  const Scene scene = lit_ball();
  const InstanceId head = scene.instances().front();
  frame.frames->update(scene, frame_settings(), {.deformed = {head}});
  const HostBuffer buffer = frame.host.buffer(1 << 20, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  frame.host.run([&](VkCommandBuffer commands) {
    const auto refused = [&](const char* what, const vulkan::DeformedMesh& mesh) {
      EXPECT_THROW(frame.frames->record_deformation(commands, head, std::span(&mesh, 1)), InputError) << what;
    };
    const vulkan::VertexStream good{buffer.handle, 0, 12};
    refused("no such mesh", {.mesh = 1, .vertices = 100000, .positions_m = good});
    refused("too few", {.mesh = 0, .vertices = 0, .positions_m = good});
    refused("stride", {.mesh = 0, .vertices = 100000, .positions_m = {buffer.handle, 0, 0}});
    refused("stride", {.mesh = 0, .vertices = 100000, .positions_m = {buffer.handle, 0, 13}});
    refused("offset", {.mesh = 0, .vertices = 100000, .positions_m = {buffer.handle, 2, 12}});
    refused("huge", {.mesh = 0, .vertices = ~0u, .positions_m = {buffer.handle, 0, 4096}});
    const vulkan::DeformedMesh mesh{.mesh = 0, .vertices = 100000};
    EXPECT_THROW(frame.frames->record_deformation(commands, InstanceId{77}, std::span(&mesh, 1)), InputError);
  });
}

}  // namespace
}  // namespace dermis::tests
