// SPDX-License-Identifier: MIT
// Made-up plans: from each pair of uses to its barrier.
#include "frame/barriers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dermis/error.h"
#include "hazards.h"
#include "made_up.h"
#include "support/thrown.h"

namespace dermis::frame::test {
namespace {

struct Way {
  const char* name;
  PassKind kind;
  Access access;
};

constexpr Way texture_writers[] = {{"colour", PassKind::raster, Access::colour_target},
                                   {"image written by compute", PassKind::compute, Access::storage_write},
                                   {"image written by raster", PassKind::raster, Access::storage_write},
                                   {"copied to", PassKind::copy, Access::copy_target}};
constexpr Way texture_readers[] = {{"sampled by compute", PassKind::compute, Access::sampled},
                                   {"sampled by raster", PassKind::raster, Access::sampled},
                                   {"image read by compute", PassKind::compute, Access::storage_read},
                                   {"image read by raster", PassKind::raster, Access::storage_read},
                                   {"copied from", PassKind::copy, Access::copy_source}};
constexpr Way depth_writers[] = {{"depth", PassKind::raster, Access::depth_target},
                                 {"copied to", PassKind::copy, Access::copy_target}};
constexpr Way depth_readers[] = {{"sampled by compute", PassKind::compute, Access::sampled},
                                 {"sampled by raster", PassKind::raster, Access::sampled},
                                 {"copied from", PassKind::copy, Access::copy_source}};
constexpr Way buffer_writers[] = {{"written by compute", PassKind::compute, Access::storage_write},
                                  {"written by raster", PassKind::raster, Access::storage_write},
                                  {"copied to", PassKind::copy, Access::copy_target}};
constexpr Way buffer_readers[] = {{"read by compute", PassKind::compute, Access::storage_read},
                                  {"read by raster", PassKind::raster, Access::storage_read},
                                  {"copied from", PassKind::copy, Access::copy_source},
                                  {"arguments of a draw", PassKind::raster, Access::indirect_arguments},
                                  {"arguments of a dispatch", PassKind::compute, Access::indirect_arguments},
                                  {"indices of a draw", PassKind::raster, Access::indices}};

std::string join(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

void expect_clean(const FrameGraph& plan) {
  for (const FrameKind& kind : frame_kinds)
    EXPECT_EQ(join(hazards(plan, derive_barriers(plan, kind), kind)), "") << name_of(kind);
}

// A plan of two passes, the second of which must wait for the first exactly as both say.
template <class Id>
void expect_pair(Plan& plan, Id id, const Way& first, const Way& second) {
  SCOPED_TRACE(std::string(first.name) + ", then " + second.name);
  constexpr bool is_texture = std::is_same_v<Id, TextureId>;
  add(plan, "first", first.kind, {{first.access, id}});
  add(plan, "second", second.kind, {{second.access, id}});

  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers.size(), 2u);
  ASSERT_EQ(barriers[1].size(), 1u);
  const Barrier& b = barriers[1].front();
  const Demand from = demand_of(first.access, first.kind, is_texture);
  Demand to = demand_of(second.access, second.kind, is_texture);
  if constexpr (is_texture)
    if (second.access == Access::sampled && only_shaders(plan.textures()[id.index]))
      to.layout = VK_IMAGE_LAYOUT_GENERAL;

  EXPECT_EQ(b.is_texture, is_texture);
  EXPECT_EQ(b.index, id.index);
  EXPECT_FALSE(b.first_use);
  EXPECT_EQ(b.source_stages, from.stages);
  EXPECT_EQ(b.source_access, from.written);
  EXPECT_EQ(b.target_stages, to.stages);
  EXPECT_EQ(b.target_access, to.access);
  EXPECT_EQ(b.old_layout, from.layout);
  EXPECT_EQ(b.new_layout, to.layout);
  expect_clean(plan);
}

template <std::size_t W, std::size_t R>
void expect_all_pairs(const gpu::TextureDesc& desc, const Way (&writers)[W], const Way (&readers)[R]) {
  for (const Way& writer : writers) {
    for (const Way& reader : readers) {
      Plan plan;
      expect_pair(plan, plan.texture("texture", desc), writer, reader);
    }
    for (const Way& again : writers) {
      Plan plan;
      expect_pair(plan, plan.texture("texture", desc), writer, again);
    }
  }
}

TEST(Barriers, TextureWrittenThenUsed) { expect_all_pairs(small_map, texture_writers, texture_readers); }
TEST(Barriers, DepthWrittenThenUsed) { expect_all_pairs(small_depth, depth_writers, depth_readers); }

TEST(Barriers, BufferWrittenThenUsed) {
  for (const Way& writer : buffer_writers) {
    for (const Way& reader : buffer_readers) {
      Plan plan;
      expect_pair(plan, plan.buffer("buffer", small_buffer), writer, reader);
    }
    for (const Way& again : buffer_writers) {
      Plan plan;
      expect_pair(plan, plan.buffer("buffer", small_buffer), writer, again);
    }
  }
}

// One pair in plain figures, so that a mistake shared by all the tables shows.
TEST(Barriers, ColourThenSampledByComputeInFigures) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "blur", PassKind::compute, {{Access::sampled, map}});
  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers[1].size(), 1u);
  const Barrier& b = barriers[1].front();
  EXPECT_EQ(b.source_stages, 0x400u);            // COLOR_ATTACHMENT_OUTPUT
  EXPECT_EQ(b.source_access, 0x100u);            // COLOR_ATTACHMENT_WRITE
  EXPECT_EQ(b.target_stages, 0x800u);            // COMPUTE_SHADER
  EXPECT_EQ(b.target_access, 0x100000000u);      // SHADER_SAMPLED_READ
  EXPECT_EQ(static_cast<int>(b.old_layout), 2);  // COLOR_ATTACHMENT_OPTIMAL
  EXPECT_EQ(static_cast<int>(b.new_layout), 5);  // SHADER_READ_ONLY_OPTIMAL
}

