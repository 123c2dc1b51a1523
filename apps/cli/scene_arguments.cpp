// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <charconv>
#include <filesystem>

#include "cli/brief_log.h"
#include "cli/command.h"
#include "core/error.h"
#include "core/file.h"
#include "settings/names.h"

namespace dermis::cli {
namespace {

// WIDTHxHEIGHT. CLI11 turns a false into exit status 2; sizes that parse but make no sense are refused by the
// renderer.
bool parse_size(const std::string& text, RenderSettings& settings) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, settings.output.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return false;
  const auto height = std::from_chars(width.ptr + 1, end, settings.output.height);
  return height.ec == std::errc() && height.ptr == end;
}

// AZ,EL or AZ,EL,IRRADIANCE.
PlacedLight parse_light(const std::string& text) {
  PlacedLight light;
  double* const numbers[] = {&light.azimuth_deg, &light.elevation_deg, &light.irradiance};
  const char *at = text.data(), *const end = at + text.size();
  std::size_t found = 0;
  while (found < 3) {
    const auto number = std::from_chars(at, end, *numbers[found]);
    if (number.ec != std::errc()) break;
    at = number.ptr;
    if (++found < 3 && at != end && *at == ',') {
      ++at;
      continue;
    }
    if (at == end && found >= 2) return light;
    break;
  }
  throw CLI::ValidationError("--light", "expected AZ,EL or AZ,EL,IRRADIANCE, got '" + text + "'");
}

// EV, or auto: none.
std::optional<double> parse_exposure(const std::string& text) {
  if (text == "auto") return std::nullopt;
  double ev = 0;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, ev);
  if (number.ec != std::errc() || number.ptr != end)
    throw CLI::ValidationError("--exposure", "expected EV or auto, got '" + text + "'");
  return ev;
}

void add_switch(CLI::App& command, const std::string& name, bool& value, const std::string& help,
                const std::string& on = "on", const std::string& off = "off") {
  command
      .add_option_function<std::string>(
          name, [&value, on](const std::string& text) { value = text == on; }, help)
      ->check(CLI::IsMember({on, off}))
      ->default_str(value ? on : off)
      ->group("Light");
}

// `value` is the enumeration or an optional one. An empty `default_name` says nothing of a default.
template <class Enum, class Value>
CLI::Option* add_named(CLI::App& command, const std::string& name, Value& value, const std::string& help,
                       std::string_view default_name) {
  return command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = find_name<Enum>(name, text); }, help)
      ->type_name("TEXT")
      ->default_str(std::string(default_name));
}

// cull,depth,clip in any order, or all, or none.
bool parse_optimise(const std::vector<std::string>& names, RenderSettings& s) {
  bool cull = false, depth = false, clip = false;
  for (const std::string& name : names) {
    const bool alone = names.size() == 1;
    if (name == "all" && alone)
      cull = depth = clip = true;
    else if (name == "cull")
      cull = true;
    else if (name == "depth")
      depth = true;
    else if (name == "clip")
      clip = true;
    else if (name != "none" || !alone)
      return false;
  }
  s.quality.cull = cull, s.quality.depth = depth, s.quality.clip = clip;
  return true;
}

void add_optimise_options(CLI::App& command, RenderSettings& s) {
  const char* group = "What is not seen is not computed";

  command
      .add_option_function<std::vector<std::string>>(
          "--optimise",
          [&s](const std::vector<std::string>& names) {
            if (!parse_optimise(names, s))
              throw CLI::ValidationError("--optimise", "expected all, none, or some of cull,depth,clip");
          },
          "leave out skin that faces away (cull), map texels that the distance does not need (depth), skin "
          "outside the picture (clip); "
          "all; "
          "none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,NAME,..")
      ->default_str("all")
      ->group(group);

  add_named<LightMaps>(
      command, "--maps", s.quality.maps,
      "full: one map of full size a Gaussian; progressive: half the size, a quarter, an eighth "
      "where the light is smooth by then",
      name_of(s.quality.maps))
      ->group(group);
  add_named<BlurMask>(
      command, "--mask", s.quality.mask,
      "how convolutions skip unlit texels: alpha, depth, tiles (default: fastest on this kind of device)", "")
      ->group(group);

  command
      .add_option("--d-ref", s.quality.d_ref,
                  "distance, in radii, up to which light maps have their full size (default: where a texel "
                  "is as large as a pixel)")
      ->group(group);
  command
      .add_option("--clip-margin", s.quality.clip_margin_mm,
                  "skin this far outside the picture is still lit, mm (default: the profile's reach, 3 sigma "
                  "of its widest Gaussian)")
      ->group(group);

  command
      .add_option(
          "--map-budget", s.quality.map_budget_mb,
          "memory for light maps, MB; skin that does not fit together goes in batches (default: four maps of "
          "full size, at most a quarter of the device's)")
      ->group(group);
  command
      .add_option(
          "--skip-unseen-heads", s.quality.skip_unseen_heads,
          "leave out heads wholly outside the picture: true, false (default: true if anything is optimised)")
      ->group(group);
}

