// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/known_names.h"
#include "base/settings/comparison_fields.h"
#include "base/settings/names.h"
#include "cli/command.h"
#include "cli/compare_page.h"
#include "cli/comparison/table.h"
#include "cli/help.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/scene_comparison.h"
#include "cli/settings_options.h"
#include "cli/test_scenes/test_scenes.h"
#include "image/codec.h"

namespace dermis::cli {
namespace {

// Two PNG of this many pixels take 2 GB.
constexpr image::DecodeLimits limits{.max_side = 16384, .max_pixels = std::size_t{1} << 26};

struct CompareArguments : SceneArguments {
  std::string a, b, json, html, region;
  std::vector<std::string> variances;
  SceneComparisonSettings scene_settings;
  bool table = false;
  std::vector<std::string> sizes{"640x360", "1280x720"}, test_scenes{"all"};
  std::vector<double> distances{2.5, 10};
};

/// Refuses outputs before pictures are read.
void check_outputs(const CompareArguments& arguments) {
  if (arguments.html == "-") throw input_error("--html", "needs a file, not standard output");
  std::vector<std::string> taken;
  for (const std::string* input :
       {&arguments.a, &arguments.b, &arguments.region, &arguments.scene,
        &arguments.scene_settings.reference_file, &arguments.scene_settings.variance_file})
    if (!input->empty()) taken.push_back(*input);
  taken.insert(taken.end(), arguments.variances.begin(), arguments.variances.end());
  for (const std::string& output : {arguments.json, arguments.html, arguments.save_settings}) {
    if (output.empty() || output == "-") continue;
    check_writable(output);
    for (const std::string& other : taken)
      if (same_file(output, other))
        throw input_error(output, "is also another file of this command; outputs need names of their own");
    taken.push_back(output);
  }
}

template <class Image>
void check_size(const Image& a, const std::string& a_name, const Image& b, const std::string& b_name) {
  if (a.width != b.width || a.height != b.height)
    throw input_error(b_name, "is {} x {} pixels, {} is {} x {}; only pictures of one size can be compared",
                      b.width, b.height, a_name, a.width, a.height);
}

image::Region region_for(const CompareArguments& arguments, int width, int height) {
  return arguments.region.empty() ? image::Region() : image::load_region(arguments.region, width, height);
}

void compare_linear(const CompareArguments& arguments, std::span<const std::byte> a_bytes,
                    std::span<const std::byte> b_bytes, Compared& compared) {
  const image::ImageF a = image::decode_image_f(a_bytes, arguments.a, limits),
                      b = image::decode_image_f(b_bytes, arguments.b, limits);
  check_size(a, arguments.a, b, arguments.b);
  compared.region = region_for(arguments, a.width, a.height);

  std::vector<image::ImageF> variances;
  for (const std::string& name : arguments.variances) {
    variances.push_back(image::load_image_f(name, limits));
    check_size(a, arguments.a, variances.back(), name);
    const auto& values = variances.back().values;
    const auto negative = std::find_if(values.begin(), values.end(), [](float value) { return value < 0; });
    if (negative != values.end()) throw input_error(name, "holds {}; variances are 0 or more", *negative);
  }

  const ToneMap tone_map = arguments.settings.output.tone_map;
  compared.tone_map = name_of(tone_map);
  compared.found = image::compare(a, b, tone_map, variances, compared.region);
  compared.shown_a = image::to_display(a, tone_map);
  compared.shown_b = image::to_display(b, tone_map);
}

void compare_display(const CompareArguments& arguments, std::span<const std::byte> a_bytes,
                     std::span<const std::byte> b_bytes, Compared& compared) {
  if (!arguments.variances.empty())
    throw input_error("--z", "needs two linear pictures (EXR); {} holds display values", arguments.a);
  compared.shown_a = image::decode_image8(a_bytes, arguments.a, limits);
  compared.shown_b = image::decode_image8(b_bytes, arguments.b, limits);
  check_size(compared.shown_a, arguments.a, compared.shown_b, arguments.b);
  compared.region = region_for(arguments, compared.shown_a.width, compared.shown_a.height);
  compared.found = image::compare(compared.shown_a, compared.shown_b, compared.region);
}

void compare_two(const CompareArguments& arguments) {
  Compared compared{.a = arguments.a, .b = arguments.b, .region_name = arguments.region};
  {
    const std::vector<std::byte> a = read_file(arguments.a), b = read_file(arguments.b);
    const image::PictureKind kind = image::picture_kind(a, arguments.a);
    if (image::picture_kind(b, arguments.b) != kind) {
      const auto name = [](bool linear) { return linear ? "linear light" : "display values"; };
      const bool linear = kind == image::PictureKind::linear;
      throw input_error(arguments.b, "holds {}, {} holds {}; compare two PNG or two EXR pictures",
                        name(!linear), arguments.a, name(linear));
    }
    (kind == image::PictureKind::linear ? compare_linear : compare_display)(arguments, a, b, compared);
  }

  // All there is to say before anything is written.
  const std::string json = compared_json(compared),
                    page = arguments.html.empty() ? "" : compared_page(compared);

  if (!arguments.html.empty()) write_file(arguments.html, page);
  if (!arguments.json.empty()) write_text(arguments.json, json);
  if (arguments.json != "-") write_text("-", compared_text(compared));
}

SceneComparisonSettings comparison_settings(const CompareArguments& arguments) {
  SceneComparisonSettings settings = arguments.scene_settings;
  settings.render = arguments.settings;
  settings.reference = *arguments.reference;
  if (settings.techniques == std::vector<std::string>{"all"}) settings.techniques.clear();
  std::vector<std::string> known = technique_names();
  for (const std::string& name : settings.techniques)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      known.insert(known.begin(), "all");
      throw input_error("", "--techniques {}", unknown_name(name, known));
    }
  return settings;
}

comparison::PictureSize picture_size(const std::string& text) {
  OutputSettings output;
  if (!parse_size(text, output))
    throw input_error("", "--sizes: expected WIDTHxHEIGHT in pixels, got '{}'", text);
  return {.width = output.width, .height = output.height};
}

// Settings that a table chooses by itself must not be given once more.
void check_table(const CompareArguments& a) {
  const CameraSettings& camera = a.settings.camera;
  if (camera.distance || camera.eye_m || !camera.name.empty())
    throw input_error("", "a table has --distances; --distance, --eye and --camera are of one comparison");
  if (!a.scene_settings.reference_file.empty())
    throw input_error("--reference", "is of one picture, and a table has several");
  if (a.sizes.empty() || a.distances.empty())
    throw input_error("", "a table needs at least one of --sizes and one of --distances");
}

void compare_cases(const CompareArguments& arguments) {
  check_table(arguments);
  comparison::TableSettings settings{.comparison = comparison_settings(arguments),
                                     .sizes = {},
                                     .distances = arguments.distances,
                                     .test_scenes = comparison::test_scenes_of(arguments.test_scenes)};
  for (const std::string& size : arguments.sizes) settings.sizes.push_back(picture_size(size));
  const Scene scene = open_scene(arguments);
  catch_interrupts();
  settings.comparison.hooks = terminal_hooks();

  comparison::Table table = comparison::compare_table(scene, settings);
  table.settings = settings_file(arguments);
  if (!arguments.html.empty()) write_file(arguments.html, comparison::table_page(table));
  if (!arguments.json.empty()) write_text(arguments.json, comparison::table_json(table));
  if (arguments.json != "-") write_text("-", comparison::table_text(table));
  save_settings(arguments);
}

void compare_techniques(const CompareArguments& arguments) {
  SceneComparisonSettings settings = comparison_settings(arguments);
  const Scene scene = open_scene(arguments);
  catch_interrupts();
  settings.hooks = terminal_hooks();
  const SceneComparison found = compare_scene_here(scene, settings);
  const std::string page = arguments.html.empty() ? "" : scene_comparison_page(found);
  if (!arguments.html.empty()) write_file(arguments.html, page);
  if (!arguments.json.empty())
    write_text(arguments.json, scene_comparison_json(found, settings_file(arguments)));
  if (arguments.json != "-") write_text("-", scene_comparison_text(found));
  save_settings(arguments);
}

void run(const CompareArguments& arguments) {
  const bool two = !arguments.a.empty() || !arguments.b.empty();
  if (arguments.scene.empty() && arguments.a.empty()) throw CLI::RequiredError("A (or --scene)");
  if (arguments.scene.empty() && arguments.b.empty()) throw CLI::RequiredError("B");
  if (!arguments.scene.empty() && two) throw CLI::ExcludesError("--scene", "A and B");
  if (arguments.variances.size() > 2)
    throw CLI::ArgumentMismatch::AtMost("--z", 2, arguments.variances.size());
  check_outputs(arguments);
  if (arguments.scene.empty())
    compare_two(arguments);
  else
    arguments.table ? compare_cases(arguments) : compare_techniques(arguments);
}

void add_table_options(CLI::App& command, CompareArguments& a) {
  const char* group = "Table";
  CLI::Option* table =
      command
          .add_flag("--table", a.table,
                    "compare over sizes, distances and test scenes, and say in words where each "
                    "technique is the right choice")
          ->group(group);
  const auto add = [&](const char* name, auto& values, const std::string& type, const std::string& preset,
                       const char* help) {
    rare(command.add_option(name, values, help)
             ->delimiter(',')
             ->allow_extra_args(false)
             ->type_name(type)
             ->default_str(preset)
             ->needs(table)
             ->group(group));
  };
  add("--sizes", a.sizes, "WxH,..", fmt::format("{}", fmt::join(a.sizes, ",")), "of pictures, pixels");
  add("--distances", a.distances, "D,..", fmt::format("{}", fmt::join(a.distances, ",")),
      "from the eye to the head, in radii of its bounding sphere");
  std::vector<std::string> scenes{"all", "none"};
  for (const test_scenes::TestScene& scene : test_scenes::all()) scenes.emplace_back(scene.name);
  add("--test-scenes", a.test_scenes, one_of(scenes), "all",
      "all, none, or names: scenes for what techniques cannot do, at the smallest of the sizes "
      "(docs/choosing.md)");
}

// Everything that belongs to a scene says so when there is none.
void add_scene_options(CLI::App& command, CompareArguments& a) {
  a.settings.output.width = a.settings.output.height = 512;
  a.settings.output.bloom = 0;  // the reference has none
  a.settings.output.frames = 3;

  const std::vector<CLI::Option*> before = command.get_options();
  add_scene_arguments(command, a, SceneUse::comparison);

  SceneComparisonSettings& s = a.scene_settings;
  const char* group = "Technique";
  command.add_option("--techniques", s.techniques, "all, or some of the list of `render --technique`")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("all|" + one_of(technique_names()))
      ->default_str("all")
      ->group(group);
  for_each_setting(s, [&](const std::string& path, const About& about, auto& value, std::string_view) {
    if (path != "techniques")
      rare(AddOption{command}("--" + std::string(about.option), about, value)->group(group));
  });
  add_device_option(command, s.device)->group(group);
  add_table_options(command, a);

  CLI::Option* file =
      command
          .add_option("--reference", s.reference_file,
                      "a picture of `dermis reference` instead of rendering it: EXR of the same size")
          ->type_name("FILE")
          ->group(truth_group);
  rare(command
           .add_option("--variance", s.variance_file,
                       "EXR: the variance of --reference, to say what its noise adds")
           ->type_name("FILE")
           ->needs(file)
           ->group(truth_group));

  // Tie what was added here to --scene, except what suits two pictures, too.
  CLI::Option* scene = command.get_option("--scene");
  for (CLI::Option* option : command.get_options())
    if (option != scene && option->get_name() != "--tone-map" && option->get_name() != "--view" &&
        std::find(before.begin(), before.end(), option) == before.end())
      option->needs(scene);
}

}  // namespace

