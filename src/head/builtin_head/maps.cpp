// SPDX-License-Identifier: MIT
#include "head/builtin_head/maps.h"

#include <algorithm>
#include <array>

#include "base/core/parallel.h"
#include "head/builtin_head/openings.h"

namespace dermis::builtin_head {
namespace {

// The net refined on the sculpture with all its creases: the detail that the normal map adds to the mesh.
// Small maps have about one texel per point; points are the most expensive part of the whole head.
struct FineNet {
  int per_cell = 4;
  int stride = 0;
  std::vector<vec3> at_mm, normal;
  std::vector<Region> region;
};

// A normal that is sampled this near to the surface is the surface's.
constexpr float near_mm = 0.05f;

FineNet refine_on(const Sculpture& bust, const Skin& skin, const Net& net, int map_size) {
  FineNet fine;
  fine.per_cell = std::clamp(map_size / net.columns, 1, 4);
  const int n = fine.per_cell, columns = net.columns * n, rows = net.rows * n;
  fine.stride = columns + 1;
  fine.at_mm.resize(static_cast<std::size_t>(fine.stride * (rows + 1)));
  fine.normal.resize(fine.at_mm.size());
  fine.region.resize(fine.at_mm.size());

  parallel_for(static_cast<std::size_t>(rows + 1), [&](std::size_t row) {
    const int j = std::min(static_cast<int>(row) / n, net.rows - 1);
    const float v = static_cast<float>(row) / static_cast<float>(n) - static_cast<float>(j);
    for (int k = 0; k <= columns; ++k) {
      const int i = std::min(k / n, net.columns - 1);
      const float u = static_cast<float>(k) / static_cast<float>(n) - static_cast<float>(i);
      const auto at = [&](int a, int b) { return net.at_mm[net.index(i + a, j + b)]; };
      const auto normal = [&](int a, int b) { return net.normal[net.index(i + a, j + b)]; };
      const vec3 flat = glm::mix(glm::mix(at(0, 0), at(1, 0), u), glm::mix(at(0, 1), at(1, 1), u), v);
      const vec3 side =
          glm::mix(glm::mix(normal(0, 0), normal(1, 0), u), glm::mix(normal(0, 1), normal(1, 1), u), v);

      const std::size_t self = row * static_cast<std::size_t>(fine.stride) + static_cast<std::size_t>(k);
      if (cell_in_opening(i, j)) {  // lids' edges and lining are where the net has them, and wet
        fine.at_mm[self] = flat;
        fine.normal[self] = glm::normalize(side);
        fine.region[self] = skin.region(flat);
        fine.region[self].lips = 1;
        continue;
      }

      // Steps to the surface; where that was more than a touch, a second step gives the normal.
      vec3 p = flat;
      vec3 g = bust.project(p, Detail::fine, 0.30f, 1);
      if (glm::distance(p, flat) > near_mm) g = bust.project(p, Detail::fine, 0.25f, 1);
      // A crease may be steep, but a normal that points into the mesh is a stray sample.
      const float facing = glm::dot(g, glm::normalize(side));
      if (!(facing > 0.12f)) {
        g = glm::normalize(g + (0.15f - facing) * glm::normalize(side));
        if (!(glm::dot(g, side) > 0)) g = glm::normalize(side);
      }

      fine.at_mm[self] = p;
      fine.normal[self] = g;
      fine.region[self] = skin.region(p);
    }
  });
  return fine;
}

// The position of a texel on the net.
struct Place {
  float x = 0, y = 0;  // in cells
};

// Finds which place of the net the centre of each texel shows.
class Places {
 public:
  Places(const Net& net, int size)
      : net_(net),
        size_(size),
        low_(static_cast<int>(std::ceil(chart_margin * static_cast<float>(size) - 0.5f))),
        high_(size - 1 - low_),
        places_(static_cast<std::size_t>(size) * size) {
    for (int j = 0; j < net.rows; ++j) {
      for (int i = 0; i < net.columns; ++i) {
        draw({vec2(i, j), vec2(i + 1, j), vec2(i + 1, j + 1)});
        draw({vec2(i, j), vec2(i + 1, j + 1), vec2(i, j + 1)});
      }
    }
  }
  /// Texels beyond the chart repeat its border.
  const Place& operator()(int x, int y) const {
    return places_[static_cast<std::size_t>(std::clamp(y, low_, high_)) * size_ +
                   static_cast<std::size_t>(std::clamp(x, low_, high_))];
  }
  int low() const { return low_; }
  int high() const { return high_; }

