// SPDX-License-Identifier: MIT
// Draws the page that a newcomer sees: a face with scattering and without, two details, three skins.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/core/file.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/demo/page.h"
#include "cli/output.h"
#include "cli/progress.h"

namespace dermis::cli {
namespace {

struct DemoArguments {
  std::string scan, folder = "out";
  DeviceArguments on;
};

/// A camera and the lamps that go with it.
struct View {
  std::array<double, 3> eye_m, target_m;
  double fov_deg;
  std::vector<PlacedLight> lights;
  double ambient;
};

/// One hard lamp from the side, whose shadows show how far light spreads, and a faint one for the other side.
const std::vector<PlacedLight> side_light = {{.azimuth_deg = 72, .elevation_deg = 22, .irradiance = 4.5},
                                             {.azimuth_deg = -70, .elevation_deg = 5, .irradiance = 0.2}};
/// A lamp behind the ear, and a faint one in front.
const std::vector<PlacedLight> back_light = {{.azimuth_deg = 158, .elevation_deg = 8, .irradiance = 12},
                                             {.azimuth_deg = 20, .elevation_deg = 20, .irradiance = 0.5}};

/// Views of a head: its origin is where its file has it.
struct Views {
  View face, terminator, ear;
};
const Views scan_views = {.face = {{0.09, 0.075, 0.62}, {0.01, 0.058, 0.05}, 16.5, side_light, 0.04},
                          .terminator = {{0.09, 0.075, 0.62}, {0.012, 0.078, 0.08}, 6.5, side_light, 0.04},
                          .ear = {{0.3, 0.085, 0.4}, {0.079, 0.078, -0.005}, 8.5, back_light, 0.06}};
const Views built_in_views = {.face = {{0.1, 0.02, 0.68}, {0.008, -0.005, 0.05}, 15, side_light, 0.04},
                              .terminator = {{0.1, 0.02, 0.68}, {0.01, 0.012, 0.07}, 6, side_light, 0.04},
                              .ear = {{0.3, 0.03, 0.38}, {0.077, 0.018, -0.012}, 8.5, back_light, 0.06}};
const View bust = {{0.14, 0.02, 0.75}, {0.004, 0.005, 0.05}, 20, side_light, 0.04};

constexpr const char* background = "#3a424d";

RenderSettings settings_of(const View& view, int width, int height) {
  RenderSettings s;
  s.camera.eye_m = view.eye_m;
  s.camera.target_m = view.target_m;
  s.camera.fov_deg = view.fov_deg;
  s.lighting.placed_lights = view.lights;
  s.lighting.ambient = view.ambient;
  s.output.background = background;
  s.output.width = width;
  s.output.height = height;
  s.quality.map_size = 1024;
  return s;
}

/// The word that started this program, as a shell takes it.
std::string program() { return command_line().substr(0, command_line().find(' ')); }

/// Returns the command line that draws these settings.
std::string command_of(const std::string& scene, const RenderSettings& s, const std::string& output) {
  const auto point = [](const std::array<double, 3>& p) {
    return fmt::format("{:g},{:g},{:g}", p[0], p[1], p[2]);
  };
  std::string text =
      fmt::format("{} render {} --eye {} --target {} --fov {:g}", program(), cli::quoted(scene),
                  point(*s.camera.eye_m), point(*s.camera.target_m), *s.camera.fov_deg);
  for (const PlacedLight& light : s.lighting.placed_lights)
    text += fmt::format(" --light={:g},{:g},{:g}", light.azimuth_deg, light.elevation_deg, light.irradiance);
  text += fmt::format(" --ambient {:g} --background {} --map-size {} --size {}x{}", s.lighting.ambient,
                      cli::quoted(s.output.background), s.quality.map_size, s.output.width, s.output.height);
  if (s.technique != RenderSettings().technique) text += " --technique " + s.technique;
  return text + " -o " + cli::quoted(output);
}

class Demo {
 public:
  explicit Demo(const DemoArguments& arguments)
      : arguments_(arguments),
        renderer_(
            {.device = arguments.on.device, .validate = arguments.on.validate, .hooks = terminal_hooks()}) {}

  /// Draws the three pairs of a head.
  void draw_head(const std::string& name, const Scene& scene, const Views& views) {
    page_.pairs = {
        pair("One hard light from the side", name, scene, settings_of(views.face, 600, 660), "demo"),
        pair("Where light turns to shadow", name, scene, settings_of(views.terminator, 420, 420),
             "demo-terminator"),
        pair("An ear, lit from behind", name, scene, settings_of(views.ear, 420, 420), "demo-ear")};
  }

  void draw_skin(const std::string& name, const Scene& scene) {
    page_.skins.push_back(
        drawn(name, scene, settings_of(bust, 300, 360), "demo-" + name.substr(name.find(':') + 1)));
  }

