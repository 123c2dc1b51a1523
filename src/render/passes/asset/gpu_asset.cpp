// SPDX-License-Identifier: MIT
#include "render/passes/asset/gpu_asset.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <new>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "gpu/device.h"
#include "gpu/texture_upload.h"
#include "head/scene/surface/fine_normals.h"
#include "head/scene/surface/turned.h"
#include "head/scene/surface/weld.h"
#include "image/colour.h"
#include "image/resize.h"
#include "render/passes/asset/alpha_max.h"
#include "render/passes/asset/charts_first.h"
#include "render/passes/asset/curvature_smoothing.h"
#include "render/passes/asset/first_corners.h"
#include "render/passes/asset/gutter_list.h"
#include "render/passes/asset/vertices.h"
#include "render/shared/gutters_io.h"
#include "render/shared/rig_io.h"
#include "render/shared/sources_io.h"
#include "tissue/optics/directional_albedo.h"

namespace dermis::passes {
namespace {

constexpr int generated = -1;  // image number of maps without a file
constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

io::MapIo map_io(const scene::MapRef& map) {
  return {.u_axis = map.transform[0],
          .v_axis = map.transform[1],
          .offset = map.transform[2],
          .uv_set = static_cast<std::uint32_t>(map.uv_set),
          .channel = static_cast<std::uint32_t>(map.channel),
          .scale = map.scale,
          .present = map.present() ? 1u : 0u};
}

gpu::Address address(AssetWrap wrap) {
  return wrap == AssetWrap::repeat  ? gpu::Address::repeat
         : wrap == AssetWrap::clamp ? gpu::Address::clamp
                                    : gpu::Address::mirror;
}

std::array<scene::MapRef, MAP_COUNT> maps_of(const scene::Material& m) {
  std::array<scene::MapRef, MAP_COUNT> maps;
  maps[MAP_BASE_COLOUR] = m.base_colour_map;
  maps[MAP_NORMAL] = m.normal_map;
  maps[MAP_ROUGHNESS] = m.metallic_roughness_map;
  maps[MAP_OCCLUSION] = m.occlusion_map;
  maps[MAP_SPECULAR] = m.specular_map;
  maps[MAP_EMISSIVE] = m.emissive_map;
  maps[MAP_SPECULAR_COLOUR] = m.specular_colour_map;

  if (m.skin) {
    maps[MAP_SPECULAR] = m.skin_settings.specular;
    maps[MAP_ROUGHNESS] = m.skin_settings.roughness;
    maps[MAP_DETAIL] = m.skin_settings.detail;

    // Skin without a roughness map of its own has glTF's: G of metallic-roughness, times the factor.
    if (!maps[MAP_ROUGHNESS].present() && m.metallic_roughness_map.present()) {
      maps[MAP_ROUGHNESS] = m.metallic_roughness_map;
      maps[MAP_ROUGHNESS].channel = 1;
      maps[MAP_ROUGHNESS].scale = m.roughness;
    }
  }

  return maps;
}

io::MaterialIo material_io(const scene::Material& m, const std::array<scene::MapRef, MAP_COUNT>& maps) {
  io::MaterialIo c{};
  c.base_colour = m.base_colour;
  c.emissive = m.emissive;
  c.metallic = m.metallic;
  c.roughness = m.roughness;
  c.ior = m.ior;
  c.specular = m.specular;
  // Alpha of 8 bits may become a half float: a value equal to the cutoff must be kept.
  c.alpha_cutoff = m.alpha_cutoff - 1.0f / 4096;
  c.transmission = m.transmission;
  c.specular_colour = m.specular_colour;

  c.flags = (m.double_sided ? MATERIAL_DOUBLE_SIDED : 0u) | (m.unlit ? MATERIAL_UNLIT : 0u) |
            (m.alpha_mode == AssetAlpha::mask ? MATERIAL_ALPHA_MASK : 0u) |
            (m.alpha_mode == AssetAlpha::blend ? MATERIAL_ALPHA_BLEND : 0u);

  c.mix_before = m.skin_settings.mix_or_default();
  c.rho_s = 0.18f;  // [DLE07] GPU Gems 3, ch. 14.3
  const auto& lobes = m.skin_settings.lobes;
  c.lobe_factor_0 = lobes.empty() ? 1.0f : lobes[0].roughness_factor;
  c.lobe_weight_0 = lobes.empty() ? 1.0f : lobes[0].weight;
  c.lobe_factor_1 = lobes.size() > 1 ? lobes[1].roughness_factor : 1.0f;
  c.lobe_weight_1 = lobes.size() > 1 ? lobes[1].weight : 0.0f;

  for (int i = 0; i < MAP_COUNT; ++i) c.maps[i] = map_io(maps[static_cast<std::size_t>(i)]);
  return c;
}

gpu::Texture single_texel(gpu::Device& device, const char* name, std::array<std::uint8_t, 4> rgba,
                          bool array = false) {
  gpu::Texture texture(device, name,
                       {.width = 1,
                        .height = 1,
                        .format = VK_FORMAT_R8G8B8A8_UNORM,
                        .usage = VK_IMAGE_USAGE_SAMPLED_BIT,
                        .array = array});
  gpu::upload(device, texture, std::as_bytes(std::span(rgba)));
  return texture;
}

// Returns RGBA16F texels of an sRGB map: linear colours, alpha unchanged.
std::vector<std::uint16_t> halves_of(std::span<const std::uint8_t> rgba) {
  std::array<std::uint16_t, 256> plain{}, linear{};
  for (std::size_t i = 0; i < 256; ++i) {
    plain[i] = image::float_to_half(static_cast<float>(i) / 255.0f);
    linear[i] = image::float_to_half(image::srgb8_to_linear(static_cast<std::uint8_t>(i)));
  }
  std::vector<std::uint16_t> halves(rgba.size());
  for (std::size_t i = 0; i < rgba.size(); ++i) halves[i] = (i % 4 == 3 ? plain : linear)[rgba[i]];
  return halves;
}

// Uploads the table of the directional albedo as RGBA16F.
gpu::Texture upload_directional_albedo(gpu::Device& device) {
  std::vector<std::uint16_t> halves;
  for (const float value : optics::directional_albedo_table()) halves.push_back(image::float_to_half(value));
  gpu::Texture texture(device, "directional_albedo",
                       {.width = optics::directional_albedo_columns + 2,
                        .height = optics::directional_albedo_rows,
                        .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                        .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  gpu::upload(device, texture, std::as_bytes(std::span(halves)));
  return texture;
}

// Without a shape it is 0.
std::vector<io::SkinVertexIo> skin_vertices_of(const scene::SkinMesh& skin,
                                               std::span<const scene::VertexShape> shape) {
  std::vector<io::SkinVertexIo> vertices;
  for (std::size_t i = 0; i < skin.vertices.size(); ++i) {
    const scene::VertexShape body = shape.empty() ? scene::VertexShape{} : shape[i];
    vertices.push_back({.unwrap = skin.unwrap[i],
                        .metric_mm2 = skin.metric[i],
                        .chart = 0,
                        .curvature_per_mm =
                            glm::packHalf2x16({body.curvature.mean_per_mm, body.curvature.difference_per_mm}),
                        .body_mm = glm::packHalf2x16({body.thickness_mm, body.border_mm})});
  }
  for (std::size_t i = 0; i < skin.indices.size(); ++i)
    vertices[skin.indices[i]].chart = skin.triangle_chart[i / 3];  // no vertex is between two
  return vertices;
}

GpuMesh upload_sorted_skin(gpu::Device& device, const scene::SkinMesh& skin, std::size_t number) {
  std::vector<io::VertexIo> vertices;
  std::vector<io::VertexExtraIo> extras;
  for (std::size_t i = 0; i < skin.vertices.size(); ++i) {
    vertices.push_back(vertex_io(skin.vertices[i]));
    extras.push_back(vertex_extra_io(skin.vertices[i]));
  }
  join_equal(extras);

  GpuMesh mesh;
  mesh.name = fmt::format("skin {}", number);
  const auto make = [&](std::string_view what, auto&& values, VkBufferUsageFlags usage) {
    return gpu::make_buffer(device, fmt::format("{} {}", mesh.name, what), std::span(std::as_const(values)),
                            usage);
  };
  mesh.vertices = make("vertices", vertices, gpu::texels_of_shaders);
  mesh.vertex_extras = make("vertex extras", extras, gpu::texels_of_shaders);
  mesh.skin_vertices = make("skin vertices", skin_vertices_of(skin, {}), gpu::texels_of_shaders);
  mesh.indices = make("indices", skin.indices, storage | VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  mesh.first_corners =
      make("first corners", first_corner_indices(skin.indices), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  mesh.turned_neighbours = make("turned neighbours", scene::turned_neighbours(skin), storage);

  mesh.draws = draws_of(skin);
  return mesh;
}

GpuMesh upload_skin(gpu::Device& device, const scene::SkinMesh& skin, std::size_t number) {
  return scene::has_chartless(skin) ? upload_sorted_skin(device, charts_first(skin), number)
                                    : upload_sorted_skin(device, skin, number);
}

}  // namespace

std::vector<GpuDraw> draws_of(const scene::SkinMesh& mesh) {
  std::vector<GpuDraw> draws;
  std::uint32_t first_index = 0;
  for (const bool on_map : {true, false})
    for (std::size_t t = 0; t < mesh.triangle_material.size(); ++t) {
      const int material = mesh.triangle_material[t];
      if ((mesh.triangle_chart[t] != scene::no_chart) != on_map) continue;
      if (draws.empty() || draws.back().material != material || draws.back().on_map != on_map)
        draws.push_back(
            {.first_index = first_index, .index_count = 0, .material = material, .on_map = on_map});
      draws.back().index_count += 3;
      first_index += 3;
    }
  return draws;
}

void GpuMaterial::offer(Bindings& bindings) const {
  bindings.add("Material", buffer)
      .add("map_base_colour", maps[MAP_BASE_COLOUR])
      .add("map_normal", maps[MAP_NORMAL])
      .add("map_roughness", maps[MAP_ROUGHNESS])
      .add("map_occlusion", maps[MAP_OCCLUSION])
      .add("map_specular", maps[MAP_SPECULAR])
      .add("map_emissive", maps[MAP_EMISSIVE])
      .add("map_specular_colour", maps[MAP_SPECULAR_COLOUR])
      .add("map_detail", maps[MAP_DETAIL])
      .add("map_alpha_max", alpha_max);
}

gpu::Texture unwrap_map(gpu::Device& device, const std::string& name, int side,
                        std::initializer_list<const std::vector<float>*> layers) {
  const auto texels = static_cast<std::uint32_t>(side);
  std::vector<std::uint16_t> halves;
  for (const std::vector<float>* values : layers) {
    DERMIS_ASSERT_EQ(values->size(), std::size_t{texels} * texels * 4);
    for (const float value : *values)
      halves.push_back(image::float_to_half(std::min(value, image::max_half)));
  }

  gpu::Texture map(device, name,
                   {.width = texels,
                    .height = texels,
                    .layers = static_cast<std::uint32_t>(layers.size()),
                    .format = VK_FORMAT_R16G16B16A16_SFLOAT,
                    .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  gpu::upload(device, map, std::as_bytes(std::span(halves)));
  return map;
}

GpuAsset::GpuAsset(gpu::PipelineLibrary& library, const scene::AssetData& scene) {
  gpu::Device& device = library.device();
  mm_per_unit = static_cast<float>(scene.mm_per_unit);
  white_ = single_texel(device, "white", {255, 255, 255, 255});
  white_layers_ = single_texel(device, "white layer", {255, 255, 255, 255}, true);
  flat_normal_ = single_texel(device, "flat normal", {128, 128, 255, 255});

  Steps steps("bringing the scene to the device", scene.materials.size() + scene.skin.size());
  for (const scene::Material& m : scene.materials) {
    MaterialMaps material;
    material.name = m.name;
    material.skin = m.skin;
    material.double_sided = m.double_sided;
    material.alpha_mode = m.alpha_mode;
    material.cut_out = m.skin && m.alpha_mode == AssetAlpha::mask;
    material.emits = m.skin && m.emissive != glm::vec3(0);
    material.detailed = m.skin && m.skin_settings.detail.present();
    material.alpha_max = {material.cut_out && m.base_colour_map.present()
                              ? &alpha_max(device, scene, m.base_colour_map.image)
                              : &white_,
                          library.sampler({.filter = gpu::Filter::nearest,
                                           .u = address(m.base_colour_map.wrap_u),
                                           .v = address(m.base_colour_map.wrap_v)})};

    auto maps = maps_of(m);
    const gpu::Texture* fine = nullptr;
    if (const auto normals = scene::fine_normals(scene, materials_.size())) {
      maps[MAP_NORMAL] = m.skin_settings.displacement;
      maps[MAP_NORMAL].scale = 1;
      fine = &upload_map(library, m.name + " fine normals", *normals, generated, false);
    }

    material.constants = material_io(m, maps);

    for (int i = 0; i < MAP_COUNT; ++i) {
      const scene::MapRef& map = maps[static_cast<std::size_t>(i)];
      const bool srgb = i == MAP_BASE_COLOUR || i == MAP_EMISSIVE || (i == MAP_SPECULAR_COLOUR && !m.skin);
      const gpu::Texture& none = i == MAP_NORMAL ? flat_normal_ : white_;
      const VkSampler sampler =
          library.sampler({.filter = map.nearest ? gpu::Filter::nearest : gpu::Filter::linear,
                           .u = address(map.wrap_u),
                           .v = address(map.wrap_v),
                           .max_anisotropy = map.nearest || device.limits().software ? 1.0f : 8.0f});

      const bool is_fine = i == MAP_NORMAL && fine;
      material.maps[static_cast<std::size_t>(i)] = {is_fine ? fine
                                                    : map.present()
                                                        ? &texture(library, scene, map.image, srgb)
                                                        : &none,
                                                    sampler};
    }

    materials_.push_back(std::move(material));
    steps.done();
  }

  directional_albedo = upload_directional_albedo(device);
  for (std::size_t i = 0; i < scene.skin.size(); ++i) {
    skin.push_back(upload_skin(device, scene.skin[i], i));
    steps.done();
  }
  surfaces = upload_surfaces(device, scene);
  unmoved = passes::unmoved(device);
}

GpuLook GpuAsset::make_look(gpu::Device& device, const LookSettings& settings) const {
  GpuLook look;
  for (const MaterialMaps& maps : materials_) {
    GpuMaterial& material = look.materials.emplace_back(GpuMaterial{maps, {}, true});
    io::MaterialIo& constants = material.constants;
    constants.mix_before = settings.mix.value_or(constants.mix_before);
    if (material.skin) constants.base_colour *= glm::vec4(settings.tint, 1);

    // A material that had none has no transform and takes the first coordinates: MapIo's of no map.
    const int number = static_cast<int>(look.materials.size()) - 1;
    for (const HostMap& map : settings.maps) {
      if (map.material != number) continue;
      const auto slot = static_cast<std::size_t>(map.map);
      look.of_host.push_back(std::make_unique<gpu::Texture>("map of the host", gpu::TextureDesc{}, map.view));
      material.maps[slot].texture = look.of_host.back().get();
      constants.maps[map.map].present = 1;
    }

    material.mixed = constants.mix_before > 0;
    material.buffer =
        gpu::make_buffer(device, "material " + material.name, std::span<const io::MaterialIo>(&constants, 1),
                         VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  }
  return look;
}

void GpuAsset::make_gutters(gpu::Device& device, std::size_t number, const scene::SkinMesh& skin_mesh,
                            std::uint32_t side, int width_texels) {
  GpuMesh& mesh = skin[number];
  GpuMesh::Gutters& made = mesh.gutters[side];
  if (made.width_texels >= width_texels) return;
  const std::vector<io::GutterIo> list = packed(gutter_list(skin_mesh, static_cast<int>(side), width_texels));
  made.width_texels = width_texels;
  made.count = static_cast<std::uint32_t>(list.size());
  if (list.empty()) return;
  made.list = gpu::make_buffer(device, mesh.name + " gutters", std::span<const io::GutterIo>(list), storage);
  made.tile_links = gpu::make_buffer(device, mesh.name + " tile links",
                                     std::span<const std::uint32_t>(tile_links(list, side)), storage);
}

void GpuAsset::make_welded(gpu::Device& device, std::size_t number, const scene::SkinMesh& skin_mesh) {
  GpuMesh& mesh = skin[number];
  if (mesh.welded.point_of) return;
  const std::vector<std::uint32_t> point_of = scene::weld_positions(skin_mesh.vertices);
  mesh.welded = {.point_of = gpu::make_buffer(device, mesh.name + " welded points",
                                              std::span<const std::uint32_t>(point_of), storage),
                 .smoothing = curvature_smoothing(skin_mesh, double{mm_per_unit})};
}

void GpuAsset::make_rig(gpu::Device& device, const scene::AssetData& scene) {
  if (!rig) rig.emplace(upload_rig(device, scene, surfaces));
}

void GpuAsset::give_shape(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh,
                          std::span<const scene::VertexShape> shape) {
  DERMIS_ASSERT_EQ(shape.size(), mesh.vertices.size());
  const std::vector<io::SkinVertexIo> vertices = skin_vertices_of(mesh, shape);
  skin[number].skin_vertices =
      gpu::make_buffer(device, skin[number].name + " skin vertices",
                       std::span<const io::SkinVertexIo>(vertices), gpu::texels_of_shaders);
}

void GpuAsset::make_rig_curvature(gpu::Device& device, std::size_t number, const scene::SkinMesh& mesh,
                                  const scene::CurvatureScales& scales) {
  GpuRig::Skin& of_rig = rig->skin[number];
  if (of_rig.curvature_first) return;
  const scene::CurvatureStencil stencil =
      scene::curvature_stencil(mesh.vertices, mesh.indices, double{mm_per_unit}, scales);
  std::vector<io::CurvatureNeighbourIo> neighbours;
  for (const scene::CurvatureNeighbour& one : stencil.neighbours)
    neighbours.push_back({.vertex = one.vertex, .weight = one.weight});
  if (neighbours.empty()) neighbours.emplace_back();  // Vulkan has no empty buffers

  const std::string& name = skin[number].name;
  of_rig.curvature_first = gpu::make_buffer(device, name + " first neighbours",
                                            std::span<const std::uint32_t>(stencil.first), storage);
  of_rig.curvature_neighbours =
      gpu::make_buffer(device, name + " neighbours in curvature",
                       std::span<const io::CurvatureNeighbourIo>(neighbours), storage);
}

const GpuMesh::Sources* GpuMesh::sources_of(int source_mesh) const {
  const auto found = sources.find(source_mesh);
  return found == sources.end() ? nullptr : &found->second;
}

void GpuAsset::make_sources(gpu::Device& device, std::size_t number, const scene::SkinMesh& skin_mesh) {
  GpuMesh& mesh = skin[number];
  if (!mesh.sources.empty()) return;
  std::map<int, std::vector<io::SourceVertexIo>> lists;
  for (std::uint32_t v = 0; v < skin_mesh.sources.size(); ++v)
    lists[skin_mesh.sources[v].mesh].push_back({.vertex = v, .source = skin_mesh.sources[v].vertex});

  std::map<int, GpuMesh::Sources> made;
  for (const auto& [source_mesh, list] : lists) {
    GpuMesh::Sources& sources = made[source_mesh];
    sources.count = static_cast<std::uint32_t>(list.size());
    for (const io::SourceVertexIo& vertex : list)
      sources.source_vertices = std::max(sources.source_vertices, vertex.source + 1);
    sources.list = gpu::make_buffer(device, fmt::format("{} of source {}", mesh.name, source_mesh),
                                    std::span<const io::SourceVertexIo>(list), storage);
  }
  mesh.sources = std::move(made);
}

const gpu::Texture& GpuAsset::texture(gpu::PipelineLibrary& library, const scene::AssetData& scene, int image,
                                      bool srgb) {
  for (const Loaded& loaded : textures_)
    if (loaded.image == image && loaded.srgb == srgb) return *loaded.texture;
  const scene::MapImage& map = scene.images[static_cast<std::size_t>(image)];
  try {
    return upload_map(library, map.name, *map.pixels, image, srgb);
  } catch (const DeviceError& error) {
    throw device_error("{}: {}; a smaller texture_budget_mb takes less", scene.name, error.what());
  } catch (const std::bad_alloc&) {
    throw device_error(
        "{}: too little memory for the map '{}' of {} x {} texels; a smaller texture_budget_mb takes less",
        scene.name, map.name, map.pixels->width, map.pixels->height);
  }
}

const gpu::Texture& GpuAsset::alpha_max(gpu::Device& device, const scene::AssetData& scene, int image) {
  if (const auto found = alpha_max_.find(image); found != alpha_max_.end()) return found->second;
  const scene::MapImage& map = scene.images[static_cast<std::size_t>(image)];
  const AlphaLevels levels = alpha_max_levels(*map.pixels);
  gpu::Texture made(device, "alpha of " + map.name,
                    {.width = static_cast<std::uint32_t>(map.pixels->width),
                     .height = static_cast<std::uint32_t>(map.pixels->height),
                     .mips = levels.count,
                     .format = VK_FORMAT_R8_UNORM,
                     .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  gpu::upload(device, made, std::as_bytes(std::span(levels.bytes)));
  return alpha_max_.emplace(image, std::move(made)).first->second;
}

const gpu::Texture& GpuAsset::upload_map(gpu::PipelineLibrary& library, const std::string& name,
                                         const image::Image8& pixels, int image, bool srgb) {
  // The software driver decodes sRGB with an error of 0.2 to 0.4 %, which comparisons with the reference
  // would show.
  const bool halves = srgb && library.device().limits().software;
  const auto width = static_cast<std::uint32_t>(pixels.width),
             height = static_cast<std::uint32_t>(pixels.height);
  auto made = std::make_unique<gpu::Texture>(
      library.device(), "map " + name,
      gpu::TextureDesc{.width = width,
                       .height = height,
                       .mips = static_cast<std::uint32_t>(std::bit_width(std::max(width, height))),
                       .format = halves ? VK_FORMAT_R16G16B16A16_SFLOAT
                                 : srgb ? VK_FORMAT_R8G8B8A8_SRGB
                                        : VK_FORMAT_R8G8B8A8_UNORM,
                       .usage = VK_IMAGE_USAGE_SAMPLED_BIT});

  // Level by level, each in strips of rows, so that little memory is needed beside the map.
  gpu::TextureUpload upload(library.device(), *made);
  std::uint32_t level = 0;
  image::for_each_mip(pixels, srgb, [&](const image::Image8& mip) {
    const std::size_t row_values = static_cast<std::size_t>(mip.width) * 4;
    const auto rows = static_cast<std::uint32_t>(mip.height), strip = upload.rows_at_a_time(level);
    for (std::uint32_t first = 0; first < rows; first += strip) {
      const std::span values(&mip.rgba[first * row_values], std::min(strip, rows - first) * row_values);
      if (halves) {
        const std::vector<std::uint16_t> texels = halves_of(values);
        upload.rows(level, first, std::as_bytes(std::span(texels)));
      } else {
        upload.rows(level, first, std::as_bytes(values));
      }
    }
    ++level;
  });
  upload.finish();
  textures_.push_back({image, srgb, std::move(made)});
  return *textures_.back().texture;
}

}  // namespace dermis::passes
