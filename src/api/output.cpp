// SPDX-License-Identifier: MIT
#include "api/output.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/known_names.h"
#include "base/settings/names.h"
#include "image/colour.h"
#include "render/techniques/mapped_terms.h"

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

// Texels per mm of a stretch map as colour: the geometric mean of both directions, 0 to 8 texels per mm from
// black to white.
std::vector<float> grey_of_density(std::vector<float> rgba, std::uint32_t most_side) {
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const float density =
        rgba[i + 3] > 0 ? std::sqrt(std::abs(rgba[i] * rgba[i + 2])) * 0.001f * static_cast<float>(most_side)
                        : 0.0f;
    rgba[i] = rgba[i + 1] = rgba[i + 2] = density / 8;
  }
  return rgba;
}

// A square of the picture takes its place.
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

std::vector<float> values_of(std::span<const std::byte> bytes, techniques::Shown::As as,
                             std::uint32_t most_side) {
  if (as == techniques::Shown::As::depth) return grey_of_depth(bytes);
  std::vector<float> values = floats_of_halves(bytes);
  return as == techniques::Shown::As::texel_density ? grey_of_density(std::move(values), most_side) : values;
}

// Eight bits for a display, opaque.
std::vector<std::uint8_t> display_values(const std::vector<float>& rgba, bool is_light) {
  std::vector<std::uint8_t> display(rgba.size(), 255);
  for (std::size_t i = 0; i < rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const float value = std::clamp(rgba[i], 0.0f, 1.0f);
    display[i] =
        static_cast<std::uint8_t>(std::lround(255 * (is_light ? image::linear_to_srgb(value) : value)));
  }
  return display;
}

