// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "render/passes/asset/gutter_list.h"
#include "render/shared/tiles_io.h"

namespace dermis::passes {
namespace {

constexpr std::uint32_t side = 64, across = side / TILE_SIDE, tiles = across * side / TILE_SIDE;

std::uint32_t tile_at(std::uint32_t x, std::uint32_t y) { return y / TILE_SIDE * across + x / TILE_SIDE; }
std::uint32_t tile_of(std::uint32_t packed) { return tile_at(packed & 0xFFFF, packed >> 16); }

struct Found {
  std::set<std::uint32_t> lit, blurred;  // besides seen tiles
  bool operator==(const Found&) const = default;
};

// Follows each gutter from its own tile.
Found by_gutters(const std::vector<io::GutterIo>& gutters, const std::vector<bool>& seen) {
  Found found;
  for (const io::GutterIo& g : gutters) {
    const std::uint32_t tile = tile_of(g.texel), own = tile_of(g.own),
                        source = tile_at(static_cast<std::uint32_t>(g.source.x),
                                         static_cast<std::uint32_t>(g.source.y));
    if (seen[tile] && (g.own == g.texel || !seen[own])) {
      if (!seen[source]) found.lit.insert(source);
    } else if (!seen[tile] && g.chart != 0 && (seen[source] || seen[own])) {
      found.blurred.insert(tile);
    }
  }
  return found;
}

// Follows the links of each tile, as tiles.comp does.
Found by_links(const std::vector<std::uint32_t>& links, const std::vector<bool>& seen) {
  Found found;
  const auto is_seen = [&](std::uint32_t tile) { return tile != NO_TILE && seen[tile]; };
  for (std::uint32_t tile = 0; tile < tiles; ++tile)
    for (std::uint32_t i = links[tile]; !seen[tile] && i < links[tile + 1]; ++i) {
      const std::size_t at = tiles + 1 + 2 * std::size_t{i};
      if (!is_seen(links[at] & ~TILE_LINK_LIGHTS) || is_seen(links[at + 1])) continue;
      ((links[at] & TILE_LINK_LIGHTS) != 0 ? found.lit : found.blurred).insert(tile);
    }
  return found;
}

TEST(TileLinks, FindTheTilesThatGuttersTake) {
  std::mt19937 random(7);
  const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  const auto texel = [&] { return below(side) | below(side) << 16; };
  bool any_lit = false, any_blurred = false;

  for (int round = 0; round < 40; ++round) {
    std::vector<io::GutterIo> gutters(30);
    for (io::GutterIo& g : gutters) {
      g = {.texel = texel(),
           .own = texel(),
           .source = {static_cast<float>(below(side)) + 0.5f, static_cast<float>(below(side)) + 0.5f},
           .chart = below(3)};
      if (below(4) == 0) g.own = g.texel;
    }
    std::vector<bool> seen(tiles);
    for (std::uint32_t tile = 0; tile < tiles; ++tile) seen[tile] = below(3) == 0;

    const Found wanted = by_gutters(gutters, seen);
    EXPECT_EQ(by_links(tile_links(gutters, side), seen), wanted) << "round " << round;
    any_lit = any_lit || !wanted.lit.empty();
    any_blurred = any_blurred || !wanted.blurred.empty();
  }
  EXPECT_TRUE(any_lit && any_blurred);
}

}  // namespace
}  // namespace dermis::passes
