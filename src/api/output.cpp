// SPDX-License-Identifier: MIT
#include "api/output.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "image/colour.h"

namespace dermis::api {
namespace {

std::vector<float> floats_of_halves(std::span<const std::byte> bytes) {
  std::vector<float> values(bytes.size() / 2);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint16_t half = 0;
    std::memcpy(&half, bytes.data() + 2 * i, 2);
    values[i] = image::half_to_float(half);
  }
  return values;
}

// Depth as shades of grey: near bright, nothing black.
std::vector<float> grey_of_depth(std::span<const std::byte> bytes) {
  std::vector<float> values(bytes.size());
  for (std::size_t i = 0; i < bytes.size() / 4; ++i) {
    float depth = 0;
    std::memcpy(&depth, bytes.data() + 4 * i, 4);
    for (std::size_t c = 0; c < 3; ++c) values[4 * i + c] = depth;
    values[4 * i + 3] = 1;
  }
  return values;
}

// Texels per mm of the stretch map as colour: the geometric mean of both directions, 0 to 8 texels per mm from black to white.
void density_of_stretch(std::vector<float>& rgba, int map_size) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const float density = rgba[i + 3] > 0 ? std::sqrt(std::abs(rgba[i] * rgba[i + 2])) * 0.001f * static_cast<float>(map_size) : 0.0f;
    rgba[i] = rgba[i + 1] = rgba[i + 2] = density / 8;
  }
}

// The density is computed from the stretch map.
std::string shown_map(const RenderSettings& settings) { return settings.show == "texel-density" ? "stretch" : settings.show; }

}  // namespace

void check_device_limits(const RenderSettings& s, const gpu::DeviceLimits& limits) {
  const auto check = [&](const char* name, int value) {
    if (static_cast<std::uint32_t>(value) > limits.max_image_side)
      throw input_error("", "--{} {} is over what this device can do: {}", name, value, limits.max_image_side);
  };
  check("size", std::max(s.width, s.height));
  check("map-size", s.map_size);
  check("shadow-size", s.shadow_size);
}

void check_show(const techniques::FrameOutputs& out, const RenderSettings& settings) {
  if (settings.show == "picture" || out.shows.count(shown_map(settings))) return;
  std::string names = "picture";
  for (const auto& [name, id] : out.shows) names += ", " + name;
  if (out.shows.count("stretch")) names += ", texel-density";
  throw input_error("", "--show '{}' is not known to this technique; there are: {}", settings.show, names);
}

passes::GpuSceneSettings upload_settings(const RenderSettings& settings, const FrameSetup& setup) {
  passes::GpuSceneSettings upload;
  if (settings.mix) upload.mix = static_cast<float>(*settings.mix);
  upload.map_size = settings.map_size;
  if (setup.technique->scatters)
    for (const techniques::SkinPart& part : setup.plan.skin) upload.gutter_texels.push_back(part.gutter_texels);
  return upload;
}

void fill_counts(Statistics& st, const scene::Scene& scene, const RenderSettings& settings, const FrameSetup& setup,
                 const techniques::FrameOutputs& out, std::span<const std::byte> counters) {
  std::uint32_t counts[techniques::counter_count] = {};
  DERMIS_ASSERT_EQ(counters.size(), sizeof counts);
  std::memcpy(counts, counters.data(), sizeof counts);
  st.technique = setup.technique->name;
  st.width = settings.width, st.height = settings.height;
  st.map_size = settings.map_size;
  st.heads = settings.heads;
  st.lights = setup.lights;
  st.gaussians = setup.gaussians;
  st.distance = settings.distance;
  st.d_ref = setup.d_ref;
  st.skin_pixels = counts[techniques::counter_skin_pixels];
  for (const scene::Material& m : scene.materials)
    if (m.skin) st.skin_materials.push_back(m.name);
  if (setup.technique->scatters) {
    st.irradiance_texels = counts[techniques::counter_irradiance];
    st.convolved_texels = st.irradiance_texels * static_cast<std::uint64_t>(setup.gaussians);
    st.launched = st.irradiance_texels + out.launched_per_head * static_cast<std::uint64_t>(settings.heads);
    st.used_size.assign(static_cast<std::size_t>(settings.heads), settings.map_size);
  }
}

void read_picture(Picture& picture, frame::Executor& executor, const techniques::FrameOutputs& out, const RenderSettings& settings) {
  const auto read = [&](frame::TextureId id, std::uint32_t layer) {
    return gpu::read_back(executor.device(), executor.resources().texture(id), frame::final_layout(executor.plan(), id, false), layer);
  };
  if (settings.show == "picture") {
    picture.width = settings.width, picture.height = settings.height;
    picture.linear_rgba = floats_of_halves(read(out.picture, 0));
    const std::vector<std::byte> display = read(out.display, 0);
    picture.display_rgba.resize(display.size());
    std::memcpy(picture.display_rgba.data(), display.data(), display.size());
    return;
  }
  const bool density = settings.show == "texel-density";
  const auto found = out.shows.find(shown_map(settings));
  DERMIS_ASSERT_EQ(found != out.shows.end(), true);
  const gpu::TextureDesc& desc = executor.resources().texture(found->second).desc();
  const bool depth = desc.format == VK_FORMAT_D32_SFLOAT;
  const std::uint32_t layer = depth ? static_cast<std::uint32_t>(std::stoul(settings.show.substr(settings.show.find(':') + 1))) : 0;
  const std::vector<std::byte> bytes = read(found->second, layer);
  picture.width = static_cast<int>(desc.width), picture.height = static_cast<int>(desc.height);
  picture.linear_rgba = depth ? grey_of_depth(bytes) : floats_of_halves(bytes);
  if (density) density_of_stretch(picture.linear_rgba, settings.map_size);
  const bool is_light = !depth && !density && settings.show != "stretch";
  for (std::size_t i = 0; i < picture.linear_rgba.size(); ++i) {
    const float value = std::clamp(picture.linear_rgba[i], 0.0f, 1.0f);
    picture.display_rgba.push_back(
        i % 4 == 3 ? 255 : static_cast<std::uint8_t>(std::lround(255 * (is_light ? image::linear_to_srgb(value) : value))));
  }
}

}  // namespace dermis::api
