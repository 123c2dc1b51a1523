// SPDX-License-Identifier: MIT
#include "render/techniques/published/published.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "render/passes/finish/count/count.h"
#include "render/techniques/batches.h"
#include "render/techniques/published/convolution.h"
#include "render/techniques/published/cull.h"
#include "render/techniques/published/final.h"
#include "render/techniques/published/irradiance.h"
#include "render/techniques/published/report.h"
#include "render/techniques/published/stretch.h"
#include "render/techniques/published/visibility.h"
#include "render/techniques/screen.h"

namespace dermis::techniques {
namespace papers {
namespace {

// The maps of the light of one object at a time, of T_max (or less, if no head of the frame uses more).
struct LightMaps {
  frame::TextureId irradiance;
  std::vector<frame::TextureId> blurred;  // one per term
  std::vector<frame::TextureId> joining;  // light through the body, of the second and third group of terms
  frame::TextureId scratch;               // between both axes of a convolution
  frame::TextureId depth_mask;            // valid with Mask::depth

  LightMaps(passes::FramePlan& plan, const FrameSettings& s);
  std::vector<frame::TextureId> all() const;
};

LightMaps::LightMaps(passes::FramePlan& plan, const FrameSettings& s) {
  if (s.skin.empty()) return;
  const std::uint32_t side = s.square_side;
  gpu::TextureDesc map{.width = side, .height = side, .format = passes::light_format};
  std::size_t terms = 0;
  for (const PlannedMesh& part : s.skin) terms = std::max(terms, part.profile.terms.size());

  for (std::size_t k = 0; k < terms; ++k) blurred.push_back(plan.texture(fmt::format("light {}", k), map));
  irradiance = plan.texture("irradiance", map);
  scratch = plan.texture("scratch", map);
  for (std::size_t g = 1; s.translucency && g < passes::transmission_groups(terms).size(); ++g)
    joining.push_back(plan.texture(fmt::format("joining {}", g), map));
  map.format = passes::depth_format;
  if (mask_of(s) == Mask::depth) depth_mask = plan.texture("depth mask", map);
}

std::vector<frame::TextureId> LightMaps::all() const {
  std::vector<frame::TextureId> maps = blurred;
  maps.insert(maps.end(), joining.begin(), joining.end());
  for (const frame::TextureId map : {irradiance, scratch, depth_mask})
    if (map.valid()) maps.push_back(map);
  return maps;
}

// Adds the passes of an object, [JG08] figure 2: irradiance map, convolutions, sum.
class AddObject {
 public:
  AddObject(passes::FramePlan& plan, const FrameSettings& s, Screen& screen, const LightMaps& maps,
            frame::BufferId kept, const std::vector<frame::TextureId>& stretch, const Object& object,
            std::uint32_t number)
      : plan_(&plan),
        s_(&s),
        screen_(&screen),
        maps_(&maps),
        kept_(kept),
        object_(object),
        part_(&s.skin[object.mesh]),
        stretch_(stretch[part_->unwrap]),
        number_(number) {
    const auto groups = passes::transmission_groups(part_->profile.terms.size());
    if (s.translucency) {
      joining_.assign(maps.joining.begin(),
                      maps.joining.begin() + static_cast<std::ptrdiff_t>(groups.size() - 1));
      through_ = part_->through(object.mesh);
    }
  }

  void add() {
    add_irradiance();
    add_mask();
    add_convolutions();
    add_final();
  }

 private:
  std::string name(std::string_view what) const {
    const bool several = s_->head_count() > 1 || s_->most_meshes() > 1;
    return several ? fmt::format("{} batch {}", what, number_) : std::string(what);
  }

  void add_count(std::string_view what, ObjectCounter which) {
    plan_->add<passes::Count>(name(what), {maps_->irradiance, screen_->counters()},
                              {.slot = object_counter(*s_, 0, part_->in_model, which),
                               .slots_per_head = counters_of_object * s_->most_meshes(),
                               .squares = {object_}});
  }

  // [DLE07] sec. 3.2, less what [JG08] sec. 3 and 5 leave out.
  void add_irradiance() {
    if (s_->optimise.cull) plan_->add<Cull>(name("cull triangles"), {kept_}, {object_});
    const LitMesh mesh{.object = object_,
                       .clip = s_->optimise.clip,
                       .cut_out = part_->cut_out,
                       .environment = s_->environment,
                       .soft_shadows = s_->soft_shadows,
                       .through = through_,
                       .shadow = screen_->shadow(),
                       .entering = screen_->entering(),
                       .kept = s_->optimise.cull ? kept_ : frame::BufferId{}};
    plan_->add<Irradiance>(name("irradiance"), {maps_->irradiance, joining_}, {mesh});
    if (through_)
      plan_->add<MissedLight>(name("count transmission misses"), {screen_->counters()},
                              {mesh, counter_missed_light});
    add_count("count texels", counter_lit_texels);
  }

