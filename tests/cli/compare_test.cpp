// SPDX-License-Identifier: MIT
// `dermis compare`: what it prints and writes, and what it refuses.
#include <nlohmann/json.hpp>

#include <limits>

#include "cli/program.h"
#include "image/codec.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Compare : public Program {
 protected:
  std::string png(const std::string& name, int width, int height, std::uint8_t left,
                  std::uint8_t right) const {
    image::Image8 picture{.width = width, .height = height, .rgba = {}};
    for (int i = 0; i < width * height; ++i) {
      const std::uint8_t value = i % width < width / 2 ? left : right;
      picture.rgba.insert(picture.rgba.end(), {value, value, value, 255});
    }
    image::save_png(folder() / name, picture);
    return (folder() / name).string();
  }
  std::string exr(const std::string& name, int width, int height, float value, float first = 0) const {
    image::ImageF picture{.width = width, .height = height, .channels = 3, .values = {}};
    picture.values.assign(static_cast<std::size_t>(width * height * 3), value);
    picture.values[0] += first;
    image::save_exr(folder() / name, picture);
    return (folder() / name).string();
  }
  json found(const Arguments& arguments) const {
    Arguments all{"compare", "--json", "-"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Result result = run(all);
    EXPECT_EQ(result.status, 0) << result.err;
    return json::parse(result.out, nullptr, false);
  }
};

TEST_F(Compare, DisplayPictures) {
  const std::string a = png("a.png", 40, 30, 50, 50), b = png("b.png", 40, 30, 50, 200);
  const json same = found({a, a}), other = found({a, b});
  EXPECT_EQ(same.at("psnr_db"), 100);
  EXPECT_EQ(same.at("flip").at("max"), 0);
  EXPECT_EQ(same.at("rel_mse"), 0);
  EXPECT_LT(other.at("psnr_db"), 10);
  EXPECT_GT(other.at("flip").at("mean"), 0.2);
  EXPECT_EQ(other, found({a, b})) << "two runs are equal";
}

TEST_F(Compare, OnlyTheRegionCounts) {
  const std::string a = png("a.png", 40, 30, 50, 50), b = png("b.png", 40, 30, 50, 200);
  const json right = found({a, b, "--region", png("right.png", 40, 30, 0, 1)});
  EXPECT_EQ(right.at("pixels"), 600);
  EXPECT_NEAR(right.at("psnr_db"), 20 * std::log10(255.0 / 150), 1e-9);
  EXPECT_EQ(found({a, b, "--region", png("left.png", 40, 30, 255, 0)}).at("psnr_db"), 100);
  expect_refused(run({"compare", a, b, "--region", png("small.png", 39, 30, 1, 1)}),
                 "small.png: the region is 39 x 30");
  expect_refused(run({"compare", a, b, "--region", png("black.png", 40, 30, 0, 0)}),
                 "black.png: the region is black everywhere");
  expect_refused(run({"compare", a, b, "--region", exr("region.exr", 40, 30, 1)}), "expected PNG or JPEG");
}

TEST_F(Compare, LinearPictures) {
  const std::string a = exr("a.exr", 20, 20, 0.5f), b = exr("b.exr", 20, 20, 0.6f);
  const json filmic = found({a, b, "--tone-map", "filmic"}), linear = found({a, b, "--tone-map", "linear"});
  EXPECT_EQ(filmic.at("exposures").at("count"), 2);
  EXPECT_NE(filmic.at("psnr_db"), linear.at("psnr_db"));
  EXPECT_EQ(filmic.at("flip"), linear.at("flip")) << "HDR-FLIP has its own curve";
  EXPECT_NEAR(filmic.at("rel_mse"), 0.01 / 0.26, 1e-6);
  expect_refused(run({"compare", a, b, "--tone-map", "sepia"}),
                 "there are: natural, neutral, agx, filmic, srgb, linear");
}

TEST_F(Compare, NoiseAgainstVariances) {
  const std::string a = exr("a.exr", 10, 10, 1), b = exr("b.exr", 10, 10, 1, 0.25f),
                    v = exr("v.exr", 10, 10, 0.01f);
  EXPECT_NEAR(found({a, b, "--z", v}).at("z").at("beyond_2"), 1 / 300.0, 1e-12);
  EXPECT_EQ(found({a, b, "--z", v}).at("z").at("beyond_3"), 0);
  EXPECT_EQ(found({"--z", v, "--z", v, a, b}).at("z").at("beyond_2"), 0) << "variances add up";
  expect_refused(run({"compare", a, b, "--z", exr("small.exr", 9, 10, 1)}), "small.exr: is 9 x 10 pixels");
  expect_refused(run({"compare", a, b, "--z", exr("negative.exr", 10, 10, -1)}),
                 "negative.exr: holds -1; variances are 0 or more");
  const std::string p = png("p.png", 10, 10, 1, 2);
  expect_refused(run({"compare", p, p, "--z", v}), "--z: needs two linear pictures");
}

