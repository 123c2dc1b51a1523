// SPDX-License-Identifier: MIT
#include "techniques/texture_space/texture_space.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "passes/add_transmitted/add_transmitted.h"
#include "passes/blur/blur.h"
#include "passes/count/count.h"
#include "passes/depth_mask/depth_mask.h"
#include "passes/dilate/dilate.h"
#include "passes/downsample/downsample.h"
#include "passes/final_pass/final_pass.h"
#include "passes/gutters/gutters.h"
#include "passes/irradiance/irradiance.h"
#include "passes/show_visibility/show_visibility.h"
#include "passes/stretch/stretch.h"
#include "passes/tiles/tiles.h"
#include "passes/transmission.h"
#include "techniques/screen.h"

namespace dermis::techniques {
namespace {

using passes::Gutters;
using passes::MapSquare;
using passes::Mask;

std::vector<std::array<float, 3>> weights(const gaussians::SumOfGaussians& profile) {
  std::vector<std::array<float, 3>> w;
  for (const gaussians::Gaussian& term : profile.terms)
    w.push_back({static_cast<float>(term.weight[0]), static_cast<float>(term.weight[1]),
                 static_cast<float>(term.weight[2])});
  return w;
}

std::vector<float> sigmas_mm(const gaussians::SumOfGaussians& profile) {
  std::vector<float> sigmas;
  for (const gaussians::Gaussian& term : profile.terms)
    sigmas.push_back(static_cast<float>(std::sqrt(term.variance_mm2)));
  return sigmas;
}

// Light maps of one size, and what says which of their texels convolutions skip.
struct Level {
  std::uint32_t halvings = 0;
  frame::TextureId light;  // what its first convolution reads
  frame::TextureId scratch, depth_mask;
  std::vector<frame::TextureId> blurred;  // of the terms that end here
  passes::TileLists border, lit;
};

class TextureSpace {
 public:
  TextureSpace(frame::FramePlan& plan, const FrameSettings& settings)
      : plan_(&plan), settings_(settings), screen_(plan, settings) {
    for (const SkinPart& part : settings_.skin) add_halvings(part);
    if (!settings_.skin.empty()) make_maps();
  }

  void add_batch(std::uint32_t first_head, std::uint32_t heads) {
    for (std::uint32_t head = first_head; head < first_head + heads; ++head) screen_.add_shadow(head);
    // The first meshes come last, so that what `--show` reads is of the first one.
    for (std::uint32_t batch = mesh_batches(); batch-- > 0; ++batch_) {
      const std::uint32_t first = batch * meshes_per_batch();
      const std::uint32_t end =
          std::min(first + meshes_per_batch(), static_cast<std::uint32_t>(settings_.skin.size()));
      add_skin(first_head, heads, first, end);
    }
    for (std::uint32_t head = first_head; head < first_head + heads; ++head) {
      for (std::uint32_t mesh = 0; !splits_heads() && mesh < settings_.skin.size(); ++mesh)
        add_final(square_of(head, mesh));
      screen_.add_surfaces(head);
    }
  }

  FrameOutputs finish() {
    FrameOutputs out = screen_.finish();
    if (settings_.skin.empty()) return out;
    out.shows["irradiance"] = levels_.front().light;
    out.shows["stretch"] = stretch_.front();
    if (settings_.visibility) out.shows["visibility"] = add_visibility();
    for (std::size_t k = 0; k < blurred_.size(); ++k) out.shows[fmt::format("blur:{}", k)] = blurred_[k];
    for (const auto& [name, id] : out.shows) plan_->read_back(id);
    out.shown_origin = square_of(settings_.heads - 1, 0).origin;
    for (const SkinPart& part : settings_.skin) out.work.push_back(work_of(part));
    return out;
  }

