// SPDX-License-Identifier: MIT
// The frames that are really drawn: no hazard in them, and no barrier that could be left out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hazards.h"
#include "render/passes/pixels/labels/labels_io.h"
#include "render/techniques/memory.h"
#include "render/techniques/technique.h"
#include "support/sanitized.h"
#include "tissue/gaussians/known.h"

namespace dermis::frame::test {
namespace {

struct Case {
  std::string name;
  const techniques::Technique* technique;
  techniques::FrameSettings settings;
};

// Some heads of one model with some equal skin meshes.
void set_heads(techniques::FrameSettings& s, std::uint32_t heads, std::size_t parts, bool more = false) {
  s.skin.assign(parts, {.profile = gaussians::skin_six(),
                        .max_uv_per_mm = 4.0 / s.most_side,
                        .mean_uv_per_mm = 4.0 / s.most_side});
  s.set_most_side(s.most_side);
  for (std::uint32_t i = 0; i < parts; ++i) s.skin[i].unwrap = s.skin[i].in_model = i;
  s.models = {{.meshes = static_cast<std::uint32_t>(parts), .has_surfaces = more, .has_blended = more}};
  s.heads.assign(heads, 0);
}

// Meshes whose blurs differ in their number of steps, and in their terms on maps.
void add_blurs_that_differ(std::vector<Case>& all) {
  techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 256, .shadow_size = 64};
  set_heads(s, 2, 3);
  s.skin[0].max_uv_per_mm = s.skin[0].mean_uv_per_mm = 1.0 / s.most_side;
  s.skin[0].first_mapped = 4;
  s.skin[1].max_uv_per_mm = 40.0 / s.most_side;
  s.skin[2].profile.terms.resize(2);
  s.heads_per_batch = 2;
  s.optimise = {.cull = true, .depth = true, .clip = true};
  s.translucency = true;
  all.push_back({"chains that differ", &techniques::find_technique("texture-space"), std::move(s)});
}

std::vector<Case> cases() {
  std::vector<Case> all;

  for (const techniques::Technique* technique : techniques::techniques())
    for (const std::uint32_t heads : {1u, 2u})
      for (const std::size_t parts : {0u, 1u, 2u})
        for (const std::uint32_t samples : {1u, 4u})
          for (const bool more : {false, true}) {
            techniques::FrameSettings s{.width = 64,
                                        .height = 48,
                                        .samples = samples,
                                        .most_side = 64,
                                        .shadow_size = 64,
                                        .shadow_layers = 2};
            set_heads(s, heads, parts, more);
            s.bloom = more ? 0.05f : 0.0f;
            s.labels = more ? (1u << LABEL_COUNT) - 1 : 0;
            s.translucency = more && parts > 0 && technique->has_light_maps;
            all.push_back({fmt::format("{}, {} heads of {} skin parts, {} samples{}", technique->name, heads,
                                       parts, samples, more ? ", surfaces, bloom, labels" : ""),
                           technique, std::move(s)});
          }

  // Take three heads two at a time.
  for (const std::size_t parts : {1u, 2u})
    for (const bool sparse : {false, true}) {
      techniques::FrameSettings s{
          .width = 64, .height = 48, .samples = 1, .most_side = 64, .shadow_size = 64};
      set_heads(s, 3, parts);
      s.heads_per_batch = 2;
      s.optimise = {.cull = sparse, .depth = true, .clip = sparse};
      s.translucency = true;
      all.push_back({fmt::format("two batches, {} skin parts{}", parts, sparse ? ", cull and clip" : ""),
                     &techniques::find_technique("texture-space"), std::move(s)});
    }

  techniques::FrameSettings parts{
      .width = 64, .height = 48, .samples = 1, .most_side = 64, .shadow_size = 64};
  parts.meshes_per_batch = 2;
  parts.optimise = {.cull = true, .depth = true, .clip = true};
  parts.translucency = true;
  set_heads(parts, 1, 3);
  all.push_back(
      {"2 of 3 skin parts at a time", &techniques::find_technique("texture-space"), std::move(parts)});

  // Heads of two assets, one of them with two profiles, in batches that hold some of each.
  for (const std::uint32_t heads_per_batch : {1u, 3u, 5u}) {
    techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 64, .shadow_size = 64};
    set_heads(s, 5, 4);
    s.skin[3].unwrap = s.skin[2].unwrap;
    for (std::uint32_t i = 2; i < 4; ++i) s.skin[i].in_model = 0;
    s.models = {{.first_mesh = 0, .meshes = 2, .has_surfaces = true, .has_blended = true},
                {.first_mesh = 2, .meshes = 1},
                {.first_mesh = 3, .meshes = 1}};
    s.heads = {0, 1, 2, 0, 1};
    s.heads_per_batch = heads_per_batch;
    s.optimise = {.cull = true, .depth = true, .clip = true};
    s.translucency = true;
    all.push_back({fmt::format("three models, {} heads at a time", heads_per_batch),
                   &techniques::find_technique("texture-space"), std::move(s)});
  }
  add_blurs_that_differ(all);
  return all;
}