TEST(Barriers, ReadAgainInTheSameStageNeedsNone) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "read", PassKind::compute, {{Access::sampled, map}});
  add(plan, "read again", PassKind::compute, {{Access::sampled, map}});
  EXPECT_TRUE(derive_barriers(plan)[2].empty());
  expect_clean(plan);
}

TEST(Barriers, ReadInANewStageWaitsForTheWrite) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  const BufferId list = plan.buffer("list", small_buffer);

  add(plan, "write", PassKind::compute, {{Access::storage_write, map}, {Access::storage_write, list}});
  add(plan, "compute", PassKind::compute, {{Access::sampled, map}, {Access::storage_read, list}});
  add(plan, "raster", PassKind::raster, {{Access::sampled, map}, {Access::storage_read, list}});
  add(plan, "arguments", PassKind::compute, {{Access::indirect_arguments, list}});

  // All three wait for the first pass alone, so at one boundary.
  const auto barriers = derive_barriers(plan);
  EXPECT_EQ(barriers[1].size(), 5u);
  EXPECT_TRUE(barriers[2].empty() && barriers[3].empty());
  constexpr VkPipelineStageFlags2 raster =
      VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  for (const Barrier& b : barriers[1]) {
    EXPECT_NE(b.source_stages & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, 0u);
    EXPECT_EQ(b.old_layout, b.new_layout);
  }
  EXPECT_EQ(std::ranges::count(barriers[1], raster, &Barrier::target_stages), 2);
  EXPECT_EQ(std::ranges::count(barriers[1], VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT, &Barrier::target_access),
            1);
  expect_clean(plan);
}

