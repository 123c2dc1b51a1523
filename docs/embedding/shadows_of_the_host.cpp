// SPDX-License-Identifier: MIT
// An off-screen host whose shadow map is also the one of dermis: a bar of the host throws its shadow on a
// head of dermis, and the head throws one on the floor of the host.
//
//   shadows_of_the_host [PICTURE.ppm]    exits with 1 on errors and on messages of the validation layer
//
// A frame: the host's bar and dermis's head into the shadow map (way ii), floor, bar and head into the depth
// pre-pass (way ii), floor and bar into the colour by the host, the head by HostFrames::record() (way i),
// which reads the shadow map (way iv).
#include <dermis/vulkan.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#define GLM_FORCE_DEPTH_ZERO_TO_ONE
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "device.h"
#include "pipeline.h"

namespace {

namespace dv = dermis::vulkan;

constexpr VkExtent2D kExtent{480, 480}, kMapExtent{1024, 1024};
constexpr std::uint32_t kFrames = 24, kInFlight = 2;
constexpr VkFormat kColourFormat = VK_FORMAT_R32G32B32A32_SFLOAT, kDepthFormat = VK_FORMAT_D32_SFLOAT;
// The light of host and heads, in the unit of dermis: irradiance pi on white shows 1.
constexpr float kIrradiance = 3.0F, kAmbient = 0.05F;
const glm::dvec3 kToLight = glm::normalize(glm::dvec3(0.35, 0.8, 0.9));
// The built-in head is about 0.25 m high and stands around the origin: found by looking, for no member of
// Asset says so.
const glm::dvec3 kMiddle{0.0, 0.0, 0.0};
constexpr double kReach = 0.3;  // m around kMiddle that the shadow map holds, across the light

constexpr std::uint32_t kVertexCode[] = {
#include "box.vert.inc"
};
constexpr std::uint32_t kFragmentCode[] = {
#include "box.frag.inc"
};

struct Box {
  glm::dvec3 centre, half;
};
const Box kFloor{{0.0, -0.18, -0.1}, {0.6, 0.01, 0.6}};

Box bar(double turn) {  // of the way from left to right
  return {kMiddle + 0.4 * kToLight + glm::dvec3(-0.1 + 0.2 * turn, 0.0, 0.0), {0.01, 0.15, 0.01}};
}

std::array<double, 16> array_of(const glm::dmat4& m) {
  std::array<double, 16> a{};
  std::copy_n(glm::value_ptr(m), 16, a.begin());
  return a;
}

glm::dmat4 y_down(glm::dmat4 projection) {
  for (int c = 0; c < 4; ++c) projection[c][1] = -projection[c][1];
  return projection;
}

// Near is 1, as PictureTargets has it: near and far change places.
dermis::CameraMatrices make_camera() {
  const glm::dmat4 view = glm::lookAtRH(kMiddle + glm::dvec3(-0.35, 0.15, 1.1),
                                        kMiddle + glm::dvec3(0.03, 0.03, 0), glm::dvec3(0, 1, 0));
  return {array_of(view), array_of(y_down(glm::perspectiveRH_ZO(glm::radians(24.0), 1.0, 10.0, 0.1)))};
}

// Near is 0, which LightShadow is told.
glm::dmat4 make_light_matrix() {
  const glm::dmat4 view = glm::lookAtRH(kMiddle + kToLight, kMiddle, glm::dvec3(0, 1, 0));
  return y_down(glm::orthoRH_ZO(-kReach, kReach, -kReach, kReach, 0.5, 2.0)) * view;
}

// What a frame shows, so that pictures can be compared.
struct Shown {
  double turn = 0;
  bool bar = true;  // in the shadow map; the camera always sees it
  bool head_in_map = true;
};

struct Pixel {
  float r, g, b, a;
  double luminance() const { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }
};
struct Picture {
  std::vector<Pixel> colour;
  std::vector<float> depth;
};

template <class Value>
std::vector<Value> texels_of(const std::vector<std::byte>& bytes) {
  std::vector<Value> values(bytes.size() / sizeof(Value));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

// As the shaders have them.
struct BoxPush {
  glm::mat4 clip_from_world;
  glm::vec4 centre, half;
};
struct LightBlock {
  glm::mat4 light_from_world;
  glm::vec4 to_light;
  float ambient;
};

class Program {
 public:
  explicit Program(const host::Device& device) : device_(device) {
    const dermis::LightId id = scene_.add_light({.light = light()});
    scene_.add({.asset = dermis::Asset::built_in()});
    settings_.lighting.ambient = kAmbient;
    settings_.output.exposure_ev = 0.0;
    inputs_.shadows = {{.light = id,
                        .depth = map_.view.get(),
                        .extent = kMapExtent,
                        .clip_from_world = array_of(light_from_world_),
                        .reversed_depth = false}};
    frames_.update(scene_, settings_, inputs_);
  }
  ~Program() { queue_.wait(); }  // before frames_ goes, the device must have finished

  void use_own_shadows() { frames_.update(scene_, settings_, {}); }

  // Submits a frame; waits only for the one before the last. What only the host moves needs no update().
  void draw(const Shown& shown) {
    const host::Frames::Frame frame = queue_.begin();
    record(frame, shown);
    queue_.submit();
  }

  Picture picture(const Shown& shown) {
    draw(shown);
    return {texels_of<Pixel>(device_.read(colour_, sizeof(Pixel))),
            texels_of<float>(device_.read(depth_, sizeof(float)))};
  }

  glm::dmat4 world_from_clip() const { return glm::inverse(clip_from_world_); }
  dermis::DeviceCounters counters() const { return renderer_.counters(); }

 private:
  static dermis::Light light() {
    const glm::dvec3 d = -kToLight;
    return {.name = "sun",
            .type = dermis::LightType::directional,
            .colour = {kIrradiance, kIrradiance, kIrradiance},
            .direction = {d.x, d.y, d.z}};
  }

  // One host pass: the boxes, each under the same matrix. A set of descriptors: with colour.
  void draw_boxes(VkCommandBuffer commands, const host::Pipeline& pipeline, VkDescriptorSet set,
                  const glm::dmat4& clip_from_world, const std::vector<Box>& boxes) const {
    if (set) {
      pipeline.bind(commands, set);
    } else {
      pipeline.bind(commands);
    }
    for (const Box& box : boxes) {
      pipeline.push(commands, BoxPush{clip_from_world, glm::dvec4(box.centre, 1), glm::dvec4(box.half, 0)});
      vkCmdDraw(commands, 36, 1, 0, 0);
    }
    vkCmdEndRendering(commands);
  }

  void record(const host::Frames::Frame& frame, const Shown& shown) {
    const VkCommandBuffer commands = frame.commands;
    // The shadow map. One for all frames: dermis's barriers and the host's keep their order.
    map_.layout = depth_.layout = colour_.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    host::transition(commands, map_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    host::begin_rendering(commands, nullptr, &map_, {}, 1.0F);
    draw_boxes(commands, in_map_, VK_NULL_HANDLE, light_from_world_,
               shown.bar ? std::vector{bar(shown.turn)} : std::vector<Box>{});
    // Without the head the map would say that nothing is between the light and the skin that faces away from
    // it, and light would come through all of the body.
    if (shown.head_in_map) {
      frames_.record_depth(commands, array_of(light_from_world_),
                           {.targets = 0, .depth = map_.view.get(), .extent = kMapExtent});
    }
    host::transition(commands, map_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);

    // The depth pre-pass; `cull` as the picture does, so that its depth is equal.
    const std::vector<Box> seen{kFloor, bar(shown.turn)};
    host::transition(commands, depth_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    host::begin_rendering(commands, nullptr, &depth_, {}, 0.0F);
    draw_boxes(commands, in_depth_, VK_NULL_HANDLE, clip_from_world_, seen);
    frames_.record_depth(commands, dv::clip_from_world(camera_),
                         {.targets = 1, .depth = depth_.view.get(), .extent = kExtent, .cull = true});

    host::transition(commands, colour_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    host::begin_rendering(commands, &colour_, &depth_, std::array<float, 4>{});
    const std::array<host::Descriptor, 2> values{
        {{.image = {sampler_.get(), map_.view.get(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}},
         {.buffer = {light_block_.buffer.get(), 0, VK_WHOLE_SIZE}}}};
    draw_boxes(commands, in_colour_, sets_.write(frame.slot, values), clip_from_world_, seen);
    const dv::View view{
        .camera = camera_, .colour = colour_.view.get(), .depth = depth_.view.get(), .extent = kExtent};
    frames_.record(commands, {&view, 1}, frame.numbers);
  }

  const host::Device& device_;
  const dermis::CameraMatrices camera_ = make_camera();
  const glm::dmat4 clip_from_world_ = glm::make_mat4(dv::clip_from_world(camera_).data());
  const glm::dmat4 light_from_world_ = make_light_matrix();

  host::Image map_ = device_.make_image(
      kDepthFormat, kMapExtent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
  host::Image depth_ = device_.make_image(
      kDepthFormat, kExtent, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  host::Image colour_ = device_.make_image(
      kColourFormat, kExtent, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
  const host::Buffer light_block_ = device_.make_buffer_of(
      std::vector{LightBlock{light_from_world_, glm::dvec4(kToLight, kIrradiance), kAmbient}},
      VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  const host::Owned<VkSampler> sampler_ = host::make_sampler(device_, VK_COMPARE_OP_LESS_OR_EQUAL);
  const host::Pipeline in_map_{device_,
                               {.vertex = kVertexCode,
                                .push_bytes = sizeof(BoxPush),
                                .compare = VK_COMPARE_OP_LESS_OR_EQUAL,
                                .cull = VK_CULL_MODE_NONE}};
  const host::Pipeline in_depth_{
      device_, {.vertex = kVertexCode, .push_bytes = sizeof(BoxPush), .cull = VK_CULL_MODE_NONE}};
  const host::Pipeline in_colour_{
      device_,
      {.vertex = kVertexCode,
       .fragment = kFragmentCode,
       .colour_format = kColourFormat,
       .descriptors = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
       .push_bytes = sizeof(BoxPush),
       .cull = VK_CULL_MODE_NONE}};
  const host::DescriptorSets sets_{device_, in_colour_, kInFlight};

  dermis::Scene scene_;
  dermis::RenderSettings settings_;
  dv::HostInputs inputs_;
  dermis::Renderer renderer_{device_.host()};
  // Depth targets: 0 is the shadow map, near 0; 1 the pre-pass, near 1 as the picture.
  dv::HostFrames frames_{renderer_,
                         {.frames_in_flight = kInFlight,
                          .picture = dv::PictureTargets{.colour_format = kColourFormat, .largest = kExtent},
                          .depths = {{.format = kDepthFormat, .reversed_depth = false},
                                     {.format = kDepthFormat, .reversed_depth = true}}}};
  host::Frames queue_{device_, kInFlight};
};

// Whether the ray from a point to the light meets the box.
bool in_shadow_of(const Box& box, const glm::dvec3& point) {
  const glm::dvec3 a = (box.centre - box.half - point) / kToLight,
                   b = (box.centre + box.half - point) / kToLight;
  const glm::dvec3 near = glm::min(a, b), far = glm::max(a, b);
  return std::max({near.x, near.y, near.z, 0.0}) < std::min({far.x, far.y, far.z});
}

// Means of luminance, each of a set of pixels that `wanted` chooses by place and skin.
template <class Wanted>
double mean(const Program& program, const Picture& picture, const Wanted& wanted,
            std::size_t* counted = nullptr) {
  const glm::dmat4 world_from_clip = program.world_from_clip();
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < picture.colour.size(); ++i) {
    if (picture.depth[i] == 0) continue;  // nothing is there
    const glm::dvec4 p =
        world_from_clip * glm::dvec4((static_cast<double>(i % kExtent.width) + 0.5) / kExtent.width * 2 - 1,
                                     (static_cast<double>(i / kExtent.width) + 0.5) / kExtent.height * 2 - 1,
                                     picture.depth[i], 1);
    if (!wanted(glm::dvec3(p) / p.w, picture.colour[i].a == 1)) continue;
    sum += picture.colour[i].luminance();
    ++count;
  }
  if (counted) *counted = count;
  return count ? sum / static_cast<double>(count) : 0;
}

void write_ppm(const Picture& picture, const std::string& path) {
  std::ofstream file(path, std::ios::binary);
  file << "P6\n" << kExtent.width << ' ' << kExtent.height << "\n255\n";
  for (const Pixel& p : picture.colour)
    for (const float c : {p.r, p.g, p.b})
      file.put(static_cast<char>(std::lround(255 * std::pow(std::clamp(c, 0.0F, 1.0F), 1 / 2.2F))));
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

// Returns whether the shadows are where they should be.
bool run(const host::Device& device, const std::string& path) {
  Program program(device);
  for (std::uint32_t f = 0; f < kFrames; ++f) program.draw({.turn = static_cast<double>(f) / (kFrames - 1)});
  const dermis::DeviceCounters before = program.counters();
  constexpr double turn = 0.5;
  const Picture with = program.picture({.turn = turn});
  const Picture without = program.picture({.turn = turn, .bar = false});
  const Picture headless = program.picture({.turn = turn, .head_in_map = false});
  const dermis::DeviceCounters after = program.counters();
  program.use_own_shadows();
  const Picture own = program.picture({.turn = turn, .bar = false});

  const auto shaded = [&](const glm::dvec3& p, bool skin) { return skin && in_shadow_of(bar(turn), p); };
  const auto unshaded = [&](const glm::dvec3& p, bool skin) { return skin && !in_shadow_of(bar(turn), p); };
  const auto floor = [&](const glm::dvec3& p, bool) { return std::abs(p.y - kFloor.centre.y - 0.01) < 1e-4; };
  std::size_t pixels = 0, others = 0;
  const double dark = mean(program, with, shaded, &pixels), bright = mean(program, without, shaded);
  const double dark_others = mean(program, with, unshaded, &others);
  const double bright_others = mean(program, without, unshaded);
  std::printf("skin behind the bar, %zu pixels: %.4f with the bar, %.4f without\n", pixels, dark, bright);
  std::printf("other skin, %zu pixels: %.4f with the bar, %.4f without\n", others, dark_others,
              bright_others);
  std::printf("all skin without the bar: %.4f by the host's map, %.4f by dermis's own\n",
              mean(program, without, [](const glm::dvec3&, bool skin) { return skin; }),
              mean(program, own, [](const glm::dvec3&, bool skin) { return skin; }));
  const double under = mean(program, with, floor), free = mean(program, headless, floor);
  std::printf("floor: %.4f with the head's shadow, %.4f without\n", under, free);
  std::printf("three steady frames: %llu allocations, %llu submissions of dermis\n",
              static_cast<unsigned long long>(after.allocations - before.allocations),
              static_cast<unsigned long long>(after.submissions - before.submissions));
  write_ppm(with, path);
  std::printf("%s: a head of dermis, a bar and a floor of the host after %u frames\n", path.c_str(),
              kFrames + 4);
  return pixels > 100 && dark < 0.7 * bright && under < free;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const host::Device device(true);
    const bool good = run(device, argc > 1 ? argv[1] : "shadows_of_the_host.ppm");
    for (const std::string& message : device.messages()) std::fprintf(stderr, "%s\n", message.c_str());
    std::printf("%s, %zu messages; shadows are %s\n",
                device.validated() ? "validated" : "no validation layer", device.messages().size(),
                good ? "right" : "WRONG");
    return good && device.messages().empty() ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "shadows_of_the_host: %s\n", e.what());
    return 1;
  }
}
