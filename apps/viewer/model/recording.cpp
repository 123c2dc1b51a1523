// SPDX-License-Identifier: MIT
#include "viewer/model/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "base/core/error.h"
#include "viewer/model/camera_moves.h"
#include "viewer/model/command_line.h"
#include "viewer/model/program.h"

namespace dermis::viewer {
namespace {

// Returns the elevation of the camera above its target, whole degrees.
double elevation_deg(const Document& document) {
  const CameraPlace place = camera_place(document);
  const double up = place.eye_m[1] - place.target_m[1],
               along = std::hypot(place.eye_m[0] - place.target_m[0], place.eye_m[2] - place.target_m[2]);
  return std::round(std::atan2(up, along) * 180 / std::numbers::pi);
}

std::vector<std::string> motion_words(const Recording& recording, const Document& document) {
  switch (recording.motion) {
    case RecordedMotion::turntable: {
      const double height = elevation_deg(document);
      return {"--orbit", fmt::format("0,{}..360,{}", height, height)};
    }
    case RecordedMotion::lamp: return {"--light-orbit", "0,30..360,30"};
    case RecordedMotion::clip: return {"--clip", clip_of(document.scene)};
  }
  return {};
}

}  // namespace

std::string clip_of(const Scene& scene) {
  for (const InstanceId id : scene.instances())
    if (const auto& pose = scene.instance(id).pose; pose && pose->clip) return pose->clip->clip;
  return {};
}

Document ready_for_clip(Document document, const std::string& clip) {
  for (const InstanceId id : document.scene.instances())
    if (const auto& pose = document.scene.instance(id).pose; pose && pose->clip && pose->clip->clip == clip)
      document.scene.set_pose(id, std::nullopt);
  return document;
}

std::vector<std::string> sequence_words(const Recording& recording,
                                        const std::vector<std::string>& scene_words, const Document& document,
                                        const std::string& device, const std::string& name) {
  RenderSettings settings = document.settings;
  if (recording.motion == RecordedMotion::turntable) {
    const int heads = settings.camera.heads;
    const std::optional<double> fov_deg = settings.camera.fov_deg;
    settings.camera = {};
    settings.camera.heads = heads;
    settings.camera.fov_deg = fov_deg;
  }

  std::vector<std::string> words{"sequence"};
  const auto add = [&words](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  for (const std::string& word : scene_words) words.push_back(word);
  add(option_words(settings));
  add(motion_words(recording, document));
  add({"--fps", fmt::format("{}", recording.fps)});
  if (recording.motion != RecordedMotion::clip) add({"--to", fmt::format("{}", recording.seconds)});
  add({"--device", device, "-o", name + (recording.video ? ".mp4" : "-%04d.png")});
  return words;
}

std::string record(const std::vector<std::string>& words, const Hooks& hooks) {
  const TemporaryFolder folder;
  const std::string said = folder.path() + "/said.txt";

  std::vector<std::string> all{dermis_program()};
  all.insert(all.end(), words.begin(), words.end());
  if (!run_program(all, said, hooks.stop, std::chrono::milliseconds(50)))
    throw InputError("", last_line(said));
  return last_line(said);
}

}  // namespace dermis::viewer