// Two chains that know nothing of each other wait at the same boundaries.
TEST(Barriers, StandWhereOthersStand) {
  Plan plan;
  const BufferId a = plan.buffer("a", small_buffer), b = plan.buffer("b", small_buffer);
  add(plan, "write a", PassKind::compute, {{Access::storage_write, a}});
  add(plan, "write b", PassKind::compute, {{Access::storage_write, b}});
  add(plan, "read a", PassKind::compute, {{Access::storage_read, a}});
  add(plan, "read b", PassKind::compute, {{Access::storage_read, b}});
  add(plan, "arguments of a", PassKind::compute, {{Access::indirect_arguments, a}});
  std::vector<std::size_t> counts;
  for (const auto& list : derive_barriers(plan)) counts.push_back(list.size());
  EXPECT_EQ(counts, (std::vector<std::size_t>{2, 0, 3, 0, 0}));
  expect_clean(plan);
}

// What only shaders touch has one layout from its first frame on.
TEST(Barriers, ATextureOfShadersStaysInGeneral) {
  Plan plan;
  const TextureId light = plan.texture("light", small_map), drawn = plan.texture("drawn", small_map);
  add(plan, "write", PassKind::compute, {{Access::storage_write, light}});
  add(plan, "draw", PassKind::raster, {{Access::colour_target, drawn}});
  add(plan, "read", PassKind::compute, {{Access::sampled, light}, {Access::sampled, drawn}});
  for (const auto& list : derive_barriers(plan))
    for (const Barrier& b : list) {
      if (b.index != light.index) continue;
      EXPECT_EQ(b.old_layout, VK_IMAGE_LAYOUT_GENERAL);
      EXPECT_EQ(b.new_layout, VK_IMAGE_LAYOUT_GENERAL);
    }
  EXPECT_EQ(final_layout(plan, light), VK_IMAGE_LAYOUT_GENERAL);
  EXPECT_EQ(final_layout(plan, drawn), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  expect_clean(plan);
}

// A layout change rewrites the image: what could read it before cannot any more.
TEST(Barriers, ReadersAfterALayoutChangeWaitForIt) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "image in compute", PassKind::compute, {{Access::storage_read, map}});
  add(plan, "sampled in raster", PassKind::raster, {{Access::sampled, map}});
  add(plan, "image in raster", PassKind::raster, {{Access::storage_read, map}});
  add(plan, "image in compute again", PassKind::compute, {{Access::storage_read, map}});
  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers[4].size(), 1u);
  EXPECT_NE(barriers[4].front().source_stages & VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, 0u);
  expect_clean(plan);
}

TEST(Barriers, WriteAfterReadsWaitsForAllOfThem) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "compute", PassKind::compute, {{Access::sampled, map}});
  add(plan, "raster", PassKind::raster, {{Access::sampled, map}});
  add(plan, "overwrite", PassKind::copy, {{Access::copy_target, map}});
  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers[3].size(), 1u);
  constexpr VkPipelineStageFlags2 readers = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT |
                                            VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT |
                                            VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  EXPECT_EQ(barriers[3].front().source_stages & readers, readers);
  EXPECT_EQ(barriers[3].front().old_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  expect_clean(plan);
}

TEST(Barriers, TransientContentsAreDiscardedAndWaitForTheLastFrame) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "read", PassKind::compute, {{Access::sampled, map}});
  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers[0].size(), 1u);
  const Barrier& b = barriers[0].front();
  EXPECT_TRUE(b.first_use);
  EXPECT_EQ(b.old_layout, VK_IMAGE_LAYOUT_UNDEFINED);
  EXPECT_EQ(b.new_layout, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  EXPECT_NE(b.source_stages & VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, 0u);
  expect_clean(plan);
}

