// SPDX-License-Identifier: MIT
#include "cli/demo/page.h"

#include <gtest/gtest.h>

namespace dermis::cli::demo {
namespace {

image::Image8 grey(std::uint8_t value) {
  return {.width = 6, .height = 4, .rgba = std::vector<std::uint8_t>(6 * 4 * 4, value)};
}

Page page_of(std::size_t heads) {
  Page page;
  for (std::size_t i = 0; i < heads; ++i) {
    Pair pair{.name = "a <head>",
              .scattered = {.command = "dermis render 'a&b'", .pixels = grey(200), .cost = {}},
              .lambert = {.command = "dermis render --technique lambert", .pixels = grey(100), .cost = {}}};
    pair.scattered.cost.device = "a device";
    pair.scattered.cost.passes = {{.name = "blur 0 u", .ms = 1.5, .calls = 1},
                                  {.name = "final", .ms = 12.25, .calls = 1},
                                  {.name = "background", .ms = 0.5, .calls = 1}};
    pair.lambert.cost.passes = {{.name = "final", .ms = 3, .calls = 1}};
    page.heads.push_back(std::move(pair));
  }
  return page;
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

TEST(DemoPage, HasPicturesCommandsAndTimes) {
  const std::string page = html(page_of(2));
  EXPECT_EQ(count(page, "id=\"scattered-"), 2u);
  EXPECT_EQ(count(page, "id=\"lambert-"), 2u);
  EXPECT_EQ(count(page, "a &lt;head&gt;</h2>"), 2u);
  EXPECT_NE(page.find("a&amp;b"), std::string::npos);
  EXPECT_NE(page.find("a device"), std::string::npos);

  // The longest pass first; each in its group.
  EXPECT_LT(page.find("12.25"), page.find("1.50"));
  EXPECT_LT(page.find("1.50"), page.find("0.50"));
  EXPECT_EQ(page.find("other</td>"), std::string::npos);
}

TEST(DemoPage, AsksNothingOfTheNetwork) {
  const std::string page = html(page_of(1));
  EXPECT_EQ(count(page, "src=\"http"), 0u);
  EXPECT_EQ(count(page, "href=\"http"), 0u);
}

TEST(DemoPage, ShowsAStripWhereThereIsOne) {
  Page page = page_of(1);
  EXPECT_EQ(html(page).find("id=\"strip\""), std::string::npos);
  page.strip = grey(50);
  page.strip_command = "dermis sequence built-in";
  EXPECT_NE(html(page).find("id=\"strip\""), std::string::npos);
}

}  // namespace
}  // namespace dermis::cli::demo
