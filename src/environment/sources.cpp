// SPDX-License-Identifier: MIT
#include "environment/sources.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "environment/level_sets.h"

namespace dermis::environment {
namespace {

using std::numbers::pi;

/// The least irradiance of a source, as a share of that of the picture. Weaker ones neither ring nor cast a
/// visible shadow.
constexpr double least_share = 0.04;

/// A region becomes several discs if one spread (standard deviation) is this many times the other, and a disc
/// of that spread would have a larger angular radius [rad] than this.
constexpr double most_elongation = 1.7, least_cut_rad = 0.1;
constexpr int most_pieces = 4;

constexpr int most_width = 2048;  // a pixel then has a third of the sun's diameter

/// Returns a picture of at most `most_width` columns, if whole pixels fit, with the same energy: neither
/// light maps nor reflections show more of it.
image::ImageF reduced(const image::ImageF& picture) {
  int factor = (picture.width + most_width - 1) / most_width;
  while (factor < picture.height && (picture.width % factor != 0 || picture.height % factor != 0)) ++factor;
  if (factor <= 1 || factor >= picture.height) return picture;

  image::ImageF out{
      .width = picture.width / factor, .height = picture.height / factor, .channels = 3, .values = {}};
  out.values.reserve(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 3);
  for (int y = 0; y < out.height; ++y) {
    const double omega = pixel_solid_angle(y, out.width, out.height);
    for (int x = 0; x < out.width; ++x) {
      glm::dvec3 sum(0);
      for (int j = y * factor; j < (y + 1) * factor; ++j)
        for (int i = x * factor; i < (x + 1) * factor; ++i) {
          const float* rgb = picture.at(i, j);
          sum += glm::dvec3(rgb[0], rgb[1], rgb[2]) * pixel_solid_angle(j, picture.width, picture.height);
        }
      for (glm::length_t c = 0; c < 3; ++c) out.values.push_back(static_cast<float>(sum[c] / omega));
    }
  }
  return out;
}

/// The excess of one pixel over the level of its region.
struct Piece {
  std::uint32_t pixel;
  glm::dvec3 direction, excess;  // unit; times solid angle, per channel
  double variance;               // rad^2 per axis, of bilinear interpolation
  double brightness() const { return (excess.x + excess.y + excess.z) / 3; }
};

std::vector<Piece> pieces_of(const image::ImageF& picture, const LevelRegion& region) {
  std::vector<Piece> pieces;
  pieces.reserve(region.pixels.size());

  for (const std::uint32_t pixel : region.pixels) {
    const int x = static_cast<int>(pixel) % picture.width, y = static_cast<int>(pixel) / picture.width;
    const double v = (y + 0.5) / picture.height, step = pi / picture.height;
    Piece piece{pixel, direction_of((x + 0.5) / picture.width, v), glm::dvec3(0), 0};

    // A tent two pixels wide has the variance pixel^2 / 6; here the mean of both axes.
    const double across = 2 * pi / picture.width * std::sin(pi * v);
    piece.variance = (step * step + across * across) / 12;

    const float* rgb = picture.at(x, y);
    const double omega = pixel_solid_angle(y, picture.width, picture.height);
    for (glm::length_t c = 0; c < 3; ++c)
      piece.excess[c] =
          (double{rgb[c]} - double{std::min(rgb[c], static_cast<float>(region.level[c]))}) * omega;
    pieces.push_back(piece);
  }
  return pieces;
}

/// Adds the pieces to the picture, times -1 or 1.
void add_to(image::ImageF& picture, const std::vector<Piece>& pieces, double times) {
  for (const Piece& piece : pieces) {
    const int y = static_cast<int>(piece.pixel) / picture.width;
    const double omega = pixel_solid_angle(y, picture.width, picture.height);
    float* rgb = picture.values.data() + 3 * std::size_t{piece.pixel};
    for (glm::length_t c = 0; c < 3; ++c)
      rgb[c] = static_cast<float>(std::max(double{rgb[c]} + times * piece.excess[c] / omega, 0.0));
  }
}

glm::dvec3 energy_of(const std::vector<Piece>& pieces) {
  glm::dvec3 sum(0);
  for (const Piece& piece : pieces) sum += piece.excess;
  return sum;
}

glm::dvec3 middle_of(const std::vector<Piece>& pieces) {
  glm::dvec3 sum(0);
  for (const Piece& piece : pieces) sum += piece.brightness() * piece.direction;
  return glm::normalize(sum);
}

/// Returns two axes perpendicular to a direction.
std::array<glm::dvec3, 2> across(const glm::dvec3& d) {
  const glm::dvec3 side =
      glm::normalize(glm::cross(std::abs(d.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), d));
  return {side, glm::cross(d, side)};
}

/// Spread about the centre, in the tangent plane of the sphere.
struct Spread {
  double uu = 0, uv = 0, vv = 0;  // rad^2
  /// Returns the larger and the smaller principal variance.
  std::array<double, 2> principal() const {
    const double mean = (uu + vv) / 2, root = std::hypot((uu - vv) / 2, uv);
    return {mean + root, std::max(mean - root, 0.0)};
  }
  /// Returns the axis of the larger one, in the plane.
  glm::dvec2 axis() const {
    const double angle = 0.5 * std::atan2(2 * uv, uu - vv);
    return {std::cos(angle), std::sin(angle)};
  }
};

Spread spread_of(const std::vector<Piece>& pieces, const glm::dvec3& middle) {
  const auto [side, up] = across(middle);
  Spread spread;
  double total = 0;
  for (const Piece& piece : pieces) {
    const double weight = piece.brightness(), along = glm::dot(piece.direction, middle);
    const double u = glm::dot(piece.direction, side) / along, v = glm::dot(piece.direction, up) / along;
    spread.uu += weight * (u * u + piece.variance);
    spread.uv += weight * u * v;
    spread.vv += weight * (v * v + piece.variance);
    total += weight;
  }
  spread.uu /= total;
  spread.uv /= total;
  spread.vv /= total;
  return spread;
}

/// Returns a disc of the same energy, centre and spread. The variance of a disc is radius^2 / 4 per axis.
Source disc_of(const std::vector<Piece>& pieces) {
  const glm::dvec3 middle = middle_of(pieces);
  const auto [large, small] = spread_of(pieces, middle).principal();
  return {middle, energy_of(pieces), std::sqrt(2 * (large + small))};
}

/// Returns one disc for a round region, several of equal energy along an elongated one.
std::vector<Source> discs_of(std::vector<Piece> pieces) {
  std::erase_if(pieces, [](const Piece& piece) { return piece.brightness() <= 0; });
  const glm::dvec3 middle = middle_of(pieces);
  const Spread spread = spread_of(pieces, middle);
  const auto [large, small] = spread.principal();
  const double elongation = std::sqrt(large / small);
  if (elongation < most_elongation || 2 * std::sqrt(large) < least_cut_rad) return {disc_of(pieces)};

  const auto [side, up] = across(middle);
  const glm::dvec2 axis = spread.axis();
  const glm::dvec3 along = side * axis.x + up * axis.y;
  std::stable_sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
    return glm::dot(a.direction, along) < glm::dot(b.direction, along);
  });