  // Seams, and what marks the texels that convolutions skip.
  void add_mask() {
    plan_->add<Seams>(name("irradiance gutters"), {maps_->irradiance}, {.object = object_});
    add_count("count masked texels", counter_masked_texels);
    if (mask_of(*s_) == Mask::depth)
      plan_->add<DepthMask>(name("depth mask"), {maps_->irradiance, maps_->depth_mask}, {object_});
  }

  // [DLE07] sec. 3.3: each Gaussian starts from the one before, narrow to wide.
  void add_convolutions() {
    const std::vector<std::size_t> groups = passes::transmission_groups(part_->profile.terms.size());
    const std::vector<Step> steps = steps_of(part_->profile, s_->chain_texels_per_mm(*part_));
    frame::TextureId light = maps_->irradiance;
    std::size_t term = 0;

    for (std::size_t i = 0; i < steps.size(); ++i) {
      // A group of terms begins: its light through the body joins.
      const bool term_begins = i > 0 && steps[i - 1].ends_term;
      for (std::size_t g = 1; term_begins && through_ && g < groups.size(); ++g)
        if (groups[g] == term) light = join_through(g, light);

      add_step(steps[i], i, light, maps_->blurred[term]);
      light = maps_->blurred[term];
      if (steps[i].ends_term) ++term;
    }
  }

  frame::TextureId join_through(std::size_t group, frame::TextureId light) {
    const frame::TextureId joined = joining_[group - 1];
    const std::string what = fmt::format("add transmitted {}", group);
    plan_->add<JoinThrough>(name(what), {light, joined}, {object_});
    plan_->add<Seams>(name(what + " gutters"), {joined}, {.object = object_});
    return joined;
  }

  void add_step(const Step& step, std::size_t number, frame::TextureId light, frame::TextureId target) {
    Blur::Settings blur{.object = object_,
                        .variance_mm2 = step.variance_mm2,
                        .first = number == 0,
                        .axis = 0,
                        .alpha_test = mask_of(*s_) == Mask::alpha};
    const std::string what = fmt::format("blur {}", number);
    plan_->add<Blur>(name(what + " u"), {light, stretch_, maps_->scratch, maps_->depth_mask}, blur);
    blur.axis = 1;
    plan_->add<Blur>(name(what + " v"), {maps_->scratch, stretch_, target, maps_->depth_mask}, blur);
    plan_->add<Seams>(name(what + " gutters"), {target}, {.object = object_});
  }

  // [DLE07] sec. 3.4.
  void add_final() {
    const std::vector<frame::TextureId> lights(
        maps_->blurred.begin(),
        maps_->blurred.begin() + static_cast<std::ptrdiff_t>(part_->profile.terms.size()));
    plan_->add<Final>(name("final"), {lights, screen_->shadow(), screen_->colour(), screen_->depth()},
                      {.object = object_,
                       .part = *part_,
                       .samples = s_->samples,
                       .format = s_->picture_format(),
                       .clear = screen_->take_clear(),
                       .environment = s_->environment,
                       .soft_shadows = s_->soft_shadows});
    plan_->add<UnshadedReads>(name("count unshaded reads"),
                              {lights.front(), screen_->depth(), screen_->counters()},
                              {object_, s_->samples, part_->cut_out, counter_unshaded_reads});
  }

