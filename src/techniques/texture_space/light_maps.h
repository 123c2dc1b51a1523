// SPDX-License-Identifier: MIT
/// The textures in which light on the skin is stored and blurred, and the passes that fill them with light.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "passes/irradiance/irradiance_texels.h"
#include "passes/kept_triangles.h"
#include "passes/light_pool.h"
#include "passes/tile_lists.h"
#include "techniques/screen.h"
#include "techniques/texture_space/map_pool.h"

namespace dermis::techniques {

/// Returns whether texels stay unlit (cull, clip), so that convolutions may skip them.
inline bool is_sparse(const FrameSettings& settings) {
  return settings.optimise.cull || settings.optimise.clip;
}

/// Light maps of one size, T_max >> halvings, and what says which of their texels convolutions skip.
struct Level {
  std::uint32_t halvings = 0;
  frame::TextureId light;                 ///< what its first convolution reads
  frame::TextureId scratch;               ///< between the two axes of a blur
  std::vector<frame::TextureId> blurred;  ///< one per term; of a cascade what has spread so far
  passes::TileLists border;               ///< tiles that Dilate fills; valid if the light is sparse
  passes::TileLists lit;                  ///< tiles to blur; likewise
};

/// Return the same squares in the maps of a level.
passes::MapSquare on_level(passes::MapSquare square, const Level& level);
std::vector<passes::MapSquare> on_level(std::vector<passes::MapSquare> squares, const Level& level);

/// The maps of all skin meshes, and the passes up to the first blur. `all` are the squares of one batch,
/// sorted by mesh.
class LightMaps {
 public:
  /// Makes the maps. Needs at least one skin mesh; plan, settings and screen must outlive this.
  LightMaps(passes::FramePlan& plan, const FrameSettings& settings, Screen& screen);

  /// Gives the passes that follow the number of a turn of the pool.
  void begin_turn(std::uint32_t number) { turn_ = number; }

  /// Stores the metric of the unwrap of each square's mesh, which have a map each. [DLE07] sec. 3.4.
  void add_stretch(const std::vector<passes::MapSquare>& squares);
  /// Lights the skin meshes of a batch and prepares their maps for blurring.
  void add_light(const std::vector<passes::MapSquare>& all);
  /// Of a cascade. Halves light that has not spread once more, to the maps of levels()[halvings], and
  /// prepares these for blurring. `squares`: on maps of T_max, sorted by mesh.
  void add_level(std::uint32_t halvings, const std::vector<passes::MapSquare>& squares);
  /// Of a cascade: returns the light of a group of terms that has not spread, on levels()[halvings].
  frame::TextureId unspread(std::size_t group, std::uint32_t halvings) const;

  const MapPool& pool() const { return pool_; }
  const std::vector<Level>& levels() const { return levels_; }  ///< large to small; one without a cascade
  /// One per term; of a cascade one, the sum.
  const std::vector<frame::TextureId>& blurred() const { return blurred_; }
  const std::vector<frame::TextureId>& transmitted() const { return transmitted_; }
  /// Returns the stretch map of a mesh. Meshes that take turns with a square take turns with this, too.
  frame::TextureId stretch(std::uint32_t mesh) const;
  /// Returns all maps of the pool.
  std::vector<frame::TextureId> textures() const;

  /// Return the name of a pass: "irradiance", "irradiance batch 1", and "cascade 0 u part 2" of one skin
  /// mesh.
  std::string name(std::string_view what) const;
  std::string name(std::string_view what, std::uint32_t mesh) const;

 private:
  Level make_level(std::uint32_t halvings);
  void add_stretch(std::string_view what, const std::vector<passes::MapSquare>& squares, frame::Runs runs,
                   bool when_moved);
  void make_chain();
  void make_cascade();
  void make_stretch();
  void add_irradiance(const passes::Irradiance::Settings& settings);
  void add_texels(const passes::Irradiance::Settings& settings, const passes::Irradiance::In& in);
  void add_masks(const Level& level, const std::vector<passes::MapSquare>& all);
  void add_dilation(const Level& level, const std::vector<passes::MapSquare>& all);
  void add_masked_counts(const Level& level, const std::vector<passes::MapSquare>& all);
  void add_tiles(const Level& level, const std::vector<passes::MapSquare>& all);

  passes::FramePlan* plan_;
  const FrameSettings* settings_;
  Screen* screen_;
  MapPool pool_;
  std::uint32_t turn_ = 0;  // of the pool
  std::vector<Level> levels_;
  std::vector<frame::TextureId> blurred_;
  std::vector<frame::TextureId> stretch_;      // by unwrap, or by turn of the meshes of a head
  frame::TextureId host_irradiance_;           // valid if a host draws the light
  passes::LitTexels texels_;                   // valid if texels are lit by a compute pass
  passes::KeptTriangles kept_;                 // valid if triangles are culled
  std::vector<frame::TextureId> transmitted_;  // with translucency: of the second and third group of terms
  std::map<std::pair<std::size_t, std::uint32_t>, frame::TextureId> halved_transmitted_;  // group, halvings
};

/// Returns the name of a pass on a level: "downsample 1/2", or just `what` on the level of full size.
std::string at(std::string_view what, const Level& level);

}  // namespace dermis::techniques