// Throws InputError if the nearest head does not read the map that `show` names, so that it is not made. The
// map is that of its first skin mesh.
void check_light_is_stored(const techniques::Shown& shown, const std::string& name,
                           const setup::FrameSetup& setup) {
  using Needs = techniques::Shown::Needs;
  const auto head = std::find_if(setup.heads.rbegin(), setup.heads.rend(), [&](const passes::Head& h) {
    return setup.plan.models[h.model].meshes > 0;
  });
  if (shown.needs == Needs::nothing || head == setup.heads.rend()) return;

  const std::uint32_t mesh = setup.plan.models[head->model].first_mesh;
  const std::uint32_t side = head->detail.side;
  const passes::MappedTerms mapped = techniques::mapped_terms(setup.plan, mesh, head->detail);
  if (!mapped.any)
    throw input_error("",
                      "output.show '{}' is not stored from here: with {} of {} texels per side all terms are "
                      "lit per pixel; without quality.depth all are stored",
                      name, side, setup.plan.most_side);
  if (shown.needs == Needs::term && shown.term < mapped.first_written)
    throw input_error(
        "",
        "output.show '{}' is not stored from here: with {} of {} texels per side the terms before "
        "blur:{} are lit per pixel; without quality.depth all are stored",
        name, side, setup.plan.most_side, setup.plan.skin[mesh].first_mapped + mapped.first_written);
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n == 0 ? 0 : n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

void check_device_limits(const RenderSettings& s, const gpu::DeviceLimits& limits) {
  const auto check = [&](const char* name, int value) {
    if (static_cast<std::uint32_t>(value) > limits.max_image_side)
      throw input_error("", "{} {} is over what this device can do: {}", name, value, limits.max_image_side);
  };
  check("output.width or output.height", std::max(s.output.width, s.output.height));
  check("quality.map_size", s.quality.map_size);
  check("quality.shadow_size", s.quality.shadow_size);
}

void check_show(const techniques::FrameOutputs& out, const RenderSettings& settings,
                const setup::FrameSetup& setup) {
  if (settings.output.show == "picture") return;
  const auto found = out.shows.find(settings.output.show);
  if (found != out.shows.end()) {
    check_light_is_stored(found->second, found->first, setup);
    return;
  }

  std::vector<std::string> names{"picture"};
  for (const auto& [name, shown] : out.shows) names.push_back(name);
  throw input_error("", "output.show '{}' is not known to this technique; {}", settings.output.show,
                    listed_names(settings.output.show, names));
}

void fill_counts(Statistics& st, std::span<const AssetPointer> assets, const RenderSettings& settings,
                 const setup::FrameSetup& setup, std::span<const std::byte> counters) {
  st.technique = setup.technique->name;
  st.settings = settings;
  st.width = settings.output.width;
  st.height = settings.output.height;
  st.map_size = settings.quality.map_size;
  st.heads = static_cast<int>(setup.heads.size());
  st.lights = static_cast<int>(setup.lights.size());
  st.environment_lights = setup.environment_lights;
  st.gaussians = setup.gaussians;
  st.distance = settings.camera.distance;
  st.d_ref = setup.d_ref;
  st.tone_map = name_of(settings.output.tone_map);
  for (const AssetPointer& asset : assets)
    for (const scene::Material& m : asset->data->materials)
      if (m.skin) st.skin_materials.push_back(m.name);

  std::vector<std::uint32_t> counts(counters.size() / sizeof(std::uint32_t));
  std::memcpy(counts.data(), counters.data(), counters.size());
  const techniques::FrameReport report = setup.technique->report(setup.plan, counts, setup.heads);
  st.skin_pixels = report.skin_pixels;
  st.optimise = report.optimise;
  st.mask = report.mask;
  st.translucency = report.translucency;
  st.shape_aware = report.shape_aware;
  st.irradiance_texels = report.irradiance_texels;
  st.convolved_texels = report.convolved_texels;
  st.launched = report.launched;
  st.unshaded_reads = report.unshaded_reads;
  st.transmission_misses = report.transmission_misses;
  st.light_reads = report.light_reads;
  if (setup.technique->taps_per_pixel)
    st.light_reads += report.skin_pixels * setup.technique->taps_per_pixel(setup.plan);

  if (!setup.technique->has_light_maps) return;
  st.used_size.resize(setup.heads.size());
  for (const passes::Head& head : setup.heads)
    st.used_size[head.number] = head.visible ? static_cast<int>(head.detail.side) : 0;

  st.mapped_terms.resize(setup.heads.size());
  for (const passes::Head& head : setup.heads) {
    const techniques::Model& model = setup.plan.models[head.model];
    int& most = st.mapped_terms[head.number];
    for (std::uint32_t mesh = model.first_mesh; head.visible && mesh < model.first_mesh + model.meshes;
         ++mesh)
      most = std::max(most, techniques::mapped_count(setup.plan, mesh, head.detail));
  }
}

std::vector<PassStatistics> passes_of(const frame::FrameTime& frame, const frame::FrameGraph& graph) {
  std::vector<PassStatistics> passes;
  auto node = graph.passes().begin();
  for (const gpu::Timing& timed : frame.passes) {
    // In the order of the plan; some of its passes did not run.
    node =
        std::find_if(node, graph.passes().end(), [&](const auto& pass) { return pass.name == timed.name; });
    DERMIS_ASSERT(node != graph.passes().end());
    const frame::WrittenImages written = frame::written_images(graph, *node);
    passes.push_back(
        {.name = timed.name, .ms = timed.ms, .texels = written.texels, .image_bytes = written.bytes});
  }
  return passes;
}

void fill_times(Statistics& statistics, std::span<const frame::FrameTime> frames,
                const frame::FrameGraph& graph) {
  std::vector<double> totals;
  for (const frame::FrameTime& f : frames) totals.push_back(f.total_ms);
  statistics.frame_ms_median = median(totals);
  statistics.frame_ms_min = *std::min_element(totals.begin(), totals.end());
  statistics.frame_ms_max = *std::max_element(totals.begin(), totals.end());
  statistics.frames = static_cast<int>(frames.size());

  statistics.passes = passes_of(frames.front(), graph);
  for (std::size_t p = 0; p < statistics.passes.size(); ++p) {
    std::vector<double> times;
    for (const frame::FrameTime& f : frames) times.push_back(f.passes[p].ms);
    statistics.passes[p].ms = median(times);
  }
}

void fill_device(Statistics& statistics, gpu::Device& device) {
  const DeviceInfo& summary = device.summary();
  statistics.device = summary.name;
  statistics.driver = summary.driver;
  statistics.api = summary.api;
  statistics.image_bytes = device.image_bytes();
  statistics.buffer_bytes = device.buffer_bytes();
  statistics.peak_bytes = device.peak_bytes();
}

void fill_picture(Picture& picture, const RenderSettings& settings, std::span<const std::byte> halves,
                  std::span<const std::byte> display) {
  picture.width = settings.output.width;
  picture.height = settings.output.height;
  picture.linear_rgba = floats_of_halves(halves);
  picture.display_rgba.resize(display.size());
  std::memcpy(picture.display_rgba.data(), display.data(), display.size());
}

std::vector<float> read_before_bloom(frame::GraphExecutor& executor, const techniques::FrameOutputs& out) {
  return floats_of_halves(gpu::read_back(executor.device(), executor.resources().texture(out.before_bloom),
                                         executor.layout_of(out.before_bloom)));
}

void read_picture(Picture& picture, frame::GraphExecutor& executor, const techniques::FrameOutputs& out,
                  const RenderSettings& settings, const setup::FrameSetup& setup) {
  const auto read = [&](frame::TextureId id, std::uint32_t layer) {
    return gpu::read_back(executor.device(), executor.resources().texture(id), executor.layout_of(id), layer);
  };

  if (settings.output.show == "picture") {
    fill_picture(picture, settings, read(out.picture, 0), read(out.display, 0));
    return;
  }

  const auto found = out.shows.find(settings.output.show);
  DERMIS_ASSERT_EQ(found != out.shows.end(), true);
  const techniques::Shown& shown = found->second;
  const gpu::TextureDesc& desc = executor.resources().texture(shown.map).desc();
  picture.width = static_cast<int>(desc.width);
  picture.height = static_cast<int>(desc.height);
  picture.linear_rgba = values_of(read(shown.map, shown.layer), shown.as, setup.plan.most_side);
  if (shown.used_square) crop(picture, shown.origin, static_cast<int>(setup.heads.back().detail.side));
  picture.display_rgba = display_values(picture.linear_rgba, shown.as == techniques::Shown::As::light);
}

}  // namespace dermis::api