 private:
  void draw(const std::array<vec2, 3>& nodes);
  const Net& net_;
  int size_, low_, high_;
  std::vector<Place> places_;
};

// A centre on an edge belongs to both triangles, the later wins.
void Places::draw(const std::array<vec2, 3>& nodes) {
  std::array<vec2, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec2& chart = net_.chart[net_.index(static_cast<int>(nodes[k].x), static_cast<int>(nodes[k].y))];
    at[k] = chart_uv(chart) * static_cast<float>(size_) - 0.5f;
  }
  const vec2 ab = at[1] - at[0], ac = at[2] - at[0];
  const float area = ab.x * ac.y - ab.y * ac.x;
  if (area == 0) return;
  constexpr float rounding = -1e-3f;
  const auto first = [&](float a, float b, float c) {
    return std::max(low_, static_cast<int>(std::floor(std::min({a, b, c}))));
  };
  const auto last = [&](float a, float b, float c) {
    return std::min(high_, static_cast<int>(std::ceil(std::max({a, b, c}))));
  };

  for (int y = first(at[0].y, at[1].y, at[2].y); y <= last(at[0].y, at[1].y, at[2].y); ++y) {
    for (int x = first(at[0].x, at[1].x, at[2].x); x <= last(at[0].x, at[1].x, at[2].x); ++x) {
      const vec2 p = vec2(x, y) - at[0];
      const float b = (p.x * ac.y - p.y * ac.x) / area, c = (ab.x * p.y - ab.y * p.x) / area;
      if (std::min({b, c, 1 - b - c}) < rounding) continue;
      const vec2 place = nodes[0] + b * (nodes[1] - nodes[0]) + c * (nodes[2] - nodes[0]);
      places_[static_cast<std::size_t>(y) * size_ + static_cast<std::size_t>(x)] = {
          std::clamp(place.x, 0.0f, static_cast<float>(net_.columns)),
          std::clamp(place.y, 0.0f, static_cast<float>(net_.rows))};
    }
  }
}

// The place of a texel: a point of the sculpture, and the relief over it.
struct Surface {
  vec3 at_mm{0};
  float height_mm = 0;
};

class Baker {
 public:
  Baker(const Sculpture& bust, const Net& net, const scene::Primitive& mesh, int size,
        const Complexion& complexion)
      : skin_(bust, complexion),
        net_(net),
        mesh_(mesh),
        fine_(refine_on(bust, skin_, net, size)),
        places_(net, size),
        size_(size),
        surface_(static_cast<std::size_t>(size) * size) {}

  Maps run() {
    Maps maps;
    for (image::Image8* map : {&maps.colour, &maps.normal, &maps.reflection}) {
      map->width = map->height = size_;
      map->rgba.assign(surface_.size() * 4, 255);
    }
    parallel_for(static_cast<std::size_t>(size_),
                 [&](std::size_t y) { paint_row(static_cast<int>(y), maps); });
    parallel_for(static_cast<std::size_t>(size_),
                 [&](std::size_t y) { normal_row(static_cast<int>(y), maps.normal); });
    return maps;
  }

 private:
  template <class T, class Mix>
  T sample(const std::vector<T>& field, const Place& at, const Mix& mix) const {
    const float x = at.x * static_cast<float>(fine_.per_cell), y = at.y * static_cast<float>(fine_.per_cell);
    const int i = std::min(static_cast<int>(x), fine_.stride - 2),
              j = std::min(static_cast<int>(y), net_.rows * fine_.per_cell - 1);
    const float u = x - static_cast<float>(i), v = y - static_cast<float>(j);
    const T* row = &field[static_cast<std::size_t>(j) * static_cast<std::size_t>(fine_.stride) +
                          static_cast<std::size_t>(i)];
    return mix(mix(row[0], row[1], u), mix(row[fine_.stride], row[fine_.stride + 1], u), v);
  }
  vec3 sample(const std::vector<vec3>& field, const Place& at) const {
    return sample(field, at, [](const vec3& a, const vec3& b, float t) { return a + t * (b - a); });
  }
  void paint_row(int y, Maps& maps);
  void normal_row(int y, image::Image8& map) const;
  vec3 surface_slope(int x, int y) const;
  glm::mat3 mesh_frame(const Place& at) const;

