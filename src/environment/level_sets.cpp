// SPDX-License-Identifier: MIT
#include "environment/level_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "environment/environment.h"
#include "environment/sources.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;
constexpr std::uint32_t none = ~0u;

/// Angular radius of a disc as large as a region of each size may be: a sun, its glare, a lamp or a window.
constexpr std::array<double, 3> half_angles_deg{1.5, 6, 20};

/// The mean direction of a disc of angular radius a has the length (1 + cos a) / 2. A region with a shorter
/// one than a disc of 50 degrees is a horizon, not a lamp.
const double least_resultant = (1 + std::cos(50 * pi / 180)) / 2;

/// Sums over the pixels of a level set.
struct Component {
  double solid_angle = 0, energy = 0;
  glm::dvec3 direction{0};
  std::uint32_t first = none, last = none;  // a list through Flood::next_
  std::array<bool, half_angles_deg.size()> outgrown{};

  bool is_compact(std::size_t size) const {
    const double most = 2 * pi * (1 - std::cos(half_angles_deg[size] * pi / 180));
    return !outgrown[size] && solid_angle <= most && glm::length(direction) >= least_resultant * solid_angle;
  }
};

/// Adds pixels from the brightest to the dimmest and joins each with its neighbours. A region that outgrows a
/// size with a pixel was, just before, a largest compact region of that size.
class Flood {
 public:
  Flood(const image::ImageF& picture, double least_excess)
      : picture_(picture), least_excess_(least_excess), floor_(mean_brightness(picture)) {
    const auto count = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    for (std::size_t i = 0; i < count; ++i)
      if (brightness(static_cast<std::uint32_t>(i)) > floor_) order_.push_back(static_cast<std::uint32_t>(i));
    std::sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
      const double at_a = brightness(a), at_b = brightness(b);
      return at_a != at_b ? at_a > at_b : a < b;
    });
    slot_.assign(count, none);
    parent_.resize(order_.size());
    next_.assign(order_.size(), none);
    components_.resize(order_.size());
  }

  std::array<std::vector<LevelRegion>, half_angles_deg.size()> regions() {
    for (std::uint32_t i = 0; i < order_.size(); ++i) add(i);

    // A region that never joined a larger one ends at the mean of the picture.
    for (std::uint32_t i = 0; i < order_.size(); ++i)
      if (parent_[i] == i)
        for (std::size_t size = 0; size < found_.size(); ++size)
          if (components_[i].is_compact(size)) keep(components_[i], size, glm::dvec3(floor_));
    return std::move(found_);
  }

 private:
  double brightness(std::uint32_t pixel) const {
    const float* rgb = picture_.values.data() + 3 * std::size_t{pixel};
    return (double{rgb[0]} + double{rgb[1]} + double{rgb[2]}) / 3;
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void add(std::uint32_t i) {
    const std::uint32_t pixel = order_[i];
    const int x = static_cast<int>(pixel) % picture_.width, y = static_cast<int>(pixel) / picture_.width;
    const double omega = pixel_solid_angle(y, picture_.width, picture_.height);
    Component& own = components_[i];
    own.solid_angle = omega;
    own.energy = omega * brightness(pixel);
    own.direction = omega * direction_of((x + 0.5) / picture_.width, (y + 0.5) / picture_.height);
    own.first = own.last = i;
    for (std::size_t size = 0; size < found_.size(); ++size) own.outgrown[size] = !own.is_compact(size);
    parent_[i] = slot_[pixel] = i;

    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) join_with(i, x + dx, y + dy);
  }

  /// Joins with the pixel at (x, y), which may lie across the seam or a pole, if it was added already.
  void join_with(std::uint32_t i, int x, int y) {
    const int width = picture_.width, height = picture_.height;
    if (y < 0 || y >= height) {
      y = y < 0 ? 0 : height - 1;
      x += width / 2;
    }
    x = (x % width + width) % width;
    const std::uint32_t other =
        slot_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    if (other == none) return;
    const std::uint32_t a = root(i), b = root(other);
    if (a != b) join(a, b, order_[i]);
  }

  void join(std::uint32_t a, std::uint32_t b, std::uint32_t at_pixel) {
    if (components_[a].solid_angle < components_[b].solid_angle) std::swap(a, b);
    Component& large = components_[a];
    Component& small = components_[b];
    Component both = large;
    both.solid_angle += small.solid_angle;
    both.energy += small.energy;
    both.direction += small.direction;
    for (std::size_t size = 0; size < found_.size(); ++size) {
      both.outgrown[size] = large.outgrown[size] || small.outgrown[size];
      both.outgrown[size] = !both.is_compact(size);
      if (!both.outgrown[size]) continue;
      const float* rgb = picture_.values.data() + 3 * std::size_t{at_pixel};
      for (const Component* before : {&large, &small})
        if (!before->outgrown[size]) keep(*before, size, {rgb[0], rgb[1], rgb[2]});
    }
    next_[large.last] = small.first;
    both.last = small.last;
    large = both;
    parent_[b] = a;
  }

  void keep(const Component& component, std::size_t size, const glm::dvec3& level) {
    const double at = (level.x + level.y + level.z) / 3,
                 excess = component.energy - at * component.solid_angle;
    // A source is on average at least twice as bright as its level.
    if (excess < least_excess_ || excess < at * component.solid_angle) return;
    LevelRegion region{.pixels = {}, .level = level, .excess = excess};
    for (std::uint32_t i = component.first;; i = next_[i]) {
      region.pixels.push_back(order_[i]);
      if (i == component.last) break;
    }
    found_[size].push_back(std::move(region));
  }

  const image::ImageF& picture_;
  double least_excess_, floor_;
  std::vector<std::uint32_t> order_;          // pixels, brightest first
  std::vector<std::uint32_t> slot_;           // index of a pixel in order_; none if not added yet
  std::vector<std::uint32_t> parent_, next_;  // by slot
  std::vector<Component> components_;         // valid for slots that are their own parent
  std::array<std::vector<LevelRegion>, half_angles_deg.size()> found_;
};

}  // namespace

double mean_brightness(const image::ImageF& picture) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y) {
    double row = 0;
    for (int x = 0; x < 3 * picture.width; ++x) row += double{picture.at(0, y)[x]} / 3;
    sum += row * pixel_solid_angle(y, picture.width, picture.height);
  }
  return sum / (4 * pi);
}

std::vector<LevelRegion> compact_regions(const image::ImageF& picture, double least_excess) {
  std::vector<LevelRegion> all;
  for (std::vector<LevelRegion>& of_size : Flood(picture, least_excess).regions()) {
    std::stable_sort(of_size.begin(), of_size.end(),
                     [](const LevelRegion& a, const LevelRegion& b) { return a.excess > b.excess; });
    for (LevelRegion& region : of_size) all.push_back(std::move(region));
  }
  return all;
}

}  // namespace dermis::environment
