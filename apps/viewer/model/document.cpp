// SPDX-License-Identifier: MIT
#include "viewer/model/document.h"

#include <utility>

namespace dermis::viewer {

bool same_contents(const Scene& a, const Scene& b) {
  const std::vector<InstanceId> ids = a.instances();
  if (ids != b.instances() || a.light_changes() != b.light_changes() || a.lights() != b.lights() ||
      a.environment_changes() != b.environment_changes())
    return false;
  for (const InstanceId id : ids)
    if (a.changes(id) != b.changes(id) || !(a.instance(id).asset == b.instance(id).asset)) return false;
  return true;
}

History::History(Document first) { states_.push_back({.document = std::move(first)}); }

void History::take(Document next, std::string what, std::uint64_t gesture) {
  const bool waits_for_profile = next.skin.serial != now().skin.serial && next.skin.kind != SkinKind::scene &&
                                 same_contents(next.scene, now().scene);
  if (!waits_for_profile) ++revision_;
  states_.resize(at_ + 1);
  if (gesture != 0 && states_.back().gesture == gesture && at_ > 0) {
    states_.back().document = std::move(next);
    return;
  }
  states_.push_back({.document = std::move(next), .what = std::move(what), .gesture = gesture});
  if (states_.size() > most_undo + 1) states_.erase(states_.begin());
  at_ = states_.size() - 1;
}

void History::amend(Document document) {
  ++revision_;
  states_[at_].document = std::move(document);
}

void History::undo() {
  if (!can_undo()) return;
  --at_;
  ++revision_;
}

void History::redo() {
  if (!can_redo()) return;
  ++at_;
  ++revision_;
}

}  // namespace dermis::viewer
