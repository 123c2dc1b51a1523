// SPDX-License-Identifier: MIT
// Reads cameras and lights, and checks references of animations (a scene at rest needs no more of them).
#include <cmath>
#include <numbers>

#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"

namespace dermis::scene::gltf {

namespace {

constexpr double largest = std::numeric_limits<float>::max();

/// Returns a number above 0.
float positive(const Value& value, const char* key) {
  const double number = value.at(key).number();
  if (!(number > 0)) value.at(key).fail("must be over 0, is {}", number);
  return static_cast<float>(number);
}

/// A far plane that nothing is in front of is left out.
void read_far_plane(const Value& value, Camera& camera) {
  if (!value.has("zfar")) return;
  const auto far = static_cast<float>(number_near(value, "zfar", 0));
  if (far > camera.znear_m)
    camera.zfar_m = far;
  else
    warn_at(value, fmt::format("zfar {} is not more than znear {}, and is left out", far, camera.znear_m));
}

void read_perspective(const Value& value, Camera& camera) {
  camera.fov_y_rad = positive(value, "yfov");
  if (camera.fov_y_rad >= std::numbers::pi_v<float>)
    value.fail("yfov must be less than pi, is {}", camera.fov_y_rad);
  const auto near = static_cast<float>(number_near(value, "znear", 0));
  if (near > 0)
    camera.znear_m = near;
  else
    warn_at(value, fmt::format("znear must be over 0, {} m is taken", camera.znear_m));
  read_far_plane(value, camera);
}

void read_orthographic(const Value& value, Camera& camera) {
  camera.orthographic = true;
  const double ymag = value.at("ymag").number();
  if (ymag == 0) value.fail("ymag must not be 0");
  camera.ymag_m = static_cast<float>(std::abs(ymag));
  camera.znear_m = static_cast<float>(number_near(value, "znear", 0, 0));
  read_far_plane(value, camera);
}

Camera read_camera(const Value& value) {
  Camera camera;
  camera.name = text_near(value, "name", "");
  const std::string& type = value.at("type").text();
  if (type == "perspective")
    read_perspective(value.at("perspective"), camera);
  else if (type == "orthographic")
    read_orthographic(value.at("orthographic"), camera);
  else
    value.at("type").fail("must be perspective or orthographic, is '{}'", type.substr(0, 40));
  return camera;
}

/// Exporters write equal angles for a hard edge, and none where the defaults hold.
void read_spot(const Value& light_value, Light& light) {
  constexpr double right_angle = std::numbers::pi / 2 + 1e-6;
  constexpr float hard_edge = 0.999f;  // of the outer angle
  const std::optional<Value> value = light_value.find("spot");
  if (!value || !value->is_object()) {
    warn_at(light_value, "is a spot that does not say its cone; it has the default");
    return;
  }
  light.inner_cone_rad = static_cast<float>(number_near(*value, "innerConeAngle", 0, 0, right_angle));
  light.outer_cone_rad =
      static_cast<float>(number_near(*value, "outerConeAngle", std::numbers::pi / 4, 0, right_angle));
  if (!(light.outer_cone_rad > 0)) value->fail("a cone without an angle lights nothing");
  if (light.inner_cone_rad < light.outer_cone_rad) return;
  warn_at(*value, "the inner angle is not less than the outer one, and the edge is hard");
  light.inner_cone_rad = hard_edge * light.outer_cone_rad;
}

// Reads extras.dermis: what KHR_lights_punctual cannot express. Strict, as for materials.
void read_extras(const Value& value, Light& light) {
  const std::optional<Value> extras = value.find("extras");
  if (!extras || !extras->is_object() || !extras->has("dermis")) return;
  const Value dermis = extras->at("dermis");
  if (light.type == LightType::directional) {
    dermis.object().only_keys({"angle_deg"});
    const double angle_deg = dermis.number_or("angle_deg", 0, 0, 170);
    light.radius = static_cast<float>(std::tan(angle_deg / 2 * std::numbers::pi / 180));
  } else {
    dermis.object().only_keys({"radius_m"});
    light.radius = static_cast<float>(dermis.number_or("radius_m", 0, 0, 1e6));
  }
}

Light read_light(const Value& value) {
  Light light;
  light.name = text_near(value, "name", "");
  const std::string& type = value.at("type").text();
  const std::vector<double> colour = numbers_near(value, "color", 3, 0);
  for (glm::length_t i = 0; i < 3 && !colour.empty(); ++i)
    light.colour[i] = static_cast<float>(colour[static_cast<std::size_t>(i)]);
  light.colour *= static_cast<float>(number_near(value, "intensity", 1, 0, largest));
  if (!std::isfinite(light.colour.x + light.colour.y + light.colour.z))
    light.colour = glm::clamp(light.colour, glm::vec3(0), glm::vec3(largest));
  if (value.has("range")) {
    light.range_m = static_cast<float>(number_near(value, "range", 0, 0));
    if (!(light.range_m > 0)) warn_at(value, "its range is not over 0, and it has no limit");
  }

  if (type == "directional")
    light.type = LightType::directional;
  else if (type == "point")
    light.type = LightType::point;
  else if (type == "spot") {
    light.type = LightType::spot;
    read_spot(value, light);
  } else {
    value.fail("light type '{}' is not known", type.substr(0, 40));
  }
  return light;
}

/// Returns what `read` does; nothing, with a warning, if it throws InputError.
template <class Read>
auto read_or_leave_out(const Value& value, const Read& read) -> std::optional<decltype(read())> {
  std::optional<decltype(read())> made;
  const std::string fault = fault_of([&] { made = read(); });
  if (!fault.empty())
    warn_of_fault(value.file(), "cameras or lights that cannot be read are left out", value.place(), fault,
                  "it is left out");
  return made;
}

}  // namespace

void read_cameras(Document& document, const Value& root) {
  root.for_each("cameras", [&](const Value& value) {
    document.cameras.push_back(read_or_leave_out(value, [&] { return read_camera(value); }));
  });
}

void read_lights(Document& document, const Value& root) {
  const auto lights = extension(root, "KHR_lights_punctual");
  if (!lights) return;
  lights->for_each("lights", [&](const Value& value) {
    document.lights.push_back(read_or_leave_out(value, [&] { return read_light(value); }));
    if (document.lights.back()) read_extras(value, *document.lights.back());
  });
}

}  // namespace dermis::scene::gltf
