// SPDX-License-Identifier: MIT
#include "tools/report/html.h"

#include <gtest/gtest.h>

#include "image/codec.h"
#include "tools/report/escape.h"

namespace dermis::report {
namespace {

TEST(Html, TextStandsForItself) {
  EXPECT_EQ(escape("a < b & \"c\" > 'd'"), "a &lt; b &amp; &quot;c&quot; &gt; &#39;d&#39;");
  EXPECT_EQ(escape("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x99\x82"), "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x99\x82");
  EXPECT_EQ(escape("line\nbreak\x01\x7f"), "line break  ");
  EXPECT_EQ(escape("\xff\xc3(\xe2\x82"), "\xef\xbf\xbd\xef\xbf\xbd(\xef\xbf\xbd\xef\xbf\xbd") << "no UTF-8";
  EXPECT_EQ(escape(""), "");
}

std::vector<std::byte> from_base64(std::string_view text) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::byte> bytes;
  unsigned bits = 0, have = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    EXPECT_NE(digit, std::string_view::npos);
    bits = bits << 6 | static_cast<unsigned>(digit), have += 6;
    if (have >= 8) bytes.push_back(static_cast<std::byte>(bits >> (have -= 8) & 255u));
  }
  return bytes;
}

// Sizes of all remainders by three.
TEST(Html, PicturesSurviveTheirUri) {
  std::size_t remainders = 0;
  for (int width = 1; width <= 12; ++width) {
    image::Image8 picture{.width = width, .height = 3, .rgba = {}};
    for (int i = 0; i < width * 3 * 4; ++i)
      picture.rgba.push_back(i % 4 == 3 ? std::uint8_t{255} : static_cast<std::uint8_t>(i * 37));
    const std::string uri = png_uri(picture);
    constexpr std::string_view kind = "data:image/png;base64,";
    ASSERT_TRUE(uri.starts_with(kind));
    EXPECT_EQ((uri.size() - kind.size()) % 4, 0u);
    const std::vector<std::byte> bytes = from_base64(std::string_view(uri).substr(kind.size()));
    remainders |= std::size_t{1} << bytes.size() % 3;
    EXPECT_EQ(bytes, image::encode_png(picture));
    EXPECT_EQ(image::decode_image8(bytes, "uri").rgba, picture.rgba);
  }
  EXPECT_EQ(remainders, 7u) << "the sizes above do not meet every kind of ending";
}

TEST(Html, ScalesAndTables) {
  const std::string scale = magma_scale(0.5);
  EXPECT_NE(scale.find("#000004"), std::string::npos);
  EXPECT_NE(scale.find("#fcfdbf"), std::string::npos);
  for (const char* tick : {">0<", ">0.125<", ">0.25<", ">0.375<", ">0.5<"})
    EXPECT_NE(scale.find(tick), std::string::npos) << tick;
  EXPECT_NE(table({{"<name>", "&"}}).find("<td>&lt;name&gt;</td><td>&amp;</td>"), std::string::npos);
}

TEST(Html, APageHoldsItsTitleAndBody) {
  const std::string page = report::page("a < b", "<p>body</p>");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  EXPECT_NE(page.find("<title>a &lt; b</title>"), std::string::npos);
  EXPECT_NE(page.find("<p>body</p>"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

}  // namespace
}  // namespace dermis::report
