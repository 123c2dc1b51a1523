// SPDX-License-Identifier: MIT
#include "head/scene/gltf/load.h"

#include "base/core/hooks.h"
#include "base/core/log.h"
#include "base/core/one_line.h"
#include "base/core/warnings.h"
#include "head/scene/gltf/finish.h"
#include "head/scene/gltf/play.h"
#include "head/scene/gltf/read_rig.h"
#include "head/scene/import/complete.h"
#include "head/scene/surface/missing_uv.h"
#include "head/scene/surface/overlapping_skin.h"

namespace dermis::scene {

namespace {

using namespace gltf;

// An asset that cannot be posed is still shown in the pose of its file.
void keep_rig(const Document& document, Bytes& bytes, const LoadOptions& options, const Placed& placed,
              const ViewNodes& views, AssetData& scene) {
  std::vector<bool> own_tangents;
  for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
    const auto material = static_cast<std::size_t>(scene.primitives[i].material);
    own_tangents.push_back(keeps_tangents(scene.materials[material], placed.file_tangents[i]));
  }
  try {
    scene.rig = read_rig(document, bytes, options.unit_scale, placed.moving, own_tangents, views, scene);
  } catch (const InputError& error) {
    scene.why_no_rig = error.what();
    warn("{}; it cannot be posed once it is loaded", error.what());
  }
}

// Returns whether a rig is to be kept. Says so if there would be one, and it is too large.
bool wants_rig(const Document& document, AssetData& scene) {
  if (!can_move(document)) return false;
  scene.why_no_rig = too_large_to_pose(document);
  if (scene.why_no_rig.empty()) return true;
  const std::string line =
      fmt::format("{}: has {}, so it cannot be posed once it is loaded", document.file, scene.why_no_rig);
  warn_of(line, document.file, line);
  return false;
}

AssetData load(const std::filesystem::path& path, const LoadOptions& options) {
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
  check_limits(document, bytes.read_bytes(), options);

  AssetData scene;
  scene.name = path.filename().string();
  scene.clips = animation_names(document);
  MaterialNumbers numbers;
  std::vector<MaterialSource> materials = used_materials(document, numbers);
  choose_skin(document.file, options.skin_material, unused_materials(document, numbers), materials);
  std::vector<std::optional<float>> glossiness;
  for (MaterialSource& m : materials) {
    numbers.skin.push_back(m.material.skin);
    glossiness.push_back(m.glossiness);
    scene.materials.push_back(std::move(m.material));
  }

  check_skin_nodes(document, numbers);
  const bool posable = wants_rig(document, scene);
  Placed placed = place_meshes(document, bytes, numbers, options, posable);
  scene.primitives = std::move(placed.primitives);
  leave_out_maps_without_uv(document.file, placed.has_uv, scene);
  steps.done();

  part_overlapping_skin(document.file, scene);
  complete_surfaces(placed.file_tangents, scene);
  const ViewNodes views = place_lights_and_cameras(document, options.unit_scale, scene);
  if (posable) keep_rig(document, bytes, options, placed, views, scene);
  steps.done();

  decode_images(document, bytes,
                {.max_side = options.max_map_side,
                 .budget_bytes = static_cast<std::uint64_t>(options.texture_budget_mb * 1e6)},
                scene);
  turn_glossiness(glossiness, scene);
  average_transmission(document.file, scene);
  steps.done();

  warn_of_size(document.file, scene);
  return scene;
}

}  // namespace

AssetData load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
  return with_errors_of_import(path.string(), [&] {
    try {
      return load(path, options);
    } catch (const std::filesystem::filesystem_error& error) {
      throw input_error(path.string(), "{}", error.what());
    }
  });
}

}  // namespace dermis::scene
