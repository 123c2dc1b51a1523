// SPDX-License-Identifier: MIT
/// The textures in which light on the skin is stored and blurred, and the passes that fill them with light.
#pragma once

#include <string>
#include <vector>

#include "render/passes/light_map/irradiance/irradiance.h"
#include "render/passes/light_map/light_pool.h"
#include "render/passes/light_map/tile_lists.h"
#include "render/techniques/screen.h"
#include "render/techniques/texture_space/map_pool.h"

namespace dermis::techniques {

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
  void add_stretch_gutters(const std::vector<passes::MapSquare>& squares);
  /// Finds which triangle each texel of a batch shows.
  void add_texel_map(const std::vector<passes::MapSquare>& all);
  /// Lights the skin meshes of a batch and prepares their maps for blurring.
  void add_light(const std::vector<passes::MapSquare>& all);
  const MapPool& pool() const { return pool_; }
  frame::TextureId light() const { return light_; }          ///< input of the first blur
  frame::TextureId entered() const { return entered_; }      ///< without light through the body
  const passes::TileLists& tiles() const { return tiles_; }  ///< that are lit and blurred
  /// Between both axes of a blur: one per term that is blurred at a time.
  const std::vector<frame::TextureId>& scratch() const { return scratch_; }
  /// One per term. The last may be that of light(), once nothing reads it any more.
  const std::vector<frame::TextureId>& blurred() const { return blurred_; }
  const std::vector<frame::TextureId>& transmitted() const { return transmitted_; }
  /// Returns the stretch map of a mesh. Meshes that take turns with a square take turns with this, too.
  frame::TextureId stretch(std::uint32_t mesh) const;
  /// Returns all maps of the pool.
  std::vector<frame::TextureId> textures() const;

  /// Return the name of a pass: "irradiance", "irradiance batch 1", and "blur 0 u part 2" of one skin mesh.
  std::string name(std::string_view what) const;
  std::string name(std::string_view what, std::uint32_t mesh) const;

 private:
  struct StretchPass {
    std::string name;
    frame::Runs runs{};
    bool when_moved = false;
    std::vector<passes::MapSquare> squares = {};
  };
  std::vector<StretchPass> stretch_passes(const std::vector<passes::MapSquare>& squares) const;
  frame::TextureId make_map(std::string name);
  void make_stretch();
  void add_tiles(const std::vector<passes::MapSquare>& all);

  passes::FramePlan* plan_;
  const FrameSettings* settings_;
  Screen* screen_;
  MapPool pool_;
  std::uint32_t turn_ = 0;                    // of the pool
  std::vector<frame::TextureId> light_maps_;  // all that hold light of ours
  frame::TextureId light_, entered_;
  passes::TileLists tiles_;
  std::vector<frame::TextureId> scratch_, blurred_;
  std::vector<frame::TextureId> stretch_;      // by unwrap, or by turn of the meshes of a head
  frame::TextureId host_irradiance_;           // valid if a host draws the light
  frame::TextureId texels_;                    // of passes::TexelMap
  std::vector<frame::TextureId> transmitted_;  // with translucency: of the second and third group of terms
};

}  // namespace dermis::techniques
