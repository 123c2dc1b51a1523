// SPDX-License-Identifier: MIT
// Measures heads in the frames of a host.
//   hosts_bench OUT.json HEAD [ROUNDS [TECHNIQUE...]]
// One head at 2.5, 10 and 50 radii, the row of 16 at 50; targets of 960 x 600 with one and with four samples;
// light maps and shadow maps of 1024. Three rounds of lambert and texture-space unless told. The head turns,
// so shadow maps are drawn in each frame.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "dermis/renderer.h"
#include "dermis/vulkan.h"
#include "device.h"
#include "support/median.h"

namespace {

using namespace dermis;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr VkExtent2D size{960, 600};
const double tan_half_fov = std::tan(10 * std::numbers::pi / 180);  // as cameras are framed

struct Case {
  int heads = 1;
  double distance = 2.5;  // radii
};
constexpr std::array cases{Case{1, 2.5}, Case{1, 10}, Case{1, 50}, Case{16, 50}};

CameraMatrices camera_at(double distance_m) {
  CameraMatrices m;
  m.camera_from_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -distance_m, 1};
  const double aspect = static_cast<double>(size.width) / size.height;
  m.clip_from_camera = {
      1 / (aspect * tan_half_fov), 0, 0, 0, 0, -1 / tan_half_fov, 0, 0, 0, 0, 0, -1, 0, 0, 0.05, 0};
  return m;
}

// A host with targets of its own, whose skin is shaded in one of both ways.
class Shown {
 public:
  Shown(const host::Device& device, const Renderer& renderer, const Asset& head, const Case& shown,
        const RenderSettings& settings)
      : device_(&device),
        settings_(settings),
        bounds_(head.bounds()),
        camera_(camera_at(shown.distance * bounds_.radius_m)),
        frames_(renderer,
                {.frames_in_flight = 1,
                 .picture = vulkan::PictureTargets{
                     .samples = static_cast<std::uint32_t>(settings.quality.samples), .largest = size}}) {
    for (int i = 0; i < shown.heads; ++i) heads_.push_back(scene_.add({.asset = head}));
    scene_.add_light({.light = {.colour = {2, 1.9, 1.8}, .direction = {-1, -0.5, -1}}});
    scene_.add_light({.light = {.colour = {1, 1, 1.2}, .direction = {1, -0.3, -0.5}}});
    const auto samples = static_cast<std::uint32_t>(settings.quality.samples);
    colour_ =
        device.make_image(VK_FORMAT_R16G16B16A16_SFLOAT, size, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, samples);
    depth_ =
        device.make_image(VK_FORMAT_D32_SFLOAT, size, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, samples);
  }

  // Returns how long the device took, ms.
  double draw() {
    place();
    frames_.update(scene_, settings_);
    const vulkan::View view{
        .camera = camera_, .colour = colour_.view.get(), .depth = depth_.view.get(), .extent = size};
    const auto start = Clock::now();
    device_->run([&](VkCommandBuffer commands) {
      host::transition(commands, colour_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
      host::transition(commands, depth_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
      host::begin_rendering(commands, &colour_, &depth_, std::array<float, 4>{}, 0.0f);
      vkCmdEndRendering(commands);
      frames_.record(commands, std::span(&view, 1), {.frame = number_ + 1, .finished = number_});
    });
    ++number_;
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  }

 private:
  // Side by side; each turns about its middle.
  void place() {
    const double angle = 0.01 * static_cast<double>(number_), c = std::cos(angle), s = std::sin(angle);
    const auto [x, y, z] = bounds_.centre_m;
    for (std::size_t i = 0; i < heads_.size(); ++i) {
      const double column = static_cast<double>(i) - 0.5 * static_cast<double>(heads_.size() - 1),
                   to_m = 2.2 * bounds_.radius_m * column;
      scene_.set_transform(heads_[i],
                           {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, to_m - c * x - s * z, -y, s * x - c * z, 1});
    }
  }

  const host::Device* device_;
  RenderSettings settings_;
  AssetBounds bounds_;
  CameraMatrices camera_;
  Scene scene_;
  std::vector<InstanceId> heads_;
  host::Image colour_, depth_;
  vulkan::HostFrames frames_;
  std::uint64_t number_ = 0;
};

Json cost_of(const host::Device& device, const Asset& head, const Case& shown, const RenderSettings& settings,
             int rounds) {
  const Renderer renderer(device.host());
  Shown frames(device, renderer, head, shown, settings);
  for (int frame = 0; frame < 3; ++frame) frames.draw();  // makes maps and pipelines

  std::vector<double> all_ms;
  for (int frame = 0; frame < 3 * rounds; ++frame) all_ms.push_back(frames.draw());
  const double ms = median(all_ms);
  fmt::print("{:>16}, {} samples, {:>2} heads at {:>4} radii: {:7.1f} ms\n", settings.technique,
             settings.quality.samples, shown.heads, shown.distance, ms);
  return {{"technique", settings.technique},
          {"samples", settings.quality.samples},
          {"heads", shown.heads},
          {"distance", shown.distance},
          {"ms", ms}};
}

void measure(const std::string& path, const Asset& head, int rounds,
             const std::vector<std::string>& techniques) {
  const host::Device device(false);
  Json runs = Json::array();
  for (const std::string& technique : techniques)
    for (const int samples : {1, 4})
      for (const Case& shown : cases) {
        RenderSettings settings{.technique = technique};
        settings.quality.map_size = settings.quality.shadow_size = 1024;
        settings.quality.samples = samples;
        settings.output.exposure_ev = 0;
        runs.push_back(cost_of(device, head, shown, settings, rounds));
      }
  std::ofstream(path) << Json{{"device", device.name()}, {"runs", runs}}.dump(2) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: hosts_bench OUT.json HEAD [ROUNDS [TECHNIQUE...]]\n");
    return 2;
  }
  try {
    const int rounds = argc > 3 ? std::max(std::atoi(argv[3]), 1) : 3;
    std::vector<std::string> techniques(argv + std::min(argc, 4), argv + argc);
    if (techniques.empty()) techniques = {"lambert", "texture-space"};
    const std::string head = argv[2];
    measure(argv[1], head == "built-in" ? Asset::built_in() : Asset::load(head), rounds, techniques);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "hosts_bench: {}\n", error.what());
    return 1;
  }
}
