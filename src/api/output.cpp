// SPDX-License-Identifier: MIT
#include "api/output.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "image/colour.h"
#include "shared/tiles_io.h"

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

// Texels per mm of the stretch map as colour: the geometric mean of both directions, 0 to 8 texels per mm
// from black to white.
void density_of_stretch(std::vector<float>& rgba, int map_size) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const float density =
        rgba[i + 3] > 0 ? std::sqrt(std::abs(rgba[i] * rgba[i + 2])) * 0.001f * static_cast<float>(map_size)
                        : 0.0f;
    rgba[i] = rgba[i + 1] = rgba[i + 2] = density / 8;
  }
}

// The square of one head out of the pool.
void crop(Picture& picture, glm::uvec2 origin, int side) {
  std::vector<float> square;
  for (int y = 0; y < side; ++y) {
    const std::size_t row = (static_cast<std::size_t>(origin.y) + static_cast<std::size_t>(y)) *
                            static_cast<std::size_t>(picture.width);
    const auto first = picture.linear_rgba.begin() + static_cast<std::ptrdiff_t>(4 * (row + origin.x));
    square.insert(square.end(), first, first + 4 * static_cast<std::ptrdiff_t>(side));
  }
  picture.linear_rgba = std::move(square);
  picture.width = picture.height = side;
}

// The density is computed from the stretch map.
std::string shown_map(const RenderSettings& settings) {
  return settings.show == "texel-density" ? "stretch" : settings.show;
}

}  // namespace