void add_environment_options(CLI::App& command, RenderSettings& s) {
  const char* group = "Light";
  command
      .add_option("--environment", s.lighting.environment,
                  "light from all around: an equirectangular .hdr or .exr, or 'studio' (default: --ambient)")
      ->group(group);
  command.add_option("--environment-intensity", s.lighting.environment_intensity, "multiplies its radiance")
      ->group(group);
  command
      .add_option("--environment-rotation", s.lighting.environment_rotation_deg,
                  "degrees about the vertical, from the head's front towards its left")
      ->group(group);
}

void add_real_time_options(CLI::App& command, RenderSettings& s, SceneUse use) {
  if (use == SceneUse::real_time) {
    std::string names;
    for (const std::string& name : technique_names()) names += (names.empty() ? "" : ", ") + name;
    command.add_option("--technique", s.technique, names)->group("Technique");
    command.add_option("--heads", s.camera.heads, "heads in a row, 1.6 radii apart")->group("Camera");
  }
  if (use != SceneUse::comparison)  // the reference has none
    command
        .add_option("--bloom", s.output.bloom, "share of the light that is spread over the picture, 0 to 1")
        ->group("Camera");
  command.add_option("--map-size", s.quality.map_size, "side of the light maps, texels")->group("Technique");
  command.add_option("--shadow-size", s.quality.shadow_size, "side of a shadow map, texels")
      ->group("Technique");
  command
      .add_option(use == SceneUse::comparison ? "--msaa" : "--samples", s.quality.samples,
                  "anti-aliasing, 1 or 4 samples per pixel")
      ->group("Technique");
}

void add_profile_options(CLI::App& command, RenderSettings& s) {
  command
      .add_option("--profile", s.skin.profile,
                  "diffusion profile: a published name or a JSON file (default: the material's, else the "
                  "published six Gaussians)")
      ->group("Technique");
  command.add_flag("--normalise", s.skin.normalise_profile, "divide a profile's weights by their sum")
      ->group("Technique");
  command
      .add_option(
          "--mix", s.skin.mix,
          "part of the albedo applied before the light scatters, 0 to 1 (default: the material's, else 0.5)")
      ->group("Technique");
}

void add_view_options(CLI::App& command, RenderSettings& s) {
  command
      .add_option_function<std::string>(
          "--size",
          [&s](const std::string& text) {
            if (!parse_size(text, s))
              throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT in pixels, got '" + text + "'");
          },
          "picture, pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", s.output.width, s.output.height))
      ->group("Camera");

  command
      .add_option("--camera", s.camera.name,
                  "a camera of the scene (default: its first, else the head is framed from the front)")
      ->group("Camera");
  command
      .add_option("--fov", s.camera.fov_deg,
                  "vertical field of view, degrees (default: the camera's, 20 when framing)")
      ->group("Camera");
  command
      .add_option_function<std::vector<double>>(
          "--orbit",
          [&s](const std::vector<double>& angles) {
            s.camera.orbit_deg = {angles[0], angles[1]};
          },
          "turn the framing camera: azimuth towards the head's left, elevation; degrees")
      ->delimiter(',')
      ->expected(2)
      ->type_name("AZ,EL")
      ->default_str("0,0")
      ->group("Camera");
  command
      .add_option("--distance", s.camera.distance,
                  "the eye stands this far from the middle head, in radii of its bounding sphere")
      ->group("Camera");

  command
      .add_option_function<std::string>(
          "--exposure", [&s](const std::string& text) { s.output.exposure_ev = parse_exposure(text); },
          "radiance is multiplied by 2^EV; auto: by the light on the skin, so that white skin would show 0.5 "
          "on average")
      ->type_name("EV|auto")
      ->default_str("0")
      ->group("Camera");
  add_named<ToneMap>(command, "--tone-map", s.output.tone_map,
                     fmt::format("how display values (PNG, PSNR, FLIP) come from light: {}",
                                 fmt::join(names_of<ToneMap>, ", ")),
                     name_of(s.output.tone_map))
      ->group("Camera");

  command
      .add_option_function<std::string>(
          "--view", [](const std::string&) { throw CLI::ValidationError("--view", "is now --tone-map"); },
          "the former name of --tone-map")
      ->group("");  // not in the help
}

