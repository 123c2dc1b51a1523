// SPDX-License-Identifier: MIT
// The built-in head: closed, evenly unwrapped, seamless, the same on every run, and shaped like a head.
#include "head/builtin_head/builtin_head.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "dermis/error.h"
#include "head/scene/surface/coverage.h"
#include "head/scene/surface/unwrap.h"

namespace dermis::scene {
namespace {

using glm::dvec3;
using glm::vec2;
using glm::vec3;

constexpr int test_map_size = 256;

const AssetData& head() {
  static const AssetData scene = builtin_head::make({test_map_size});
  return scene;
}
const Primitive& mesh() { return head().primitives.front(); }

const Primitive& part(std::string_view name) {
  for (const Primitive& p : head().primitives) {
    if (p.name == name) return p;
  }
  throw std::runtime_error("no part of that name");
}

std::uint64_t fnv(std::uint64_t h, const void* data, std::size_t bytes) {
  const auto* p = static_cast<const unsigned char*>(data);
  for (std::size_t i = 0; i < bytes; ++i) h = (h ^ p[i]) * 1099511628211ull;
  return h;
}

std::uint64_t hash(const AssetData& scene) {
  std::uint64_t h = 14695981039346656037ull;
  for (const Primitive& part : scene.primitives) {
    for (const Vertex& v : part.vertices) {
      h = fnv(h, &v.position_m, sizeof v.position_m);
      h = fnv(h, &v.normal, sizeof v.normal);
      h = fnv(h, &v.tangent, sizeof v.tangent);
      h = fnv(h, &v.uv0, sizeof v.uv0);
    }
    h = fnv(h, part.indices.data(), part.indices.size() * sizeof(std::uint32_t));
  }
  for (const MapImage& image : scene.images) h = fnv(h, image.pixels->rgba.data(), image.pixels->rgba.size());
  return h;
}

vec3 texel(const image::Image8& map, const vec2& uv) {
  const auto at = [](float c, int n) { return std::min(n - 1, static_cast<int>(c * static_cast<float>(n))); };
  const std::uint8_t* p = map.at(at(uv.x, map.width), at(uv.y, map.height));
  return {p[0], p[1], p[2]};
}

using Key = std::array<float, 3>;
Key key(std::uint32_t i) {
  const vec3& p = mesh().vertices[i].position_m;
  return {p.x, p.y, p.z};
}

// Frontmost z [mm] of the triangles that the line x, y (mm) along z crosses; -1000 if none.
double front_mm(double x, double y) {
  double front = -1000;
  const Primitive& m = mesh();
  for (std::size_t t = 0; t < m.indices.size(); t += 3) {
    std::array<dvec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = dvec3(m.vertices[m.indices[t + k]].position_m) * 1000.0;
    const auto side = [&](const dvec3& a, const dvec3& b) {
      return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
    };
    const double u = side(p[1], p[2]), v = side(p[2], p[0]), w = side(p[0], p[1]), sum = u + v + w;
    if (std::abs(sum) < 1e-12 || u * sum < 0 || v * sum < 0 || w * sum < 0) continue;
    front = std::max(front, (u * p[0].z + v * p[1].z + w * p[2].z) / sum);
  }
  return front;
}

TEST(BuiltinHead, IsOneSkinPrimitiveWithEyesOf25000To40000Triangles) {
  std::size_t triangles = 0, skins = 0;
  std::set<std::string> names;
  for (const Primitive& part : head().primitives) {
    ASSERT_LT(static_cast<std::size_t>(part.material), head().materials.size());
    EXPECT_TRUE(part.has_uv) << part.name;
    for (const std::uint32_t i : part.indices) ASSERT_LT(i, part.vertices.size()) << part.name;
    triangles += part.indices.size() / 3;
    skins += head().materials[static_cast<std::size_t>(part.material)].skin;
    names.insert(part.name);
  }
  EXPECT_EQ(skins, 1u);
  EXPECT_GE(triangles, 25000u);
  std::printf("%zu triangles\n", triangles);
  EXPECT_LE(triangles, 40000u);
  for (const char* part : {"eyes", "caruncles", "tears"}) EXPECT_TRUE(names.contains(part)) << part;

  const Material& skin = head().materials.front();
  EXPECT_TRUE(skin.skin);
  EXPECT_EQ(skin.name, "skin");
  EXPECT_FLOAT_EQ(skin.ior, 1.4f);
  EXPECT_FALSE(skin.skin_settings.mix.has_value());

  for (const MapRef* ref : {&skin.base_colour_map, &skin.normal_map, &skin.skin_settings.specular,
                            &skin.skin_settings.roughness}) {
    ASSERT_TRUE(ref->present());
    ASSERT_LT(static_cast<std::size_t>(ref->image), head().images.size());
  }

  for (const MapImage& image : std::span(head().images).first(3)) {
    EXPECT_EQ(image.pixels->width, test_map_size);
    EXPECT_EQ(image.pixels->height, test_map_size);
    EXPECT_EQ(image.pixels->rgba.size(), static_cast<std::size_t>(test_map_size) * test_map_size * 4);
  }
}

TEST(BuiltinHead, VerticesAreSound) {
  for (const Vertex& v : mesh().vertices) {
    ASSERT_NEAR(glm::length(v.normal), 1, 1e-4);
    ASSERT_NEAR(glm::length(vec3(v.tangent)), 1, 1e-4);
    ASSERT_NEAR(glm::dot(v.normal, vec3(v.tangent)), 0, 1e-3);
    ASSERT_EQ(v.tangent.w, 1);
    ASSERT_GT(std::min(v.uv0.x, v.uv0.y), 0);
    ASSERT_LT(std::max(v.uv0.x, v.uv0.y), 1);
  }
}

TEST(BuiltinHead, HasTheSizeOfABustAndItsMiddleAtTheOrigin) {
  vec3 low(1e9f), high(-1e9f);
  for (const Vertex& v : mesh().vertices) {
    low = glm::min(low, v.position_m);
    high = glm::max(high, v.position_m);
  }
  const vec3 size = high - low, middle = 0.5f * (low + high);
  EXPECT_NEAR(size.y, 0.32f, 0.01f);
  EXPECT_NEAR(size.x, 0.18f, 0.04f);
  EXPECT_NEAR(size.z, 0.215f, 0.02f);
  EXPECT_LT(glm::length(middle), 0.02f);
}

TEST(BuiltinHead, IsClosed) {
  std::map<std::pair<Key, Key>, int> edges;
  for (std::size_t t = 0; t < mesh().indices.size(); t += 3) {
    const std::array<Key, 3> k = {key(mesh().indices[t]), key(mesh().indices[t + 1]),
                                  key(mesh().indices[t + 2])};
    if (k[0] == k[1] || k[1] == k[2] || k[2] == k[0]) continue;
    for (std::size_t e = 0; e < 3; ++e) ++edges[std::minmax(k[e], k[(e + 1) % 3])];
  }
  int open = 0;
  for (const auto& [edge, uses] : edges) open += uses != 2;
  EXPECT_EQ(open, 0);
}

TEST(BuiltinHead, TrianglesFaceOutwardsAndHaveArea) {
  int degenerate = 0, turned = 0;
  const Primitive& m = mesh();
  for (std::size_t t = 0; t < m.indices.size(); t += 3) {
    const Vertex &a = m.vertices[m.indices[t]], &b = m.vertices[m.indices[t + 1]],
                 &c = m.vertices[m.indices[t + 2]];
    const vec3 n = glm::cross(b.position_m - a.position_m, c.position_m - a.position_m);
    degenerate += glm::length(n) < 2e-9f;  // mm^2 / 500
    turned += glm::dot(n, a.normal + b.normal + c.normal) < 0;
  }
  EXPECT_LE(degenerate, 5);
  EXPECT_LE(turned, 20);  // in the ears' folds
}

TEST(BuiltinHead, UnwrapDoesNotOverlapAndKeepsTheFaceDense) {
  const std::vector<SkinMesh> skins = skin_meshes(head());
  ASSERT_EQ(skins.size(), 1u);
  EXPECT_EQ(skins.front().charts, 1);
  EXPECT_LT(uv_overlap_fraction(skins.front(), 1024), 0.0005);
  EXPECT_GT(uv_area_sum(skins.front()), 0.9);

  const UnwrapDensity density = unwrap_density(skins.front(), head().mm_per_unit);
  EXPECT_NEAR(density.area_mm2, 190000, 25000);
  EXPECT_LT(density.uv_per_mm.p95, 2.5 * density.uv_per_mm.p50);
  EXPECT_LT(density.largest_uv_per_mm.p95, 4 * density.uv_per_mm.p50);

  // On the face at least three texels per mm of a map of 2048.
  double face = 0, area = 0;
  const Primitive& m = mesh();
  for (std::size_t t = 0; t < m.indices.size(); t += 3) {
    const Vertex &a = m.vertices[m.indices[t]], &b = m.vertices[m.indices[t + 1]],
                 &c = m.vertices[m.indices[t + 2]];
    if (a.position_m.z < 0.06f || a.position_m.y < -0.08f) continue;
    area += 0.5e6 * static_cast<double>(
                        glm::length(glm::cross(b.position_m - a.position_m, c.position_m - a.position_m)));
    const vec2 u = b.uv0 - a.uv0, v = c.uv0 - a.uv0;
    face += 0.5 * static_cast<double>(std::abs(u.x * v.y - u.y * v.x)) * 2048 * 2048;
  }
  std::printf("%.1f texels per mm on the face, of maps of 2048\n", std::sqrt(face / area));
  EXPECT_GT(std::sqrt(face / area), 3);
}

// Lengths of the skin along and across, over those of the map: the ratio of both, worst direction to best.
TEST(BuiltinHead, UnwrapStretchesHardlyAnySkinBeyond3To1) {
  const Primitive& m = mesh();
  double area = 0, even = 0;
  for (std::size_t t = 0; t < m.indices.size(); t += 3) {
    const Vertex &a = m.vertices[m.indices[t]], &b = m.vertices[m.indices[t + 1]],
                 &c = m.vertices[m.indices[t + 2]];
    const dvec3 g = triangle_metric(a.position_m, b.position_m, c.position_m, a.uv0, b.uv0, c.uv0);
    const double mean = 0.5 * (g.x + g.z), apart = std::hypot(0.5 * (g.x - g.z), g.y);
    const double here = 0.5 * static_cast<double>(glm::length(
                                  glm::cross(b.position_m - a.position_m, c.position_m - a.position_m)));
    area += here;
    if (mean + apart < 9 * (mean - apart)) even += here;
  }
  std::printf("%.1f %% of the skin is stretched less than 3:1\n", 100 * even / area);
  EXPECT_GT(even, 0.95 * area);
}

TEST(BuiltinHead, TheSeamOfTheUnwrapIsAtTheBack) {
  std::map<Key, std::vector<std::uint32_t>> places;
  for (std::uint32_t i = 0; i < mesh().vertices.size(); ++i) places[key(i)].push_back(i);
  int pairs = 0;
  for (const auto& [place, ids] : places) {
    if (ids.size() < 2 || mesh().vertices[ids[0]].uv0 == mesh().vertices[ids[1]].uv0) continue;
    ++pairs;
    // From the crown over the back to the underside of the bust.
    EXPECT_LT(std::abs(place[0]), 0.01f);
    EXPECT_TRUE(place[2] < 0 || place[1] > 0.13f || place[1] < -0.16f) << place[1] << " " << place[2];
  }
  EXPECT_GT(pairs, 100);
}

TEST(BuiltinHead, LooksLikeAFace) {
  // Heights in mm above the eyes, which lie 35 mm above the origin.
  const auto depth = [](double x, double above_eyes) { return front_mm(x, above_eyes + 35); };
  const double tip = depth(0, -37), root = depth(0, 3), brow = depth(0, 18), lips = depth(0, -73),
               chin = depth(0, -102), groove = depth(0, -87);

  EXPECT_GT(tip, root + 20) << "nose";
  EXPECT_GT(brow, root + 2) << "brow";
  EXPECT_GT(tip, depth(17, -20) + 20) << "nose against cheek";
  EXPECT_GT(lips, groove + 4) << "lower lip";
  EXPECT_GT(chin, groove + 1) << "chin";
  EXPECT_GT(tip, lips + 8);

  // The cornea stands before both corners of the lids and behind the brow, and the lids do not hide it.
  for (const float side : {1.0f, -1.0f}) {
    double cornea = -1000;
    for (const Vertex& v : part("eyes").vertices) {
      if (side * v.position_m.x > 0) cornea = std::max(cornea, 1000.0 * static_cast<double>(v.position_m.z));
    }
    EXPECT_GT(cornea, depth(side * 17, -4) + 1.5) << "inner corner";
    EXPECT_GT(cornea, depth(side * 48, -1) + 8) << "outer corner";
    EXPECT_LT(cornea, brow);
    EXPECT_GT(cornea, depth(side * 31.4, 0) + 8) << "an open eye";
  }

  // Ears stand out at the side, between brow and nose, and nowhere else.
  float ear = 0, temple = 0;
  for (const Vertex& v : mesh().vertices) {
    const vec3 p = v.position_m * 1000.0f - vec3(0, 35, 0);
    if (p.y > -46 && p.y < 20 && p.z < 10 && p.z > -45) ear = std::max(ear, std::abs(p.x));
    if (p.y > 30) temple = std::max(temple, std::abs(p.x));
  }
  EXPECT_GT(ear, temple + 6);
}

TEST(BuiltinHead, NostrilsAreHollow) {
  // Looking up from below: the surface beside the columella lies deeper than the columella itself.
  const auto lowest = [](double x, double z) {
    double low = 1000;
    const Primitive& m = mesh();
    for (std::size_t t = 0; t < m.indices.size(); t += 3) {
      std::array<dvec3, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = dvec3(m.vertices[m.indices[t + k]].position_m) * 1000.0;
      if (p[0].y < -20 || p[0].y > 40) continue;  // only the nose is above

      // Weigh the corners at (x, z); outside the triangle one weight has the other sign than the sum.
      const auto side = [&](const dvec3& a, const dvec3& b) {
        return (b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x);
      };
      const double u = side(p[1], p[2]), v = side(p[2], p[0]), w = side(p[0], p[1]), sum = u + v + w;
      if (std::abs(sum) < 1e-12 || u * sum < 0 || v * sum < 0 || w * sum < 0) continue;
      low = std::min(low, (u * p[0].y + v * p[1].y + w * p[2].y) / sum);
    }
    return low;
  };

  const double columella = lowest(0, 104);
  EXPECT_GT(lowest(7.5, 104), columella + 2);
  EXPECT_GT(lowest(-7.5, 104), columella + 2);
}

TEST(BuiltinHead, ColourIsSkinAndVaries) {
  const image::Image8& colour =
      *head().images[static_cast<std::size_t>(head().materials.front().base_colour_map.image)].pixels;

  std::set<std::uint32_t> different;
  double red = 0, green = 0, blue = 0;
  for (std::size_t i = 0; i < colour.rgba.size(); i += 4) {
    red += colour.rgba[i];
    green += colour.rgba[i + 1];
    blue += colour.rgba[i + 2];
    different.insert(
        static_cast<std::uint32_t>(colour.rgba[i] << 16 | colour.rgba[i + 1] << 8 | colour.rgba[i + 2]));
    ASSERT_EQ(colour.rgba[i + 3], 255);
  }

  EXPECT_GT(red, 1.1 * green);
  EXPECT_GT(green, 1.05 * blue);
  EXPECT_GT(different.size(), 1200u);

  // Redness (red over green) at a place of the face, mm.
  const auto redness = [&](const vec3& near_mm) {
    const Vertex* best = nullptr;
    float distance = 1e9f;
    for (const Vertex& v : mesh().vertices) {
      const float d = glm::distance(v.position_m * 1000.0f - vec3(0, 35, 0), near_mm);
      if (d < distance) {
        distance = d;
        best = &v;
      }
    }
    const vec3 c = texel(colour, best->uv0);
    return c.x / c.y;
  };

  const float forehead = redness({0, 45, 92});
  EXPECT_GT(redness({8, -73, 100}), 1.10f * forehead) << "lips";
  EXPECT_GT(redness({0, -37, 117}), 1.03f * forehead) << "tip of the nose";
}

TEST(BuiltinHead, ColourMeetsAcrossTheSeam) {
  // Vertices that share a place but not their texture coordinates are the seam.
  const image::Image8& colour = *head().images.front().pixels;
  std::map<Key, std::vector<std::uint32_t>> places;
  for (std::uint32_t i = 0; i < mesh().vertices.size(); ++i) places[key(i)].push_back(i);
  int pairs = 0, far_apart = 0;
  for (const auto& [place, ids] : places) {
    for (std::size_t k = 1; k < ids.size(); ++k) {
      const vec3 d =
          glm::abs(texel(colour, mesh().vertices[ids[0]].uv0) - texel(colour, mesh().vertices[ids[k]].uv0));
      ++pairs;
      // a texel of 256 spans up to 4 mm, stubble and freckles are smaller
      far_apart += std::max({d.x, d.y, d.z}) > 24;
      ASSERT_GT(glm::dot(mesh().vertices[ids[0]].normal, mesh().vertices[ids[k]].normal), 0.9999f);
    }
  }
  EXPECT_GT(pairs, 100);
  EXPECT_LT(far_apart, pairs / 10);
}

TEST(BuiltinHead, NormalSpecularAndRoughnessMapsAreWithinTheirRanges) {
  const Material& skin = head().materials.front();
  const image::Image8& normal = *head().images[static_cast<std::size_t>(skin.normal_map.image)].pixels;
  const MapRef &specular = skin.skin_settings.specular, &roughness = skin.skin_settings.roughness;
  const image::Image8& gloss = *head().images[static_cast<std::size_t>(specular.image)].pixels;

  std::size_t flat = 0, texels = 0;
  for (std::size_t i = 0; i < normal.rgba.size(); i += 4) {
    const vec3 n = vec3(normal.rgba[i], normal.rgba[i + 1], normal.rgba[i + 2]) / 127.5f - 1.0f;
    ASSERT_NEAR(glm::length(n), 1, 0.02);
    ASSERT_GT(n.z, 0);
    flat += n.z > 0.9f;
    ++texels;

    const int s = gloss.rgba[i + static_cast<std::size_t>(specular.channel)],
              r = gloss.rgba[i + static_cast<std::size_t>(roughness.channel)];
    ASSERT_GE(s, 50);
    ASSERT_GE(r, 0.40 * 255);
    ASSERT_LE(r, 0.70 * 255);
  }

  EXPECT_GT(flat, texels * 8 / 10);
  EXPECT_LT(flat, texels);
}

TEST(BuiltinHead, IsTheSameOnEveryRun) { EXPECT_EQ(hash(head()), hash(builtin_head::make({test_map_size}))); }

TEST(BuiltinHead, RefusesMapSizesThatAreNoPowerOfTwoFrom64To4096) {
  for (const int size : {0, -64, 32, 100, 8192}) EXPECT_THROW(builtin_head::make({size}), InputError) << size;
}

}  // namespace
}  // namespace dermis::scene