void check_device_limits(const RenderSettings& s, const gpu::DeviceLimits& limits) {
  const auto check = [&](const char* name, int value) {
    if (static_cast<std::uint32_t>(value) > limits.max_image_side)
      throw input_error("", "--{} {} is over what this device can do: {}", name, value,
                        limits.max_image_side);
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

namespace {

// Texels that hold light from the mesh itself, times the Gaussians that blur them; in halved maps those
// beside seams are among them.
std::uint64_t convolved(const techniques::FrameOutputs& out, std::span<const std::uint32_t> counts) {
  std::uint64_t sum = 0;
  for (std::uint32_t mesh = 0; mesh < out.work.size(); ++mesh)
    for (std::uint32_t halvings = 0; halvings <= passes::max_halvings; ++halvings) {
      const auto which = halvings == 0 ? techniques::counter_lit_texels : techniques::counter_masked_texels;
      sum += std::uint64_t{counts[techniques::mesh_counter(mesh, halvings, which)]} *
             out.work[mesh][halvings].terms;
    }
  return sum;
}

std::uint64_t irradiance_texels(const techniques::FrameOutputs& out, std::span<const std::uint32_t> counts) {
  std::uint64_t sum = 0;
  for (std::uint32_t mesh = 0; mesh < out.work.size(); ++mesh)
    sum += counts[techniques::mesh_counter(mesh, 0, techniques::counter_lit_texels)];
  return sum;
}

std::uint64_t used_texels(const setup::FrameSetup& setup, std::uint32_t halvings) {
  std::uint64_t sum = 0;
  for (const setup::HeadSetup& head : setup.heads) {
    const std::uint64_t side =
        passes::halved_side(static_cast<std::uint32_t>(head.map_side), setup.plan.map_size, halvings);
    if (head.visible) sum += side * side;
  }
  return sum;
}

// Shader invocations of shading and convolution. Drawn or computed whole, a convolution runs over the used
// squares; otherwise over what its mask leaves of them.
std::uint64_t launched(const setup::FrameSetup& setup, const techniques::FrameOutputs& out,
                       std::span<const std::uint32_t> counts) {
  std::uint64_t sum = irradiance_texels(out, counts);
  const bool sparse = setup.plan.optimise.cull || setup.plan.optimise.clip;
  for (std::uint32_t mesh = 0; mesh < out.work.size(); ++mesh)
    for (std::uint32_t halvings = 0; halvings <= passes::max_halvings; ++halvings) {
      const techniques::FrameOutputs::LevelWork& work = out.work[mesh][halvings];
      std::uint64_t texels = used_texels(setup, halvings);
      if (work.halved) sum += texels;
      if (sparse && setup.plan.mask == passes::Mask::tiles)
        texels = std::uint64_t{TILE_WIDTH * TILE_HEIGHT} *
                 counts[techniques::mesh_counter(mesh, halvings, techniques::counter_tiles)];
      if (sparse && setup.plan.mask == passes::Mask::depth)
        texels = counts[techniques::mesh_counter(mesh, halvings, techniques::counter_masked_texels)];
      sum += texels * work.convolutions;
    }
  return sum;
}

void fill_optimise(Statistics& st, const techniques::FrameSettings& plan) {
  const techniques::Optimise& o = plan.optimise;
  if (o.cull) st.optimise.emplace_back("cull");
  if (o.depth) st.optimise.emplace_back("depth");
  if (o.clip) st.optimise.emplace_back("clip");
  if (o.cull || o.clip)
    st.mask = plan.mask == passes::Mask::alpha   ? "alpha"
              : plan.mask == passes::Mask::depth ? "depth"
                                                 : "tiles";
}

}  // namespace

void fill_counts(Statistics& st, const setup::Subject& subject, const RenderSettings& settings,
                 const setup::FrameSetup& setup, const techniques::FrameOutputs& out,
                 std::span<const std::byte> counters) {
  std::vector<std::uint32_t> counts(counters.size() / sizeof(std::uint32_t));
  DERMIS_ASSERT_EQ(counts.size(), techniques::counter_count(subject.skin.size()));
  std::memcpy(counts.data(), counters.data(), counters.size());

  st.technique = setup.technique->name;
  st.width = settings.width;
  st.height = settings.height;
  st.map_size = settings.map_size;
  st.heads = settings.heads;
  st.lights = setup.lights;
  st.environment_lights = setup.suns;
  st.gaussians = setup.gaussians;
  st.distance = settings.distance;
  st.d_ref = setup.camera.d_ref;
  st.tone_map = settings.tone_map;

  st.skin_pixels = counts[techniques::counter_skin_pixels];
  for (const scene::Material& m : subject.scene->materials)
    if (m.skin) st.skin_materials.push_back(m.name);

  if (!setup.technique->scatters) return;
  fill_optimise(st, setup.plan);
  st.maps = setup.plan.progressive ? "progressive" : "full";
  st.irradiance_texels = irradiance_texels(out, counts);
  st.convolved_texels = convolved(out, counts);
  st.unshaded_reads = counts[techniques::counter_unshaded_reads];
  st.translucency = setup.plan.translucency;
  st.transmission_misses = counts[techniques::counter_transmission_misses];
  st.launched = launched(setup, out, counts);

  st.used_size.resize(setup.heads.size());
  for (const setup::HeadSetup& head : setup.heads)
    st.used_size[static_cast<std::size_t>(head.number)] = head.visible ? head.map_side : 0;
}

std::vector<float> read_before_bloom(frame::Executor& executor, const techniques::FrameOutputs& out) {
  return floats_of_halves(gpu::read_back(executor.device(), executor.resources().texture(out.before_bloom),
                                         executor.layout_of(out.before_bloom)));
}

void read_picture(Picture& picture, frame::Executor& executor, const techniques::FrameOutputs& out,
                  const RenderSettings& settings, const setup::FrameSetup& setup) {
  const auto read = [&](frame::TextureId id, std::uint32_t layer) {
    return gpu::read_back(executor.device(), executor.resources().texture(id), executor.layout_of(id), layer);
  };

  if (settings.show == "picture") {
    picture.width = settings.width;
    picture.height = settings.height;
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
  const std::uint32_t layer =
      depth ? static_cast<std::uint32_t>(std::stoul(settings.show.substr(settings.show.find(':') + 1))) : 0;

  const std::vector<std::byte> bytes = read(found->second, layer);
  picture.width = static_cast<int>(desc.width);
  picture.height = static_cast<int>(desc.height);
  picture.linear_rgba = depth ? grey_of_depth(bytes) : floats_of_halves(bytes);

  const bool is_light = settings.show == "irradiance" || settings.show.rfind("blur:", 0) == 0;
  if (is_light) crop(picture, out.shown_origin, setup.heads.back().map_side);
  if (settings.show == "visibility") crop(picture, {0, 0}, setup.heads.back().map_side);
  if (density) density_of_stretch(picture.linear_rgba, settings.map_size);

  for (std::size_t i = 0; i < picture.linear_rgba.size(); ++i) {
    const float value = std::clamp(picture.linear_rgba[i], 0.0f, 1.0f);
    picture.display_rgba.push_back(i % 4 == 3
                                       ? 255
                                       : static_cast<std::uint8_t>(std::lround(
                                             255 * (is_light ? image::linear_to_srgb(value) : value))));
  }
}

}  // namespace dermis::api
