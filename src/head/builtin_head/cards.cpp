// SPDX-License-Identifier: MIT
// Brows and lashes: strips of cards with one map of hairs, its alpha their coverage.
#include <algorithm>
#include <array>

#include "base/core/parallel.h"
#include "head/builtin_head/hair.h"
#include "head/builtin_head/landmarks.h"
#include "head/builtin_head/maps.h"
#include "head/builtin_head/noise.h"
#include "head/builtin_head/openings.h"
#include "head/builtin_head/parts.h"

namespace dermis::builtin_head {
namespace {

// The map: the brow above (its box on the face, mm), the upper and the lower lashes below it, root to tip
// downwards.
constexpr vec2 brow_low(6.0f, 6.0f), brow_high(60.0f, 33.0f);
constexpr float brow_v = 0.5f;  // it ends here
struct Band {
  float root_v, tip_v;
};
constexpr Band upper_band{0.53f, 0.76f}, lower_band{0.80f, 0.96f};

// Draws one hair into the alpha of the map: a parabola from root to tip, tapered.
void draw_lash(image::Image8& map, const vec2& root, const vec2& tip, float bend, float width) {
  constexpr int pieces = 7;
  const auto at = [&](float t) { return glm::mix(root, tip, t) + vec2(bend * 4 * t * (1 - t), 0); };
  for (int k = 0; k < pieces; ++k) {
    const float t0 = static_cast<float>(k) / pieces, t1 = static_cast<float>(k + 1) / pieces;
    const vec2 a = at(t0), ab = at(t1) - a;
    const float reach = width + 1.5f;
    const vec2 low = glm::min(a, a + ab) - reach, high = glm::max(a, a + ab) + reach;
    for (int y = std::max(0, static_cast<int>(low.y));
         y <= std::min(map.height - 1, static_cast<int>(high.y)); ++y) {
      for (int x = std::max(0, static_cast<int>(low.x));
           x <= std::min(map.width - 1, static_cast<int>(high.x)); ++x) {
        const vec2 ap = vec2(x, y) + 0.5f - a;
        const float t = std::clamp(glm::dot(ap, ab) / std::max(glm::dot(ab, ab), 1e-6f), 0.0f, 1.0f);
        const float half = 0.5f * width * (1.0f - 0.85f * (t0 + t * (t1 - t0)));
        const float edge = std::max(half, 0.5f);
        const float cover =
            half / edge * (1 - smooth_step(edge - 0.5f, edge + 0.5f, glm::length(ap - t * ab)));
        std::uint8_t& alpha = map.at(x, y)[3];
        alpha = std::max(alpha, static_cast<std::uint8_t>(255.0f * std::min(cover, 1.0f)));
      }
    }
  }
}

void draw_lashes(image::Image8& map, const Band& band, int count, int kind) {
  const float w = static_cast<float>(map.width), h = static_cast<float>(map.height);
  for (int n = 0; n < count; ++n) {
    const auto dice = [&](int k) { return unit(lattice_hash(n, k, kind, 877)); };
    const float u = 0.03f + 0.94f * (static_cast<float>(n) + dice(0)) / static_cast<float>(count);
    // Lashes gather in small tufts, and are shorter towards both corners.
    const float tuft = 0.012f * std::sin(u * 75.0f);
    const float length = (0.60f + 0.36f * dice(1)) * (0.45f + 0.55f * smooth_step(0.0f, 0.35f, u)) *
                         (1 - 0.35f * smooth_step(0.8f, 1.0f, u));
    const vec2 root(u * w, band.root_v * h + 2.0f),
        tip((u + tuft + 0.030f * (dice(2) - 0.5f)) * w, glm::mix(band.root_v, band.tip_v, length) * h);
    draw_lash(map, root, tip, 0.010f * w * (dice(3) - 0.5f), w * (0.0070f + 0.0030f * dice(4)));
  }
}

image::Image8 paint_hairs(int size, const vec3& colour) {
  image::Image8 map;
  map.width = map.height = size;
  map.rgba.assign(static_cast<std::size_t>(size) * size * 4, 0);
  const Hairs hairs;
  const float texel_mm = (brow_high.x - brow_low.x) / static_cast<float>(size);

  parallel_for(static_cast<std::size_t>(size), [&](std::size_t row) {
    const float v = (static_cast<float>(row) + 0.5f) / static_cast<float>(size);
    for (int x = 0; x < size; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(size);
      std::uint8_t* out = map.at(x, static_cast<int>(row));
      const float tone = 1.0f + 0.5f * gradient_noise({u * 40.0f, v * 9.0f, 0}, 881);
      const vec3 here = v < brow_v ? colour : 0.4f * colour;  // lashes are darker
      for (int k = 0; k < 3; ++k) out[k] = linear_to_srgb8(here[k] * tone);
      if (v >= brow_v) continue;
      const vec2 at(glm::mix(brow_low.x, brow_high.x, u), glm::mix(brow_high.y, brow_low.y, v / brow_v));
      out[3] = static_cast<std::uint8_t>(255.0f * std::min(1.0f, hairs.coverage(at, 1.2f * texel_mm)));
    }
  });

  draw_lashes(map, upper_band, 190, 1);
  draw_lashes(map, lower_band, 84, 2);
  return map;
}

// A sheet over the brow's box, which stands off the skin a little.
void add_brow(const Sculpture& bust, PartMesh& mesh, float side) {
  constexpr int columns = 17, rows = 5;
  const std::vector<vec3> curve = smooth_curve(brow_line, 6);
  std::uint32_t first = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      // The strip follows the arch of the brow.
      const float s = static_cast<float>(i) / (columns - 1),
                  t = 2.0f * static_cast<float>(j) / (rows - 1) - 1.0f;
      const vec3 middle = curve[static_cast<std::size_t>(s * static_cast<float>(curve.size() - 1) + 0.5f)];
      const vec2 at =
          glm::clamp(vec2(glm::mix(8.0f, 57.0f, s), middle.y + t * 8.0f), brow_low + 0.5f, brow_high - 0.5f);
      const vec3 p = bust.onto_skin({side * at.x, at.y, middle.z});
      vec3 q = from_symmetric(p);
      const vec3 n = bust.project(q, Detail::form, 1.0f, 1);
      const vec2 uv((at.x - brow_low.x) / (brow_high.x - brow_low.x),
                    brow_v * (brow_high.y - at.y) / (brow_high.y - brow_low.y));
      const std::uint32_t id = mesh.add(p + n * (0.45f + 0.35f * (1 - t * t)), n, uv);
      if (i == 0 && j == 0) first = id;
    }
  }
  mesh.grid(first, columns, rows, side < 0);
}

