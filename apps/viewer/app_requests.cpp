// SPDX-License-Identifier: MIT
// Requests of panels: files, undo, the camera.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "cli/command_line.h"
#include "viewer/app_state.h"
#include "viewer/model/command_line.h"
#include "viewer/model/page.h"

namespace dermis::viewer {

void App::save_scene(const SaveNames& names) {
  now().scene.save(names.scene);
  saved_scene_ = {now().scene, names.scene};
  say("saved " + names.scene.string());
}

// The words that name the scene; writes the scene file that they need.
std::vector<std::string> App::scene_in_file(const SaveNames& names) {
  if (!scene_words(now(), saved_scene_)) save_scene(names);
  return scene_words(now(), saved_scene_).value();
}

void App::write_page_number(std::size_t number) {
  if (pager_.is_running()) {
    say("a page is being written", true);
    return;
  }
  try {
    const std::vector<Page> pages =
        pages_of(scene_in_file(save_names(view_.save_name)), option_words(shown_settings()), options_.device);
    pager_.start([page = pages.at(number)](const Hooks& hooks) { return write_page(page, hooks); });
    say(std::string("computing: ") + pages.at(number).title);
  } catch (const InputError& error) { say(error.what(), true); }
}

// A clip is played by the sequence, from a scene file in which it plays nothing yet.
void App::start_recording() {
  const SaveNames names = save_names(view_.save_name);
  const std::string base = std::filesystem::path(names.picture).replace_extension().string();
  Document document = now();
  document.settings = shown_settings();
  std::vector<std::string> words;
  if (view_.recording.motion == RecordedMotion::clip) {
    const std::string clip = clip_of(now().scene);
    if (clip.empty()) throw InputError("record", "no clip is chosen in the panel Pose");
    const std::string file = base + ".sequence.scene.json";
    ready_for_clip(now(), clip).scene.save(file);
    words = {file};
  } else {
    words = scene_in_file(names);
  }
  words = sequence_words(view_.recording, words, document, options_.device, base);
  std::string line = "sequence:";
  for (const std::string& word : words) line += " " + cli::quoted(word);
  tell(line);
  recorder_.start([words](const Hooks& hooks) { return record(words, hooks); });
  view_.records = true;
  say("recording " + base);
}

void App::save_one(const Requests& requests, const SaveNames& names) {
  if (requests.save_settings) {
    Document as_shown = now();
    as_shown.settings = shown_settings();
    save_settings(as_shown, names.settings);
    say("saved " + names.settings.string());
  }
  if (requests.save_profile) {
    write_profile(profile_of(now()), names.profile.string());
    say("saved " + names.profile.string());
  }

  if (requests.save_scene) save_scene(names);
  if (!requests.copy_command) return;
  view_.command_line =
      render_command(scene_in_file(names), shown_settings(), options_.device, names.picture.string());
  ImGui::SetClipboardText(view_.command_line.c_str());
  say("copied the command line");
  tell("command: " + view_.command_line);
}

void App::save(const Requests& requests) {
  try {
    const SaveNames names = save_names(view_.save_name);
    if (requests.save_png) painters_.save({now().scene, shown_settings(), names.picture});
    if (requests.save_exr) painters_.save({now().scene, shown_settings(), names.light});
    save_one(requests, names);
    if (requests.record && !view_.records) start_recording();
    if (requests.stop_recording) recorder_.end();
  } catch (const InputError& error) { say(error.what(), true); }
}

void App::serve(const Requests& requests) {
  if (requests.undo) history_->undo();
  if (requests.redo) history_->redo();
  if (requests.frame) {
    Document next = now();
    const double aspect = static_cast<double>(std::max(area_.width, 1)) / std::max(area_.height, 1);
    try {
      set_camera(next.settings, framed(camera_place(next), spheres_.of(next), aspect));
      history_->take(std::move(next), "frame the heads");
    } catch (const InputError& error) { say(error.what(), true); }
  }
  to_open_.insert(to_open_.end(), requests.open.begin(), requests.open.end());
  save(requests);
  if (requests.page) write_page_number(*requests.page);
  if (requests.profile_page && skin_ && !pager_.is_running())
    pager_.start([skin = *skin_](const Hooks& hooks) { return write_profile_page(skin, hooks); });
  if (requests.undo || requests.redo || requests.frame) frames_left_ = std::max(frames_left_, 2);
}

}  // namespace dermis::viewer