std::string first_of(const std::vector<std::string>& lines) {
  return lines.empty() ? "" : fmt::format("{} (of {})", lines.front(), lines.size());
}

TEST(TechniqueFrames, HaveNoHazard) {
  for (const Case& c : cases()) {
    passes::FramePlan plan;
    c.technique->build(plan, c.settings);
    EXPECT_GE(plan.passes().size(), 3u) << c.name;
    for (const FrameKind& kind : frame_kinds)
      EXPECT_EQ(first_of(hazards(plan, derive_barriers(plan, kind), kind)), "")
          << c.name << ", " << name_of(kind);
  }
}

// Each barrier is there for a reason: without it the checker must complain. This also shows that the checker
// sees every pass.
TEST(TechniqueFrames, HaveNoBarrierTooMany) {
  const std::size_t every = tests::turns<std::size_t>(1, 16);
  std::size_t number = 0, removed = 0;
  for (const Case& c : cases()) {
    passes::FramePlan plan;
    c.technique->build(plan, c.settings);

    for (const FrameKind& kind : {FrameKind{}, whole_frame}) {
      const auto barriers = derive_barriers(plan, kind);
      for (std::size_t p = 0; p < barriers.size(); ++p)
        for (std::size_t k = 0; k < barriers[p].size(); ++k) {
          if (number++ % every != 0) continue;
          ++removed;
          auto fewer = barriers;
          fewer[p].erase(fewer[p].begin() + static_cast<std::ptrdiff_t>(k));

          const Barrier& b = barriers[p][k];
          EXPECT_FALSE(hazards(plan, fewer, kind).empty())
              << c.name << ": nothing is missed without the barrier of '"
              << (b.is_texture ? plan.textures()[b.index].name : plan.buffers()[b.index].name) << "' before '"
              << plan.passes()[p].name << "', " << name_of(kind);
        }
    }
  }

  EXPECT_GT(removed, 500 / every);
}

// Who asks for labels gets a pass that draws and one that writes them at the end, and the frame before it is
// as it was.
TEST(TechniqueFrames, GrowByThePassesOfLabels) {
  for (const techniques::Technique* technique : techniques::techniques()) {
    techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 64, .shadow_size = 64};
    set_heads(s, 2, 2, true);
    passes::FramePlan without, with;
    EXPECT_FALSE(technique->build(without, s).labels.valid());
    s.labels = LABEL_DEPTH;
    EXPECT_TRUE(technique->build(with, s).labels.valid());

    ASSERT_EQ(with.passes().size(), without.passes().size() + 2);
    for (std::size_t p = 0; p < without.passes().size(); ++p) {
      EXPECT_EQ(with.passes()[p].name, without.passes()[p].name);
      EXPECT_NE(without.passes()[p].name, "labels");
    }
    EXPECT_EQ(with.passes()[without.passes().size()].name, "labels");
    EXPECT_EQ(with.passes().back().name, "label planes");
    EXPECT_EQ(with.passes().back().runs, Runs::every_frame);
  }
}

// Heads go through each pass together, of however many assets they are.
// As published, one head goes through all of them after the other.
TEST(TechniqueFrames, OfManyHeadsHaveThePassesOfOne) {
  for (const techniques::Technique* technique : techniques::techniques())
    for (const bool translucency : {false, true}) {
      if (technique->as_published) continue;
      const auto passes_of = [&](std::uint32_t heads, std::uint32_t models) {
        techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 256, .shadow_size = 64};
        set_heads(s, heads, models, true);
        s.models.clear();
        for (std::uint32_t m = 0; m < models; ++m) {
          s.models.push_back({.first_mesh = m, .meshes = 1, .has_surfaces = true, .has_blended = true});
          s.skin[m].in_model = 0;
        }
        for (std::uint32_t head = 0; head < heads; ++head) s.heads[head] = head % models;
        s.heads_per_batch = heads;
        s.optimise = {.cull = true, .depth = true, .clip = true};
        s.translucency = translucency;

        passes::FramePlan plan;
        technique->build(plan, s);
        std::vector<std::string> names;
        for (const PassNode& pass : plan.passes()) names.push_back(pass.name);
        return names;
      };
      EXPECT_EQ(passes_of(64, 6), passes_of(1, 1)) << technique->name << translucency;
    }
}

