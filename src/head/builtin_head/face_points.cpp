// SPDX-License-Identifier: MIT
#include "head/builtin_head/face_points.h"

#include <cmath>
#include <limits>
#include <vector>

#include "base/core/assert.h"
#include "head/builtin_head/openings.h"
#include "head/builtin_head/parts.h"

namespace dermis::builtin_head {
namespace {

constexpr int mesh_of_skin = 0, mesh_of_eyes = 1;

struct Marked {
  std::size_t number = 0;  ///< of the landmark
  vec3 at{0};              ///< in the symmetric face, mm
};

// The left half and the midline; numbers as iBUG has them. Jaw, brow, bridge and base of the nose, outer
// borders of the lips.
const std::vector<Marked> left_half = {
    {8, {0, -116, 83.5f}},    {9, {15.5f, -114.3f, 81}},   {10, {31, -109, 67}},
    {11, {45, -98, 51}},      {12, {57.5f, -78, 34}},      {13, {63, -58, 28}},
    {14, {67.5f, -39, 26}},   {15, {70.4f, -19, 26}},      {16, {70.6f, 2, 24}},
    {22, {16, 14.6f, 91}},    {23, {22, 18.3f, 91}},       {24, {31, 20, 88}},
    {25, {41, 19.7f, 83}},    {26, {51, 14.8f, 74}},       {27, {0, 2, 90}},
    {28, {0, -11, 97.5f}},    {29, {0, -22, 106.5f}},      {30, {0, -35, 117}},
    {33, {0, -49.5f, 98.5f}}, {34, {5.5f, -47.8f, 97.8f}}, {35, {10.8f, -46.6f, 96.6f}},
    {51, {0, -61.6f, 101}},   {52, {5.5f, -60, 101}},      {53, {16, -64.4f, 95}},
    {55, {18, -74.4f, 92}},   {56, {9, -77.8f, 97}},       {57, {0, -78.6f, 98}},
};

// Returns the landmark that stands where this one stands, on the other half.
constexpr std::size_t opposite(std::size_t number) {
  constexpr std::array<std::array<std::size_t, 2>, 5> sums{
      {{16, 16}, {26, 43}, {35, 66}, {54, 102}, {59, 114}}};  // last of a group, sum of both numbers
  if (number >= 27 && number <= 30) return number;
  for (const auto& [last, sum] : sums)
    if (number <= last) return sum - number;
  return number;
}
static_assert(opposite(8) == 8 && opposite(16) == 0 && opposite(22) == 21 && opposite(26) == 17);
static_assert(opposite(33) == 33 && opposite(35) == 31 && opposite(53) == 49 && opposite(57) == 57);
static_assert(opposite(55) == 59);

struct MarkedNode {
  std::size_t number = 0;  ///< of the landmark
  int column = 0, row = 0;
};

// Edges of the lids, corners of eyes and mouth, inner edges of the lips. Rows grow upwards, columns to the
// left.
std::vector<MarkedNode> marked_nodes() {
  constexpr Opening eye = Openings::eye, mouth = Openings::mouth;
  constexpr int last = Openings::columns, half = Openings::half, middle = last / 2;
  std::vector<MarkedNode> found{{48, mouth.from, mouth.middle}, {54, mouth.to, mouth.middle}};

  const int inner = eye.from + 7, outer = eye.from + 13;
  const std::array<std::array<int, 2>, 6> left{{{eye.from, eye.middle},
                                                {inner, eye.middle + half},
                                                {outer, eye.middle + half},
                                                {eye.to, eye.middle},
                                                {outer, eye.middle - half},
                                                {inner, eye.middle - half}}};
  constexpr std::array<std::size_t, 6> right{39, 38, 37, 36, 41, 40};
  for (std::size_t k = 0; k < left.size(); ++k) {
    found.push_back({42 + k, left[k][0], left[k][1]});
    found.push_back({right[k], last - left[k][0], left[k][1]});
  }

  constexpr int upper = mouth.middle + half, lower = mouth.middle - half, aside = 7;
  found.insert(found.end(), {{60, mouth.from + 3, upper},
                             {61, middle - aside, upper},
                             {62, middle, upper},
                             {63, middle + aside, upper},
                             {64, mouth.to - 3, upper},
                             {65, middle + aside, lower},
                             {66, middle, lower},
                             {67, middle - aside, lower}});
  return found;
}

// A corner of the cell to its right and above: every inner node has one.
LandmarkPlace node_place(const MarkedNode& node) {
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>((node.row + j) * (Openings::columns + 1) + node.column + i);
  };
  return {.mesh = mesh_of_skin, .vertices = {at(0, 0), at(1, 0), at(1, 1)}, .weights = {1, 0, 0}};
}

// Weights of the point of a triangle that is nearest to p: Ericson, Real-Time Collision Detection, 2005,
// section 5.1.5.
glm::dvec3 nearest_weights(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p) {
  const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], bp = p - t[1], cp = p - t[2];
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp),
               d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};

  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  if (const double along = d4 - d3, back = d5 - d6; va <= 0 && along >= 0 && back >= 0)
    return {0, back / (along + back), along / (along + back)};
  return glm::dvec3(va, vb, vc) / (va + vb + vc);
}

LandmarkPlace nearest_place(const scene::Primitive& skin, const glm::dvec3& p) {
  LandmarkPlace best{.mesh = mesh_of_skin};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < skin.indices.size(); corner += 3) {
    std::array<glm::dvec3, 3> triangle;
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = glm::dvec3(skin.vertices[skin.indices[corner + k]].position_m);
    if (std::abs(triangle[0].y - p.y) > 0.02) continue;  // cells are smaller than that

    const glm::dvec3 w = nearest_weights(triangle, p);
    const double distance = glm::distance(w.x * triangle[0] + w.y * triangle[1] + w.z * triangle[2], p);
    if (!(distance < least)) continue;
    least = distance;
    best.vertices = {skin.indices[corner], skin.indices[corner + 1], skin.indices[corner + 2]};
    best.weights = {w.x, w.y, w.z};
  }
  DERMIS_ASSERT_LT(least, 0.01);
  return best;
}

}  // namespace

std::array<LandmarkPlace, Landmarks::count> landmark_places(const scene::AssetData& head) {
  const scene::Primitive& skin = head.primitives.at(mesh_of_skin);
  const scene::Primitive& eyes = head.primitives.at(mesh_of_eyes);
  std::array<LandmarkPlace, Landmarks::count> places;

  for (const MarkedNode& node : marked_nodes()) places[node.number] = node_place(node);
  for (const Marked& mark : left_half) {
    places[mark.number] = nearest_place(skin, to_world_m(from_symmetric(mark.at)));
    if (const std::size_t other = opposite(mark.number); other != mark.number)
      places[other] = nearest_place(skin, to_world_m(from_symmetric({-mark.at.x, mark.at.y, mark.at.z})));
  }

  // The left eyeball comes first; each begins with its pole and the ring about it.
  const auto half = static_cast<std::uint32_t>(eyes.vertices.size() / 2);
  for (std::uint32_t side = 0; side < 2; ++side) {
    const std::uint32_t pole = side == 0 ? half : 0;
    places[68 + side] = {.mesh = mesh_of_eyes, .vertices = {pole, pole + 1, pole + 2}, .weights = {1, 0, 0}};
  }
  return places;
}

}  // namespace dermis::builtin_head