TEST_F(Compare, PixelsThatAreNoNumbersAreBlackAndSaidToBe) {
  const std::string a = exr("a.exr", 10, 10, 1),
                    b = exr("nan.exr", 10, 10, 1, std::numeric_limits<float>::quiet_NaN());
  const Result result = run({"compare", a, b, "--json", "-"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err.find("dermis: warning: "), 0u);
  EXPECT_NE(result.err.find("nan.exr: 1 values are infinite or not numbers"), std::string::npos)
      << result.err;
  const json j = json::parse(result.out);
  for (const auto& [key, value] : j.at("flip").items()) EXPECT_TRUE(value.is_number()) << key;
}

TEST_F(Compare, PicturesOfOnePixel) {
  EXPECT_GT(found({png("a.png", 1, 1, 0, 0), png("b.png", 1, 1, 255, 255)}).at("flip").at("mean"), 0.9);
  EXPECT_EQ(found({exr("a.exr", 1, 1, 0), exr("b.exr", 1, 1, 0)}).at("flip").at("mean"), 0);
}

TEST_F(Compare, WhatCannotBeCompared) {
  const std::string a = png("a.png", 40, 30, 50, 50), x = exr("x.exr", 40, 30, 1);
  expect_refused(run({"compare", a, png("b.png", 30, 40, 50, 50)}), "b.png: is 30 x 40 pixels, ");
  expect_refused(run({"compare", x, exr("y.exr", 30, 40, 1)}), "y.exr: is 30 x 40 pixels, ");
  expect_refused(run({"compare", x, a}), "a.png: holds display values, ");
  expect_refused(run({"compare", a, x}), "x.exr: holds linear light, ");
  expect_refused(run({"compare", a, (folder() / "none.png").string()}), "none.png: no such file");
  expect_refused(run({"compare", a, folder().string()}), "is a directory");
  expect_refused(run({"compare", a, file("empty.png", "")}), "empty.png: is empty");
  expect_refused(run({"compare", a, file("text.png", "no picture")}),
                 "text.png: is of an unknown picture format");
  expect_refused(run({"compare", a, file("cut.png", read_text(a).substr(0, 60))}), "cut.png");
  expect_refused(run({"compare", file("cut.exr", read_text(x).substr(0, 400)), x}), "cut.exr");
}

// A header that promises 10,000 x 10,000 pixels, more than a comparison takes.
TEST_F(Compare, SizesThatLie) {
  std::string giant = read_text(png("a.png", 4, 4, 1, 2));
  for (const std::size_t at : {std::size_t{16}, std::size_t{20}})
    giant.replace(at, 4, std::string("\0\0\x27\x10", 4));
  expect_refused(run({"compare", file("giant.png", giant), file("giant2.png", giant)}), "giant.png");
  expect_refused(run({"compare", file("giant.png", giant), file("giant2.png", giant)},
                     {.address_space_bytes = 600u << 20}),
                 "giant.png");
}

TEST_F(Compare, AFileForPeopleAndOneForPrograms) {
  const std::string a = png("a.png", 40, 30, 50, 50), b = png("b & <c>.png", 40, 30, 50, 200);
  const std::string page = (folder() / "page.html").string(), numbers = (folder() / "numbers.json").string();
  const Result result = run({"compare", a, b, "--html", page, "--json", numbers});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("FLIP, mean"), std::string::npos);
  EXPECT_GT(json::parse(read_text(numbers)).at("flip").at("mean"), 0);
  const std::string html = read_text(page);
  EXPECT_TRUE(html.starts_with("<!doctype html>"));
  EXPECT_NE(html.find("b &amp; &lt;c&gt;.png"), std::string::npos);
  EXPECT_EQ(html.find("<c>"), std::string::npos);
}

TEST_F(Compare, OutputsThatCannotBe) {
  const std::string a = png("a.png", 4, 4, 1, 2), before = read_text(a);
  expect_refused(run({"compare", a, a, "--html", "-"}), "needs a file");
  expect_refused(run({"compare", a, a, "--html", a}), "names of their own");
  expect_refused(run({"compare", a, a, "--json", a}), "names of their own");
  expect_refused(
      run({"compare", a, a, "--json", (folder() / "x").string(), "--html", (folder() / "." / "x").string()}),
      "names of their own");
  expect_refused(run({"compare", a, a, "--json", (folder() / "none" / "x.json").string()}), "does not exist");
  EXPECT_EQ(read_text(a), before);
  expect_not_understood(run({"compare", a}), "B is required");
  expect_not_understood(run({"compare", a, a, a}), "a.png");
  expect_not_understood(run({"compare", a, a, "--z"}), "--z");
  expect_not_understood(run({"compare", a, a, "--brush"}), "--brush");
}

}  // namespace
}  // namespace dermis::tests
