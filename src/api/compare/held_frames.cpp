// SPDX-License-Identifier: MIT
#include "api/compare/held_frames.h"

#include <algorithm>

#include "base/core/error.h"
#include "gpu/device.h"

namespace dermis::api {

std::uint64_t half_of_device(const std::string& device) {
  for (const DeviceInfo& summary : gpu::list_devices())
    if (summary.name == device && summary.memory_bytes > 0) return summary.memory_bytes / 2;
  return std::uint64_t{2} << 30;
}

std::size_t HeldFrames::add(const Scene& scene, const RenderSettings& settings) {
  entries_.push_back({.scene = scene, .settings = settings, .frame = {}});
  return entries_.size() - 1;
}

Picture HeldFrames::warm_up(std::size_t i) {
  Entry& entry = entries_[i];
  Picture picture = prepared(entry).picture();
  // Memory that the device holds by now, of this frame and those before it.
  const std::uint64_t held = picture.statistics.image_bytes + picture.statistics.buffer_bytes;
  if (none_waits_ || held > (*most_bytes_)(picture.statistics.device)) entry.frame.reset();
  return picture;
}

double HeldFrames::draw(std::size_t i, std::vector<PassStatistics>* passes) {
  Entry& entry = entries_[i];
  const bool keep = entry.frame.has_value();
  PreparedFrame& frame = prepared(entry);
  const double ms = frame.draw();
  if (passes) *passes = frame.last_passes();
  if (!keep) entry.frame.reset();
  return ms;
}

PreparedFrame& HeldFrames::prepared(Entry& entry) {
  if (entry.frame) return *entry.frame;
  try {
    entry.frame = renderer_->prepare(entry.scene, entry.settings);
  } catch (const DeviceError&) {
    // Too little memory beside the frames that wait: from here on none does.
    if (std::none_of(entries_.begin(), entries_.end(), [](const Entry& e) { return e.frame.has_value(); }))
      throw;
    for (Entry& other : entries_) other.frame.reset();
    none_waits_ = true;
    entry.frame = renderer_->prepare(entry.scene, entry.settings);
  }
  return *entry.frame;
}

}  // namespace dermis::api