 private:
  // Lights and blurs skin meshes first_mesh to end_mesh of some heads; draws them too if others take their
  // squares afterwards.
  void add_skin(std::uint32_t first_head, std::uint32_t heads, std::uint32_t first_mesh,
                std::uint32_t end_mesh) {
    std::vector<MapSquare> all;
    for (std::uint32_t mesh = first_mesh; mesh < end_mesh; ++mesh)
      for (std::uint32_t head = first_head; head < first_head + heads; ++head)
        all.push_back(square_of(head, mesh));
    if (splits_heads())
      for (std::uint32_t mesh = first_mesh; mesh < end_mesh; ++mesh) add_stretch(mesh);
    add_light(all);
    for (std::uint32_t mesh = first_mesh; mesh < end_mesh; ++mesh) add_convolution(mesh, of_mesh(all, mesh));
    if (splits_heads())
      for (const MapSquare& square : all) add_final(square);
  }

  // One square per head of a batch and skin mesh of a batch, in rows.
  std::uint32_t meshes_per_batch() const {
    const auto meshes = static_cast<std::uint32_t>(settings_.skin.size());
    return settings_.meshes_per_batch == 0 ? meshes : std::min(settings_.meshes_per_batch, meshes);
  }
  std::uint32_t mesh_batches() const {
    const auto meshes = static_cast<std::uint32_t>(settings_.skin.size());
    return meshes == 0 ? 0 : (meshes + meshes_per_batch() - 1) / meshes_per_batch();
  }
  bool splits_heads() const { return mesh_batches() > 1; }
  std::uint32_t squares() const { return settings_.heads_per_batch * meshes_per_batch(); }
  // Sides of pools for parts of a head are powers of two, whose coordinates do not round: the picture is the
  // same for every budget.
  std::uint32_t columns() const {
    const auto least = static_cast<std::uint32_t>(std::ceil(std::sqrt(squares())));
    return splits_heads() ? std::bit_ceil(least) : least;
  }

  MapSquare square_of(std::uint32_t head, std::uint32_t mesh) const {
    const std::uint32_t index =
        head % settings_.heads_per_batch * meshes_per_batch() + mesh % meshes_per_batch();
    return {.instance = head,
            .mesh = mesh,
            .origin = glm::uvec2(index % columns(), index / columns()) * settings_.map_size,
            .index = index,
            .largest_side = settings_.map_size};
  }
  // Meshes that take turns with a square take turns with its stretch map.
  frame::TextureId stretch_of(std::uint32_t mesh) const { return stretch_[mesh % meshes_per_batch()]; }

  // What cull and clip have left unlit is skipped; with neither, the whole used square is convolved by the
  // same kind of pass.
  bool sparse() const { return settings_.optimise.cull || settings_.optimise.clip; }
  Mask mask() const {
    if (sparse()) return settings_.mask;
    return settings_.mask == Mask::tiles ? Mask::whole : Mask::drawn;
  }

  bool cut_out() const {
    return std::any_of(settings_.skin.begin(), settings_.skin.end(),
                       [](const SkinPart& part) { return part.cut_out; });
  }

  static std::string at(std::string_view what, const Level& level) {
    return level.halvings > 0 ? fmt::format("{} 1/{}", what, 1u << level.halvings) : std::string(what);
  }
  std::string name(std::string_view what) const {
    const bool several = settings_.heads > settings_.heads_per_batch || splits_heads();
    return several ? fmt::format("{} batch {}", what, batch_) : std::string(what);
  }
  std::string name(std::string_view what, std::uint32_t mesh) const {
    return name(std::string(what) + part(mesh));
  }

  // A term's map serves all skin meshes: it is halved as often as the one that needs it largest allows.
  void add_halvings(const SkinPart& part) {
    std::vector<std::uint32_t> halvings(part.profile.terms.size(), 0);
    if (settings_.progressive)
      halvings = passes::map_halvings(part.profile, part.mean_texels_per_mm, settings_.map_size);
    for (std::size_t k = 0; k < halvings.size(); ++k) {
      if (k == halvings_.size()) halvings_.push_back(halvings[k]);
      halvings_[k] = std::min(halvings_[k], halvings[k]);
    }
  }

