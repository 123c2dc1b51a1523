// SPDX-License-Identifier: MIT
#include "scene/load.h"

#include "core/hooks.h"
#include "core/one_line.h"
#include "scene/complete.h"
#include "scene/gltf/finish.h"
#include "scene/gltf/play.h"
#include "scene/missing_uv.h"

namespace dermis::scene {

namespace {

using namespace gltf;

Scene load(const std::filesystem::path& path, const LoadOptions& options) {
  Steps steps("reading " + one_line(path.filename().string()), 3);
  const Container container = open_container(path);
  const json::Document json = parse(container.json, path.string());
  Document document = read_document(json.root(), container, path);
  Bytes bytes(document, container);
  if (!options.clip.empty() || options.time_s) {
    const Clip clip = read_clip(document, bytes, find_animation(document, options.clip));
    Pose pose = rest_pose(document);
    play(clip, options.time_s.value_or(0), pose);
    take_pose(pose, document);
  }
  check_limits(document, options);

  Scene scene;
  scene.name = path.filename().string();
  scene.clips = animation_names(document);
  MaterialNumbers numbers;
  std::vector<MaterialSource> materials = used_materials(document, numbers);
  choose_skin(document.file, options.skin_material, materials);
  for (MaterialSource& m : materials) {
    numbers.skin.push_back(m.material.skin);
    scene.materials.push_back(std::move(m.material));
  }

  check_skin_nodes(document, numbers);
  Placed placed = place_meshes(document, bytes, numbers, options);
  scene.primitives = std::move(placed.primitives);
  leave_out_maps_without_uv(document.file, placed.has_uv, scene);
  steps.done();

  complete_surfaces(placed.file_tangents, scene);
  steps.done();

  place_lights_and_cameras(document, options.unit_scale, scene);
  decode_images(document, bytes,
                {.max_side = options.max_map_side,
                 .budget_bytes = static_cast<std::uint64_t>(options.texture_budget_mb * 1e6)},
                scene);
  steps.done();

  warn_of_size(document.file, scene);
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
  return load_with_one_line_errors(path.string(), [&] {
    try {
      return load(path, options);
    } catch (const std::filesystem::filesystem_error& error) {
      throw input_error(path.string(), "{}", error.what());
    }
  });
}

}  // namespace dermis::scene
