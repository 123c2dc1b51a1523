// SPDX-License-Identifier: MIT
#include "truth/reference/environment_sampler.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/hooks.h"

namespace dermis::reference {
namespace {

using std::numbers::pi;

constexpr int most_rows = 512;

/// Returns the brightest pixel that a cell or its border shows, so that no lit direction has the density 0.
/// Cells hold pixels first..last.
struct Span {
  int first, last;
};
Span pixels_of(int cell, int cells, int pixels) {
  const auto place = [&](int edge) { return static_cast<double>(edge) * pixels / cells; };
  return {static_cast<int>(std::floor(place(cell) - 0.5)),
          static_cast<int>(std::ceil(place(cell + 1) - 0.5))};
}

double mean_brightness(const image::ImageF& picture, Span columns, Span rows) {
  double sum = 0;
  int count = 0;
  for (int y = rows.first; y <= rows.last; ++y)
    for (int x = columns.first; x <= columns.last; ++x) {
      const float* p = picture.at((x % picture.width + picture.width) % picture.width,
                                  std::clamp(y, 0, picture.height - 1));
      sum += double{p[0]} + double{p[1]} + double{p[2]};
      ++count;
    }
  return sum / count;
}

}  // namespace

EnvironmentSampler::EnvironmentSampler(environment::Environment picture, double intensity,
                                       double rotation_deg)
    : picture_(std::move(picture)), intensity_(intensity), rotation_rad_(rotation_deg * pi / 180) {
  const image::ImageF& pixels = picture_.radiance;
  rows_ = std::min(pixels.height, most_rows);
  columns_ = std::min(pixels.width, 2 * most_rows);
  cumulative_.reserve(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_));
  double sum = 0;
  Steps rows("preparing the environment", static_cast<std::size_t>(rows_));
  for (int y = 0; y < rows_; ++y) {
    for (int x = 0; x < columns_; ++x) {
      sum += solid_angle(y) * mean_brightness(pixels, pixels_of(x, columns_, pixels.width),
                                              pixels_of(y, rows_, pixels.height));
      cumulative_.push_back(sum);
    }
    rows.done();
  }
  if (sum > 0)
    for (double& value : cumulative_) value /= sum;
}

/// Returns the solid angle of a cell of the row, between two circles of latitude.
double EnvironmentSampler::solid_angle(int row) const {
  return 2 * pi / columns_ * (std::cos(pi * row / rows_) - std::cos(pi * (row + 1) / rows_));
}

glm::dvec3 EnvironmentSampler::to_picture(const glm::dvec3& d) const {
  const double c = std::cos(rotation_rad_), s = std::sin(rotation_rad_);
  return {d.x * c - d.z * s, d.y, d.x * s + d.z * c};
}

glm::dvec3 EnvironmentSampler::radiance(const glm::dvec3& direction) const {
  return intensity_ *
         environment::radiance_at(picture_.radiance, environment::place_of(to_picture(direction)));
}

glm::dvec3 EnvironmentSampler::draw(Random& random) const {
  const double pick = random.next(), across = random.next(), down = random.next();
  const auto cell = std::min<std::size_t>(
      static_cast<std::size_t>(std::upper_bound(cumulative_.begin(), cumulative_.end(), pick) -
                               cumulative_.begin()),
      cumulative_.size() - 1);
  const int row = static_cast<int>(cell) / columns_, column = static_cast<int>(cell) % columns_;
  const double top = std::cos(pi * row / rows_), bottom = std::cos(pi * (row + 1) / rows_);
  // The same as environment::direction_of.
  const double y = top + down * (bottom - top), azimuth = ((column + across) / columns_ - 0.5) * 2 * pi;
  const double flat = std::sqrt(std::max(0.0, 1 - y * y));
  const glm::dvec3 d(flat * std::sin(azimuth), y, -flat * std::cos(azimuth));
  const double c = std::cos(rotation_rad_), s = std::sin(rotation_rad_);
  return {d.x * c + d.z * s, d.y, -d.x * s + d.z * c};
}

double EnvironmentSampler::density(const glm::dvec3& direction) const {
  if (cumulative_.back() == 0) return 0;
  const glm::dvec2 at = environment::place_of(to_picture(direction));
  const int row = std::clamp(static_cast<int>(at.y * rows_), 0, rows_ - 1),
            column = std::clamp(static_cast<int>(at.x * columns_), 0, columns_ - 1);
  const auto cell =
      static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  return (cumulative_[cell] - (cell > 0 ? cumulative_[cell - 1] : 0)) / solid_angle(row);
}

}  // namespace dermis::reference
