// SPDX-License-Identifier: MIT
#include "render/setup/environment_light.h"

#include <cmath>
#include <numbers>
#include <span>

#include "base/core/hooks.h"
#include "image/colour.h"
#include "render/passes/asset/gpu_asset.h"
#include "render/setup/background.h"
#include "render/setup/preparation.h"

namespace dermis::setup {
namespace {

std::filesystem::file_time_type time_of(const std::string& name) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(name, error);
  return error ? std::filesystem::file_time_type{} : time;
}

// The picture of an environment, and its mip levels, on the device.
gpu::Texture texture_of(gpu::Device& device, const char* name, std::span<const image::ImageF> levels) {
  std::vector<std::uint16_t> halves;
  for (const image::ImageF& level : levels)
    for (std::size_t i = 0; i < level.values.size(); i += 3) {
      // The sun may be brighter than a half float can say.
      for (std::size_t c = 0; c < 3; ++c)
        halves.push_back(image::float_to_half(std::min(level.values[i + c], image::max_half)));
      halves.push_back(image::float_to_half(1));
    }

  gpu::Texture made(device, name,
                    {.width = static_cast<std::uint32_t>(levels.front().width),
                     .height = static_cast<std::uint32_t>(levels.front().height),
                     .mips = static_cast<std::uint32_t>(levels.size()),
                     .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                     .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  gpu::upload(device, made, std::as_bytes(std::span(halves)));
  return made;
}

}  // namespace

bool EnvironmentSource::operator==(const EnvironmentSource& other) const {
  return name == other.name && written == other.written && shown == other.shown &&
         pixels.rgb == other.pixels.rgb && pixels.width == other.pixels.width &&
         pixels.height == other.pixels.height;
}

std::optional<EnvironmentSource> choose_environment(const RenderSettings& settings,
                                                    const std::optional<SceneEnvironment>& of_scene) {
  EnvironmentSource source{.name = settings.lighting.environment};
  if (source.name.empty() && !of_scene) return {};
  source.shown = background_of(settings.output.background).kind == passes::Behind::Kind::environment;
  if (source.name.empty()) source.name = of_scene->file;
  if (source.name.empty())
    source.pixels = *of_scene;
  else
    source.written = time_of(source.name);
  return source;
}

environment::Environment read_environment(const EnvironmentSource& source) {
  if (source.name == "studio") return environment::studio();
  if (!source.pixels.rgb)
    return preparation("the environment '" + source.name + "'").environment(source.name);
  return environment::from_pixels("environment", source.pixels.width, source.pixels.height,
                                  *source.pixels.rgb);
}

EnvironmentLight environment_light(gpu::Device& device, const EnvironmentSource& source) {
  EnvironmentLight made{.source = source,
                        .sources = {},
                        .irradiance = {},
                        .sky = {},
                        .bouncing_sky = {},
                        .map = {},
                        .picture = {}};

  Steps steps("preparing the environment", 3);
  const environment::Environment whole = read_environment(source);
  if (source.shown) made.picture = texture_of(device, "environment, shown", {&whole.radiance, 1});
  environment::Split split = environment::split_sources(whole);
  steps.done();
  made.sources = std::move(split.sources);
  made.irradiance = environment::irradiance_of(split.remainder);

  steps.done();

  const std::vector<image::ImageF> levels = environment::prefilter(split.remainder);
  const environment::SkyHarmonics sky = environment::sky_of(levels.front());
  made.sky = environment::without_ringing(sky);
  made.bouncing_sky = environment::with_sources(sky, made.sources);
  steps.done();

  made.map = texture_of(device, "environment", levels);
  return made;
}

bool SkyOnSkin::is_of(const EnvironmentLight& environment, double degrees, const glm::mat3& rotation) const {
  return of.get() == &environment && rotation_deg == degrees && world_from_asset == rotation;
}

SkyOnSkin sky_on_skin(gpu::Device& device, std::shared_ptr<const EnvironmentLight> environment_light,
                      double rotation_deg, const glm::mat3& world_from_asset,
                      const std::vector<environment::Occlusion>& occlusion) {
  SkyOnSkin made{.of = std::move(environment_light),
                 .rotation_deg = rotation_deg,
                 .world_from_asset = world_from_asset,
                 .sky = {},
                 .bouncing_sky = {},
                 .maps = {}};
  const auto seen = [&](const environment::SkyHarmonics& world) {
    const environment::SkyHarmonics sky = environment::turned(world, rotation_deg * std::numbers::pi / 180);
    return world_from_asset == glm::mat3(1) ? sky : environment::seen_from(sky, glm::dmat3(world_from_asset));
  };
  made.sky = seen(made.of->sky);
  made.bouncing_sky = seen(made.of->bouncing_sky);
  for (const environment::Occlusion& mesh : occlusion) {
    const environment::SkyLight light = environment::sky_light(mesh, made.sky, made.bouncing_sky);
    made.maps.push_back(
        {passes::unwrap_map(device, "light of the sky", mesh.side, {&light.direct, &light.bounced})});
  }
  return made;
}

std::vector<scene::Light> environment_lights(const std::vector<environment::Source>& sources,
                                             const RenderSettings& settings) {
  const double angle = settings.lighting.environment_rotation_deg * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<scene::Light> lights;
  for (const environment::Source& source : sources) {
    const glm::dvec3& d = source.direction;
    scene::Light light;
    light.name = fmt::format("sun {}", lights.size() + 1);
    light.type = LightType::directional;
    light.colour = glm::vec3(source.irradiance * settings.lighting.environment_intensity);
    light.direction = -glm::vec3(d.x * c + d.z * s, d.y, -d.x * s + d.z * c);
    light.radius = static_cast<float>(source.tangent);
    lights.push_back(light);
  }
  return lights;
}

void fill_environment(io::FrameIo& frame, const EnvironmentLight& environment_light,
                      const RenderSettings& settings) {
  const double angle = settings.lighting.environment_rotation_deg * std::numbers::pi / 180;
  frame.environment_intensity = static_cast<float>(settings.lighting.environment_intensity);
  frame.environment_cos = static_cast<float>(std::cos(angle));
  frame.environment_sin = static_cast<float>(std::sin(angle));
  for (std::size_t k = 0; k < environment_light.irradiance.size(); ++k)
    frame.environment_irradiance[k] =
        glm::vec3(environment_light.irradiance[k] * settings.lighting.environment_intensity);
}

}  // namespace dermis::setup
