// SPDX-License-Identifier: MIT
#include "techniques/texture_space/texture_space.h"

#include <algorithm>
#include <cmath>

#include "passes/blur/blur.h"
#include "passes/border/border.h"
#include "passes/count/count.h"
#include "passes/depth_mask/depth_mask.h"
#include "passes/gutters/gutters.h"
#include "passes/irradiance/irradiance.h"
#include "passes/skin/skin.h"
#include "passes/stretch/stretch.h"
#include "passes/tiles/tiles.h"
#include "passes/visibility/visibility.h"
#include "techniques/screen.h"

namespace dermis::techniques {
namespace {

using passes::Gutters;
using passes::MapSquare;
using passes::Mask;

std::vector<std::array<float, 3>> weights(const gaussians::SumOfGaussians& profile) {
  std::vector<std::array<float, 3>> w;
  for (const gaussians::Gaussian& term : profile.terms)
    w.push_back({static_cast<float>(term.weight[0]), static_cast<float>(term.weight[1]), static_cast<float>(term.weight[2])});
  return w;
}

std::vector<float> sigmas_mm(const gaussians::SumOfGaussians& profile) {
  std::vector<float> sigmas;
  for (const gaussians::Gaussian& term : profile.terms) sigmas.push_back(static_cast<float>(std::sqrt(term.variance_mm2)));
  return sigmas;
}

class TextureSpace {
 public:
  TextureSpace(frame::FramePlan& plan, const FrameSettings& settings) : plan_(&plan), settings_(settings), screen_(plan, settings) {
    for (const SkinPart& part : settings_.skin) terms_ = std::max(terms_, part.profile.terms.size());
    if (!settings_.skin.empty()) make_maps();
  }

  void add_batch(std::uint32_t first_head, std::uint32_t heads) {
    batch_ = first_head / settings_.heads_per_batch;
    for (std::uint32_t head = first_head; head < first_head + heads; ++head) screen_.add_shadow(head);
    std::vector<MapSquare> all;
    for (std::uint32_t mesh = 0; mesh < settings_.skin.size(); ++mesh)
      for (std::uint32_t head = first_head; head < first_head + heads; ++head) all.push_back(square_of(head, mesh));
    if (!all.empty()) add_light(all);
    for (std::uint32_t mesh = 0; mesh < settings_.skin.size(); ++mesh) add_convolution(mesh, of_mesh(all, mesh));
    for (std::uint32_t head = first_head; head < first_head + heads; ++head) {
      for (std::uint32_t mesh = 0; mesh < settings_.skin.size(); ++mesh) add_final(square_of(head, mesh));
      screen_.add_surfaces(head);
    }
  }

  FrameOutputs finish() {
    FrameOutputs out = screen_.finish();
    if (settings_.skin.empty()) return out;
    out.shows["irradiance"] = irradiance_;
    out.shows["stretch"] = stretch_.front();
    if (settings_.visibility) out.shows["visibility"] = add_visibility();
    for (std::size_t k = 0; k < levels_.size(); ++k) out.shows[fmt::format("blur:{}", k)] = levels_[k];
    for (const auto& [name, id] : out.shows) plan_->read_back(id);
    out.shown_origin = square_of(settings_.heads - 1, 0).origin;
    for (const SkinPart& part : settings_.skin)
      out.convolutions.push_back(static_cast<std::uint32_t>(2 * passes::blur_steps(part.profile, part.max_texels_per_mm).size()));
    return out;
  }

 private:
  // One square a head of a batch and skin mesh, in rows.
  std::uint32_t squares() const { return settings_.heads_per_batch * static_cast<std::uint32_t>(settings_.skin.size()); }
  std::uint32_t columns() const { return static_cast<std::uint32_t>(std::ceil(std::sqrt(squares()))); }

  MapSquare square_of(std::uint32_t head, std::uint32_t mesh) const {
    const std::uint32_t index = head % settings_.heads_per_batch * static_cast<std::uint32_t>(settings_.skin.size()) + mesh;
    return {
        .instance = head, .mesh = mesh, .origin = glm::uvec2(index % columns(), index / columns()) * settings_.map_size, .index = index};
  }

