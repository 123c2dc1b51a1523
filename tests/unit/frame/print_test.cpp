// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "made_up.h"

namespace dermis::frame::test {
namespace {

void expect_has(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
}

Plan example() {
  Plan plan;
  const TextureId map = plan.texture("light", small_map);
  gpu::TextureDesc shadow = small_depth;
  shadow.layers = 2;
  const TextureId depth = plan.texture("shadow maps", shadow);
  gpu::TextureDesc screen = small_map;
  screen.samples = 4;
  const TextureId colour = plan.texture("colour", screen, Lifetime::persistent);
  const BufferId list = plan.buffer("list", small_buffer, Lifetime::persistent);
  add(plan, "shadow", PassKind::raster, {{Access::depth_target, depth}});
  add(plan, "blur", PassKind::compute,
      {{Access::sampled, depth}, {Access::storage_write, map}, {Access::indirect_arguments, list}});
  add(plan, "final", PassKind::raster, {{Access::sampled, map}, {Access::colour_target, colour}});
  add(plan, "keep", PassKind::copy, {{Access::copy_target, list}});
  return plan;
}

// Columns are padded for a reader; the words and their order are what counts.
std::string words(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c != ' ' || (!out.empty() && out.back() != ' ' && out.back() != '\n')) out += c;
  return out;
}

TEST(PrintText, HasALinePerPassAndResource) {
  EXPECT_EQ(words(print_text(example())),
            "passes\n"
            "shadow raster depth 'shadow maps';\n"
            "blur compute samples 'shadow maps'; writes 'light'; arguments from 'list';\n"
            "final raster samples 'light'; renders to 'colour';\n"
            "keep copy copies to 'list';\n"
            "textures\n"
            "light 8x8 R16G16B16A16_SFLOAT 0.00 MB transient\n"
            "shadow maps 8x8x2 D32_SFLOAT 0.00 MB transient\n"
            "colour 8x8 4 samples R16G16B16A16_SFLOAT 0.00 MB persistent\n"
            "buffers\n"
            "list 64 bytes persistent\n");
}

TEST(PrintText, AnEmptyPlanHasTitlesOnly) { EXPECT_EQ(print_text(Plan()), "passes\ntextures\n"); }

TEST(PrintText, SaysMegabytes) {
  Plan plan;
  plan.texture("map", {.width = 1024, .height = 1024, .format = VK_FORMAT_R16G16B16A16_SFLOAT});
  expect_has(print_text(plan), " 8.39 MB ");
}

TEST(PrintDot, ArrowsGoWithTheData) {
  const std::string dot = print_dot(example());
  EXPECT_TRUE(dot.starts_with("digraph frame {\n"));
  EXPECT_TRUE(dot.ends_with("}\n"));
  for (const char* line : {"  p0 -> t1;\n", "  t1 -> p1;\n", "  p1 -> t0;\n", "  b0 -> p1;\n",
                           "  t0 -> p2;\n", "  p2 -> t2;\n", "  p3 -> b0;\n"})
    expect_has(dot, line);
  expect_has(dot, "p1 [shape=box, style=filled, fillcolor=\"#f2d6c9\", label=\"blur\"]");
  expect_has(dot, "t1 [shape=ellipse, label=\"shadow maps\\n8x8x2 D32_SFLOAT\"]");
  expect_has(dot, "b0 [shape=ellipse, style=dashed, label=\"list\\n64 bytes\"]");
}

TEST(PrintDot, NamesWithQuotesStayInTheirQuotes) {
  Plan plan;
  plan.texture("a \"map\" \\ here", small_map);
  expect_has(print_dot(plan), "label=\"a \\\"map\\\" \\\\ here\\n8x8");
}

}  // namespace
}  // namespace dermis::frame::test
