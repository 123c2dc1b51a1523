// SPDX-License-Identifier: MIT
// Poses of a character: a clip and its time, weights of morph targets.
#include <imgui.h>

#include <algorithm>

#include "viewer/model/animation.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/places.h"

namespace dermis::viewer {
namespace {

bool clip_rows(const Asset& asset, RigPose& pose, ViewState& view) {
  const std::vector<std::string> clips = asset.clips();
  if (clips.empty()) {
    ImGui::TextDisabled("no clips");
    return false;
  }

  bool changed = false;
  const std::string now = pose.clip ? pose.clip->clip : "(at rest)";
  if (ImGui::BeginCombo("clip", now.c_str())) {
    if (ImGui::Selectable("(at rest)", !pose.clip) && pose.clip) {
      pose.clip.reset();
      view.playing = false;
      changed = true;
    }
    for (const std::string& clip : clips)
      if (ImGui::Selectable(clip.c_str(), pose.clip && pose.clip->clip == clip)) {
        pose.clip = ClipTime{.clip = clip};
        changed = true;
      }
    ImGui::EndCombo();
  }
  if (!pose.clip) return changed;

  const double least = 0, most = std::max(end_of(asset, pose.clip->clip), 1e-3);
  changed |= ImGui::SliderScalar("time", ImGuiDataType_Double, &pose.clip->seconds, &least, &most, "%.3f s",
                                 ImGuiSliderFlags_AlwaysClamp);
  if (noted_button(view.playing ? "Stop" : "Play")) view.playing = !view.playing;
  ImGui::SameLine();
  ImGui::Checkbox("loop", &view.loops);
  return changed;
}

bool weight_rows(const Asset& asset, RigPose& pose) {
  bool changed = false;
  for (const std::string& name : asset.morph_weights()) {
    double weight = weight_of(pose, name);
    const double least = 0, most = 1;
    const bool moved =
        ImGui::SliderScalar(name.c_str(), ImGuiDataType_Double, &weight, &least, &most, "%.2f");
    note_place(name);
    if (!moved) continue;
    set_weight(pose, name, weight);
    changed = true;
  }
  return changed;
}

}  // namespace

void animation_panel(Desk& desk) {
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.55f);
  int number = 0;
  for (const InstanceId id : desk.now.scene.instances()) {
    const Instance& instance = desk.now.scene.instance(id);
    const std::string title =
        (instance.name.empty() ? instance.asset.name() : instance.name) + "##" + std::to_string(number++);
    if (!ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen)) continue;

    ImGui::PushID(number);
    RigPose pose = instance.pose.value_or(RigPose{});
    bool changed = clip_rows(instance.asset, pose, desk.view);
    const bool open = ImGui::TreeNode("weights");
    note_place("weights");
    if (open) {
      changed |= weight_rows(instance.asset, pose);
      ImGui::TreePop();
    }
    if (changed)
      desk.edit("pose", [&](Document& next) {
        next.scene.set_pose(id, is_rest(pose) ? std::nullopt : std::optional(pose));
      });
    ImGui::PopID();
  }
  ImGui::PopItemWidth();
}

}  // namespace dermis::viewer