  void credit(std::string text) { page_.credit = std::move(text); }

  int finish(const std::string& head, double seconds) {
    show_line("");
    if (tell_validation_messages(renderer_)) return 1;

    page_.seconds = seconds;
    page_.next = next_commands(head);
    const std::string file = path("demo.html");
    write_file(file, demo::html(page_));
    const Statistics& cost = page_.pairs.front().scattered.cost;
    fmt::print("drawn in {:.0f} s on {}\npage: {}\n", seconds, cost.device,
               std::filesystem::absolute(file).string());
    return 0;
  }

 private:
  std::string path(const std::string& file) const {
    return (std::filesystem::path(arguments_.folder) / file).string();
  }

  demo::Pair pair(const std::string& title, const std::string& name, const Scene& scene, RenderSettings s,
                  const std::string& stem) {
    demo::Pair pair{.title = title, .scattered = drawn(name, scene, s, stem), .lambert = {}};
    s.technique = "lambert";
    pair.lambert = drawn(name, scene, s, stem + "-lambert");
    return pair;
  }

  demo::Shown drawn(const std::string& name, const Scene& scene, const RenderSettings& s,
                    const std::string& stem) {
    show_line("drawing " + stem);
    const std::string file = path(stem + ".png");
    Picture picture = renderer_.render(scene, s);
    picture.save(file);
    return {
        .command = command_of(name, s, file),
        .pixels = {.width = picture.width, .height = picture.height, .rgba = std::move(picture.display_rgba)},
        .cost = std::move(picture.statistics)};
  }

  /// Commands to try after the page, each as it is to be typed.
  std::vector<demo::Next> next_commands(const std::string& head) const {
    const std::string start = program(), name = cli::quoted(head);
    const auto file = [this](const std::string& stem) { return cli::quoted(path(stem)); };
    return {{"Another light and camera. Any glTF 2.0 head can stand in place of this one.",
             fmt::format(
                 "{} render {} --orbit 35,5 --environment studio --background studio --size 480x540 -o {}",
                 start, name, file("studio.png"))},
            {"Difference of the two pictures above, in numbers and as a map.",
             fmt::format("{} compare {} {} --html {}", start, file("demo.png"), file("demo-lambert.png"),
                         file("difference.html"))},
            {"Skin from measured coefficients: how far light spreads in it, and a picture with that profile.",
             fmt::format("{0} profile --preset skin1 --gaussians 6 -o {1} && {0} render {2} --profile {1} "
                         "--size 480x540 -o {3}",
                         start, file("skin1.json"), name, file("skin1.png"))},
            {"A turn of the camera in eight frames, on one sheet.",
             fmt::format(
                 "{} sequence {} --orbit 0,5..360,5 --fps 2 --light=40,25 --size 160x180 -o {} --sheet {}",
                 start, name, file("turn-%02d.png"), file("turn.png"))},
            {"The options of a picture.", start + " render --help"}};
  }

  const DemoArguments& arguments_;
  Renderer renderer_;
  demo::Page page_;
};

void run(const DemoArguments& arguments, int& exit_status) {
  std::filesystem::create_directories(arguments.folder);
  const auto start = std::chrono::steady_clock::now();
  Demo demo(arguments);

  const std::string light = "built-in:light", head = arguments.scan.empty() ? light : arguments.scan;
  show_line("loading " + head);
  demo.draw_head(head, Scene::load(head, {}, terminal_hooks()),
                 arguments.scan.empty() ? built_in_views : scan_views);
  if (!arguments.scan.empty())
    demo.credit(
        "Head: Infinite, 3D Head Scan by Lee Perry-Smith (Infinite-Realities, www.ir-ltd.net), CC BY 3.0; "
        "scaled, lit and rendered by dermis.");
  for (const std::string& name : {light, std::string("built-in:medium"), std::string("built-in:dark")})
    demo.draw_skin(name, Scene::load(name, {}, terminal_hooks()));

  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  exit_status = demo.finish(head, seconds);
}

}  // namespace

void add_demo_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "demo", "draw a face with scattering and without, two details and three skins, and a page of all");
  auto arguments = std::make_shared<DemoArguments>();
  command
      ->add_option("--scan", arguments->scan,
                   "assets/heads/lee-perry-smith.gltf with its files; without it the built-in head is drawn")
      ->type_name("FILE")
      ->default_str("");
  command->add_option("-o,--output", arguments->folder, "folder of the pictures and demo.html")
      ->type_name("FOLDER");
  add_device_arguments(*command, arguments->on);
  command->callback([arguments, &exit_status] { run(*arguments, exit_status); });
}

}  // namespace dermis::cli