  // Starts the next disc where the sum of the light passes the next equal share.
  double total = 0;
  for (const Piece& piece : pieces) total += piece.brightness();
  const int count = std::min(most_pieces, static_cast<int>(std::lround(elongation)));
  std::vector<Source> sources;
  std::vector<Piece> part;
  double done = 0;
  for (const Piece& piece : pieces) {
    const auto number = static_cast<std::size_t>(std::min(done / total * count, count - 1.0));
    if (number > sources.size()) {
      sources.push_back(disc_of(part));
      part.clear();
    }
    part.push_back(piece);
    done += piece.brightness();
  }
  sources.push_back(disc_of(part));
  return sources;
}

double brightness_of(const glm::dvec3& colour) { return (colour.x + colour.y + colour.z) / 3; }

/// The pieces cut off one region, and the discs that replace them.
struct Group {
  std::vector<Piece> pieces;
  std::vector<Source> discs;
};

}  // namespace

double pixel_solid_angle(int row, int width, int height) {
  if (height == 1) return 4 * pi / width;
  const double step = pi / height, polar = (std::min(row, height - 1 - row) + 0.5) * step;

  // Int tent(t) sin dt over two rows; at a pole the row continues with its own value.
  const double rows = row == 0 || row == height - 1 ? 1 - (std::sin(1.5 * step) - std::sin(0.5 * step)) / step
                                                    : std::sin(polar) * 2 * (1 - std::cos(step)) / step;
  return 2 * pi / width * rows;
}

Split split_sources(const Environment& picture) {
  Split split{{picture.name, reduced(picture.radiance)}, {}};
  image::ImageF& left = split.remainder.radiance;
  const double irradiance = pi * mean_brightness(left);
  if (!(irradiance > 0)) return split;

  std::vector<Group> groups;
  std::size_t count = 0;
  for (const LevelRegion& region : compact_regions(left, least_share * irradiance)) {
    Group group{pieces_of(left, region), {}};
    if (brightness_of(energy_of(group.pieces)) < least_share * irradiance) continue;
    add_to(left, group.pieces, -1);
    group.discs = discs_of(group.pieces);
    count += group.discs.size();
    groups.push_back(std::move(group));
  }

  // If there are too many, the weakest stay in the picture.
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return brightness_of(energy_of(a.pieces)) > brightness_of(energy_of(b.pieces));
  });
  for (; count > most_sources; groups.pop_back()) {
    add_to(left, groups.back().pieces, 1);
    count -= groups.back().discs.size();
  }
  for (const Group& group : groups)
    split.sources.insert(split.sources.end(), group.discs.begin(), group.discs.end());
  std::stable_sort(split.sources.begin(), split.sources.end(), [](const Source& a, const Source& b) {
    return brightness_of(a.irradiance) > brightness_of(b.irradiance);
  });
  return split;
}

SkyHarmonics with_sources(SkyHarmonics sky, std::span<const Source> sources) {
  for (const Source& source : sources) {
    const Harmonics basis = harmonics(source.direction);
    for (std::size_t k = 0; k < basis.size(); ++k) sky[k] += source.irradiance * basis[k];
  }
  return sky;
}

}  // namespace dermis::environment