  Skin skin_;
  const Net& net_;
  const scene::Primitive& mesh_;
  FineNet fine_;
  Places places_;
  int size_;
  std::vector<Surface> surface_;
};

std::uint8_t to_byte(float x) { return static_cast<std::uint8_t>(std::clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f); }

// Converts linear to sRGB by a table fine enough for 8 bits: a power per texel would cost as much as the
// noise.
std::uint8_t to_srgb(float linear) {
  static const auto table = [] {
    std::array<std::uint8_t, 4096> t{};
    for (std::size_t i = 0; i < t.size(); ++i) {
      // square root spacing: dense in the dark
      const double x = std::pow((static_cast<double>(i) + 0.5) / 4096.0, 2.0);
      t[i] = to_byte(static_cast<float>(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055));
    }
    return t;
  }();
  return table[std::min<std::size_t>(4095,
                                     static_cast<std::size_t>(std::sqrt(std::max(linear, 0.0f)) * 4096.0f))];
}

void Baker::paint_row(int y, Maps& maps) {
  SkinWalk walk;
  for (int x = 0; x < size_; ++x) {
    const Place& at = places_(x, y);
    const vec3 p = sample(fine_.at_mm, at);
    const Region where = sample(fine_.region, at, blend);
    const SkinPoint s = skin_.paint(p, where, walk);
    std::uint8_t* colour = maps.colour.at(x, y);
    colour[0] = to_srgb(s.albedo.x);
    colour[1] = to_srgb(s.albedo.y);
    colour[2] = to_srgb(s.albedo.z);
    std::uint8_t* reflection = maps.reflection.at(x, y);
    reflection[0] = to_byte(s.specular);
    reflection[1] = to_byte(s.roughness);
    reflection[2] = 0;
    surface_[static_cast<std::size_t>(y) * size_ + x] = {p, s.height_mm};
  }
}

// Returns the gradient of the relief along the surface: the metric of the map converts differences of texels
// to mm.
vec3 Baker::surface_slope(int x, int y) const {
  // One-sided at the borders of the chart, whose neighbours repeat the border.
  const int low = places_.low(), high = places_.high();
  const int xc = std::clamp(x, low, high), yc = std::clamp(y, low, high);
  const int xa = std::max(xc - 1, low), xb = std::min(xc + 1, high), ya = std::max(yc - 1, low),
            yb = std::min(yc + 1, high);
  const auto at = [&](int a, int b) -> const Surface& {
    return surface_[static_cast<std::size_t>(b) * size_ + a];
  };
  const float hx = at(xb, yc).height_mm - at(xa, yc).height_mm,
              hy = at(xc, yb).height_mm - at(xc, ya).height_mm;
  const vec3 px = at(xb, yc).at_mm - at(xa, yc).at_mm, py = at(xc, yb).at_mm - at(xc, ya).at_mm;
  const float e = glm::dot(px, px), f = glm::dot(px, py), g = glm::dot(py, py);
  const float det = std::max(e * g - f * f, 1e-3f * e * g + 1e-12f);
  return ((hx * g - hy * f) * px + (hy * e - hx * f) * py) / det;
}

// Returns tangent, bitangent and normal as a renderer interpolates them over the triangle.
glm::mat3 Baker::mesh_frame(const Place& at) const {
  const int i = std::min(static_cast<int>(at.x), net_.columns - 1),
            j = std::min(static_cast<int>(at.y), net_.rows - 1);
  const float u = at.x - static_cast<float>(i), v = at.y - static_cast<float>(j);
  const bool lower = u >= v;  // the diagonal of a cell runs from (0, 0) to (1, 1)
  const scene::Vertex& a = mesh_.vertices[net_.index(i, j)];
  const scene::Vertex& b = mesh_.vertices[lower ? net_.index(i + 1, j) : net_.index(i, j + 1)];
  const scene::Vertex& c = mesh_.vertices[net_.index(i + 1, j + 1)];
  const float wc = lower ? v : u, wb = lower ? u - v : v - u, wa = 1 - wb - wc;
  const vec3 n = glm::normalize(wa * a.normal + wb * b.normal + wc * c.normal);
  vec3 t = wa * vec3(a.tangent) + wb * vec3(b.tangent) + wc * vec3(c.tangent);
  t = glm::normalize(t - n * glm::dot(n, t));
  return {t, glm::cross(n, t) * a.tangent.w, n};
}

void Baker::normal_row(int y, image::Image8& map) const {
  for (int x = 0; x < size_; ++x) {
    const Place& at = places_(x, y);
    const vec3 n = glm::normalize(glm::normalize(sample(fine_.normal, at)) - surface_slope(x, y));
    const glm::mat3 frame = mesh_frame(at);
    vec3 local = n * frame;  // row vector times matrix: the three dot products
    local.z = std::max(local.z, 0.05f);
    local = glm::normalize(local);
    std::uint8_t* out = map.at(x, y);
    for (int c = 0; c < 3; ++c) out[c] = to_byte(local[c] * 0.5f + 0.5f);
  }
}

}  // namespace

std::uint8_t linear_to_srgb8(float linear) { return to_srgb(linear); }

Maps bake(const Sculpture& bust, const Net& net, const scene::Primitive& mesh, int map_size,
          const Complexion& complexion) {
  return Baker(bust, net, mesh, map_size, complexion).run();
}

}  // namespace dermis::builtin_head
