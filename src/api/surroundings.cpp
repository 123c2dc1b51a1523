// SPDX-License-Identifier: MIT
#include "api/surroundings.h"

#include <cmath>
#include <numbers>

#include "image/colour.h"
#include "passes/gpu_scene.h"

namespace dermis::api {
namespace {

std::filesystem::file_time_type time_of(const std::string& name) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(name, error);
  return error ? std::filesystem::file_time_type{} : time;
}

}  // namespace

Surroundings surroundings_of(gpu::Device& device, const std::string& name) {
  Surroundings made{.name = name, .written = time_of(name), .irradiance = {}, .sky = {}, .map = {}};
  const environment::Environment source = environment::from_name_or_file(name);
  made.irradiance = environment::irradiance_of(source);
  const std::vector<image::ImageF> levels = environment::prefilter(source);
  made.sky = environment::sky_of(levels.front());
  std::vector<std::uint16_t> halves;
  for (const image::ImageF& level : levels)
    for (std::size_t i = 0; i < level.values.size(); i += 3) {
      // The sun may be brighter than a half float can say.
      for (std::size_t c = 0; c < 3; ++c)
        halves.push_back(image::float_to_half(std::min(level.values[i + c], image::max_half)));
      halves.push_back(image::float_to_half(1));
    }
  made.map = gpu::Texture(device, "environment",
                          {.width = environment::prefilter_width,
                           .height = environment::prefilter_width / 2,
                           .mips = environment::prefilter_levels,
                           .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                           .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  gpu::upload(device, made.map, std::as_bytes(std::span(halves)));
  return made;
}

bool is_current(const Surroundings& surroundings, const std::string& name) {
  return surroundings.name == name && surroundings.written == time_of(name);
}

SkyOnSkin sky_on_skin(gpu::Device& device, std::shared_ptr<const Surroundings> surroundings,
                      double rotation_deg, const std::vector<environment::Occlusion>& seen) {
  SkyOnSkin made{.of = std::move(surroundings), .rotation_deg = rotation_deg, .maps = {}};
  const environment::SkyHarmonics sky =
      environment::turned(made.of->sky, rotation_deg * std::numbers::pi / 180);
  for (const environment::Occlusion& mesh : seen) {
    const environment::SkyLight light = environment::sky_light(mesh, sky);
    made.maps.push_back(
        {.direct = passes::unwrap_map(device, "light of the sky", mesh.side, light.direct),
         .bounced = passes::unwrap_map(device, "light of the sky, bounced", mesh.side, light.bounced)});
  }
  return made;
}

void fill_surroundings(io::FrameIo& frame, const Surroundings& surroundings, const RenderSettings& settings) {
  const double angle = settings.environment_rotation_deg * std::numbers::pi / 180;
  frame.environment_intensity = static_cast<float>(settings.environment_intensity);
  frame.environment_cos = static_cast<float>(std::cos(angle));
  frame.environment_sin = static_cast<float>(std::sin(angle));
  for (std::size_t k = 0; k < surroundings.irradiance.size(); ++k)
    frame.environment_irradiance[k] = glm::vec3(surroundings.irradiance[k] * settings.environment_intensity);
}

}  // namespace dermis::api