  // What cull and clip have left unlit is skipped; with neither, the whole used square is convolved by the same kind of pass.
  bool sparse() const { return settings_.optimise.cull || settings_.optimise.clip; }
  Mask mask() const {
    if (sparse()) return settings_.mask;
    return settings_.mask == Mask::tiles ? Mask::whole : Mask::drawn;
  }

  std::string name(std::string_view what) const {
    return settings_.heads > settings_.heads_per_batch ? fmt::format("{} batch {}", what, batch_) : std::string(what);
  }
  std::string name(std::string_view what, std::uint32_t mesh) const {
    return name(settings_.skin.size() > 1 ? fmt::format("{} part {}", what, mesh) : std::string(what));
  }

  void make_maps() {
    const std::uint32_t rows = (squares() + columns() - 1) / columns();
    gpu::TextureDesc pool{
        .width = columns() * settings_.map_size, .height = rows * settings_.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
    irradiance_ = plan_->texture("irradiance", pool);
    scratch_ = plan_->texture("scratch", pool);
    for (std::size_t k = 0; k < terms_; ++k) levels_.push_back(plan_->texture(fmt::format("light {}", k), pool));
    if (sparse()) border_ = passes::make_tile_lists(*plan_, "border", squares(), settings_.map_size);
    if (mask() == Mask::tiles) lists_ = passes::make_tile_lists(*plan_, "lit", squares(), settings_.map_size);
    pool.format = VK_FORMAT_D32_SFLOAT;
    if (mask() == Mask::depth) depth_mask_ = plan_->texture("depth mask", pool);
    const gpu::TextureDesc map{.width = settings_.map_size, .height = settings_.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
    for (std::uint32_t mesh = 0; mesh < settings_.skin.size(); ++mesh) {
      const std::string suffix = settings_.skin.size() > 1 ? fmt::format(" part {}", mesh) : "";
      stretch_.push_back(plan_->texture("stretch" + suffix, map, frame::Lifetime::persistent));
      plan_->add<passes::Stretch>("stretch" + suffix, {stretch_.back()}, {.mesh = mesh});
      plan_->add<Gutters>("stretch gutters" + suffix, {stretch_.back()},
                          {.squares = {{.instance = 0, .mesh = mesh}}, .what = Gutters::What::stretch});
    }
  }

  void add_light(const std::vector<MapSquare>& all) {
    plan_->add<passes::Irradiance>(name("irradiance"), {irradiance_, screen_.shadow()},
                                   {.squares = all, .cull = settings_.optimise.cull, .clip = settings_.optimise.clip});
    plan_->add<passes::Count>(name("count texels"), {irradiance_, screen_.counters()}, {.slot = counter_irradiance, .squares = all});
    plan_->add<Gutters>(name("irradiance gutters"), {irradiance_}, {.squares = all});
    if (sparse()) add_border(all);
    for (std::uint32_t mesh = 0; mesh < settings_.skin.size(); ++mesh)
      plan_->add<passes::Count>(
          name("count masked texels", mesh), {irradiance_, screen_.counters()},
          {.slot = mesh_counter(mesh, counter_masked_texels), .threshold = 0.5f, .absolute = true, .squares = of_mesh(all, mesh)});
    if (mask() == Mask::depth) plan_->add<passes::DepthMask>(name("depth mask"), {irradiance_, depth_mask_}, {.squares = all});
    if (mask() == Mask::tiles) {
      std::vector<frame::TextureId> maps = levels_;
      maps.push_back(scratch_);
      plan_->add<passes::ClearTiles>(name("clear tiles"), {lists_});
      plan_->add<passes::TileClasses>(name("tile classes"), {irradiance_, lists_}, {all});
      plan_->add<passes::Tiles>(name("tiles"), {lists_, screen_.counters()},
                                {.squares = all, .first_slot = mesh_counter(0, counter_tiles), .slot_stride = counter_mesh_stride});
      plan_->add<passes::IdleTiles>(name("idle tiles"), {lists_, maps}, {.squares = all});
    }
  }

  void add_border(const std::vector<MapSquare>& all) {
    plan_->add<passes::ClearTiles>(name("clear border tiles"), {border_});
    plan_->add<passes::TileClasses>(name("border tile classes"), {irradiance_, border_}, {all});
    plan_->add<passes::Tiles>(name("border tiles"), {border_, screen_.counters()}, {.squares = all, .what = passes::Tiles::What::border});
    for (std::uint32_t mesh = 0; mesh < settings_.skin.size(); ++mesh)
      plan_->add<passes::Border>(name("border", mesh), {irradiance_, stretch_[mesh], border_}, {of_mesh(all, mesh)});
  }

  // Of the nearest head.
  frame::TextureId add_visibility() {
    const frame::TextureId picture =
        plan_->texture("visibility", {.width = settings_.map_size, .height = settings_.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT},
                       frame::Lifetime::persistent);
    plan_->add<passes::Visibility>(
        "visibility", {picture},
        {.square = square_of(settings_.heads - 1, 0), .cull = settings_.optimise.cull, .clip = settings_.optimise.clip});
    return picture;
  }

  // Gaussians compose: blurring a blurred map adds variances, so each term starts from the one before. Seams are refreshed after each step.
  void add_convolution(std::uint32_t mesh, const std::vector<MapSquare>& squares) {
    frame::TextureId light = irradiance_;
    std::size_t term = 0, number = 0;
    bool first = true;
    for (const passes::BlurStep& step : passes::blur_steps(settings_.skin[mesh].profile, settings_.skin[mesh].max_texels_per_mm)) {
      const std::string step_name = fmt::format("blur {}", number++);
      // A step between two terms is overwritten by the step that ends the next term: its level serves both.
      const frame::TextureId target = levels_[term];
      passes::Blur::Settings blur{
          .squares = squares, .variance_mm2 = step.variance_mm2, .axis = 0, .texel_averaged = first, .mask = mask()};
      plan_->add<passes::Blur>(name(step_name + " u", mesh), {light, stretch_[mesh], scratch_, lists_, depth_mask_}, blur);
      blur.axis = 1;
      plan_->add<passes::Blur>(name(step_name + " v", mesh), {scratch_, stretch_[mesh], target, lists_, depth_mask_}, blur);
      plan_->add<Gutters>(name(step_name + " gutters", mesh), {target}, {.squares = squares});
      light = target;
      first = false;
      if (step.ends_term) ++term;
    }
  }

  void add_final(const MapSquare& square) {
    const SkinPart& part = settings_.skin[square.mesh];
    const std::vector<frame::TextureId> lights(levels_.begin(), levels_.begin() + static_cast<std::ptrdiff_t>(part.profile.terms.size()));
    plan_->add<passes::Skin>(label("final", settings_, square.instance, square.mesh),
                             {lights, screen_.shadow(), screen_.colour(), screen_.depth()},
                             {.square = square,
                              .samples = settings_.samples,
                              .clear = screen_.take_clear(),
                              .weights = weights(part.profile),
                              .mixes = settings_.optimise.depth,
                              .sigmas_mm = sigmas_mm(part.profile),
                              .texels_per_mm = static_cast<float>(part.mean_texels_per_mm),
                              .largest_side = settings_.map_size});
    plan_->add<passes::SkinReads>(label("count unshaded reads", settings_, square.instance, square.mesh),
                                  {lights.front(), screen_.depth(), screen_.counters()},
                                  {.square = square, .samples = settings_.samples, .slot = counter_unshaded_reads});
  }

  static std::vector<MapSquare> of_mesh(const std::vector<MapSquare>& all, std::uint32_t mesh) {
    std::vector<MapSquare> squares;
    std::copy_if(all.begin(), all.end(), std::back_inserter(squares), [&](const MapSquare& s) { return s.mesh == mesh; });
    return squares;
  }

  frame::FramePlan* plan_;
  const FrameSettings& settings_;
  Screen screen_;
  std::size_t terms_ = 0;
  std::uint32_t batch_ = 0;
  frame::TextureId irradiance_, scratch_, depth_mask_;
  std::vector<frame::TextureId> stretch_;  // one a skin mesh
  std::vector<frame::TextureId> levels_;   // one a term, of the profile with most terms
  passes::TileLists border_, lists_;
};

}  // namespace

FrameOutputs build_texture_space(frame::FramePlan& plan, const FrameSettings& settings) {
  TextureSpace frame(plan, settings);
  for (std::uint32_t head = 0; head < settings.heads; head += settings.heads_per_batch)
    frame.add_batch(head, std::min(settings.heads_per_batch, settings.heads - head));
  return frame.finish();
}

}  // namespace dermis::techniques
