// SPDX-License-Identifier: MIT
#include "scene/load.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

#include "core/hooks.h"
#include "core/one_line.h"
#include "core/warnings.h"
#include "scene/gltf/finish.h"
#include "scene/gltf/missing_uv.h"
#include "scene/placement.h"
#include "scene/tangents.h"

namespace dermis::scene {

namespace {

using namespace gltf;

constexpr float least_height_m = 0.10f, most_height_m = 0.60f;

void complete_surface(Primitive& primitive, const Material& material, bool file_tangents) {
  make_missing_normals(primitive);
  // Fine normals of a displacement map use the tangents too; if there are both, the normal map's coordinates
  // count.
  const MapRef& normal = material.normal_map;
  const MapRef& map = normal.present() ? normal : material.skin_settings.displacement;
  if (file_tangents && map.transform == MapRef{}.transform) return;
  make_tangents(primitive, map.transform, map.uv_set);
}

void warn_of_size(const Document& document, const Scene& scene) {
  float low = 0, high = 0;
  bool any = false;

  for (const Primitive& p : scene.primitives) {
    if (!scene.materials[p.material].skin) continue;
    for_each_position(p, [&](const glm::vec3& position_m) {
      low = any ? std::min(low, position_m.y) : position_m.y;
      high = any ? std::max(high, position_m.y) : position_m.y;
      any = true;
    });
  }

  const float height = high - low;
  if (any && (height < least_height_m || height > most_height_m)) {
    const std::string line = fmt::format(
        "{}: the skin is {:.4g} m high, a head has 0.1 to 0.6 m; light spreads by mm, so give the right size "
        "with unit_scale",
        document.file, height);
    warn_of(line, document.file, line);
  }
}

Scene load(const std::filesystem::path& path, const LoadOptions& options) {
  Steps steps("reading " + one_line(path.filename().string()), 3);
  const Container container = open_container(path);
  const json::Document json = parse(container.json, path.string());
  const Document document = read_document(json.root(), container, path);
  Bytes bytes(document, container);
  check_limits(document, options);

  Scene scene;
  scene.name = path.filename().string();
  MaterialNumbers numbers;
  std::vector<MaterialSource> materials = used_materials(document, numbers);
  choose_skin(document, options.skin_material, materials);
  for (MaterialSource& m : materials) {
    numbers.skin.push_back(m.material.skin);
    scene.materials.push_back(std::move(m.material));
  }

  check_skin_nodes(document, numbers);
  Placed placed = place_meshes(document, bytes, numbers, options);
  scene.primitives = std::move(placed.primitives);
  leave_out_maps_without_uv(document, placed, scene);
  steps.done();

  {
    Steps surfaces("completing surfaces", scene.primitives.size());
    for (std::size_t i = 0; i < scene.primitives.size(); ++i) {
      complete_surface(scene.primitives[i], scene.materials[scene.primitives[i].material],
                       placed.file_tangents[i]);
      surfaces.done();
    }
  }
  steps.done();

  place_lights_and_cameras(document, options.unit_scale, scene);
  decode_images(document, bytes,
                {.max_side = options.max_map_side,
                 .budget_bytes = static_cast<std::uint64_t>(options.texture_budget_mb * 1e6)},
                scene);
  steps.done();

  warn_of_size(document, scene);
  return scene;
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
  const auto too_large = [&] { return input_error(path.string(), "needs more memory than there is"); };
  const WarningGroup group;
  try {
    return load(path, options);
  } catch (const InputError& error) {
    // Messages quote names and uris of the file; an error must stay one line.
    throw InputError("", one_line(error.what()));
  } catch (const std::filesystem::filesystem_error& error) {
    throw input_error(path.string(), "{}", one_line(error.what()));
  } catch (const std::bad_alloc&) { throw too_large(); } catch (const std::length_error&) {
    throw too_large();
  }
}

}  // namespace dermis::scene
