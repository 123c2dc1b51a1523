// SPDX-License-Identifier: MIT
// Files of landmarks: what is wrong with one is said in a line, and one of another head is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "api/asset_state.h"
#include "dermis/error.h"
#include "head/landmarks/known.h"
#include "head/landmarks/places.h"
#include "head/scene/import/shapes.h"
#include "head/scene/surface/measured.h"
#include "support/files.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

const Asset& square() {
  static const Asset made = Asset::State::make(scene::measured(scene::plane(0.2)));
  return made;
}

std::string point(const std::string& triangle, const std::string& weights) {
  return fmt::format(R"({{"mesh": 0, "triangle": {}, "weights": {}}})", triangle, weights);
}

// A file of the square, whose first point is this one.
std::string file_of(const std::string& first, const std::string& mesh = {}, int count = 70) {
  const scene::AssetData& scene = *Asset::State::of(square());
  const landmarks::MeshSize size = landmarks::size_of(scene, 0);
  const auto& corners = scene.primitives.front().indices;
  const std::string some =
      point(fmt::format("[{}, {}, {}]", corners[1], corners[0], corners[2]), "[0.5, 0, 0.5]");
  std::string points = first.empty() ? some : first;
  for (int i = 1; i < count; ++i) points += ", " + some;
  return fmt::format(R"({{"schema": 1, "meshes": [{}], "points": [{}]}})",
                     mesh.empty() ? fmt::format(R"({{"mesh": 0, "vertices": {}, "triangles": {}}})",
                                                size.vertices, size.triangles)
                                  : mesh,
                     points);
}

std::string refused(const std::string& text) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "head.landmarks.json";
  write_text(file, text);
  const std::string said = thrown<InputError>([&] { Landmarks::load(square(), file); });
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  EXPECT_TRUE(said == "nothing was thrown" || said.starts_with(file.string())) << said;
  return said;
}

void expect_refused(const std::string& text, const std::string& says) {
  const std::string said = refused(text);
  EXPECT_NE(said.find(says), std::string::npos) << "expected '" << says << "' in: " << said;
}

TEST(LandmarkFiles, ThatFitAreRead) { EXPECT_EQ(refused(file_of("")), "nothing was thrown"); }

TEST(LandmarkFiles, OfAnotherHeadAreRefused) {
  expect_refused(file_of("", R"({"mesh": 0, "vertices": 14629, "triangles": 28068})"), "14629");
  expect_refused(
      file_of("",
              R"({"mesh": 3, "vertices": 4, "triangles": 2}, {"mesh": 0, "vertices": 1, "triangles": 1})"),
      "mesh 3 of");
  expect_refused(file_of(point("[0, 1, 9999]", "[1, 0, 0]")), "has no triangle 0 1 9999");
}

TEST(LandmarkFiles, ThatAreFaultyAreRefused) {
  expect_refused("", "");
  expect_refused("{", "head.landmarks.json");
  expect_refused("[]", "object");
  expect_refused(R"({"schema": 2})", "schema");
  expect_refused(file_of("", {}, 69), "points");
  expect_refused(file_of(point("[0, 1]", "[1, 0, 0]")), "points[0].triangle");
  expect_refused(file_of(point("[0, 1, -2]", "[1, 0, 0]")), "points[0].triangle[2]");
  expect_refused(file_of(point("[0, 1, 2]", "[0.5, 0, 0]")), "sum to 1");
  expect_refused(file_of(point("[0, 1, 2]", "[1.5, -0.5, 0]")), "points[0].weights[0]");
  expect_refused(file_of(point("[0, 1, 2]", R"([1, 0, "a"])")), "points[0].weights[2]");
  expect_refused(file_of(R"({"mesh": 1, "triangle": [0, 1, 2], "weights": [1, 0, 0]})"), "mesh 1 is not in");
  expect_refused(file_of(R"({"mesh": 0, "triangel": [0, 1, 2], "weights": [1, 0, 0]})"), "triangel");
}

TEST(LandmarkFiles, OfTheLibraryCanBeRead) {
  ASSERT_GE(landmarks::known_files().size(), 3u);
  for (const landmarks::KnownFile& file : landmarks::known_files())
    EXPECT_NO_THROW(
        landmarks::read_sidecar(json::Document(file.text, file.name, landmarks::sidecar_limits).root()))
        << file.name;
  EXPECT_FALSE(landmarks::known_landmarks(*Asset::State::of(square())).has_value());
  EXPECT_FALSE(Landmarks::of(square()).has_value());
}

}  // namespace
}  // namespace dermis::tests
