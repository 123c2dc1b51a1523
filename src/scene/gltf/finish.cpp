// SPDX-License-Identifier: MIT
#include "scene/gltf/finish.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/one_line.h"
#include "core/warnings.h"

namespace dermis::scene::gltf {

namespace {

constexpr float skin_ior = 1.4f;  // F0 of skin 0.028

bool says_skin(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find("skin") != std::string::npos;
}

std::string quoted_names(const std::vector<MaterialSource>& materials) {
  std::vector<std::string> names;
  for (const MaterialSource& m : materials)
    names.push_back(fmt::format("'{}'", one_line(m.material.name, 80)));
  if (names.size() > 20) names.resize(20);
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Returns the rotation of a node without its scale; it looks along -Z.
glm::dmat3 rotation_of(const glm::dmat4& world) {
  const glm::dvec3 z(world[2]), y(world[1]);
  const glm::dvec3 back = glm::length(z) > 0 ? glm::normalize(z) : glm::dvec3(0, 0, 1);
  const glm::dvec3 side = glm::cross(y, back);
  const glm::dvec3 any = std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right =
      glm::normalize(glm::length(side) > 1e-9 * glm::length(y) ? side : glm::cross(any, back));
  return {right, glm::cross(back, right), back};
}

Camera place_camera(Camera camera, const Node& node, const glm::dmat4& world, double unit_scale) {
  if (camera.name.empty()) camera.name = node.name;
  camera.world_from_camera = glm::mat4(glm::dmat4(rotation_of(world)));
  camera.world_from_camera[3] = glm::vec4(glm::vec3(world[3]), 1);
  const auto scale = static_cast<float>(unit_scale);
  camera.znear_m *= scale;
  camera.ymag_m *= scale;
  if (camera.zfar_m) *camera.zfar_m *= scale;
  return camera;
}

Light place_light(Light light, const Node& node, const glm::dmat4& world, double unit_scale) {
  if (light.name.empty()) light.name = node.name;
  const auto scale = static_cast<float>(unit_scale);
  light.position_m = glm::vec3(world[3]);
  light.direction = glm::vec3(-rotation_of(world)[2]);
  light.range_m *= scale;
  // The distance in colour / d^2 is scaled, and so must be the intensity: a change of units must not change
  // the brightness of the head.
  if (light.type != LightType::directional) {
    light.colour *= scale * scale;
    light.radius *= scale;
  }
  return light;
}

}  // namespace

std::vector<MaterialSource> used_materials(const Document& document, MaterialNumbers& numbers) {
  std::vector<bool> done(document.meshes.size(), false);
  for (const int n : shown_nodes(document)) {
    const int mesh = document.nodes[n].mesh;
    if (mesh < 0 || done[mesh]) continue;
    done[mesh] = true;
    for (const MeshPrimitive& p : document.meshes[mesh].primitives)
      if (claimed_triangles(document, p) > 0) numbers.of[p.material] = 0;
  }

  std::vector<MaterialSource> used;
  for (auto& [source, target] : numbers.of) {
    if (source < 0) continue;  // the default material is last, so that the others keep the file's order
    target = static_cast<int>(used.size());
    used.push_back(document.materials[source]);
  }
  if (numbers.of.contains(-1)) {
    numbers.of[-1] = static_cast<int>(used.size());
    used.emplace_back().material.name = "default";
  }
  return used;
}

namespace {

/// Makes blended skin a surface, as lashes are: light cannot spread in what is blended over something else.
void make_blended_skin_surface(const Document& document, std::vector<MaterialSource>& materials) {
  std::vector<MaterialSource> blended;
  for (MaterialSource& m : materials) {
    if (!m.material.skin || m.material.alpha_mode != AlphaMode::blend) continue;
    m.material.skin = false;
    blended.push_back(m);
  }
  if (!blended.empty())
    warn(
        "{}: skin with alphaMode BLEND is drawn as a blended surface, and no light spreads in it: {}; OPAQUE "
        "or MASK draws it as skin",
        document.file, quoted_names(blended));
}

}  // namespace

void choose_skin(const Document& document, const std::string& skin_material,
                 std::vector<MaterialSource>& materials) {
  bool any = false;
  const auto choose = [&](const auto& is_skin) {
    for (MaterialSource& m : materials) {
      m.material.skin = is_skin(m);
      any |= m.material.skin;
    }
  };
  // A material with "skin": false is skin only by SceneOptions::skin_material.
  const auto may_be = [](const MaterialSource& m) { return m.says_skin.value_or(true); };

  if (!skin_material.empty()) {
    choose([&](const MaterialSource& m) { return m.material.name == skin_material; });
    if (!any)
      throw input_error(document.file, "no material is called '{}'; there are: {}", skin_material,
                        quoted_names(materials));
  }

  // In this order: what the file says, what the names say, the only material.
  if (!any) choose([](const MaterialSource& m) { return m.says_skin.value_or(false); });
  if (!any) choose([&](const MaterialSource& m) { return may_be(m) && says_skin(m.material.name); });
  if (!any && materials.size() == 1) choose(may_be);

  if (!any) {
    const std::string line = fmt::format("{}: no material is skin; name one with skin_material: {}",
                                         document.file, quoted_names(materials));
    warn_of(line, document.file, line);
  }

  make_blended_skin_surface(document, materials);
  for (MaterialSource& m : materials) {
    if (m.material.skin && !m.has_ior) m.material.ior = skin_ior;
    if (!m.material.skin) m.material.skin_settings = {};
  }
}

void place_lights_and_cameras(const Document& document, double unit_scale, Scene& scene) {
  const std::vector<glm::dmat4> world = world_matrices(document, unit_scale);
  for (const int n : shown_nodes(document)) {
    const Node& node = document.nodes[n];
    if (node.camera >= 0)
      scene.cameras.push_back(place_camera(document.cameras[node.camera], node, world[n], unit_scale));
    if (node.light >= 0 && document.lights[node.light])
      scene.lights.push_back(place_light(*document.lights[node.light], node, world[n], unit_scale));
  }
}

}  // namespace dermis::scene::gltf
