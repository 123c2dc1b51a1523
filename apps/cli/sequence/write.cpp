// SPDX-License-Identifier: MIT
#include "cli/sequence/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <thread>

#include "api/fingerprint.h"
#include "api/prepare/asset_files.h"
#include "base/core/file.h"
#include "base/core/hash.h"
#include "base/core/hooks.h"
#include "base/settings/json.h"
#include "cli/picture_hints.h"
#include "cli/progress.h"
#include "cli/sequence/frames.h"
#include "cli/sequence/pattern.h"
#include "cli/sequence/record.h"
#include "cli/sequence/sheet.h"
#include "cli/sequence/video.h"
#include "cli/sequence/writers.h"
#include "cli/version.h"
#include "dermis/cancelled.h"
#include "image/codec.h"
#include "image/tone_map.h"

namespace dermis::cli::sequence {
namespace {

// All that the bytes of the files depend on, but for the device.
std::uint64_t fingerprint_of(const SequenceArguments& a, const Timeline& timeline, SceneSource& scenes) {
  Hash hash;
  hash.add(std::string_view(DERMIS_VERSION));
  hash.add(std::string_view(commit()));
  hash.add(to_json(settings_file(a)));
  hash.add(text_of(a.motion));
  hash.add(ending_of(a.output));
  for (const double number : {timeline.fps, timeline.from_s, timeline.to_s}) hash.add(number);

  // Warnings about the files have been said when they were read.
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
      names.insert(file_stem(record.path()));
      for (std::size_t i = 0; i < count; ++i) names.insert(file_stem(pattern.path(i)));
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
      if (written == 0 && a_.settings.output.show == OutputSettings().show)
        hint_at_picture(frame->picture, ending_of(a_.output) != ".exr");
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

Renderer make_renderer(const SequenceArguments& a) {
  return Renderer({.device = a.on.device, .validate = a.on.validate, .hooks = terminal_hooks()});
}

image::Image8 display_values(const std::filesystem::path& picture, ToneMap tone_map) {
  if (ending_of(picture) == ".png") return image::load_image8(picture);
  image::Image8 display = image::to_display(image::load_image_f(picture), tone_map);
  for (std::size_t i = 3; i < display.rgba.size(); i += 4) display.rgba[i] = 255;
  return display;
}

// From the files, so that it does not matter which run has written them.
void save_sheet(const SequenceArguments& a, const FramePattern& pattern, std::size_t count) {
  Sheet sheet(count, a.settings.output.width, a.settings.output.height);
  for (const std::size_t frame : sheet.shown())
    sheet.add(frame, display_values(pattern.path(frame), a.settings.output.tone_map));
  image::save_png(a.sheet, sheet.picture());
}

}  // namespace

Written write_pictures(const SequenceArguments& a, const Timeline& timeline, SceneSource& scenes) {
  const FramePattern pattern(a.output);
  const std::size_t count = timeline.frames();
  Record record(file_beside(a.output, ".resume"), fingerprint_of(a, timeline, scenes));
  clean_up(pattern, record, count);
  if (a.resume) record.load();
  const std::vector<std::size_t> to_do = frames_to_do(record, pattern, count);
  Written written{.frames = count - to_do.size()};

  if (!to_do.empty()) {
    Renderer renderer = make_renderer(a);
    bool opened = false;
    Writers writers(writer_threads(), [&](const Frame& frame) {
      const std::filesystem::path path = pattern.path(frame.number);
      frame.picture.save(path);
      record.add(frame.number, path);
    });
    written.frames += Drawing(a, timeline, scenes).draw(renderer, to_do, [&](Frame frame) {
      const Statistics& s = frame.picture.statistics;
      if (!opened) record.open(fmt::format("{} ({}, Vulkan {})", s.device, s.driver, s.api));
      opened = true;
      writers.push(std::move(frame));
    });
    writers.finish();
    show_line("");
    written.validation = tell_validation_messages(renderer);
  }

  if (written.frames < count || written.validation) return written;
  if (!a.sheet.empty()) save_sheet(a, pattern, count);
  record.remove();
  return written;
}

Written write_video(const SequenceArguments& a, const Timeline& timeline, SceneSource& scenes) {
  const std::size_t count = timeline.frames();
  const int width = a.settings.output.width, height = a.settings.output.height;
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), 0);

  Renderer renderer = make_renderer(a);
  Sheet sheet(count, width, height);
  Video video(a.output, width, height, timeline.fps);
  // One thread: the frames stay in order.
  Writers writers(1, [&](const Frame& frame) {
    video.add(frame.picture);
    if (!a.sheet.empty())
      sheet.add(frame.number, {.width = width, .height = height, .rgba = frame.picture.display_rgba});
  });
  Written written;
  written.frames =
      Drawing(a, timeline, scenes).draw(renderer, all, [&](Frame frame) { writers.push(std::move(frame)); });
  writers.finish();
  show_line("");
  written.validation = tell_validation_messages(renderer);

  if (written.frames < count || written.validation) return written;
  show_line("ffmpeg ends the video");
  video.finish();
  show_line("");
  if (!a.sheet.empty()) image::save_png(a.sheet, sheet.picture());
  return written;
}

}  // namespace dermis::cli::sequence
