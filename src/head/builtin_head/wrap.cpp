// SPDX-License-Identifier: MIT
#include "head/builtin_head/wrap.h"

#include "base/core/parallel.h"
#include "head/builtin_head/openings.h"

namespace dermis::builtin_head {
namespace {

// One row runs along the rim of the cut, so that the edge is clean.
constexpr int rim_part = 30;
// The seam runs from the cut up the back of the head and ends on the crown.
const vec3 seam_end(0, 113, 18);
// Height of the rim over the cut.
constexpr float rim_mm = 1.0f;

// Returns the pull of the threads: where it is high the net contracts.
float pull(const vec3& p, const Frame& ear) {
  const auto near = [&](const vec3& c, const vec3& r) {
    const vec3 q = (p - c) / r;
    return faded(glm::dot(q, q));
  };
  const vec3 m(std::abs(p.x), p.y, p.z);
  const vec3 e = (vec3(m.x, m.y, m.z) - ear.origin) / vec3(20, 36, 30);
  float w = 0.45f + 0.55f * near({0, -30, 95}, {62, 75, 55}) + 0.22f * near({0, 42, 90}, {60, 38, 60});
  w += 2.6f * near({31, -1, 78}, {23, 17, 30}) + 1.1f * near({0, -69, 97}, {31, 16, 30}) +
       2.0f * near({0, -38, 108}, {23, 20, 34}) + 0.45f * near({50, -30, 66}, {26, 30, 34});
  w += 1.2f * faded(glm::dot(e, e) * glm::dot(e, e));
  // Averaging makes the net sparse on a sharp ridge, so the rim of the ear pulls more.
  const vec3 local = ear.to_local(m);
  const float ring = (glm::length(vec2(local.x - 1.5f, local.y - 1.0f) / vec2(18.0f, 31.0f)) - 1.0f) / 0.16f,
              level = (local.z - 3.0f) / 6.0f;
  w += 1.6f * faded(ring * ring + level * level);
  // The threads shorten with the square root of their weight (see balance).
  return w * w;
}

// Maps the square to a disc (elliptical grid map), the disc to a hemisphere of equal area, and doubles
// longitudes: the whole sphere, cut at the back.
vec3 sphere_direction(float s, float t) {
  const float x = s * std::sqrt(1.0f - 0.5f * t * t), y = t * std::sqrt(1.0f - 0.5f * s * s);
  const float r = std::min(std::sqrt(x * x + y * y), 1.0f);
  // Sine of the angle from the front of the hemisphere, 2 asin(r / sqrt 2).
  const float sine = r * std::sqrt(2.0f - r * r);
  const float k = r > 1e-6f ? sine / r : std::sqrt(2.0f);
  const vec3 h(x * k, y * k, 1.0f - r * r);
  const float longitude = 2.0f * std::atan2(h.x, std::max(h.z, 0.0f)),
              ring = std::sqrt(h.x * h.x + h.z * h.z);
  return {ring * std::sin(longitude), h.y, ring * std::cos(longitude)};
}

// The part of the net under the cut hangs on its rim: from there to a line along the middle, on which the
// lower side is folded.
void lay_cap(Net& net) {
  const int rim_row = net.rows / rim_part;
  vec3 middle(0);
  for (int i = 0; i < net.columns; ++i)
    middle += net.at_mm[net.index(i, rim_row)] / static_cast<float>(net.columns);

  for (int i = 0; i <= net.columns; ++i) {
    const vec3 rim = net.at_mm[net.index(i, rim_row)];
    // Evenly from behind to the front, the same for both halves.
    const float along =
        static_cast<float>(std::min(i, net.columns - i)) / (0.5f * static_cast<float>(net.columns));
    const vec3 spine =
        glm::mix(net.at_mm[net.index(0, rim_row)], net.at_mm[net.index(net.columns / 2, rim_row)], along);
    vec3 line = middle + 0.75f * (spine - middle);
    line.y = 0;

    for (int j = 0; j < rim_row; ++j) {
      const float inwards = 1.0f - static_cast<float>(j) / static_cast<float>(rim_row);
      vec3& p = net.at_mm[net.index(i, j)];
      p = glm::mix(rim, line, inwards * std::sqrt(inwards));
      p.y = Sculpture::cut_mm(p.x, p.z);
    }
  }
}

// The net tends to draw together on one side of the face at the other's expense; as long as it is coarse its
// halves are made equal.
void balance_halves(Net& net) {
  for (int j = 0; j <= net.rows; ++j) {
    for (int i = 0; i <= net.columns / 2; ++i) {
      vec3 &left = net.at_mm[net.index(net.columns - i, j)], &right = net.at_mm[net.index(i, j)];
      const vec3 mean = 0.5f * (left + vec3(-right.x, right.y, right.z));
      left = mean;
      right = {-mean.x, mean.y, mean.z};
    }
  }
}

void close_seam(Net& net) {
  for (int j = 0; j <= net.rows; ++j) net.at_mm[net.index(net.columns, j)] = net.at_mm[net.index(0, j)];
  for (const int j : {0, net.rows}) {
    for (int i = 0; i < net.columns / 2; ++i)
      net.at_mm[net.index(net.columns - i, j)] = net.at_mm[net.index(i, j)];
  }
}

Net first_net(const Sculpture& bust, int columns, int rows) {
  Net net{columns, rows, std::vector<vec3>(static_cast<std::size_t>((columns + 1) * (rows + 1))), {}, {}};
  const vec3 middle(0, -35, -5);

  parallel_for(static_cast<std::size_t>(rows + 1), [&](std::size_t row) {
    const int j = static_cast<int>(row);
    for (int i = 0; i <= columns; ++i) {
      const vec3 d = sphere_direction(2.0f * static_cast<float>(i) / static_cast<float>(columns) - 1.0f,
                                      2.0f * static_cast<float>(j) / static_cast<float>(rows) - 1.0f);

      // of a ray from the middle; the bust is star-shaped enough for that at this size
      float inside = 0, outside = 1;
      const vec3 reach = d * vec3(170, 240, 200);
      for (int k = 0; k < 16; ++k) {
        const float t = 0.5f * (inside + outside);
        (bust.field(middle + t * reach, Detail::blunt) < 0 ? inside : outside) = t;
      }
      net.at_mm[net.index(i, j)] = middle + inside * reach;
    }
  });

  close_seam(net);
  return net;
}

Net refine(const Net& coarse, int columns, int rows) {
  Net net{columns, rows, std::vector<vec3>(static_cast<std::size_t>((columns + 1) * (rows + 1))), {}, {}};
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const float x = static_cast<float>(i * coarse.columns) / static_cast<float>(columns),
                  y = static_cast<float>(j * coarse.rows) / static_cast<float>(rows);
      const int a = std::min(static_cast<int>(x), coarse.columns - 1),
                b = std::min(static_cast<int>(y), coarse.rows - 1);
      const float u = x - static_cast<float>(a), v = y - static_cast<float>(b);
      const auto at = [&](int k, int l) { return coarse.at_mm[coarse.index(a + k, b + l)]; };
      net.at_mm[net.index(i, j)] =
          glm::mix(glm::mix(at(0, 0), at(1, 0), u), glm::mix(at(0, 1), at(1, 1), u), v);
    }
  }
  close_seam(net);
  return net;
}

