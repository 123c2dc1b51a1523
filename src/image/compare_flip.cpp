// SPDX-License-Identifier: MIT
// Based on: [ANAMOF20] and [ANSA21], see compare_flip.h
#include "image/compare_flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/parallel.h"
#include "image/colour.h"
#include "image/compare_flip_colour.h"
#include "image/compare_flip_filters.h"

namespace dermis::image {
namespace {

using flip::Filters;
using flip::Taps;

/// Gives one row of a picture as linear light in 0..1.
using RowSource = std::function<void(int y, flip::Rgb* row)>;

// [ANAMOF20] sec. 4.1.3 and 4.2: exponents, and the knee in the map of colour differences.
constexpr float colour_exponent = 0.7f, bend_at = 0.4f, bend_to = 0.95f;

/// Computes out[x] = sum over k of taps[k] * in[x + k * step]. step 1 filters along a row; step = row length
/// filters along columns.
void filter(const float* in, std::size_t step, const Taps& taps, std::size_t width, float* out) {
  std::fill_n(out, width, 0.0f);
  for (std::size_t k = 0; k < taps.size(); ++k) {
    const float tap = taps[k];
    if (tap == 0) continue;
    const float* shifted = in + k * step;
    for (std::size_t x = 0; x < width; ++x) out[x] += tap * shifted[x];
  }
}

/// Rows of one picture, filtered along the rows: one plane per filter.
struct FilteredRows {
  enum Plane { y, cx, cz_wide, cz_narrow, smooth, edge, point, count };
  std::array<std::vector<float>, count> planes;
};

FilteredRows filter_rows(const RowSource& source, const Filters& filters, int first, int rows, int width,
                         int height) {
  const std::size_t w = static_cast<std::size_t>(width), radius = static_cast<std::size_t>(filters.radius);
  FilteredRows filtered;
  for (std::vector<float>& plane : filtered.planes) plane.resize(static_cast<std::size_t>(rows) * w);
  std::vector<flip::Rgb> linear(w);
  std::vector<float> y(w + 2 * radius), cx(y.size()), cz(y.size());

  for (int i = 0; i < rows; ++i) {
    // Beyond the border the outermost rows and columns repeat.
    source(std::clamp(first + i, 0, height - 1), linear.data());
    for (std::size_t x = 0; x < y.size(); ++x) {
      const flip::Opponent o = flip::opponent(linear[std::min(x > radius ? x - radius : 0, w - 1)]);
      y[x] = o.y;
      cx[x] = o.cx;
      cz[x] = o.cz;
    }

    const auto along = [&](const std::vector<float>& in, const Taps& taps, FilteredRows::Plane plane) {
      filter(in.data(), 1, taps, w, filtered.planes[plane].data() + static_cast<std::size_t>(i) * w);
    };
    along(y, filters.y, FilteredRows::y);
    along(cx, filters.cx, FilteredRows::cx);
    along(cz, filters.cz_wide, FilteredRows::cz_wide);
    along(cz, filters.cz_narrow, FilteredRows::cz_narrow);
    along(y, filters.smooth, FilteredRows::smooth);
    along(y, filters.edge, FilteredRows::edge);
    along(y, filters.point, FilteredRows::point);
  }

  return filtered;
}

/// One row of one picture after all filters.
struct SeenRow {
  std::vector<float> y, cx, cz_wide, cz_narrow;         // colours that the eye resolves
  std::vector<float> edge_x, edge_y, point_x, point_y;  // edges and points that it resolves
  explicit SeenRow(std::size_t width)
      : y(width),
        cx(width),
        cz_wide(width),
        cz_narrow(width),
        edge_x(width),
        edge_y(width),
        point_x(width),
        point_y(width) {}