TEST(Barriers, PersistentContentsKeepTheirLayoutFromFrameToFrame) {
  Plan plan;
  const TextureId history = plan.texture("history", small_map, Lifetime::persistent);
  add(plan, "read", PassKind::compute, {{Access::sampled, history}});
  add(plan, "draw", PassKind::raster, {{Access::colour_target, history}});
  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers[0].size(), 1u);
  EXPECT_TRUE(barriers[0].front().first_use);
  EXPECT_EQ(barriers[0].front().old_layout, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  EXPECT_EQ(barriers[0].front().source_access, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
  EXPECT_EQ(final_layout(plan, history), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  expect_clean(plan);
}

// A frame that ends as it begins has nothing to change, except in the very first frame, when the image has no
// layout yet.
TEST(Barriers, PersistentContentsThatEndAsTheyBeginGetALayoutInTheFirstFrame) {
  Plan plan;
  const TextureId history = plan.texture("history", small_map, Lifetime::persistent);
  const TextureId table = plan.texture("table", small_map, Lifetime::persistent);
  add(plan, "read", PassKind::compute, {{Access::sampled, history}, {Access::sampled, table}});
  add(plan, "read in raster", PassKind::raster, {{Access::sampled, history}, {Access::sampled, table}});
  add(plan, "draw", PassKind::raster, {{Access::colour_target, history}});
  add(plan, "read at the end", PassKind::compute, {{Access::sampled, history}});
  add(plan, "read at the end in raster", PassKind::raster, {{Access::sampled, history}});
  EXPECT_EQ(derive_barriers(plan)[0].size(), 2u);
  expect_clean(plan);
}

TEST(Barriers, PersistentBufferWaitsForTheFrameBefore) {
  Plan plan;
  const BufferId sum = plan.buffer("sum", small_buffer, Lifetime::persistent);
  add(plan, "read", PassKind::compute, {{Access::storage_read, sum}});
  add(plan, "write", PassKind::copy, {{Access::copy_target, sum}});
  const auto barriers = derive_barriers(plan);
  ASSERT_EQ(barriers[0].size(), 1u);
  EXPECT_EQ(barriers[0].front().source_access, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  EXPECT_EQ(barriers[0].front().target_access, VK_ACCESS_2_SHADER_STORAGE_READ_BIT);
  expect_clean(plan);
}

TEST(Barriers, OnlyReadBuffersNeedNone) {
  Plan plan;
  const BufferId table = plan.buffer("table", small_buffer, Lifetime::persistent);
  add(plan, "compute", PassKind::compute, {{Access::storage_read, table}});
  add(plan, "raster", PassKind::raster, {{Access::storage_read, table}});
  for (const auto& list : derive_barriers(plan)) EXPECT_TRUE(list.empty());
  expect_clean(plan);
}

TEST(Barriers, PassesThatOnlyCountAreLeftOutOfOtherFrames) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  const BufferId counter = plan.buffer("counter", small_buffer);
  add(plan, "clear", PassKind::copy, {{Access::copy_target, counter}}, Runs::for_statistics);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "count", PassKind::compute, {{Access::sampled, map}, {Access::storage_write, counter}},
      Runs::for_statistics);
  add(plan, "write", PassKind::compute, {{Access::storage_write, map}});
  const auto with = derive_barriers(plan), without = derive_barriers(plan, {});
  EXPECT_EQ(with[2].size(), 2u);
  EXPECT_TRUE(without[0].empty());
  EXPECT_TRUE(without[2].empty());
  ASSERT_EQ(without[3].size(), 1u);
  EXPECT_EQ(without[3].front().source_stages, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT);
  EXPECT_EQ(with[3].front().old_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_EQ(without[3].front().old_layout, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  expect_clean(plan);
}

TEST(Barriers, AFrameHasWhatItsKindSays) {
  constexpr FrameKind plain{}, first{.first = true}, changed{.changed = true}, counting{.statistics = true};
  for (const FrameKind& kind : frame_kinds) EXPECT_TRUE(kind.has(Runs::every_frame));

  EXPECT_FALSE(plain.has(Runs::once) || plain.has(Runs::when_changed) || plain.has(Runs::for_statistics));
  EXPECT_TRUE(first.has(Runs::once) && first.has(Runs::when_changed)) << "nothing has been made before";
  EXPECT_FALSE(first.has(Runs::for_statistics));
  EXPECT_TRUE(changed.has(Runs::when_changed));
  EXPECT_FALSE(changed.has(Runs::once) || changed.has(Runs::for_statistics));
  EXPECT_TRUE(counting.has(Runs::for_statistics));
  EXPECT_FALSE(counting.has(Runs::once) || counting.has(Runs::when_changed));
}

// What is made once stays as the first frame has left it: the others find it in that layout.
TEST(Barriers, WhatIsMadeOnceIsWrittenInTheFirstFrameOnly) {
  Plan plan;
  const TextureId metric = plan.texture("metric", small_map, Lifetime::persistent);
  add(plan, "make", PassKind::raster, {{Access::colour_target, metric}}, Runs::once);
  add(plan, "use", PassKind::compute, {{Access::sampled, metric}});

  const auto later = derive_barriers(plan, {});
  EXPECT_TRUE(later[0].empty());
  ASSERT_EQ(later[1].size(), 1u);
  EXPECT_EQ(later[1].front().old_layout, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL) << "contents are kept";
  EXPECT_EQ(derive_barriers(plan, {.first = true})[0].size(), 1u);
  expect_clean(plan);
}

TEST(Barriers, FinalLayoutIsThatOfTheLastUseThatTakesPart) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map), unused = plan.texture("unused", small_map);
  add(plan, "draw", PassKind::raster, {{Access::colour_target, map}});
  add(plan, "count", PassKind::compute, {{Access::sampled, map}}, Runs::for_statistics);
  EXPECT_EQ(final_layout(plan, map), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  EXPECT_EQ(final_layout(plan, map, {}), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  EXPECT_EQ(final_layout(plan, unused), VK_IMAGE_LAYOUT_UNDEFINED);
}

TEST(Plan, UsageIsCollectedFromTheAccesses) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  const BufferId list = plan.buffer("list", small_buffer);
  add(plan, "write", PassKind::compute, {{Access::storage_write, map}, {Access::storage_write, list}});
  add(plan, "read", PassKind::raster, {{Access::sampled, map}, {Access::indirect_arguments, list}});
  plan.read_back(map);
  EXPECT_EQ(plan.textures()[map.index].desc.usage,
            static_cast<VkImageUsageFlags>(VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                                           VK_IMAGE_USAGE_TRANSFER_SRC_BIT));
  EXPECT_EQ(plan.buffers()[list.index].desc.usage,
            static_cast<VkBufferUsageFlags>(VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                            VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT));
}

TEST(Plan, TheSameUseTwiceIsOneUse) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  add(plan, "read", PassKind::compute, {{Access::sampled, map}, {Access::sampled, map}});
  EXPECT_EQ(plan.passes().front().uses.size(), 1u);
}

// Two accesses would need two layouts at the same time, and order within a pass.
TEST(Plan, AResourceHasOneAccessInAPass) {
  Plan plan;
  const TextureId map = plan.texture("map", small_map);
  const BufferId list = plan.buffer("list", small_buffer);
  const auto error_of_both = [&](Access first, Access second, auto resource) {
    return tests::thrown<InternalError>([&] {
      add(plan, "both", PassKind::compute, {{first, resource}, {second, resource}});
    });
  };
  for (const std::string& error : {error_of_both(Access::sampled, Access::storage_write, map),
                                   error_of_both(Access::storage_read, Access::storage_write, list)})
    EXPECT_NE(error.find("access == use.access"), std::string::npos) << error;
}

TEST(Plan, AHandleOfNoPlanIsCaught) {
  Plan plan;
  const auto error_of = [&](Access access, auto resource) {
    return tests::thrown<InternalError>([&] { add(plan, "stray", PassKind::compute, {{access, resource}}); });
  };
  for (const std::string& error :
       {error_of(Access::sampled, TextureId{}), error_of(Access::storage_read, BufferId{})})
    EXPECT_NE(error.find("4294967295 vs 0"), std::string::npos) << "both values: " << error;
}

}  // namespace
}  // namespace dermis::frame::test
