// SPDX-License-Identifier: MIT
// `render --labels`: what each pixel shows, in files. python/tests/test_label_files.py holds their numbers
// against a session's.
#include <nlohmann/json.hpp>

#include "image/codec.h"
#include "program.h"
#include "tiny_gltf.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

class LabelFiles : public Program {
 protected:
  Result labels(const std::string& list, const std::string& output, const Arguments& more = {}) const {
    Arguments all{"render",     "built-in", "--technique", "lambert", "--size",        "32x24",
                  "--map-size", "64",       "--exposure",  "0",       "--shadow-size", "64",
                  "--labels",   list,       "-o",          output};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  std::string in(const std::string& name) const { return (folder() / name).string(); }
};

TEST_F(LabelFiles, OfAPngAreAFileEachAndASheet) {
  const Result result = labels("depth,normal,region", in("face.png"));
  ASSERT_EQ(result.status, 0) << result.err;
  for (const char* name : {"face.png", "face.depth.png", "face.normal.png", "face.region.png"}) {
    const image::Image8 picture = image::load_image8(folder() / name);
    EXPECT_EQ(picture.width, 32) << name;
    EXPECT_EQ(picture.height, 24) << name;
  }
  const auto sheet = nlohmann::json::parse(read_text(folder() / "face.json"));
  EXPECT_EQ(sheet["labels"].size(), 3u);
  EXPECT_EQ(sheet["labels"]["depth"]["step"], 1e-4);
  EXPECT_EQ(sheet["camera"]["K"][0][2], 15.5) << "the middle of 32 pixels, the first at 0";
  EXPECT_EQ(sheet["instances"].size(), 1u);
}

TEST_F(LabelFiles, OfAnExrAreLayersBesideThePicture) {
  ASSERT_EQ(labels("all", in("face.exr")).status, 0);
  const std::string bytes = read_text(folder() / "face.exr");
  for (const char* channel : {"depth.Z", "normal.X", "instance.id", "thickness.Y"})
    EXPECT_NE(bytes.find(channel), std::string::npos) << channel;
  // Whoever reads colours finds the picture that there is without labels.
  const image::ImageF with = image::load_image_f(folder() / "face.exr");
  const Arguments plain{"render",        "built-in",   "--technique", "lambert",      "--size",
                        "32x24",         "--map-size", "64",          "--exposure",   "0",
                        "--shadow-size", "64",         "-o",          in("plain.exr")};
  ASSERT_EQ(run(plain).status, 0);
  EXPECT_EQ(with.values, image::load_image_f(folder() / "plain.exr").values);
}

TEST_F(LabelFiles, LandmarksStandInTheSheet) {
  ASSERT_EQ(labels("landmarks", in("face.png")).status, 0);
  const auto sheet = nlohmann::json::parse(read_text(folder() / "face.json"));
  EXPECT_TRUE(sheet["labels"].empty()) << "no picture of them";
  ASSERT_EQ(sheet["landmarks"]["instances"].size(), 1u);
  const auto& points = sheet["landmarks"]["instances"][0];
  ASSERT_EQ(points.size(), 70u);
  for (const auto& point : points) {
    ASSERT_EQ(point.size(), 4u);
    EXPECT_TRUE(point[0] > 0 && point[0] < 32 && point[1] > 0 && point[1] < 24) << point;
  }
  EXPECT_LT(points[68][0], points[69][0]) << "the person's right is on the left of a picture from the front";
}

TEST_F(LabelFiles, OfAHeadWithoutLandmarksLackThem) {
  expect_refused(labels("landmarks", picture().string(), {"--heads", "2"}), "camera.heads is 2");
  Arguments square{"render",      file("square.gltf", tiny_gltf()),
                   "--size",      "32x24",
                   "--technique", "lambert",
                   "-o",          picture().string(),
                   "--exposure",  "0",
                   "--labels",    "landmarks"};
  const Result without = run(square);
  EXPECT_EQ(without.status, 1);
  EXPECT_NE(without.err.find("has no landmarks"), std::string::npos) << without.err;
  EXPECT_FALSE(fs::exists(picture())) << "nothing half-written";

  square.back() = "all";
  ASSERT_EQ(run(square).status, 0);
  EXPECT_FALSE(nlohmann::json::parse(read_text(folder() / "picture.json")).contains("landmarks"));

  // A file beside it that is of another head.
  file("square.landmarks.json",
       read_text(fs::path(DERMIS_SOURCE_DIR) / "assets/heads/makehuman.landmarks.json"));
  const Result other = run(square);
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.err.find("square.landmarks.json: mesh 0 of square.gltf has 81 vertices"), std::string::npos)
      << other.err;
}

TEST_F(LabelFiles, WhatNoFileHoldsIsRefused) {
  const std::string out = picture().string();
  expect_refused(labels("dept", out), "did you mean 'depth'?");
  expect_refused(labels("uv", out), "which no PNG holds");
  expect_refused(labels("depth", out, {"--distance", "45"}), "over the 6.5535 that a PNG holds");
  expect_refused(labels("depth", out, {"--show", "stretch"}), "output.show");
  expect_refused(labels("depth", out, {"--stats", in("picture.json")}), "a file of its own");
}

}  // namespace
}  // namespace dermis::tests
