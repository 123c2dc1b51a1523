// SPDX-License-Identifier: MIT
#include "gpu/techniques/support.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "builtin_head/builtin_head.h"
#include "scene/primitives.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

fs::path shared_assets() {
  if (const char* folder = std::getenv("DERMIS_ASSET_CACHE")) return folder;
  return fs::path(DERMIS_SOURCE_DIR) / ".." / "shared" / "assets";
}

/// Opens when first asked for, and returns the same scene from then on: a renderer keeps what it has uploaded
/// of the last one.
std::function<Scene()> once(std::function<Scene()> open) {
  return [open = std::move(open), kept = std::make_shared<std::optional<Scene>>()] {
    if (!*kept) *kept = open();
    return **kept;
  };
}

Subject from_file(const std::string& name, const fs::path& path, const std::vector<fs::path>& needs,
                  const std::string& advice) {
  Subject subject{.name = name, .open = once([path] { return Scene::load(path); }), .missing = {}};
  for (const fs::path& file : needs)
    if (!fs::exists(file)) subject.missing = file.filename().string() + " is not there; " + advice;
  return subject;
}

/// Ends with the last test: later the layer has ended itself.
struct Validated : testing::Environment {
  std::unique_ptr<Renderer> renderer;
  void TearDown() override { renderer.reset(); }
};
Validated* const validated = static_cast<Validated*>(testing::AddGlobalTestEnvironment(new Validated));

}  // namespace

Scene wrap(scene::Scene data) { return Scene(std::make_shared<const scene::Scene>(std::move(data))); }

Renderer& renderer() {
  static Renderer shared;
  return shared;
}

Renderer* validated_renderer() {
  try {
    if (!validated->renderer)
      validated->renderer = std::make_unique<Renderer>(Renderer::Options{.device = "best", .validate = true});
    return validated->renderer.get();
  } catch (const DeviceError& error) {
    if (std::string(error.what()).find("layer") == std::string::npos) throw;
    return nullptr;
  }
}

RenderSettings small_settings(const std::string& technique) {
  RenderSettings s;
  s.technique = technique;
  s.output.width = s.output.height = 128;
  s.quality.map_size = s.quality.shadow_size = 256;
  return s;
}

RenderSettings furnace_settings(const std::string& technique, bool specular) {
  RenderSettings s = small_settings(technique);
  s.lighting.ambient = 1;
  s.lighting.rig_lights = 0;
  s.lighting.white_albedo = true;
  s.lighting.specular = specular;
  s.output.bloom = 0;
  return s;
}

Scene sphere(double radius_m) { return wrap(scene::sphere(radius_m)); }

Scene sheared_plane() { return wrap(scene::plane(0.1, glm::dmat2(0.5, 0, 0.5, 0.5), {}, 8)); }

Scene sphere_lit_from_the_camera(double radius_m) {
  scene::Scene data = scene::sphere(radius_m);
  scene::Light light;
  light.name = "headlight";
  light.colour = glm::vec3(3);
  light.direction = {0, 0, -1};
  data.lights.push_back(light);
  return wrap(std::move(data));
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = [] {
    const fs::path heads = fs::path(DERMIS_SOURCE_DIR) / "assets" / "heads";
    const fs::path shared = shared_assets();
    const fs::path makehuman = shared / "makehuman" / "mh-african-man-young.glb",
                   ict = shared / "ict-facekit" / "ict-mean-animated.glb";
    const std::string cache = "set DERMIS_ASSET_CACHE to the folder that holds it";
    return std::vector<Subject>{
        {"sphere", once([] { return sphere(0.1); }), {}},
        {"sheared plane", once(sheared_plane), {}},
        {"built-in head", once([] { return wrap(builtin_head::make({.map_size = 512})); }), {}},
        from_file("scan", heads / "lee-perry-smith.gltf",
                  {heads / "LeePerrySmith.glb", heads / "Map-COL.jpg"}, "./run fetch-assets brings it"),
        from_file("MakeHuman", makehuman, {makehuman}, cache),
        from_file("ICT", ict, {ict}, cache),
    };
  }();
  return all;
}

const Subject& subject(const std::string& name) {
  for (const Subject& s : subjects())
    if (s.name == name) return s;
  throw std::invalid_argument("no subject " + name);
}

std::vector<std::string> subject_names() {
  std::vector<std::string> names;
  for (const Subject& s : subjects()) names.push_back(s.name);
  return names;
}

std::string test_name_of(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

SkinRange skin_range(const Picture& picture) {
  SkinRange range;
  for (std::size_t i = 0; i + 3 < picture.linear_rgba.size(); i += 4) {
    if (picture.linear_rgba[i + 3] < 1 - 1e-3f) continue;
    ++range.pixels;
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = picture.linear_rgba[i + c];
      // Not a number fails every bound: it counts as the highest value there is.
      range.low = std::min(range.low, value == value ? value : 0.0f);
      range.high = std::max(range.high, value == value ? value : 1e30f);
      range.mean[c] += static_cast<double>(value);
    }
  }
  for (double& m : range.mean) m /= static_cast<double>(std::max<std::size_t>(range.pixels, 1));
  return range;
}

std::array<double, 3> sum(const Picture& picture) {
  std::array<double, 3> total{};
  for (std::size_t i = 0; i + 3 < picture.linear_rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) total[c] += static_cast<double>(picture.linear_rgba[i + c]);
  return total;
}

}  // namespace dermis::tests