void add_light_options(CLI::App& command, RenderSettings& s, SceneUse use) {
  command
      .add_option("--lights", s.lighting.rig_lights,
                  "this many lights of the rig (key, fill, rim, further ones) instead of the scene's "
                  "(default: the scene's, else 2)")
      ->group("Light");
  command
      .add_option_function<std::vector<std::string>>(
          "--light",
          [&s](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) s.lighting.placed_lights.push_back(parse_light(text));
          },
          "one white spot instead of the scene's lights, 4 radii from the head's centre: azimuth from its "
          "front towards its left, "
          "elevation "
          "(degrees), irradiance at the centre (default: 3); may be repeated")
      ->allow_extra_args(false)
      ->type_name("AZ,EL[,I]")
      ->default_str("")
      ->group("Light");

  command
      .add_option("--light-radius", s.lighting.light_radius_m,
                  "lights are discs of this radius, m, and cast soft shadows; directional ones as if 4 radii "
                  "away (default: the scene's, "
                  "else points)")
      ->group("Light");
  command
      .add_option("--ambient", s.lighting.ambient,
                  "uniform radiance from everywhere (1 shows white Lambert as 1)")
      ->group("Light");

  add_switch(command, "--specular", s.lighting.specular, "reflection at the surface: on, off");
  if (use == SceneUse::real_time || use == SceneUse::bench)
    add_switch(command, "--translucency", s.skin.translucency, "light also comes through the body: on, off");
  add_switch(command, "--albedo", s.lighting.white_albedo, "map, or white: every albedo is 1", "white",
             "map");
}

}  // namespace

void add_scene_arguments(CLI::App& command, SceneArguments& arguments, SceneUse use) {
  command.option_defaults()->always_capture_default();

  if (use == SceneUse::comparison)
    command
        .add_option(
            "--scene", arguments.scene,
            "techniques against ground truth: .gltf or .glb file, or 'built-in' for the built-in head")
        ->group("Scene");
  else
    command.add_option("SCENE", arguments.scene, ".gltf or .glb file; without one, the built-in head");

  command
      .add_option("--skin", arguments.options.skin_material,
                  "the material that is skin (default: extras.dermis, else the name contains 'skin', else "
                  "the only one)")
      ->group("Scene");
  command
      .add_option("--unit-scale", arguments.options.unit_scale,
                  "multiplies all lengths of the file; glTF says metres")
      ->group("Scene");
  command
      .add_option(
          "--texture-budget", arguments.options.texture_budget_mb,
          "memory for the maps of the file, MB: 9.3 bytes per texel, 14.7 of colour maps; over it the "
          "largest are halved while they are read")
      ->group("Scene");
  command.add_flag("--verbose", verbose(), "print every warning and note, not the first two lines alone")
      ->default_str("")
      ->group("Scene");

  if (use != SceneUse::reference) {
    add_real_time_options(command, arguments.settings, use);
    add_optimise_options(command, arguments.settings);
  }
  add_profile_options(command, arguments.settings);
  add_view_options(command, arguments.settings);
  add_light_options(command, arguments.settings, use);
  add_environment_options(command, arguments.settings);

  // Remove what the bench varies or fixes by itself.
  if (use == SceneUse::bench)
    for (const char* own :
         {"--optimise", "--skip-unseen-heads", "--distance", "--camera", "--orbit", "--exposure"})
      command.remove_option(command.get_option(own));
}

Scene open_scene(const SceneArguments& arguments) {
  return arguments.scene.empty() ? Scene::built_in() : Scene::load(arguments.scene, arguments.options);
}

void check_picture_name(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".png" && ending != ".exr")
    throw InputError(path, "pictures are written as .png or .exr, not as '" + ending + "'");
  check_writable(path);
}

std::string& command_line() {
  static std::string line;
  return line;
}

}  // namespace dermis::cli