  void set(const FilteredRows& rows, const Filters& filters, std::size_t row) {
    const std::size_t width = y.size();
    const auto down = [&](FilteredRows::Plane plane, const Taps& taps, std::vector<float>& out) {
      filter(rows.planes[plane].data() + row * width, width, taps, width, out.data());
    };
    down(FilteredRows::y, filters.y, y);
    down(FilteredRows::cx, filters.cx, cx);
    down(FilteredRows::cz_wide, filters.cz_wide, cz_wide);
    down(FilteredRows::cz_narrow, filters.cz_narrow, cz_narrow);
    down(FilteredRows::edge, filters.smooth, edge_x);
    down(FilteredRows::smooth, filters.edge, edge_y);
    down(FilteredRows::point, filters.smooth, point_x);
    down(FilteredRows::smooth, filters.point, point_y);
  }
  flip::Lab colour(std::size_t x) const {
    return flip::hunt_lab(flip::Opponent{y[x], cx[x], cz_wide[x] + cz_narrow[x]});
  }
  float edge(std::size_t x) const { return std::sqrt(edge_x[x] * edge_x[x] + edge_y[x] * edge_y[x]); }
  float point(std::size_t x) const { return std::sqrt(point_x[x] * point_x[x] + point_y[x] * point_y[x]); }
};

/// Returns the colour difference 0 to 1, [ANAMOF20] sec. 4.1.3: differences up to bend_at of the largest
/// possible one take the range up to bend_to.
float colour_difference(const flip::Lab& a, const flip::Lab& b) {
  static const float greatest = std::pow(
      flip::hyab(flip::hunt_lab(flip::Rgb{0, 1, 0}), flip::hunt_lab(flip::Rgb{0, 0, 1})), colour_exponent);
  const float bend = bend_at * greatest;
  const float difference = std::pow(flip::hyab(a, b), colour_exponent);
  if (difference < bend) return difference * (bend_to / bend);
  return bend_to + (difference - bend) / (greatest - bend) * (1 - bend_to);
}

float flip_at(const SeenRow& a, const SeenRow& b, std::size_t x) {
  const float edge = std::abs(a.edge(x) - b.edge(x)), point = std::abs(a.point(x) - b.point(x));
  const float feature = std::sqrt(std::max(edge, point) / std::sqrt(2.0f));   // [ANAMOF20] sec. 4.2.2
  return std::pow(colour_difference(a.colour(x), b.colour(x)), 1 - feature);  // sec. 4.3
}

ImageF flip_of_rows(const RowSource& reference, const RowSource& test, int width, int height) {
  static const Filters filters = flip::make_filters(flip_pixels_per_degree);
  constexpr int band_rows = 64;
  ImageF map{.width = width, .height = height, .channels = 1, .values = {}};
  map.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

  const int bands = (height + band_rows - 1) / band_rows;
  parallel_for(static_cast<std::size_t>(bands), [&](std::size_t band) {
    const int top = static_cast<int>(band) * band_rows, bottom = std::min(top + band_rows, height);
    const int first = top - filters.radius, rows = bottom - top + 2 * filters.radius;
    const FilteredRows a = filter_rows(reference, filters, first, rows, width, height);
    const FilteredRows b = filter_rows(test, filters, first, rows, width, height);

    const std::size_t w = static_cast<std::size_t>(width);
    SeenRow seen_a(w), seen_b(w);
    for (int y = top; y < bottom; ++y) {
      seen_a.set(a, filters, static_cast<std::size_t>(y - top));
      seen_b.set(b, filters, static_cast<std::size_t>(y - top));
      float* out = map.at(0, y);
      for (std::size_t x = 0; x < w; ++x) out[x] = flip_at(seen_a, seen_b, x);
    }
  });

  return map;
}

template <class Image>
void check_sizes(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) {
    throw input_error("", "pictures of different sizes cannot be compared: {} x {} and {} x {} pixels",
                      a.width, a.height, b.width, b.height);
  }
  DERMIS_ASSERT(a.width >= 1 && a.height >= 1);
}

// The ACES curve of [ANSA21] (a x^2 + b x) / (c x^2 + d x + e); the factor 0.6 undoes the exposure in the
// published fit.
namespace aces {
constexpr double a = 0.6 * 0.6 * 2.51, b = 0.6 * 0.03, c = 0.6 * 0.6 * 2.43, d = 0.6 * 0.59, e = 0.14;
}

float tone_map(float linear) {
  if (!(linear > 0)) return 0;
  if (linear > 1e6f) return 1;  // avoids overflow of the squares below
  const double x = linear;
  return static_cast<float>(
      std::min(1.0, (aces::a * x + aces::b) * x / ((aces::c * x + aces::d) * x + aces::e)));
}

/// Chooses exposures, [ANSA21] sec. 3.2: from where the brightest pixel of the reference shows as 0.85 to
/// where its median pixel does.
void choose_exposures(const ImageF& reference, HdrFlip& result) {
  constexpr double shown = 0.85, least_share = 0x1p-30;
  // Solves the curve for the input that shows as 0.85.
  const double a = aces::a - shown * aces::c, b = aces::b - shown * aces::d, c = -shown * aces::e;
  const double target = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);