// Returns where the threads pull node (i, j). A longer thread pulls harder than in proportion, which keeps
// the net dense on nose and ears.
vec3 balance(const Net& net, const std::vector<float>& weight, int i, int j) {
  const std::size_t self = net.index(i, j);
  vec3 sum(0);
  float total = 0;
  const auto thread = [&](int di, int dj, float share) {
    const std::size_t other = net.folded(i + di, j + dj);
    const float w =
        share * (weight[self] + weight[other]) * (0.2f + glm::distance(net.at_mm[self], net.at_mm[other]));
    sum += w * net.at_mm[other];
    total += w;
  };
  thread(1, 0, 1), thread(-1, 0, 1);
  // The fold over the crown and the rim are cords that the net hangs on. They keep their length, or the end
  // of the fold would be drawn down to the forehead and the rim would bunch up behind.
  if (j == net.rows / rim_part || (j == net.rows && i % net.columns != 0)) return sum / total;
  thread(0, 1, 1), thread(0, -1, 1);
  thread(1, 1, 0.25f), thread(-1, -1, 0.25f), thread(-1, 1, 0.25f), thread(1, -1, 0.25f);
  return sum / total;
}

vec3 to_rim(const Sculpture& bust, vec3 p) {
  for (int k = 0; k < 3; ++k) {
    p.y = Sculpture::cut_mm(p.x, p.z) + rim_mm;
    const vec3 out = glm::normalize(vec3(p.x, 0, p.z + 40.0f));
    const float h = 0.5f, f = bust.uncut(p, Detail::form);
    const float slope = (bust.uncut(p + h * out, Detail::form) - f) / h;
    p -= out * std::clamp(f / std::max(slope, 0.3f), -6.0f, 6.0f);
  }
  p.y = Sculpture::cut_mm(p.x, p.z) + rim_mm;
  return p;
}

