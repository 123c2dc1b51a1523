// SPDX-License-Identifier: MIT
#include "head/builtin_head/builtin_head.h"

#include <utility>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "head/builtin_head/head_rig.h"
#include "head/builtin_head/kept.h"
#include "head/builtin_head/microrelief.h"
#include "head/builtin_head/parts.h"
#include "head/builtin_head/unwrap.h"
#include "head/scene/surface/tangents.h"

namespace dermis::builtin_head {
namespace {

scene::Primitive make_mesh(const Net& net) {
  scene::Primitive mesh;
  mesh.name = "built-in head";
  mesh.node = 0;
  mesh.has_uv = true;
  mesh.vertices.resize(net.at_mm.size());

  for (int j = 0; j <= net.rows; ++j) {
    for (int i = 0; i <= net.columns; ++i) {
      scene::Vertex& v = mesh.vertices[net.index(i, j)];
      v.position_m = to_world_m(net.at_mm[net.index(i, j)]);
      v.normal = net.normal[net.index(i, j)];
      v.uv0 = v.uv1 = chart_uv(net.chart[net.index(i, j)]);
    }
  }

  mesh.indices.reserve(static_cast<std::size_t>(net.columns * net.rows * 6));
  for (int j = 0; j < net.rows; ++j) {
    for (int i = 0; i < net.columns; ++i) {
      const auto at = [&](int a, int b) { return static_cast<std::uint32_t>(net.index(i + a, j + b)); };
      for (const std::uint32_t k : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)})
        mesh.indices.push_back(k);
    }
  }

  scene::make_tangents(mesh, scene::MapRef{}.transform, 0);
  return mesh;
}

scene::MapRef map_ref(int image, int channel) {
  scene::MapRef ref;
  ref.image = image;
  ref.wrap_u = ref.wrap_v = AssetWrap::clamp;
  ref.channel = channel;
  return ref;
}

scene::Material make_material() {
  scene::Material m;
  m.name = "skin";
  m.skin = true;
  m.metallic = 0;
  m.roughness = 0.53f;
  m.ior = 1.4f;
  m.base_colour_map = map_ref(0, 0);
  m.normal_map = map_ref(1, 0);
  m.skin_settings.specular = map_ref(2, 0);
  m.skin_settings.roughness = map_ref(2, 1);
  m.skin_settings.detail.image = 3;
  // Far away it fades and leaves no roughness behind, so it may not be as steep as furrows are. With its
  // whole slopes a small picture is 1.3 times as far from the truth (HDR-FLIP).
  m.skin_settings.detail.scale = 0.3f;
  m.skin_settings.detail.transform = glm::mat3x2(tiles_per_chart, 0, 0, tiles_per_chart, 0, 0);
  return m;
}

// The net and the maps, from the cache if it has them.
Baked baked_head(const Sculpture& bust, const Settings& settings) {
  const std::filesystem::path file = kept_file(settings.cache, settings.tone, settings.map_size);
  if (std::optional<Baked> found = kept(file, settings.map_size)) return std::move(*found);

  Baked made{.net = wrap(bust), .maps = {}};
  made.net.chart = unwrap(made.net, bust.ear_frame());
  made.maps = bake(bust, made.net, make_mesh(made.net), settings.map_size, complexion(settings.tone));
  keep(file, made);
  return made;
}

}  // namespace

scene::AssetData make(const Settings& settings) {
  const int size = settings.map_size;
  if (size < 64 || size > 4096 || (size & (size - 1)) != 0)
    throw input_error("built-in head", "map size must be a power of two from 64 to 4096, got {}", size);
  Steps steps("making the built-in head", 3);
  const Sculpture bust;
  steps.done();

  Baked baked = baked_head(bust, settings);
  const Net& net = baked.net;
  scene::AssetData scene;
  scene.name = "built-in";
  scene.primitives.push_back(make_mesh(net));
  scene.materials.push_back(make_material());
  steps.done();

  const auto add = [&](const char* name, image::Image8&& pixels) {
    scene.images.push_back({name, std::make_shared<const image::Image8>(std::move(pixels))});
  };
  add("built-in colour", std::move(baked.maps.colour));
  add("built-in normal", std::move(baked.maps.normal));
  add("built-in specular and roughness", std::move(baked.maps.reflection));
  add("built-in detail", microrelief(std::max(size / 4, 16)));
  add_eyes(bust, scene, complexion(settings.tone).colours, std::clamp(size / 4, 64, 512));
  add_teeth(scene);
  add_hair_cards(bust, scene, complexion(settings.tone).colours, std::clamp(size / 2, 64, 1024));
  for (std::size_t i = 0; i < scene.primitives.size(); ++i)
    scene.primitives[i].source_mesh = static_cast<int>(i);
  scene.rig = make_rig(net, scene);
  for (const scene::RigClip& clip : scene.rig->clips) scene.clips.push_back(clip.clip.name);
  steps.done();
  return scene;
}

}  // namespace dermis::builtin_head