void add_compare_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand(
      "compare",
      "compare two pictures, or the techniques and ground truth of a scene: FLIP, PSNR, relative error");

  auto arguments = std::make_shared<CompareArguments>();
  command->option_defaults()->always_capture_default();

  command->add_option("A", arguments->a, "the reference: PNG or JPEG, or EXR or HDR")->type_name("FILE");
  command->add_option("B", arguments->b, "compared with A: of the same size, and linear if A is")
      ->type_name("FILE");
  command->add_option("--json", arguments->json, "write the figures as JSON, - for standard output")
      ->type_name("FILE");
  command
      ->add_option("--html", arguments->html,
                   "write a page: side by side, slider, map of errors, table; one file")
      ->type_name("FILE");
  command
      ->add_option("--region", arguments->region,
                   "PNG of the same size: only pixels that are not black there count")
      ->type_name("FILE");
  command
      ->add_option("--z", arguments->variances,
                   "EXR: variance of each pixel of A or B (squared standard error); how much of the "
                   "difference is noise; up to 2 times")
      ->allow_extra_args(false)
      ->type_name("FILE")
      ->default_str("");

  add_scene_options(*command, *arguments);
  for (const char* name : {"--region", "--z"}) command->get_option(name)->excludes("--scene");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace dermis::cli