  passes::FramePlan* plan_;
  const FrameSettings* s_;
  Screen* screen_;
  const LightMaps* maps_;
  frame::BufferId kept_;
  Object object_;
  const PlannedMesh* part_;
  frame::TextureId stretch_;
  std::uint32_t number_;
  std::vector<frame::TextureId> joining_;
  std::optional<passes::ThroughMesh> through_;
};

// The first meshes of a head come last, so that what `show` reads is of the first one.
std::vector<Object> objects_of(const FrameSettings& s, std::uint32_t head) {
  std::vector<Object> objects;
  const Model& model = s.model_of(head);
  for (std::uint32_t i = model.meshes; i-- > 0;)
    objects.push_back({.head = head, .mesh = model.first_mesh + i});
  return objects;
}

// Makes the stretch map of each unwrap.
std::vector<frame::TextureId> add_stretch(passes::FramePlan& plan, const FrameSettings& s) {
  const gpu::TextureDesc desc{.width = s.most_side, .height = s.most_side, .format = passes::light_format};
  std::map<std::uint32_t, Object> by_unwrap;
  for (std::uint32_t head = 0; head < s.head_count(); ++head)
    for (const Object& object : objects_of(s, head))
      by_unwrap.try_emplace(s.skin[object.mesh].unwrap, object);

  std::vector<frame::TextureId> maps;
  for (const auto& [unwrap, object] : by_unwrap) {
    maps.resize(unwrap + 1);
    const frame::TextureId map =
        plan.texture(label_part("stretch", s, unwrap), desc, frame::Lifetime::persistent);
    plan.add<Stretch>(label_part("stretch", s, unwrap), {map}, {object});
    plan.add<Seams>(label_part("stretch gutters", s, unwrap), {map}, {.object = object, .of_stretch = true});
    maps[unwrap] = map;
  }
  return maps;
}

frame::BufferId make_kept(passes::FramePlan& plan, const FrameSettings& s) {
  std::uint64_t triangles = 1;
  for (const PlannedMesh& part : s.skin) triangles = std::max<std::uint64_t>(triangles, part.triangles);
  return plan.buffer("kept triangles", {.bytes = 3 * sizeof(std::uint32_t) * triangles});
}

// Names what `show` can name: maps of the last object.
void add_shows(FrameOutputs& out, passes::FramePlan& plan, const FrameSettings& s, const LightMaps& maps,
               const std::vector<frame::TextureId>& stretch) {
  std::uint32_t head = s.head_count() - 1;
  while (head > 0 && s.model_of(head).meshes == 0) --head;
  const Object object{.head = head, .mesh = s.model_of(head).first_mesh};
  const auto light = [&](frame::TextureId map, Shown::Needs needs, std::uint32_t term) {
    return Shown{.map = map, .as = Shown::As::light, .used_square = true, .needs = needs, .term = term};
  };

  out.shows["irradiance"] = light(maps.irradiance, Shown::Needs::irradiance, 0);
  for (std::uint32_t k = 0; k < maps.blurred.size(); ++k)
    out.shows[fmt::format("blur:{}", k)] = light(maps.blurred[k], Shown::Needs::term, k);
  const frame::TextureId metric = stretch[s.skin[object.mesh].unwrap];
  out.shows["stretch"] = {.map = metric};
  out.shows["texel-density"] = {.map = metric, .as = Shown::As::texel_density};

  if (s.visibility) {
    const frame::TextureId visibility = plan.texture(
        "visibility", {.width = s.most_side, .height = s.most_side, .format = passes::light_format},
        frame::Lifetime::persistent);
    plan.add<Visibility>("visibility", {visibility},
                         {object, s.optimise.cull, s.optimise.clip, s.skin[object.mesh].cut_out});
    out.shows["visibility"] = {.map = visibility, .used_square = true};
  }
  for (const auto& [name, shown] : out.shows) plan.read_back(shown.map);
}

// [JG08] figure 2, in its order. Of many heads, one goes through all steps after the other.
FrameOutputs build(passes::FramePlan& plan, const FrameSettings& s) {
  Screen screen(plan, s, counter_count(s));
  const LightMaps maps(plan, s);
  const bool culls = s.optimise.cull && !s.skin.empty();
  const frame::BufferId kept = culls ? make_kept(plan, s) : frame::BufferId{};
  const std::vector<frame::TextureId> stretch = add_stretch(plan, s);
  std::uint32_t number = 0;

  for (const Batch& batch : batches_of(s)) {
    screen.add_shadows(batch);
    for (std::uint32_t head = batch.first_head; head < batch.first_head + batch.heads; ++head)
      for (const Object& object : objects_of(s, head))
        AddObject(plan, s, screen, maps, kept, stretch, object, number++).add();
    screen.add_surfaces(batch);
    screen.add_blended(batch);
  }

  FrameOutputs out = screen.finish();
  if (s.skin.empty()) return out;
  out.light_maps = maps.all();
  add_shows(out, plan, s, maps, stretch);
  return out;
}

FrameOutputs maps(passes::FramePlan& plan, const FrameSettings& s) {
  FrameOutputs out;
  out.shadow_maps = Screen(plan, s, counter_count(s)).shadow_maps();
  out.light_maps = LightMaps(plan, s).all();
  return out;
}

}  // namespace
}  // namespace papers

constinit const Technique published{.name = "published",
                                    .summary =
                                        "the papers' technique as they have it (d'Eon et al. 2007; "
                                        "Jimenez and Gutierrez 2008)",
                                    .uses_profile = true,
                                    .has_light_maps = true,
                                    .as_published = true,
                                    .build = papers::build,
                                    .maps = papers::maps,
                                    .report = papers::report,
                                    .gutters = papers::gutters};

}  // namespace dermis::techniques
