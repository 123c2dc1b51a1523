// SPDX-License-Identifier: MIT
#include "head/builtin_head/openings.h"

#include "base/core/assert.h"
#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/parts.h"

namespace dermis::builtin_head {
namespace {

constexpr int half = Openings::half;

// Returns the point at part t of the length of a curve.
vec3 at_length(const std::vector<vec3>& curve, float t) {
  float total = 0;
  for (std::size_t k = 1; k < curve.size(); ++k) total += glm::distance(curve[k - 1], curve[k]);

  float left = std::clamp(t, 0.0f, 1.0f) * total;
  for (std::size_t k = 1; k < curve.size(); ++k) {
    const float piece = glm::distance(curve[k - 1], curve[k]);
    if (left <= piece || k + 1 == curve.size())
      return glm::mix(curve[k - 1], curve[k], std::min(left / std::max(piece, 1e-6f), 1.0f));
    left -= piece;
  }
  return curve.back();
}

// Turns a direction about the eyeball's centre upwards, away from the gap between the lids.
vec3 turned_up(const vec3& d, float angle) {
  const vec3 axis = glm::normalize(glm::cross(d, vec3(0, 1, 0)));
  const float c = std::cos(angle), s = std::sin(angle);
  return c * d + s * glm::cross(axis, d);
}

}  // namespace

Openings::Openings(const Sculpture& bust) {
  add_eye(bust, 1.0f);
  add_eye(bust, -1.0f);
  add_mouth(bust);
}

void Openings::add_eye(const Sculpture& bust, float side) {
  const std::vector<vec3> upper = smooth_curve(upper_lid, 8), lower = smooth_curve(lower_lid, 8);
  const float span = static_cast<float>(eye.to - eye.from);

  for (int i = eye.from; i <= eye.to; ++i) {
    // Nodes draw a little closer towards the corners, where the lids turn.
    const float s = static_cast<float>(i - eye.from) / span;
    const float t = s - 0.055f * std::sin(6.2831853f * s);
    const float corner = std::min(s, 1 - s) * span;  // in cells
    const auto edge = [&](float up) {
      vec3 q = at_length(up > 0 ? upper : lower, t);
      q.y += up * 0.35f;
      q.x *= side;
      return bust.onto_skin(q);
    };
    const vec3 centre(eye_centre.x * side, eye_centre.y, eye_centre.z);

    // The inner rim of a lid: 2 to 3 mm behind the edge, on the eyeball; towards the corners it leaves that.
    const auto rim = [&](float up) {
      const vec3 d = glm::normalize(edge(up) - centre);
      return centre + d * std::max(eye_radius_mm(d) + 0.12f, glm::distance(edge(up), centre) - 3.4f);
    };
    // In the corners the lids have left the globe: a sheet closes the pouch there, and slopes down to it.
    const float sheet_cells = s < 0.5f ? 4.2f : 2.6f;
    const float off_globe = 1.0f - smooth_step(0.5f * sheet_cells, sheet_cells, corner);

    for (int k = -half; k <= half; ++k) {
      const float up = k < 0 ? -1.0f : 1.0f;
      const vec3 e = edge(up), d = glm::normalize(e - centre);
      const int depth = half - std::abs(k);  // rows from the edge inwards

      vec3 q = e;
      if (corner < 0.5f) {
        q = bust.onto_skin(glm::mix(edge(-1), edge(1), static_cast<float>(k + half) / (2.0f * half)));
      } else if (depth == 1) {
        q = centre + d * (glm::distance(e, centre) - 0.6f);
        q.y -= 0.12f * up;
      } else if (depth >= 2) {
        q = rim(up);
        if (depth == 3) q = centre + turned_up(d, 0.45f * up) * (glm::distance(q, centre) + 0.35f);
        if (depth == 4) q = {glm::mix(e.x, centre.x, 0.35f), centre.y, centre.z - 3.0f};
        const vec3 sheet =
            glm::mix(rim(-1), rim(1), static_cast<float>(k + 2) / 4.0f) - vec3(0, 0, 0.6f + 0.7f * corner);
        if (depth > 2) q = glm::mix(q, sheet, off_globe);
      }
      nodes_.push_back({side > 0 ? i : columns - i, eye.middle + k, from_symmetric(q)});
    }
  }
}

void Openings::add_mouth(const Sculpture& bust) {
  const std::vector<vec3> line = smooth_curve(mouth_line, 8);
  const float span = 0.5f * static_cast<float>(mouth.to - mouth.from);

  for (int i = mouth.from; i <= mouth.to; ++i) {
    const float s = static_cast<float>(i) / span - static_cast<float>(mouth.from) / span - 1.0f;
    const float side = s < 0 ? -1.0f : 1.0f;
    vec3 q = at_length(line, std::abs(s));
    q.x *= side;
    const vec3 seam = bust.onto_skin(q);
    const float open = std::min(1.0f, 4.0f * (1 - std::abs(s)));  // falls to 0 at the corners

    for (int k = -half; k <= half; ++k) {
      const float up = k < 0 ? -1.0f : 1.0f;
      vec3 p = seam;
      if (std::abs(s) > 0.999f) {
        p = seam + vec3(0, 0.1f * static_cast<float>(k), 0);
      } else {
        // Lips touch for a few millimetres (a wider gap shows the teeth as a white line), then the pouch
        // widens before the teeth and closes in the throat.
        const int depth = half - std::abs(k);
        const vec3 inwards = glm::normalize(vec3(-0.35f * q.x / 25.0f, 0, -1));
        p += vec3(0, up * (depth < 2 ? 0.02f : 0.25f), 0);
        if (depth == 1) p += open * 2.5f * inwards;
        if (depth == 2) p += open * (5.0f * inwards + vec3(0, 2.5f * up, 0));
        if (depth == 3) p += open * (9.0f * inwards + vec3(0, 13.0f * up, 0));
        if (depth == 4) p = glm::mix(p, vec3(0.55f * seam.x, seam.y, 38.0f), open);
      }
      nodes_.push_back({i, mouth.middle + k, from_symmetric(p)});
    }
  }
}

void Openings::place(Net& net) const {
  const int step = columns / net.columns;
  DERMIS_ASSERT(step * net.columns == columns && step * net.rows == rows);
  for (const Node& node : nodes_) {
    if (node.i % step == 0 && node.j % step == 0)
      net.at_mm[net.index(node.i / step, node.j / step)] = node.at_mm;
  }
}

namespace {

bool within(const Opening& o, int i, int j, int cell) {
  return i >= o.from && i <= o.to - cell && j >= o.middle - half && j <= o.middle + half - cell;
}

}  // namespace

bool in_opening(int i, int j) {
  return within(Openings::eye, i, j, 0) || within(Openings::eye, Openings::columns - i, j, 0) ||
         within(Openings::mouth, i, j, 0);
}

bool cell_in_opening(int i, int j) {
  return within(Openings::eye, i, j, 1) || within(Openings::eye, Openings::columns - 1 - i, j, 1) ||
         within(Openings::mouth, i, j, 1);
}

}  // namespace dermis::builtin_head
