// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <set>
#include <thread>

#include "api/asset_files.h"
#include "api/fingerprint.h"
#include "cli/command.h"
#include "cli/commit.h"
#include "cli/progress.h"
#include "cli/sequence/frames.h"
#include "cli/sequence/pattern.h"
#include "cli/sequence/record.h"
#include "cli/sequence/scene_at.h"
#include "cli/sequence/timeline.h"
#include "cli/sequence/writers.h"
#include "core/error.h"
#include "core/file.h"
#include "core/hash.h"
#include "core/hooks.h"
#include "dermis/cancelled.h"

namespace dermis::cli {
namespace {

using namespace sequence;

constexpr double default_s = 4;  // of a sequence without a clip
constexpr const char* group = "Sequence";

struct SequenceArguments : SceneArguments {
  std::string output;
  Timeline timeline;
  std::optional<double> to_s;
  Motion motion;
  bool resume = false;
  DeviceArguments on;
};

// A time alone holds the pose while something else moves.
bool clip_plays(const SequenceArguments& a) {
  const bool names_a_clip = !a.options.clip.empty();
  return !a.options.time_s && (names_a_clip || a.motion.kind == Motion::Kind::none);
}

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

// Where nothing says how long it is: as long as the clip, or default_s.
Timeline timeline_of(const SequenceArguments& a, const Scene& scene) {
  Timeline timeline = a.timeline;
  if (a.to_s) {
    timeline.to_s = *a.to_s;
  } else if (clip_plays(a)) {
    timeline.to_s = api::clip_end_s(scene, a.options.clip);
    if (!(timeline.to_s > timeline.from_s))
      throw input_error("--from", "the clip ends at {:g} s; there is nothing to show from {:g} s on",
                        timeline.to_s, timeline.from_s);
  } else {
    timeline.to_s = timeline.from_s + default_s;
  }
  check(timeline);
  return timeline;
}

// All that the bytes of the files depend on, but for the device.
std::uint64_t fingerprint_of(const SequenceArguments& a, const Timeline& timeline, SceneSource& scenes) {
  Hash hash;
  hash.add(std::string_view(DERMIS_VERSION));
  hash.add(std::string_view(commit()));
  hash.add(to_json(settings_file(a)));
  hash.add(text_of(a.motion));
  hash.add(FramePattern(a.output).path(0).extension().string());
  for (const double number : {timeline.fps, timeline.from_s, timeline.to_s}) hash.add(number);

  // What is said of the files while they are read has been said.
  Hooks hooks = terminal_hooks();
  hooks.log = [](LogLevel, const std::string&) {};
  const Scene& scene = scenes.scene_at(timeline.from_s);
  hash.word(api::picture_fingerprint(scene, a.motion.at(a.settings, 0), hooks));
  const HookScope scope(hooks);
  if (clip_plays(a)) api::add_asset_files(hash, scene);
  return hash.value();
}

// The frames that are still to be drawn.
std::vector<std::size_t> frames_to_do(const Record& record, const FramePattern& pattern, std::size_t count) {
  std::vector<std::size_t> to_do;
  for (std::size_t frame = 0; frame < count; ++frame)
    if (!record.has(frame, pattern.path(frame))) to_do.push_back(frame);
  return to_do;
}

void clean_up(const FramePattern& pattern, const Record& record, std::size_t count) {
  std::set<std::string> names;
  const auto is_ours = [&](const std::string& name) {
    if (names.empty()) {
      names.insert(record.path().filename().string());
      for (std::size_t i = 0; i < count; ++i) names.insert(pattern.path(i).filename().string());
    }
    return names.contains(name);
  };
  remove_unfinished(pattern.path(0).parent_path(), is_ours);
}

std::size_t writer_threads() { return std::clamp(std::thread::hardware_concurrency() / 2, 1u, 4u); }

// Draws and hands over until all is done or Ctrl-C; returns how many frames are written.
class Drawing {
 public:
  Drawing(const SequenceArguments& a, const Timeline& timeline, SceneSource& scenes)
      : a_(a), timeline_(timeline), scenes_(scenes) {}

