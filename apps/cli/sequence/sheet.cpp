// SPDX-License-Identifier: MIT
#include "cli/sequence/sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "image/shrink.h"

namespace dermis::cli::sequence {
namespace {

constexpr std::size_t most_shown = 24;
constexpr int most_side = 320;  // pixels of a small picture
constexpr int gap = 6;          // pixels between them and around all
constexpr std::array<std::uint8_t, 4> behind{24, 24, 24, 255};
constexpr double wanted_aspect = 1.6;  // of the sheet

int side_of(int count, int cell) { return count * cell + (count + 1) * gap; }

// The number of columns that comes nearest to the wanted aspect with few places empty.
int choose_columns(int count, int cell_width, int cell_height) {
  int best = 1;
  double least = std::numeric_limits<double>::infinity();
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double aspect = double(side_of(columns, cell_width)) / side_of(rows, cell_height);
    const double empty = double(rows * columns - count) / count;
    const double cost = std::abs(std::log(aspect / wanted_aspect)) + empty;
    if (cost >= least) continue;
    least = cost;
    best = columns;
  }
  return best;
}

image::Image8 made_small(const image::Image8& picture, int width, int height) {
  image::Image8 small{.width = width, .height = height, .rgba = {}};
  small.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  image::AreaAverage average(
      {picture.width, picture.height}, {width, height}, 4, [&](int y, std::span<const float> values) {
        for (int x = 0; x < width; ++x)
          image::round_texel(&values[static_cast<std::size_t>(x) * 4], true, small.at(x, y));
      });

  std::vector<float> row(static_cast<std::size_t>(picture.width) * 4);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const image::Texel texel = image::weighted(picture.at(x, y), true);
      std::copy(texel.begin(), texel.end(), row.begin() + std::ptrdiff_t{x} * 4);
    }
    average.add(y, row);
    average.done_to(y);
  }
  return small;
}

}  // namespace

Sheet::Sheet(std::size_t frames, int width, int height) {
  const std::size_t count = std::min(frames, most_shown);
  for (std::size_t i = 0; i < count; ++i) shown_.push_back(i * frames / count);

  const double factor = std::min(1.0, double{most_side} / std::max(width, height));
  cell_width_ = std::max(1, static_cast<int>(std::lround(width * factor)));
  cell_height_ = std::max(1, static_cast<int>(std::lround(height * factor)));
  columns_ = choose_columns(static_cast<int>(count), cell_width_, cell_height_);
  const int rows = (static_cast<int>(count) + columns_ - 1) / columns_;

  sheet_.width = side_of(columns_, cell_width_);
  sheet_.height = side_of(rows, cell_height_);
  sheet_.rgba.resize(static_cast<std::size_t>(sheet_.width) * static_cast<std::size_t>(sheet_.height) * 4);
  for (std::size_t i = 0; i < sheet_.rgba.size(); ++i) sheet_.rgba[i] = behind[i % 4];
}

void Sheet::add(std::size_t frame, const image::Image8& picture) {
  const auto found = std::lower_bound(shown_.begin(), shown_.end(), frame);
  if (found == shown_.end() || *found != frame) return;

  const image::Image8 small = made_small(picture, cell_width_, cell_height_);
  const int place = static_cast<int>(found - shown_.begin());
  const int left = gap + place % columns_ * (cell_width_ + gap);
  const int top = gap + place / columns_ * (cell_height_ + gap);
  for (int y = 0; y < small.height; ++y)
    std::copy_n(small.at(0, y), static_cast<std::size_t>(small.width) * 4, sheet_.at(left, top + y));
}

}  // namespace dermis::cli::sequence
