// SPDX-License-Identifier: MIT
// Reads cameras and lights, and checks references of animations (a scene at rest needs no more of them).
#include <cmath>
#include <numbers>

#include "core/warnings.h"
#include "scene/gltf/document.h"

namespace dermis::scene::gltf {

namespace {

constexpr double largest = std::numeric_limits<float>::max();

/// Returns a number above 0.
float positive(const Value& value, const char* key) {
  const double number = value.at(key).number();
  if (!(number > 0)) value.at(key).fail("must be over 0, is {}", number);
  return static_cast<float>(number);
}

void read_perspective(const Value& value, Camera& camera) {
  camera.fov_y_rad = positive(value, "yfov");
  if (camera.fov_y_rad >= std::numbers::pi_v<float>)
    value.fail("yfov must be less than pi, is {}", camera.fov_y_rad);
  camera.znear_m = positive(value, "znear");
  if (value.has("aspectRatio")) positive(value, "aspectRatio");
  if (!value.has("zfar")) return;
  camera.zfar_m = positive(value, "zfar");
  if (*camera.zfar_m <= camera.znear_m)
    value.fail("zfar {} must be more than znear {}", *camera.zfar_m, camera.znear_m);
}

void read_orthographic(const Value& value, Camera& camera) {
  camera.orthographic = true;
  value.at("xmag").number();
  const double ymag = value.at("ymag").number();
  if (ymag == 0) value.fail("ymag must not be 0");
  camera.ymag_m = static_cast<float>(std::abs(ymag));
  camera.znear_m = static_cast<float>(value.at("znear").number());
  camera.zfar_m = positive(value, "zfar");
  if (camera.znear_m < 0 || *camera.zfar_m <= camera.znear_m)
    value.fail("zfar {} must be more than znear {} >= 0", *camera.zfar_m, camera.znear_m);
}

Camera read_camera(const Value& value) {
  Camera camera;
  camera.name = value.text_or("name", "");
  const std::string& type = value.at("type").text();
  if (type == "perspective")
    read_perspective(value.at("perspective"), camera);
  else if (type == "orthographic")
    read_orthographic(value.at("orthographic"), camera);
  else
    value.at("type").fail("must be perspective or orthographic, is '{}'", type.substr(0, 40));
  return camera;
}

void read_spot(const Value& value, Light& light) {
  constexpr double right_angle = std::numbers::pi / 2 + 1e-6;
  light.inner_cone_rad = static_cast<float>(value.number_or("innerConeAngle", 0, 0, right_angle));
  light.outer_cone_rad =
      static_cast<float>(value.number_or("outerConeAngle", std::numbers::pi / 4, 0, right_angle));
  if (light.inner_cone_rad >= light.outer_cone_rad)
    value.fail("innerConeAngle {} must be less than outerConeAngle {}", light.inner_cone_rad,
               light.outer_cone_rad);
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

std::optional<Light> read_light(const Document& document, const Value& value) {
  Light light;
  light.name = value.text_or("name", "");
  const std::string& type = value.at("type").text();
  const std::vector<double> colour = value.numbers("color", 3);
  const auto intensity = static_cast<float>(value.number_or("intensity", 1, 0, largest));

  for (int i = 0; i < 3 && !colour.empty(); ++i) {
    if (colour[i] < 0) value.at("color").fail("must not be negative, is {}", colour[i]);
    light.colour[i] = static_cast<float>(colour[i]);
  }
  light.colour *= intensity;
  if (!std::isfinite(light.colour.x + light.colour.y + light.colour.z))
    value.fail("color times intensity is out of range");
  if (value.has("range")) light.range_m = positive(value, "range");

  if (type == "directional")
    light.type = LightType::directional;
  else if (type == "point")
    light.type = LightType::point;
  else if (type == "spot") {
    light.type = LightType::spot;
    read_spot(value.at("spot"), light);
  } else {
    warn_of(fmt::format("{}: lights of unknown type are left out", document.file), value.place(),
            fmt::format("{}: {}: light type '{}' is not known, the light is left out", document.file,
                        value.place(), type.substr(0, 40)));
    return std::nullopt;
  }

  read_extras(value, light);
  return light;
}

}  // namespace

void read_cameras(Document& document, const Value& root) {
  root.for_each("cameras", [&](const Value& value) { document.cameras.push_back(read_camera(value)); });
}

void read_lights(Document& document, const Value& root) {
  if (const auto lights = extension(root, "KHR_lights_punctual"))
    lights->for_each("lights",
                     [&](const Value& value) { document.lights.push_back(read_light(document, value)); });
}

}  // namespace dermis::scene::gltf