  std::array<FrameOutputs::LevelWork, passes::max_halvings + 1> work_of(const SkinPart& part) const {
    std::array<FrameOutputs::LevelWork, passes::max_halvings + 1> work{};
    std::size_t term = 0;
    for (const passes::BlurStep& step : passes::blur_steps(part.profile, part.max_texels_per_mm)) {
      FrameOutputs::LevelWork& level = work[halvings_[term]];
      level.halved = halvings_[term] > 0;
      level.convolutions += 2;
      if (step.ends_term) ++level.terms, ++term;
    }
    return work;
  }

  void make_maps() {
    for (std::size_t k = 0; k < halvings_.size(); ++k) {
      if (levels_.empty() || levels_.back().halvings != halvings_[k])
        levels_.push_back(make_level(halvings_[k]));
      blurred_.push_back(plan_->texture(fmt::format("light {}", k), pool(halvings_[k])));
      levels_.back().blurred.push_back(blurred_.back());
    }
    if (settings_.translucency)
      for (std::size_t g = 1; g < passes::transmission_groups(halvings_.size()).size(); ++g)
        joining_.push_back(plan_->texture(fmt::format("joining {}", g), pool(0)));
    const gpu::TextureDesc map{
        .width = settings_.map_size, .height = settings_.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
    const auto lifetime = splits_heads() ? frame::Lifetime::transient : frame::Lifetime::persistent;
    for (std::uint32_t mesh = 0; mesh < meshes_per_batch(); ++mesh)
      stretch_.push_back(plan_->texture("stretch" + part(mesh), map, lifetime));
    for (std::uint32_t mesh = 0; !splits_heads() && mesh < settings_.skin.size(); ++mesh) add_stretch(mesh);
  }

  std::string part(std::uint32_t mesh) const {
    return settings_.skin.size() > 1 ? fmt::format(" part {}", mesh) : "";
  }

  void add_stretch(std::uint32_t mesh) {
    plan_->add<passes::Stretch>(
        "stretch" + part(mesh), {stretch_of(mesh)},
        {.mesh = mesh, .every_frame = splits_heads(), .cut_out = settings_.skin[mesh].cut_out});
    plan_->add<Gutters>("stretch gutters" + part(mesh), {stretch_of(mesh)},
                        {.squares = {{.instance = 0, .mesh = mesh}},
                         .what = Gutters::What::stretch,
                         .every_frame = splits_heads()});
  }

  gpu::TextureDesc pool(std::uint32_t halvings, VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT) const {
    const std::uint32_t rows = (squares() + columns() - 1) / columns(), side = settings_.map_size >> halvings;
    return {.width = columns() * side, .height = rows * side, .format = format};
  }

  Level make_level(std::uint32_t halvings) {
    const std::uint32_t side = settings_.map_size >> halvings;
    const std::string suffix = halvings > 0 ? fmt::format(" 1/{}", 1u << halvings) : "";
    Level level{.halvings = halvings};
    level.light = plan_->texture("irradiance" + suffix, pool(halvings));
    level.scratch = plan_->texture("scratch" + suffix, pool(halvings));
    if (sparse()) level.border = passes::make_tile_lists(*plan_, "border" + suffix, squares(), side);
    if (mask() == Mask::tiles) level.lit = passes::make_tile_lists(*plan_, "lit" + suffix, squares(), side);
    if (mask() == Mask::depth)
      level.depth_mask = plan_->texture("depth mask" + suffix, pool(halvings, VK_FORMAT_D32_SFLOAT));
    return level;
  }

  // `all` are of a run of skin meshes, in their order.
  void add_light(const std::vector<MapSquare>& all) {
    const Level& level = levels_.front();
    passes::Irradiance::Settings irradiance{.squares = all,
                                            .cull = settings_.optimise.cull,
                                            .environment = settings_.environment,
                                            .soft_shadows = settings_.soft_shadows,
                                            .clip = settings_.optimise.clip,
                                            .cut_out = cut_out(),
                                            .through = {},
                                            .mm_per_unit = settings_.mm_per_unit};
    if (settings_.translucency)
      for (const SkinPart& part : settings_.skin) irradiance.through.push_back(part.profile);
    plan_->add<passes::Irradiance>(name("irradiance"),
                                   {level.light, screen_.shadow(), screen_.entering(), joining_}, irradiance);
    if (settings_.translucency)
      plan_->add<passes::TransmissionMisses>(name("count transmission misses"),
                                             {screen_.shadow(), screen_.entering(), screen_.counters()},
                                             {.irradiance = irradiance, .slot = counter_transmission_misses});
    for (std::uint32_t mesh = all.front().mesh; mesh <= all.back().mesh; ++mesh)
      plan_->add<passes::Count>(
          name("count texels", mesh), {level.light, screen_.counters()},
          {.slot = mesh_counter(mesh, 0, counter_lit_texels), .squares = of_mesh(all, mesh)});
    add_masks(level, all);
  }

  // Goes on in smaller maps with the light of one skin mesh.
  void add_halved(const Level& level, frame::TextureId light, const std::vector<MapSquare>& from,
                  const std::vector<MapSquare>& to) {
    plan_->add<passes::Downsample>(name(at("downsample", level), to.front().mesh),
                                   {light, stretch_of(to.front().mesh), level.light},
                                   {.from = from, .to = to});
    add_masks(level, to);
  }

  // What the convolutions of a level need beside its light: the other side of seams, a border, and where
  // there is none.
  void add_masks(const Level& level, const std::vector<MapSquare>& all) {
    const auto label = [&](std::string_view what) { return name(at(what, level)); };
    plan_->add<Gutters>(label("irradiance gutters"), {level.light}, {.squares = all});
    if (sparse()) add_dilation(level, all);
    for (std::uint32_t mesh = all.front().mesh; mesh <= all.back().mesh; ++mesh)
      if (const std::vector<MapSquare> squares = of_mesh(all, mesh); !squares.empty())
        plan_->add<passes::Count>(name(at("count masked texels", level), mesh),
                                  {level.light, screen_.counters()},
                                  {.slot = mesh_counter(mesh, level.halvings, counter_masked_texels),
                                   .threshold = 0.5f,
                                   .absolute = true,
                                   .squares = squares});
    if (mask() == Mask::depth)
      plan_->add<passes::DepthMask>(label("depth mask"), {level.light, level.depth_mask}, {.squares = all});
    if (mask() == Mask::tiles) {
      std::vector<frame::TextureId> maps = level.blurred;
      maps.push_back(level.scratch);
      plan_->add<passes::ClearTiles>(label("clear tiles"), {level.lit});
      plan_->add<passes::TileClasses>(label("tile classes"), {level.light, level.lit}, {all});
      plan_->add<passes::Tiles>(label("tiles"), {level.lit, screen_.counters()},
                                {.squares = all,
                                 .first_slot = mesh_counter(0, level.halvings, counter_tiles),
                                 .slot_stride = counter_mesh_stride});
      plan_->add<passes::IdleTiles>(label("idle tiles"), {level.lit, maps}, {.squares = all});
    }
  }

  void add_dilation(const Level& level, const std::vector<MapSquare>& all) {
    const auto label = [&](std::string_view what) { return name(at(what, level)); };
    plan_->add<passes::ClearTiles>(label("clear border tiles"), {level.border});
    plan_->add<passes::TileClasses>(label("border tile classes"), {level.light, level.border}, {all});
    plan_->add<passes::Tiles>(label("border tiles"), {level.border, screen_.counters()},
                              {.squares = all, .what = passes::Tiles::What::border});
    for (std::uint32_t mesh = all.front().mesh; mesh <= all.back().mesh; ++mesh)
      if (const std::vector<MapSquare> squares = of_mesh(all, mesh); !squares.empty())
        plan_->add<passes::Dilate>(name(at("dilate", level), mesh),
                                   {level.light, stretch_of(mesh), level.border}, {squares});
    if (level.halvings > 0) return;
    for (std::size_t g = 0; g < joining_.size(); ++g)
      for (std::uint32_t mesh = all.front().mesh; mesh <= all.back().mesh; ++mesh)
        plan_->add<passes::Dilate>(name(fmt::format("dilate joining {}", g + 1), mesh),
                                   {joining_[g], stretch_of(mesh), level.border}, {of_mesh(all, mesh)});
  }

  // Of the nearest head.
  frame::TextureId add_visibility() {
    const frame::TextureId picture = plan_->texture(
        "visibility",
        {.width = settings_.map_size, .height = settings_.map_size, .format = VK_FORMAT_R16G16B16A16_SFLOAT},
        frame::Lifetime::persistent);
    plan_->add<passes::ShowVisibility>("visibility", {picture},
                                       {.square = square_of(settings_.heads - 1, 0),
                                        .cull = settings_.optimise.cull,
                                        .clip = settings_.optimise.clip,
                                        .cut_out = settings_.skin.front().cut_out});
    return picture;
  }

  // Gaussians compose: blurring a blurred map adds variances, so each term starts from the one before. Seams
  // are refreshed after each step.
  void add_convolution(std::uint32_t mesh, const std::vector<MapSquare>& all) {
    const Level* level = &levels_.front();
    frame::TextureId light = level->light;
    std::vector<MapSquare> squares = all;
    std::size_t term = 0, number = 0;
    bool first = true, joins = false;
    const std::vector<std::size_t> groups =
        passes::transmission_groups(settings_.skin[mesh].profile.terms.size());
    for (const passes::BlurStep& step :
         passes::blur_steps(settings_.skin[mesh].profile, settings_.skin[mesh].max_texels_per_mm)) {
      for (std::size_t g = 1; joins && g < groups.size(); ++g)
        if (groups[g] == term) light = add_transmitted(g, light, *level, all);
      passes::Blur::Settings blur{
          .squares = squares, .variance_mm2 = step.variance_mm2, .texel_averaged = first, .mask = mask()};
      if (halvings_[term] != level->halvings) {
        blur.halvings_before = level->halvings;
        level = &level_of(term);
        blur.squares = on_level(all, *level);
        add_halved(*level, light, squares, blur.squares);
        squares = blur.squares;
        light = level->light;
      }
      const std::string step_name = fmt::format("blur {}", number++);
      // A step between two terms is overwritten by the step that ends the next term: its map serves both.
      const frame::TextureId target = blurred_[term];
      plan_->add<passes::Blur>(name(step_name + " u", mesh),
                               {light, stretch_of(mesh), level->scratch, level->lit, level->depth_mask},
                               blur);
      blur.axis = 1;
      plan_->add<passes::Blur>(name(step_name + " v", mesh),
                               {level->scratch, stretch_of(mesh), target, level->lit, level->depth_mask},
                               blur);
      plan_->add<Gutters>(name(step_name + " gutters", mesh), {target}, {.squares = squares});
      light = target;
      first = false;
      joins = step.ends_term && settings_.translucency;
      if (step.ends_term) ++term;
    }
  }

  const Level& level_of(std::size_t term) const {
    return *std::find_if(levels_.begin(), levels_.end(),
                         [&](const Level& level) { return level.halvings == halvings_[term]; });
  }

  std::vector<MapSquare> on_level(std::vector<MapSquare> squares, const Level& level) const {
    for (MapSquare& square : squares) square = on_level(square, level);
    return squares;
  }
  MapSquare on_level(MapSquare square, const Level& level) const {
    square.origin /= 1u << level.halvings;
    square.halvings = level.halvings;
    return square;
  }

  // Light that the terms from here on bring through the body joins what the terms before have spread:
  // passes/transmission.h.
  frame::TextureId add_transmitted(std::size_t group, frame::TextureId light, const Level& level,
                                   const std::vector<MapSquare>& all) {
    const std::uint32_t mesh = all.front().mesh;
    const std::vector<MapSquare> squares = on_level(all, level);
    frame::TextureId through = joining_[group - 1];
    if (level.halvings > 0) {
      const std::string what = at(fmt::format("downsample joining {}", group), level);
      through = plan_
                    ->add<passes::Downsample>(name(what, mesh),
                                              {through, stretch_of(mesh), halved_joining(group, level)},
                                              {.from = all, .to = squares})
                    .light;
    }
    const frame::TextureId joined =
        plan_
            ->add<passes::AddTransmitted>(name(fmt::format("add transmitted {}", group), mesh),
                                          {light, through}, {.squares = squares})
            .light;
    plan_->add<Gutters>(name(fmt::format("add transmitted {} gutters", group), mesh), {joined},
                        {.squares = squares});
    return joined;
  }

  // Of a group of terms, for all meshes and batches.
  frame::TextureId halved_joining(std::size_t group, const Level& level) {
    const auto [entry, is_new] = halved_joining_.try_emplace({group, level.halvings});
    if (is_new)
      entry->second = plan_->texture(at(fmt::format("joining {}", group), level), pool(level.halvings));
    return entry->second;
  }

  void add_final(const MapSquare& square) {
    const SkinPart& part = settings_.skin[square.mesh];
    const auto count = static_cast<std::ptrdiff_t>(part.profile.terms.size());
    const std::vector<frame::TextureId> lights(blurred_.begin(), blurred_.begin() + count);
    const passes::TermsOnMap terms{.sigmas_mm = sigmas_mm(part.profile),
                                   .even_texels_per_mm = static_cast<float>(part.even_texels_per_mm),
                                   .largest_side = settings_.map_size,
                                   .coarse = part.coarse};
    plan_->add<passes::FinalPass>(
        label("final", settings_, square.instance, square.mesh),
        {lights, screen_.shadow(), screen_.colour(), screen_.depth(), screen_.entering()},
        {.square = square,
         .samples = settings_.samples,
         .clear = screen_.take_clear(),
         .weights = weights(part.profile),
         .halvings = {halvings_.begin(), halvings_.begin() + count},
         .environment = settings_.environment,
         .soft_shadows = settings_.soft_shadows,
         .off_map = part.off_map,
         .cut_out = part.cut_out,
         .emits = part.emits,
         .mixes = settings_.optimise.depth,
         .terms = terms,
         .texels_per_mm = static_cast<float>(part.mean_texels_per_mm),
         .through = settings_.translucency ? std::optional(part.profile) : std::nullopt,
         .mm_per_unit = settings_.mm_per_unit});
    for (const Level& level : levels_)
      plan_->add<passes::UnshadedReads>(
          label(at("count unshaded reads", level), settings_, square.instance, square.mesh),
          {level.blurred.front(), screen_.depth(), screen_.counters()},
          {.square = on_level(square, level),
           .samples = settings_.samples,
           .cut_out = part.cut_out,
           .slot = counter_unshaded_reads,
           .terms = terms});
  }

  static std::vector<MapSquare> of_mesh(const std::vector<MapSquare>& all, std::uint32_t mesh) {
    std::vector<MapSquare> squares;
    std::copy_if(all.begin(), all.end(), std::back_inserter(squares),
                 [&](const MapSquare& s) { return s.mesh == mesh; });
    return squares;
  }

  frame::FramePlan* plan_;
  const FrameSettings& settings_;
  Screen screen_;
  std::uint32_t batch_ = 0;                // of heads and skin meshes
  std::vector<std::uint32_t> halvings_;    // one per term, of the profile with most terms
  std::vector<Level> levels_;              // large to small; the first holds the irradiance
  std::vector<frame::TextureId> blurred_;  // one per term
  std::vector<frame::TextureId> stretch_;  // one per skin mesh of a batch
  // with translucency: what joins at the second and third group of terms
  std::vector<frame::TextureId> joining_;
  std::map<std::pair<std::size_t, std::uint32_t>, frame::TextureId> halved_joining_;  // by group and halvings
};

}  // namespace

FrameOutputs build_texture_space(frame::FramePlan& plan, const FrameSettings& settings) {
  TextureSpace frame(plan, settings);
  for (std::uint32_t head = 0; head < settings.heads; head += settings.heads_per_batch)
    frame.add_batch(head, std::min(settings.heads_per_batch, settings.heads - head));
  return frame.finish();
}

}  // namespace dermis::techniques
