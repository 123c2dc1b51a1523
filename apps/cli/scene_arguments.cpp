// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "api/prepare/scene_file.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/known_names.h"
#include "base/settings/fields.h"
#include "base/settings/json.h"
#include "cli/brief_log.h"
#include "cli/command.h"
#include "cli/help.h"
#include "cli/progress.h"
#include "cli/settings_options.h"
#include "cli/test_scenes/test_scenes.h"
#include "tissue/optics/presets.h"

namespace dermis::cli {
namespace {

constexpr const char* scene_type = "FILE|built-in|built-in:light|built-in:medium|built-in:dark";

// "built-in", "built-in:light"; nothing is the built-in head, too.
bool is_built_in(std::string_view name) {
  return name.empty() || name == "built-in" || name.starts_with("built-in:");
}
std::string built_in_name(const std::string& name) {
  return name.find(':') < name.size() ? name : "built-in:medium";
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

template <class Visit>
void for_each_optimisation(QualitySettings& quality, const Visit& visit) {
  for_each_setting(quality, [&](const std::string& name, const About& about, auto& value, std::string_view) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, bool>)
      if (about.option == "optimise") visit(name, about, value);
  });
}

// Some of the settings that share this option, in any order, or all, or none.
bool parse_optimise(const std::vector<std::string>& names, QualitySettings& quality) {
  const bool all = names == std::vector<std::string>{"all"}, none = names == std::vector<std::string>{"none"};
  const std::set<std::string> wanted(names.begin(), names.end());
  std::size_t known = 0;

  for_each_optimisation(quality, [&](const std::string& name, const About&, bool& value) {
    value = all || wanted.contains(name);
    known += wanted.count(name);
  });
  return all || none || known == wanted.size();
}

void add_size(CLI::App& command, OutputSettings& output) {
  command
      .add_option_function<std::string>(
          "--size",
          [&output](const std::string& text) {
            if (!parse_size(text, output))
              throw CLI::ValidationError("--size", "expected WIDTHxHEIGHT in pixels, got '" + text + "'");
          },
          "picture, pixels")
      ->type_name("WxH")
      ->default_str(fmt::format("{}x{}", output.width, output.height));
}

// Of the first that is not known; else all or none stand beside others.
std::string unknown_optimisation(const std::vector<std::string>& given,
                                 const std::vector<std::string>& names) {
  for (const std::string& name : given)
    if (std::find(names.begin(), names.end(), name) == names.end()) return unknown_name(name, names);
  return "all and none stand alone";
}

void add_optimise(CLI::App& command, QualitySettings& quality) {
  std::vector<std::string> names{"all", "none"};
  std::string help;
  for_each_optimisation(quality, [&](const std::string& name, const About& about, const bool&) {
    names.push_back(name);
    help += fmt::format("{} ({}), ", about.help, name);
  });
  const auto read = [&quality, names](const std::vector<std::string>& given) {
    if (!parse_optimise(given, quality))
      throw CLI::ValidationError("--optimise", unknown_optimisation(given, names));
  };
  command.add_option_function<std::vector<std::string>>("--optimise", read, help + "all, or none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name(one_of(names))
      ->default_str("all");
}

// Lights that are given one way replace those that a file of settings gives another way.
void add_lights(CLI::App& command, LightingSettings& lighting, const About& about) {
  const auto read = [&command, &lighting](const std::vector<std::string>& texts) {
    lighting.placed_lights.clear();
    for (const std::string& text : texts) lighting.placed_lights.push_back(parse_light(text));
    if (command.get_option("--lights")->count() == 0) lighting.rig_lights.reset();
  };
  command.add_option_function<std::vector<std::string>>("--light", read, help_of(about))
      ->allow_extra_args(false)
      ->type_name("AZ,EL[,I]")
      ->default_str("");
}

void add_rig_lights(CLI::App& command, LightingSettings& lighting, const About& about) {
  const auto read = [&command, &lighting](const int count) {
    lighting.rig_lights = count;
    if (command.get_option("--light")->count() == 0) lighting.placed_lights.clear();
  };
  command.add_option_function<int>("--lights", read, help_of(about))
      ->type_name("INT")
      ->default_str(lighting.rig_lights ? fmt::format("{}", *lighting.rig_lights) : "");
}

// Returns true for a setting that a command varies, fixes or does not know.
bool is_left_out(const std::string& path, const About& about, SceneUse use) {
  const auto is = [&](std::initializer_list<std::string_view> paths) {
    return std::find(paths.begin(), paths.end(), path) != paths.end();
  };
  switch (use) {
    case SceneUse::render: return false;
    case SceneUse::view: return is({"output.frames", "output.show"});
    case SceneUse::sequence: return is({"output.frames", "camera.orbit_deg"});
    case SceneUse::plan: return is({"output.frames", "output.show"});
    case SceneUse::reference: return about.real_time;
    case SceneUse::comparison:
      return is({"technique", "camera.heads", "output.bloom", "output.background", "output.show",
                 "skin.translucency"});
    case SceneUse::bench:
      return about.option == "optimise" ||
             is({"technique", "camera.name", "camera.distance", "camera.orbit_deg", "camera.eye_m",
                 "camera.target_m", "camera.heads", "output.exposure_ev", "output.background",
                 "output.frames", "output.show"});
  }
  return false;
}

void add_settings(CLI::App& command, RenderSettings& s, SceneUse use) {
  for_each_setting(
      s, [&](const std::string& path, const About& about, auto& value, std::string_view section) {
        if (about.option.empty() || is_left_out(path, about, use)) return;
        const std::string own = use == SceneUse::comparison && path == "quality.samples" ? "--msaa" : "";
        const std::string name = own.empty() ? "--" + std::string(about.option) : own;
        if (command.get_option_no_throw(name)) return;  // of several settings

        using Value = std::remove_cvref_t<decltype(value)>;
        if (name == "--size")
          add_size(command, s.output);
        else if (name == "--optimise")
          add_optimise(command, s.quality);
        else if (name == "--lights")
          add_rig_lights(command, s.lighting, about);
        else if constexpr (std::is_same_v<Value, std::vector<PlacedLight>>)
          add_lights(command, s.lighting, about);
        else
          AddOption{command}(name, about, value);
        file_under(section.empty() ? "Technique" : std::string(section), about, command.get_option(name));
      });
}

// Options are read in the order in which they are added: what is given by itself wins over the file, and an
// option of its own over --set.
void add_settings_files(CLI::App& command, SceneArguments& arguments) {
  const auto read_into = [&arguments](const auto& read) {
    SettingsFile file = settings_file(arguments);
    read(file);
    arguments.settings = file.render;
    arguments.options = file.scene;
    // Where no truth is computed, what the file says of it is left alone.
    if (arguments.reference) *arguments.reference = *file.reference;
  };
  const auto read = [read_into](const std::string& path) {
    read_into([&](SettingsFile& file) { load_settings(path, file); });
  };
  const auto set = [read_into](const std::vector<std::string>& assignments) {
    for (const std::string& one : assignments)
      read_into([&](SettingsFile& file) { load_setting(one, "--set", file); });
  };
  rare(command
           .add_option_function<std::string>(
               "--settings", read,
               "JSON written by --save-settings, or by hand; options that are given win over it")
           ->type_name("FILE")
           ->default_str("")
           ->group("Settings"));
  rare(command
           .add_option_function<std::vector<std::string>>(
               "--set", set,
               "any setting of docs/settings.md, as --set quality.light_samples=1; may be repeated")
           ->allow_extra_args(false)
           ->type_name("NAME=VALUE")
           ->default_str("")
           ->group("Settings"));
  rare(command
           .add_option("--save-settings", arguments.save_settings, "write the settings of this run as JSON")
           ->type_name("FILE")
           ->group("Settings"));
}

void add_scene(CLI::App& command, SceneArguments& arguments) {
  if (arguments.use == SceneUse::comparison) {
    command
        .add_option("--scene", arguments.scene,
                    "techniques against ground truth: a .gltf, .glb or scene file, 'built-in' for the "
                    "built-in head, or a test scene, 'test:NAME' (docs/choosing.md)")
        ->type_name(scene_type)
        ->group("Scene");
    return;
  }
  if (arguments.use == SceneUse::bench) {
    command.add_option("SCENE", arguments.scene, ".gltf or .glb file; without one, the built-in head")
        ->type_name(scene_type);
    return;
  }

  command
      .add_option("SCENE", arguments.scenes,
                  "a .gltf, .glb or scene file (docs/scenes.md), or several .gltf and .glb beside each "
                  "other. 'built-in', or nothing: the built-in head, also built-in:light and built-in:dark, "
                  "or one of six classes of skin, built-in:ita-very-light, -light, -intermediate, -tan, "
                  "-brown, -dark. "
                  "'test:NAME': a test scene (docs/choosing.md)")
      ->type_name(scene_type)
      ->default_str("");
  const auto read = [&arguments](const std::string& name) {
    arguments.layout = find_name<Layout>("--layout", name);
  };
  rare(command
           .add_option_function<std::string>(
               "--layout", read,
               "places several files, 1.6 radii of the larger neighbour apart. Their own lights have no "
               "common world and are left out: unless told of other lights, the rig stands around all")
           ->type_name(one_of(names_of<Layout>))
           ->default_str("row")
           ->group("Scene"));
  rare(command
           .add_option("--save-scene", arguments.save_scene,
                       "write the scene of this run, files and where they stand, as a scene file")
           ->type_name("FILE")
           ->group("Scene"));
}

// Before anything is loaded, which may take long.
void check_scenes(const SceneArguments& a) {
  if (a.layout && a.scenes.size() < 2)
    throw input_error("--layout", "places several files beside each other, and there is {}",
                      a.scenes.empty() ? "none" : "one");
  if (a.scenes.size() > 1 && a.settings.camera.heads > 1)
    throw input_error("", "camera.heads must be 1 for several files, got {}", a.settings.camera.heads);
}

// A word that is no file may be meant for one that is built in.
void check_is_there(const std::string& file) {
  std::error_code error;
  if (is_built_in(file) || std::filesystem::exists(file, error)) return;
  const std::string meant =
      did_you_mean(file, {"built-in", "built-in:light", "built-in:medium", "built-in:dark",
                          "built-in:ita-very-light", "built-in:ita-light", "built-in:ita-intermediate",
                          "built-in:ita-tan", "built-in:ita-brown", "built-in:ita-dark"});
  if (!meant.empty()) throw input_error(file, "no such file{}", meant);
}

Asset open_asset(const std::string& file, const SceneOptions& options, const Hooks& hooks) {
  check_is_there(file);
  return Asset::load(is_built_in(file) ? built_in_name(file) : file, options, hooks);
}

// Nothing of a file can be chosen where there is none.
Scene open_test_scene(const std::string& name, const SceneArguments& arguments, const Hooks& hooks) {
  if (json_of(arguments.options) != json_of(SceneOptions{}))
    throw input_error(name, "is generated: options of files, such as a unit scale or a clip, are not for it");
  return test_scenes::make(name, arguments.settings.output.height, hooks);
}

// A file that is given twice is loaded once.
Scene open_scenes(const SceneArguments& arguments, const SceneOptions& options, const Hooks& hooks) {
  std::vector<Asset> assets;
  for (const std::string& file : arguments.scenes) {
    const auto before = std::find_if(
        arguments.scenes.begin(), arguments.scenes.begin() + static_cast<std::ptrdiff_t>(assets.size()),
        [&](const std::string& other) {
          return other == file || (!is_built_in(file) && !is_built_in(other) && same_file(other, file));
        });
    const auto number = static_cast<std::size_t>(before - arguments.scenes.begin());
    assets.push_back(number < assets.size() ? Asset(assets[number]) : open_asset(file, options, hooks));
  }
  return laid_out(assets, arguments.layout.value_or(Layout::row));
}

// Returns how an option of a setting is called: the last part of its path, without a unit.
std::string spelt(std::string_view path) {
  std::string name = "--" + std::string(path.substr(path.rfind('.') + 1));
  if (name.ends_with("_mm") || name.ends_with("_mb")) name.resize(name.size() - 3);
  std::ranges::replace(name, '_', '-');
  return name;
}

// An option of versions before, which help does not show.
void former_option(CLI::App& command, const std::string& name, const std::string& why) {
  command
      .add_option_function<std::string>(
          name, [=](const std::string&) { throw CLI::ValidationError(name, why); }, why)
      ->expected(0, 1)
      ->group("");
}

// Those of settings that are gone, and of those that are for --set alone.
void add_former_options(CLI::App& command, const SceneArguments& arguments) {
  former_option(command, "--view", "is now --tone-map");
  former_option(command, "--albedo", "is now --set lighting.white_albedo=true");
  former_option(command, "--normalise", "is gone: the weights of a profile must sum to 1 in its file");
  for (const Gone& gone : gone_from<QualitySettings>)
    if (gone.value.empty())
      former_option(command, spelt(gone.name), fmt::format("is gone: {}", gone.instead));

  const auto one = [&](const std::string& path, const About& about, const auto&, std::string_view) {
    if (about.option.empty()) former_option(command, spelt(path), fmt::format("is now --set {}=VALUE", path));
  };
  for_each_setting(arguments.settings, one);
  for_each_setting(arguments.options, one, "scene");
}

}  // namespace

bool parse_size(const std::string& text, OutputSettings& output) {
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, output.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return false;
  const auto height = std::from_chars(width.ptr + 1, end, output.height);
  return height.ec == std::errc() && height.ptr == end;
}

void add_scene_arguments(CLI::App& command, SceneArguments& arguments, SceneUse use) {
  command.option_defaults()->always_capture_default();
  arguments.use = use;

  add_scene(command, arguments);
  add_settings_files(command, arguments);
  for_each_setting(
      arguments.options, [&](const std::string&, const About& about, auto& value, std::string_view) {
        if (about.option.empty()) return;
        file_under("Scene", about, AddOption{command}("--" + std::string(about.option), about, value));
      });
  rare(
      command.add_flag("--verbose", verbose(), "print every warning and note, not the first two lines alone")
          ->default_str("")
          ->group("Scene"));

  add_settings(command, arguments.settings, use);
  if (use == SceneUse::reference || use == SceneUse::comparison)
    for_each_setting(arguments.reference.emplace(), [&](const std::string&, const About& about, auto& value,
                                                        std::string_view) {
      file_under(truth_group, about, AddOption{command}("--" + std::string(about.option), about, value));
    });
  add_former_options(command, arguments);

  // Names of rooms that the rows know nothing of.
  if (CLI::Option* medium = command.get_option_no_throw("--medium")) {
    std::vector<std::string_view> names;
    for (const optics::Material& material : optics::jensen_materials()) names.push_back(material.name);
    medium->type_name(one_of(names) + "|COEFFICIENTS");
  }
  if (CLI::Option* technique = command.get_option_no_throw("--technique"))
    technique->type_name(one_of(technique_names()));
}

SettingsFile settings_file(const SceneArguments& arguments) {
  return {.render = arguments.settings, .scene = arguments.options, .reference = arguments.reference};
}

void save_settings(const SceneArguments& arguments) {
  if (arguments.save_settings.empty()) return;
  write_file(arguments.save_settings, to_json(settings_file(arguments)));
}

void check_scene_output(const SceneArguments& arguments, std::initializer_list<std::string> outputs) {
  const std::string& file = arguments.save_scene;
  if (file.empty()) return;
  check_writable(file);
  std::vector<std::string> taken(outputs);
  taken.push_back(arguments.save_settings);
  // The scene file that was read may be written again.
  if (arguments.scenes.size() > 1)
    taken.insert(taken.end(), arguments.scenes.begin(), arguments.scenes.end());
  for (const std::string& other : taken)
    if (!other.empty() && other != "-" && same_file(file, other))
      throw input_error(file, "is also another file of this command; --save-scene needs its own");
}

void save_scene(const SceneArguments& arguments, const Scene& scene) {
  if (!arguments.save_scene.empty()) scene.save(arguments.save_scene);
}

PlayingScene open_playing_scene(const SceneArguments& arguments, const Hooks& hooks) {
  if (!arguments.save_settings.empty()) check_writable(arguments.save_settings);
  check_scenes(arguments);

  const bool takes_several = arguments.use != SceneUse::comparison && arguments.use != SceneUse::bench;
  const std::string only =
      takes_several && !arguments.scenes.empty() ? arguments.scenes.front() : arguments.scene;
  if (arguments.scenes.size() <= 1 && test_scenes::is_test_scene(only))
    return {open_test_scene(only, arguments, hooks), {}};

  check_is_there(only);
  const SceneOptions options = api::at_begin(arguments.options);
  Scene scene = arguments.scenes.size() > 1
                    ? open_scenes(arguments, options, hooks)
                    : Scene::load(is_built_in(only) ? built_in_name(only) : only, options, hooks);
  std::vector<api::Playing> playing = api::playing(scene, arguments.options);
  return {std::move(scene), std::move(playing)};
}

PlayingScene open_playing_scene(const SceneArguments& arguments) {
  PlayingScene opened = open_playing_scene(arguments, terminal_hooks());
  show_line("");
  return opened;
}

Scene open_scene(const SceneArguments& arguments, const Hooks& hooks) {
  PlayingScene opened = open_playing_scene(arguments, hooks);
  api::play(opened.playing, arguments.options.time_s.value_or(0), opened.scene);
  return std::move(opened.scene);
}

Scene open_scene(const SceneArguments& arguments) {
  Scene scene = open_scene(arguments, terminal_hooks());
  show_line("");
  return scene;
}

void check_picture_name(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending != ".png" && ending != ".exr")
    throw InputError(path, "pictures are written as .png or .exr, not as '" + ending + "'");
  check_writable(path);
}

std::string& command_line() {
  static std::string line;
  return line;
}

}  // namespace dermis::cli
