// SPDX-License-Identifier: MIT
// Draws what one shows to somebody: a head with and without scattering, a strip of frames, and a page of
// both.
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/demo/page.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/sequence/sheet.h"
#include "core/error.h"
#include "core/file.h"
#include "image/codec.h"

namespace dermis::cli {
namespace {

constexpr int strip_frames = 6;

struct DemoArguments {
  std::string head = "built-in", scan, folder = "out";
  DeviceArguments on;
};

// What a person would type for these settings.
std::string command_of(const char* command, const std::string& scene, const RenderSettings& s,
                       const std::string& output) {
  std::string text = fmt::format("dermis {} {}", command, scene);
  if (!s.camera.name.empty()) text += " --camera " + s.camera.name;
  if (s.camera.eye_m && s.camera.target_m)
    text += fmt::format(" --eye {:g},{:g},{:g} --target {:g},{:g},{:g} --fov {:g}", (*s.camera.eye_m)[0],
                        (*s.camera.eye_m)[1], (*s.camera.eye_m)[2], (*s.camera.target_m)[0],
                        (*s.camera.target_m)[1], (*s.camera.target_m)[2], *s.camera.fov_deg);
  for (const PlacedLight& light : s.lighting.placed_lights)
    text += fmt::format(" --light {:g},{:g},{:g}", light.azimuth_deg, light.elevation_deg, light.irradiance);
  text += fmt::format(" --light-radius {:g} --environment {} --environment-intensity {:g} --background {}",
                      *s.lighting.light_radius_m, s.lighting.environment, s.lighting.environment_intensity,
                      s.output.background);
  if (s.technique != RenderSettings().technique) text += " --technique " + s.technique;
  return text + fmt::format(" --map-size {} --size {}x{} -o {}", s.quality.map_size, s.output.width,
                            s.output.height, output);
}

// A soft key light, the built-in studio for the rest, a wall behind.
RenderSettings settings_of_demo() {
  RenderSettings s;
  s.lighting.placed_lights = {{.azimuth_deg = -20, .elevation_deg = 38, .irradiance = 2.6}};
  s.lighting.light_radius_m = 0.12;
  s.lighting.environment = "studio";
  s.lighting.environment_intensity = 0.3;
  s.output.background = "studio";
  s.output.width = 640;
  s.output.height = 720;
  s.output.frames = 3;
  s.quality.map_size = 1024;
  return s;
}

// Three-quarter view of the built-in head: its face fills the frame.
void frame_face(RenderSettings& s) {
  s.camera.eye_m = {0.46, 0.03, 0.88};
  s.camera.target_m = {0.0, 0.018, 0.03};
  s.camera.fov_deg = 17.5;
}

class Demo {
 public:
  Demo(const DemoArguments& arguments)
      : arguments_(arguments),
        renderer_(
            {.device = arguments.on.device, .validate = arguments.on.validate, .hooks = terminal_hooks()}) {}

  void draw_head(const std::string& name, const std::string& title, const Scene& scene, RenderSettings s,
                 const std::string& stem) {
    show_line("drawing " + title);
    demo::Pair pair{.name = title, .scattered = drawn(name, scene, s, stem), .lambert = {}};
    s.technique = "lambert";
    pair.lambert = drawn(name, scene, s, stem + "-lambert");
    page_.heads.push_back(std::move(pair));
  }