void add_lashes(const Sculpture& bust, PartMesh& mesh, float side, bool is_upper) {
  constexpr int columns = 19;
  const int rows = is_upper ? 4 : 3;
  const std::vector<vec3> edge = smooth_curve(is_upper ? upper_lid : lower_lid, 8);
  const vec3 centre(side * eye_centre.x, eye_centre.y, eye_centre.z);
  const float up = is_upper ? 1.0f : -1.0f, length_mm = is_upper ? 9.0f : 5.5f;
  const Band& band = is_upper ? upper_band : lower_band;

  std::uint32_t first = 0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const float s = static_cast<float>(i) / (columns - 1),
                  t = static_cast<float>(j) / static_cast<float>(rows - 1);
      const float along = 0.07f + 0.91f * s;
      const vec3 e = edge[static_cast<std::size_t>(along * static_cast<float>(edge.size() - 1) + 0.5f)];
      const vec3 root = bust.onto_skin({side * e.x, e.y + 0.35f * up, e.z});
      const vec3 d = glm::normalize(root - centre);
      // Forwards, fanned out to both corners, then curling away from the gap.
      const vec3 out = glm::normalize(vec3(d.x + side * 0.45f * (s - 0.4f), 0.35f * d.y, d.z));
      const vec3 p = root - 0.25f * d +
                     length_mm * (out * (0.95f * t - 0.15f * t * t) +
                                  vec3(0, up * (0.02f * t + (is_upper ? 0.40f : 0.38f) * t * t), 0));
      const vec3 n = glm::normalize(vec3(out.x * 0.3f, up, 0.5f));
      const std::uint32_t id = mesh.add(p, n, {s, glm::mix(band.root_v, band.tip_v, t)});
      if (i == 0 && j == 0) first = id;
    }
  }
  mesh.grid(first, columns, rows, (side < 0) != !is_upper);
}

}  // namespace

void add_hair_cards(const Sculpture& bust, scene::AssetData& scene, const Colouring& colours, int map_size) {
  const int material = static_cast<int>(scene.materials.size());
  scene::Material m;
  m.name = "hair";
  m.metallic = 0;
  m.roughness = 0.7f;
  m.specular = 0.2f;
  m.alpha_mode = AssetAlpha::blend;
  m.double_sided = true;
  m.base_colour_map.image = static_cast<int>(scene.images.size());
  m.base_colour_map.wrap_u = m.base_colour_map.wrap_v = AssetWrap::clamp;
  scene.materials.push_back(m);
  scene.images.push_back(
      {"built-in hair", std::make_shared<const image::Image8>(paint_hairs(map_size, colours.hair))});

  PartMesh brows("brows", material), lashes("lashes", material);
  for (const float side : {1.0f, -1.0f}) {
    add_brow(bust, brows, side);
    add_lashes(bust, lashes, side, true);
    add_lashes(bust, lashes, side, false);
  }
  scene.primitives.push_back(brows.finish());
  scene.primitives.push_back(lashes.finish());
}

}  // namespace dermis::builtin_head