  std::size_t draw(Renderer& renderer, const std::vector<std::size_t>& to_do,
                   const std::function<void(Frame)>& hand_over) {
    Frames frames(renderer, a_.settings);
    std::size_t written = 0;
    const auto take = [&](std::optional<Frame> frame) {
      if (!frame) return;
      hand_over(std::move(*frame));
      ++written;
    };

    std::optional<Progress> progress;
    try {
      for (const std::size_t frame : to_do) {
        if (interrupted_flag()) break;
        if (progress) progress->show(fmt::format("frame {} of {}", frame + 1, timeline_.frames()));
        take(frames.draw(frame, scenes_.scene_at(timeline_.seconds(frame)),
                         a_.motion.at(a_.settings, timeline_.share(frame))));

        // The first one prepares what the others use: the time left is that of the others.
        if (progress)
          progress->done(1);
        else
          progress.emplace(static_cast<double>(std::max<std::size_t>(to_do.size() - 1, 1)));
      }
    } catch (const Cancelled&) {
      if (!interrupted_flag()) throw;
    }
    take(frames.finish());
    return written;
  }

 private:
  const SequenceArguments& a_;
  const Timeline& timeline_;
  SceneSource& scenes_;
};

int stopped(std::size_t written, std::size_t count) {
  show_line("");
  fmt::print(stderr, "dermis: stopped after {} of {} frames; --resume goes on from there\n", written, count);
  return 1;
}

struct Done {
  std::size_t written = 0, count = 0;
  double seconds = 0;
  bool validated = true;
};

// Pictures with numbers.
Done write_pictures(const SequenceArguments& a, const Timeline& timeline, SceneSource& scenes) {
  const auto start = std::chrono::steady_clock::now();
  const FramePattern pattern(a.output);
  const std::size_t count = timeline.frames();
  Record record(a.output + ".resume", fingerprint_of(a, timeline, scenes));
  clean_up(pattern, record, count);
  if (a.resume) record.load();
  const std::vector<std::size_t> to_do = frames_to_do(record, pattern, count);
  Done done{.written = count - to_do.size(), .count = count};

  if (!to_do.empty()) {
    Renderer renderer({.device = a.on.device, .validate = a.on.validate, .hooks = terminal_hooks()});
    bool opened = false;
    Writers writers(writer_threads(), [&](const Frame& frame) {
      const std::filesystem::path path = pattern.path(frame.number);
      frame.picture.save(path);
      record.add(frame.number, path);
    });
    done.written += Drawing(a, timeline, scenes).draw(renderer, to_do, [&](Frame frame) {
      const Statistics& s = frame.picture.statistics;
      if (!opened) record.open(fmt::format("{} ({}, Vulkan {})", s.device, s.driver, s.api));
      opened = true;
      writers.push(std::move(frame));
    });
    writers.finish();
    show_line("");
    done.validated = !tell_validation_messages(renderer);
  }

  if (done.written == count && done.validated) record.remove();
  done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return done;
}

void run(const SequenceArguments& a, int& exit_status) {
  const FramePattern pattern(a.output);
  check_writable(pattern.path(0));
  check_scene_output(a, {});
  check_arguments(a);
  catch_interrupts();

  SceneSource scenes(a, clip_plays(a));
  const Timeline timeline = timeline_of(a, scenes.scene_at(a.timeline.from_s));
  const Done done = write_pictures(a, timeline, scenes);
  if (!done.validated) {
    exit_status = 1;
    return;
  }
  if (done.written < done.count) {
    exit_status = stopped(done.written, done.count);
    return;
  }

  save_settings(a);
  save_scene(a, scenes.scene_at(timeline.from_s));
  fmt::print("{} frames of {}x{}, {:g} to {:g} s at {:g} per second, in {}\n{} to {}\n", done.count,
             a.settings.output.width, a.settings.output.height, timeline.from_s, timeline.to_s, timeline.fps,
             duration(done.seconds), pattern.path(0).string(), pattern.path(done.count - 1).string());
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
                   "out/frame-%04d.png")
      ->required();
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