  // The clip of the head if it has one, else a turn of the camera.
  void draw_strip(Scene scene, RenderSettings s) {
    s.output.width = 320;
    s.output.height = 360;
    s.output.frames = 1;
    s.quality.map_size = 512;
    const InstanceId head = scene.instances().front();
    const Asset asset = scene.instance(head).asset;
    if (asset.clips().empty()) return;
    const std::string clip = asset.clips().front();
    const double end_s = asset.clip_end_s(clip);

    sequence::Sheet sheet(strip_frames, s.output.width, s.output.height);
    PreparedFrame frame = renderer_.prepare(scene, s);
    for (int i = 0; i < strip_frames; ++i) {
      show_line(fmt::format("frame {} of {}", i + 1, strip_frames));
      scene.pose(head, clip, end_s * i / strip_frames);
      frame.set(scene, s);
      const Picture picture = frame.picture();
      sheet.add(static_cast<std::size_t>(i),
                {.width = picture.width, .height = picture.height, .rgba = picture.display_rgba});
    }
    page_.strip = sheet.picture();
    page_.strip_command =
        command_of("sequence", arguments_.head, s, path("frame-%d.png")) +
        fmt::format(" --clip {} --fps {:g} --sheet {}", clip, strip_frames / end_s, path("demo-strip.png"));
    image::save_png(path("demo-strip.png"), page_.strip);
  }

  int finish(double seconds) {
    show_line("");
    if (tell_validation_messages(renderer_)) return 1;
    write_file(path("demo.html"), demo::html(page_));
    for (const demo::Pair& pair : page_.heads)
      fmt::print("{}: {:.0f} ms per frame, lambert {:.0f} ms\n", pair.name,
                 pair.scattered.cost.frame_ms_median, pair.lambert.cost.frame_ms_median);
    fmt::print("{} in {:.0f} s\npage: {}\n", page_.heads.front().scattered.cost.device, seconds,
               std::filesystem::absolute(path("demo.html")).string());
    return 0;
  }

 private:
  std::string path(const std::string& file) const {
    return (std::filesystem::path(arguments_.folder) / file).string();
  }

  demo::Shown drawn(const std::string& name, const Scene& scene, const RenderSettings& s,
                    const std::string& stem) {
    const std::string file = path(stem + ".png");
    Picture picture = renderer_.render(scene, s);
    picture.save(file);
    return {
        .command = command_of("render", name, s, file),
        .pixels = {.width = picture.width, .height = picture.height, .rgba = std::move(picture.display_rgba)},
        .cost = std::move(picture.statistics)};
  }

  const DemoArguments& arguments_;
  Renderer renderer_;
  demo::Page page_;
};

void run(const DemoArguments& arguments, int& exit_status) {
  if (!arguments.head.starts_with("built-in"))
    throw input_error(arguments.head, "the demo's first head is built-in, built-in:light or built-in:dark");
  std::filesystem::create_directories(arguments.folder);
  const auto start = std::chrono::steady_clock::now();
  Demo demo(arguments);

  const std::string name = arguments.head == "built-in" ? "built-in:medium" : arguments.head;
  show_line("making the head");
  const Scene head = Scene::load(name, {}, terminal_hooks());
  RenderSettings settings = settings_of_demo();
  frame_face(settings);
  demo.draw_head(arguments.head, "the built-in head", head, settings, "demo");
  demo.draw_strip(head, settings);

  if (!arguments.scan.empty()) {
    const Scene scan = Scene::load(arguments.scan, {}, terminal_hooks());
    RenderSettings of_scan = settings_of_demo();
    of_scan.camera.name = "portrait";
    demo.draw_head(arguments.scan, "a scanned head", scan, of_scan, "demo-scan");
  }

  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  exit_status = demo.finish(seconds);
}

}  // namespace

void add_demo_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "demo", "draw the built-in head with and without scattering, a strip of frames, and a page of all");
  auto arguments = std::make_shared<DemoArguments>();
  command->add_option("HEAD", arguments->head, "built-in, built-in:light or built-in:dark");
  command->add_option("--scan", arguments->scan, "glTF head with a camera 'portrait', drawn too")
      ->default_str("");
  command->add_option("-o,--output", arguments->folder, "folder of the pictures and demo.html");
  add_device_arguments(*command, arguments->on);
  command->callback([arguments, &exit_status] { run(*arguments, exit_status); });
}

}  // namespace dermis::cli
