// SPDX-License-Identifier: MIT
#include "cli/demo/page.h"

#include <gtest/gtest.h>

namespace dermis::cli::demo {
namespace {

image::Image8 grey(std::uint8_t value) {
  return {.width = 6, .height = 4, .rgba = std::vector<std::uint8_t>(6 * 4 * 4, value)};
}

Page page_of(std::size_t pairs) {
  Page page{.pairs = {},
            .skins = {{.command = "dermis render built-in:dark", .pixels = grey(50), .cost = {}}},
            .credit = "by <somebody>",
            .seconds = 12,
            .next = {{.why = "once & again", .command = "dermis render 'a b'"}}};
  for (std::size_t i = 0; i < pairs; ++i) {
    Pair pair{.title = "a <head>",
              .scattered = {.command = "dermis render 'a&b'", .pixels = grey(200), .cost = {}},
              .lambert = {.command = "dermis render --technique lambert", .pixels = grey(100), .cost = {}}};
    pair.scattered.cost.device = "a device";
    pair.scattered.cost.frame_ms_median = 7;
    page.pairs.push_back(std::move(pair));
  }
  return page;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(DemoPage, HasPicturesCommandsAndSeconds) {
  const std::string page = html(page_of(3));
  EXPECT_EQ(count(page, "id=\"scattered-"), 3u);
  EXPECT_EQ(count(page, "id=\"lambert-"), 3u);
  EXPECT_EQ(count(page, "id=\"skin-"), 1u);
  EXPECT_EQ(count(page, "a &lt;head&gt;</h2>"), 3u);
  EXPECT_NE(page.find("a&amp;b"), std::string::npos);
  EXPECT_NE(page.find("took 12 seconds on a device"), std::string::npos);
  EXPECT_NE(page.find("took 7 ms with scattering"), std::string::npos);
  EXPECT_NE(page.find("by &lt;somebody&gt;"), std::string::npos);
  EXPECT_NE(page.find("once &amp; again"), std::string::npos);
}

TEST(DemoPage, AsksNothingOfTheNetwork) {
  const std::string page = html(page_of(1));
  EXPECT_EQ(count(page, "src=\"http"), 0u);
  EXPECT_EQ(count(page, "href=\"http"), 0u);
}

TEST(DemoPage, NamesNobodyWhereNobodyIsToBeNamed) {
  Page page = page_of(1);
  EXPECT_NE(html(page).find("somebody"), std::string::npos);
  page.credit.clear();
  EXPECT_EQ(html(page).find("somebody"), std::string::npos);
}

}  // namespace
}  // namespace dermis::cli::demo
