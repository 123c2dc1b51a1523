// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/core/error.h"
#include "base/core/file.h"
#include "cli/command.h"
#include "cli/progress.h"
#include "cli/sequence/arguments.h"
#include "cli/sequence/lock.h"
#include "cli/sequence/pattern.h"
#include "cli/sequence/video.h"
#include "cli/sequence/write.h"

namespace dermis::cli {
namespace {

using namespace sequence;

constexpr double default_s = 4;  // of a sequence without a clip
constexpr const char* group = "Sequence";

void check_arguments(const SequenceArguments& a) {
  if (a.motion.kind == Motion::Kind::none && a.options.time_s)
    throw input_error("--time",
                      "holds the pose still, and nothing else moves; --from and --to say which part "
                      "of a clip is shown");
  // The end is not known yet where it is that of the clip.
  Timeline timeline = a.timeline;
  timeline.to_s = a.to_s.value_or(timeline.from_s + 1 / std::max(timeline.fps, 1e-3));
  check(timeline);
  check(a.motion, a.settings);
}

// Before anything is loaded, which may take long.
void check_outputs(const SequenceArguments& a) {
  if (is_video(a.output)) {
    check_writable(a.output);
    check_video(a.output, a.settings.output.width, a.settings.output.height);
    if (a.resume)
      throw input_error("--resume", "goes on with numbered pictures, and a video is written in one piece");
  } else {
    check_writable(FramePattern(a.output).path(0));
  }
  check_scene_output(a, {a.output, a.sheet});

  if (a.sheet.empty()) return;
  check_writable(a.sheet);
  if (ending_of(a.sheet) != ".png") throw input_error(a.sheet, "a contact sheet is written as .png");
  if (is_video(a.output)) return;
  // One of the frames cannot have its name: the numbers are not known yet.
  const FramePattern pattern(a.output);
  if (pattern.matches(a.sheet))
    throw input_error(a.sheet, "is also the name of a frame; --sheet needs a file of its own");
}

// Where nothing says how long it is: as long as the clip, or default_s.
Timeline timeline_of(const SequenceArguments& a, const SceneSource& scenes) {
  Timeline timeline = a.timeline;
  if (a.to_s) {
    timeline.to_s = *a.to_s;
  } else if (clip_plays(a)) {
    timeline.to_s = scenes.clip_end_s();
    if (!(timeline.to_s > timeline.from_s))
      throw input_error("--from", "the clip ends at {:g} s; there is nothing to show from {:g} s on",
                        timeline.to_s, timeline.from_s);
  } else {
    timeline.to_s = timeline.from_s + default_s;
  }
  check(timeline);
  return timeline;
}

int stopped(const SequenceArguments& a, std::size_t written, std::size_t count) {
  show_line("");
  fmt::print(stderr, "dermis: stopped after {} of {} frames; {}\n", written, count,
             is_video(a.output) ? "a video is written in one piece, and there is none"
                                : "--resume goes on from there");
  return 1;
}

std::string summary(const SequenceArguments& a, const Timeline& timeline, double seconds) {
  const std::size_t count = timeline.frames();
  std::string text = fmt::format("{} frame{} of {}x{}, {:g} to {:g} s at {:g} per second, in {}\n", count,
                                 count == 1 ? "" : "s", a.settings.output.width, a.settings.output.height,
                                 timeline.from_s, timeline.to_s, timeline.fps, duration(seconds));
  if (is_video(a.output)) return text + a.output + "\n";
  const FramePattern pattern(a.output);
  return text + fmt::format("{} to {}\n", pattern.path(0).string(), pattern.path(count - 1).string());
}

void run(const SequenceArguments& a, int& exit_status) {
  check_outputs(a);
  check_arguments(a);
  catch_interrupts();

  std::optional<PatternLock> lock;
  if (!is_video(a.output)) lock.emplace(a.output);

  const auto start = std::chrono::steady_clock::now();
  SceneSource scenes(a, clip_plays(a));
  const Timeline timeline = timeline_of(a, scenes);
  const Written written =
      is_video(a.output) ? write_video(a, timeline, scenes) : write_pictures(a, timeline, scenes);
  if (written.validation || written.frames < timeline.frames()) {
    exit_status = written.validation ? 1 : stopped(a, written.frames, timeline.frames());
    return;
  }

  save_settings(a);
  save_scene(a, scenes.scene_at(timeline.from_s));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  fmt::print("{}", summary(a, timeline, seconds));
}

}  // namespace

void add_sequence_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "sequence",
      "render the frames of a clip, of a camera or of a lamp that moves; each is the picture that "
      "`dermis render` makes of that moment");
  auto a = std::make_shared<SequenceArguments>();
  add_scene_arguments(*command, *a, SceneUse::sequence);
  command->get_option("--clip")->description("the animation of the file that plays");
  command->get_option("--time")->description(
      "hold that animation still at this second, while camera or lamp move, s");

  command
      ->add_option("-o,--output", a->output,
                   "pictures to write, .png (display values) or .exr (linear), with the number of the frame: "
                   "out/frame-%04d.png. Or a video, .mp4, .webm or .webp, which the program ffmpeg makes")
      ->type_name("FILE")
      ->required();
  command->add_option("--sheet", a->sheet, "write a contact sheet of at most 24 frames, .png")
      ->type_name("FILE");
  add_motion_options(*command, a->settings, a->motion);
  command->add_option("--fps", a->timeline.fps, "frames per second")->group(group);
  command->add_option("--from", a->timeline.from_s, "begin, in seconds of the clip")->group(group);
  command
      ->add_option("--to", a->to_s,
                   "end, in seconds of the clip, which no frame shows (default: the clip's, 4 s later "
                   "without one)")
      ->group(group);
  command->add_flag("--resume", a->resume, "go on from OUTPUT.resume, which a stopped run leaves")
      ->group(group);
  add_device_arguments(*command, a->on);
  command->callback([a, &exit_status] { run(*a, exit_status); });
}

}  // namespace dermis::cli
