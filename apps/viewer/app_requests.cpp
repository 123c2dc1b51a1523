// SPDX-License-Identifier: MIT
// What panels ask for: files, undo, the camera.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "viewer/app_state.h"
#include "viewer/model/command_line.h"

namespace dermis::viewer {

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

  std::optional<std::vector<std::string>> words = scene_words(now(), saved_scene_);
  if (requests.save_scene || (requests.copy_command && !words)) {
    now().scene.save(names.scene);
    saved_scene_ = {now().scene, names.scene};
    say("saved " + names.scene.string());
    words = scene_words(now(), saved_scene_);
  }
  if (!requests.copy_command) return;
  view_.command_line = render_command(*words, shown_settings(), options_.device, names.picture.string());
  ImGui::SetClipboardText(view_.command_line.c_str());
  say("copied the command line");
  tell("command: " + view_.command_line);
}

void App::save(const Requests& requests) {
  try {
    const SaveNames names = save_names(view_.save_name);
    if (requests.save_png) painter_.save({now().scene, shown_settings(), names.picture});
    if (requests.save_exr) painter_.save({now().scene, shown_settings(), names.light});
    save_one(requests, names);
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
  if (requests.undo || requests.redo || requests.frame) frames_left_ = std::max(frames_left_, 2);
}

}  // namespace dermis::viewer