// A short chain beside a long one adds no pass, and a dense mesh no more than its own steps.
TEST(TechniqueFrames, ChainsThatDifferTakeTheirCommonStepsTogether) {
  const auto blurs = [](const std::vector<double>& densities, std::size_t terms_of_last) {
    techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 256, .shadow_size = 64};
    set_heads(s, 1, densities.size());
    for (std::size_t i = 0; i < densities.size(); ++i) s.skin[i].max_uv_per_mm = densities[i] / s.most_side;
    s.skin.back().profile.terms.resize(terms_of_last);
    passes::FramePlan plan;
    techniques::find_technique("texture-space").build(plan, s);
    return std::ranges::count_if(plan.passes(),
                                 [](const PassNode& pass) { return pass.name.starts_with("blur"); });
  };
  EXPECT_GT(blurs({40}, 6), blurs({4}, 6));
  EXPECT_EQ(blurs({40, 4}, 6), blurs({40}, 6));
  EXPECT_EQ(blurs({4, 40}, 6), blurs({40}, 6));
  EXPECT_EQ(blurs({4, 4}, 2), blurs({4}, 6));
}

// The lists of tiles are made for all meshes at once.
TEST(TechniqueFrames, ListTheTilesOnce) {
  techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 256, .shadow_size = 64};
  set_heads(s, 1, 2);
  s.skin[1].max_uv_per_mm = 40.0 / s.most_side;
  s.optimise = {.cull = true, .depth = true, .clip = true};
  passes::FramePlan plan;
  techniques::find_technique("texture-space").build(plan, s);
  EXPECT_EQ(std::ranges::count(plan.passes(), "tiles", &PassNode::name), 1);
}

std::uint64_t texture_bytes(const FrameGraph& plan) {
  std::uint64_t sum = 0;
  for (const TextureNode& texture : plan.textures()) sum += gpu::bytes_of(texture.desc);
  return sum;
}

// Three heads more in a batch take three times what one is said to take: nothing else grows.
TEST(TechniqueFrames, MapMemoryIsThatOfOneMoreHead) {
  for (const bool sparse : {false, true})
    for (const bool more : {false, true}) {
      techniques::FrameSettings s{
          .width = 64, .height = 48, .most_side = 256, .shadow_size = 64, .shadow_layers = 3};
      set_heads(s, 4, 1);
      s.optimise = {.cull = sparse, .depth = true, .clip = sparse};
      s.translucency = more;

      const techniques::Technique& technique = techniques::find_technique("texture-space");
      const auto bytes = [&](std::uint32_t heads_per_batch) {
        s.heads_per_batch = heads_per_batch;
        passes::FramePlan plan;
        technique.build(plan, s);
        return texture_bytes(plan);
      };
      const techniques::MapMemory memory = techniques::map_memory(technique, s);
      EXPECT_EQ(bytes(4) - bytes(1), 3 * (memory.light_maps + memory.shadow_maps))
          << (sparse ? "tiles" : "whole squares") << ", translucency " << more;
    }
}

// Light maps of two parts at a time take the same memory however many parts follow one another.
TEST(TechniqueFrames, PartsTakeTurnsWithTheirMaps) {
  const auto plan_of = [&](std::size_t parts) {
    techniques::FrameSettings s{.width = 64, .height = 48, .most_side = 256, .shadow_size = 64};
    s.meshes_per_batch = 2;
    s.optimise = {.cull = true, .depth = true, .clip = true};
    s.translucency = true;
    set_heads(s, 1, parts);
    passes::FramePlan plan;
    techniques::find_technique("texture-space").build(plan, s);
    return plan;
  };
  EXPECT_EQ(texture_bytes(plan_of(100)), texture_bytes(plan_of(4)));
}

}  // namespace
}  // namespace dermis::frame::test