  std::vector<double> luminances;
  const std::size_t channels = static_cast<std::size_t>(reference.channels);
  for (std::size_t i = 0; i < reference.values.size(); i += channels) {
    const float* p = reference.values.data() + i;
    const double luminance = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
    luminances.push_back(luminance > 0 ? luminance : 0.0);  // NaN counts as black
  }

  std::sort(luminances.begin(), luminances.end());
  const double greatest = luminances.back();
  result.exposures = 2;
  if (!(greatest > 0)) return;

  auto first = luminances.begin();
  if (luminances[luminances.size() / 2] == 0) first = std::upper_bound(first, luminances.end(), 0.0);
  const std::size_t count = static_cast<std::size_t>(luminances.end() - first);
  const double median = 0.5 * (first[static_cast<std::ptrdiff_t>((count - 1) / 2)] +
                               first[static_cast<std::ptrdiff_t>(count / 2)]);

  result.start_exposure = std::log2(target / greatest);
  result.stop_exposure = std::log2(target / std::max(median, least_share * greatest));
  result.exposures = std::max(2, static_cast<int>(std::ceil(result.stop_exposure - result.start_exposure)));
}

}  // namespace

ImageF flip_map(const Image8& reference, const Image8& test) {
  check_sizes(reference, test);
  const auto rows = [](const Image8& picture) {
    return [&picture](int y, flip::Rgb* row) {
      const std::uint8_t* in = picture.at(0, y);
      for (int x = 0; x < picture.width; ++x, in += 4)
        row[x] = {srgb8_to_linear(in[0]), srgb8_to_linear(in[1]), srgb8_to_linear(in[2])};
    };
  };
  return flip_of_rows(rows(reference), rows(test), reference.width, reference.height);
}

HdrFlip hdr_flip(const ImageF& reference, const ImageF& test) {
  check_sizes(reference, test);
  DERMIS_ASSERT_LE(3, reference.channels);
  DERMIS_ASSERT_LE(3, test.channels);

  HdrFlip result;
  choose_exposures(reference, result);
  const double step = (result.stop_exposure - result.start_exposure) / (result.exposures - 1);
  for (int i = 0; i < result.exposures; ++i) {
    const float factor = static_cast<float>(std::exp2(result.start_exposure + i * step));
    // The display curve and its inverse at the start of FLIP cancel.
    const auto rows = [factor](const ImageF& picture) {
      return [&picture, factor](int y, flip::Rgb* row) {
        const float* in = picture.at(0, y);
        for (int x = 0; x < picture.width; ++x, in += picture.channels)
          row[x] = {tone_map(in[0] * factor), tone_map(in[1] * factor), tone_map(in[2] * factor)};
      };
    };

    ImageF map = flip_of_rows(rows(reference), rows(test), reference.width, reference.height);
    if (i == 0) {
      result.map = std::move(map);
    } else {
      for (std::size_t p = 0; p < map.values.size(); ++p)
        result.map.values[p] = std::max(result.map.values[p], map.values[p]);
    }
  }

  return result;
}

FlipSummary summarise_flip(const ImageF& map, std::span<const std::uint8_t> mask) {
  DERMIS_ASSERT_EQ(map.channels, 1);
  if (!mask.empty() && mask.size() != map.values.size())
    throw input_error("", "the mask has {} pixels, the pictures have {}", mask.size(), map.values.size());

  std::vector<float> values;
  for (std::size_t i = 0; i < map.values.size(); ++i)
    if (mask.empty() || mask[i] != 0) values.push_back(map.values[i]);
  if (values.empty()) throw input_error("", "no pixel to compare: the mask selects none");
  std::sort(values.begin(), values.end());

  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  FlipSummary summary{
      .mean = sum / static_cast<double>(values.size()), .min = values.front(), .max = values.back()};

  // Finds the values at which the running sum passes 1/4, 1/2 and 3/4 of the sum.
  double running = 0;
  std::size_t i = 0;
  for (const auto& [share, target] : {std::pair(0.25, &summary.q1), std::pair(0.5, &summary.weighted_median),
                                      std::pair(0.75, &summary.q3)}) {
    while (i < values.size() && running <= share * sum) running += static_cast<double>(values[i++]);
    *target = sum > 0 ? static_cast<double>(values[i - 1]) : 0.0;
  }

  return summary;
}

double mean_flip(const Image8& reference, const Image8& test, std::span<const std::uint8_t> mask) {
  return summarise_flip(flip_map(reference, test), mask).mean;
}

}  // namespace dermis::image
