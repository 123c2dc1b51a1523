// SPDX-License-Identifier: MIT
/// The textures in which light on the skin is stored and blurred, and the passes that fill them with light.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "passes/light_pool.h"
#include "passes/tile_lists.h"
#include "techniques/screen.h"
#include "techniques/texture_space/map_pool.h"

namespace dermis::techniques {

/// How often the map of each term is halved, for the profile with most terms. A term's map serves all skin
/// meshes: it is halved as often as the mesh that needs it largest allows.
std::vector<std::uint32_t> halvings_of_terms(const FrameSettings& settings);

/// What cull and clip leave unlit is skipped by convolutions.
inline bool is_sparse(const FrameSettings& settings) {
  return settings.optimise.cull || settings.optimise.clip;
}
/// How convolutions run: as the settings say, or over the whole used square by the same kind of pass.
passes::Mask mask_of(const FrameSettings& settings);

/// Light maps of one size, and what says which of their texels convolutions skip.
struct Level {
  std::uint32_t halvings = 0;
  frame::TextureId light;  ///< what its first convolution reads
  frame::TextureId scratch, depth_mask;
  std::vector<frame::TextureId> blurred;  ///< of the terms that end here
  passes::TileLists border, lit;
};

passes::MapSquare on_level(passes::MapSquare square, const Level& level);
std::vector<passes::MapSquare> on_level(std::vector<passes::MapSquare> squares, const Level& level);
/// Those of one skin mesh.
std::vector<passes::MapSquare> of_mesh(const std::vector<passes::MapSquare>& all, std::uint32_t mesh);

class LightMaps {
 public:
  /// Makes the maps. Needs at least one skin mesh; plan, settings and screen outlive this.
  LightMaps(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen);

  /// The passes that follow are of the next batch of skin meshes: their names say so.
  void begin_batch() { ++batch_; }

  /// The metric of an unwrap: [DLE07] sec. 3.4.
  void add_stretch(std::uint32_t mesh);
  /// Lights the skin meshes of a batch and prepares their maps for blurring.
  void add_light(const std::vector<passes::MapSquare>& all);
  /// Goes on in smaller maps with the light of one skin mesh.
  void add_halved(const Level& level, frame::TextureId light, const std::vector<passes::MapSquare>& from,
                  const std::vector<passes::MapSquare>& to);

  const MapPool& pool() const { return pool_; }
  const std::vector<Level>& levels() const { return levels_; }  ///< large to small
  const Level& level_of(std::size_t term) const;
  const std::vector<std::uint32_t>& halvings() const { return halvings_; }   ///< one per term
  const std::vector<frame::TextureId>& blurred() const { return blurred_; }  ///< one per term
  const std::vector<frame::TextureId>& transmitted() const { return transmitted_; }
  /// Of the second (1) or third (2) group of terms, for all meshes and batches; made where it is first used.
  frame::TextureId halved_transmitted(std::size_t group, const Level& level);
  /// Meshes that take turns with a square take turns with its stretch map.
  frame::TextureId stretch(std::uint32_t mesh) const { return stretch_[mesh % pool_.meshes_per_batch()]; }
  /// All maps of the pool.
  std::vector<frame::TextureId> textures() const;

  /// "irradiance", "irradiance batch 1", "blur 0 u batch 1 part 2".
  std::string name(std::string_view what) const;
  std::string name(std::string_view what, std::uint32_t mesh) const;

 private:
  Level make_level(std::uint32_t halvings);
  void add_masks(const Level& level, const std::vector<passes::MapSquare>& all);
  void add_dilation(const Level& level, const std::vector<passes::MapSquare>& all);
  void add_masked_counts(const Level& level, const std::vector<passes::MapSquare>& all);
  void add_tiles(const Level& level, const std::vector<passes::MapSquare>& all);

  passes::FramePlan* plan_;
  const FrameSettings* settings_;
  Screen* screen_;
  MapPool pool_;
  std::uint32_t batch_ = 0;  // of heads and skin meshes
  std::vector<std::uint32_t> halvings_;
  std::vector<Level> levels_;
  std::vector<frame::TextureId> blurred_;
  std::vector<frame::TextureId> stretch_;      // one per skin mesh of a batch
  std::vector<frame::TextureId> transmitted_;  // with translucency: of the second and third group of terms
  std::map<std::pair<std::size_t, std::uint32_t>, frame::TextureId> halved_transmitted_;  // group, halvings
};

/// "downsample 1/2": a pass on a level of halved maps.
std::string at(std::string_view what, const Level& level);

}  // namespace dermis::techniques