void relax(Net& net, const Sculpture& bust, const Openings& openings, Detail detail, int rounds,
           float eps_mm) {
  std::vector<vec3> next(net.at_mm.size());
  std::vector<float> weight(net.at_mm.size());
  if (net.normal.empty()) net.normal.resize(net.at_mm.size(), vec3(0));
  const int rim_row = net.rows / rim_part, step_of_nodes = Openings::columns / net.columns;
  openings.place(net);

  for (int round = 0; round < rounds; ++round) {
    parallel_for(static_cast<std::size_t>(net.rows + 1), [&](std::size_t row) {
      for (int i = 0; i <= net.columns; ++i) {
        const std::size_t k = net.index(i, static_cast<int>(row));
        weight[k] = pull(net.at_mm[k], bust.ear_frame());
      }
    });
    parallel_for(static_cast<std::size_t>(net.rows + 1), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i <= net.columns; ++i) {
        const std::size_t self = net.index(i, j);
        vec3 p = net.at_mm[self];

        // See lay_cap and Openings::place.
        if (j < rim_row || in_opening(i * step_of_nodes, j * step_of_nodes)) {
          next[self] = p;
          continue;
        }
        if (j == rim_row) {
          p = glm::mix(p, balance(net, weight, i, j), 0.4f);
          if (2 * i % net.columns == 0) p.x = 0;
          next[self] = to_rim(bust, p);
          continue;
        }

        vec3 step = 0.4f * (balance(net, weight, i, j) - p);
        step -= net.normal[self] * glm::dot(net.normal[self], step);
        if (i % net.columns == 0 || j == net.rows) step.x = -p.x;
        if (j == net.rows && i == net.columns / 2) step = seam_end - p;
        p += step;

        const vec3 side = mesh_normal(net, i, j);
        const float f = round % 3 == 0 ? bust.field(p, detail) : 0.0f;
        // Deep inside a thin part the gradient may lead through it: there the net's own side decides.
        if (f < -2.0f) p += side * std::min(-f, 4.0f);
        const vec3 before = p;
        const vec3 n = bust.project(p, detail, eps_mm, 1);
        // Where the net has folded or slipped to the other side, it may leave the surface until it is smooth
        // again.
        if (round + 3 < rounds && glm::dot(n, side) < 0.25f)
          p = glm::mix(before, balance(net, weight, i, j), 0.7f);

        net.normal[self] = n;
        next[self] = p;
      }
    });

    std::swap(net.at_mm, next);
    lay_cap(net);
    if (eps_mm > 1.0f) balance_halves(net);
    openings.place(net);
    close_seam(net);
  }
}

}  // namespace

vec3 mesh_normal(const Net& net, int i, int j) {
  const auto at = [&](int k, int l) { return net.at_mm[net.folded(k, l)]; };
  const vec3 n = glm::cross(at(i + 1, j) - at(i - 1, j), at(i, j + 1) - at(i, j - 1));
  const float length = glm::length(n);
  return length > 1e-6f ? n / length : vec3(0);  // zero where the net is folded
}

std::size_t Net::folded(int i, int j) const {
  if (i < 0) i += columns;
  if (i > columns) i -= columns;
  if (j > rows || j < 0) {
    i = columns - i;
    j = j < 0 ? -j : 2 * rows - j;
  }
  return index(i, j);
}

Net wrap(const Sculpture& bust) {
  constexpr int columns = Openings::columns, rows = Openings::rows;
  static_assert(columns % 8 == 0 && rows % (4 * rim_part) == 0);
  const Openings openings(bust);
  Net net = first_net(bust, columns / 4, rows / 4);

  // Coarse nets are drawn over the blunt bust, the hollows last: a net that enters an ear before it is fine
  // enough jumps over its rim.
  relax(net, bust, openings, Detail::blunt, 120, 5.0f);
  relax(net, bust, openings, Detail::blunt, 80, 4.0f);
  net = refine(net, columns / 2, rows / 2);
  relax(net, bust, openings, Detail::blunt, 60, 3.0f);
  net = refine(net, columns, rows);
  relax(net, bust, openings, Detail::blunt, 8, 2.0f);
  relax(net, bust, openings, Detail::form, 14, 1.2f);
  relax(net, bust, openings, Detail::form, 11, 0.8f);

  for (int k = 0; k < 2; ++k) {
    parallel_for(static_cast<std::size_t>(rows + 1), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i <= columns; ++i) {
        if (in_opening(i, j)) continue;
        const std::size_t self = net.index(i, j);
        net.normal[self] = bust.project(net.at_mm[self], Detail::form, 0.6f, 1);
      }
    });
    close_seam(net);
  }

  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      if (!in_opening(i, j)) continue;
      const vec3 n = mesh_normal(net, i, j);
      net.normal[net.index(i, j)] = n == vec3(0) ? vec3(0, 0, 1) : n;
    }
  }
  return net;
}

}  // namespace dermis::builtin_head
