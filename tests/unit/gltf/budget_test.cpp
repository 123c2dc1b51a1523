// SPDX-License-Identifier: MIT
// Large maps: headers first, a budget for all maps of a file, and what a process takes on the way.
#include <spng.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>

#include "head/scene/import/texture_budget.h"
#include "image/codec.h"
#include "support.h"

#if defined(__SANITIZE_ADDRESS__)
#define DERMIS_SANITIZED 1
#endif

namespace dermis::scene::test {
namespace {

/// A grey picture of one bit per pixel, left half black and right half white, written row by row: many pixels
/// in a small file.
std::string one_bit_png(std::uint32_t width, std::uint32_t height) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                    &spng_ctx_free);

  spng_ihdr header{};
  header.width = width;
  header.height = height;
  header.bit_depth = 1;
  header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
  spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_ihdr(context.get(), &header);
  spng_encode_image(context.get(), nullptr, 0, SPNG_FMT_PNG, SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);

  std::vector<std::uint8_t> row(width / 8);
  std::fill(row.begin() + width / 16, row.end(), std::uint8_t{255});
  for (int result = 0; result == 0;) result = spng_encode_row(context.get(), row.data(), row.size());

  std::size_t size = 0;
  int error = 0;
  const std::unique_ptr<void, decltype(&std::free)> file(spng_get_png_buffer(context.get(), &size, &error),
                                                         &std::free);
  return {static_cast<const char*>(file.get()), size};
}

/// Returns by how much a child's largest resident set grows while it loads a file, MB; infinity if it fails,
/// or `check` of the scene does.
template <class Check>
double peak_mb(const fs::path& file, const LoadOptions& options, const Check& check) {
  const auto peak_kib = [] {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  int ends[2] = {-1, -1};
  if (::pipe(ends) != 0) return INFINITY;
  const pid_t child = ::fork();
  if (child == 0) {
    const Warnings quiet;
    long grown = -1;
    try {
      const long before = peak_kib();
      const AssetData scene = load_gltf(file, options);
      grown = check(scene) ? peak_kib() - before : -1;
    } catch (const std::exception&) {}
    const bool told = ::write(ends[1], &grown, sizeof grown) == sizeof grown;
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  long grown = -1;
  const bool told = ::read(ends[0], &grown, sizeof grown) == sizeof grown;
  ::close(ends[0]);
  ::waitpid(child, nullptr, 0);
  return told && grown >= 0 ? static_cast<double>(grown) * 1024 / 1e6 : INFINITY;
}

/// A triangle whose material shows `images` maps, files in `folder`: a colour map and a normal map in turns.
Builder with_maps(int images) {
  Builder b;
  b.triangle();
  b.json["materials"] = Json::array();
  for (int i = 0; i < images; ++i) {
    b.json["images"].push_back({{"uri", "map" + std::to_string(i) + ".png"}});
    b.json["textures"].push_back({{"source", i}});
  }
  Json material = {{"name", "skin"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
  if (images > 1) material["normalTexture"] = {{"index", 1}};
  b.json["materials"].push_back(material);
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  return b;
}

TEST(TextureBudget, TheLargestMapsAreHalvedAndOneNoteSaysSo) {
  const TempFolder folder;
  write_text(folder.path() / "map0.png", one_bit_png(512, 512));
  write_text(folder.path() / "map1.png", one_bit_png(512, 256));
  const fs::path file = with_maps(2).write(folder.path());
  {
    const Warnings lines;
    const AssetData scene = load_gltf(file, {.texture_budget_mb = 6});
    EXPECT_EQ(scene.images[0].pixels->width, 512);
    EXPECT_FALSE(lines.any_with("texture_budget_mb"));
  }

  // 3.8 + 1.2 MB: the first to a quarter.
  const Warnings lines;
  const AssetData scene = load_gltf(file, {.texture_budget_mb = 3});
  ASSERT_EQ(scene.images.size(), 2u);
  EXPECT_EQ(scene.images[0].pixels->width, 256);
  EXPECT_EQ(scene.images[1].pixels->width, 512);
  EXPECT_EQ(scene.images[0].pixels->at(10, 10)[0], 0);
  EXPECT_EQ(scene.images[0].pixels->at(200, 10)[0], 255);
  EXPECT_TRUE(
      lines.any_with("built.glb: its maps would take 5 MB, the texture budget is 3 MB "
                     "(texture_budget_mb): 'map0.png' is 512 x 512 pixels, read as 256 x 256"))
      << lines.all();
  const std::string said = lines.all();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

// An average in linear light is not the average of values.
TEST(TextureBudget, APictureThatIsColourAndDataIsHalvedForEach) {
  const TempFolder folder;
  write_text(folder.path() / "map0.png", one_bit_png(512, 512));
  Builder b = with_maps(1);
  b.json["materials"][0]["normalTexture"] = {{"index", 0}};
  const fs::path file = b.write(folder.path());
  const Warnings lines;
  EXPECT_EQ(load_gltf(file).images.size(), 1u) << "of full size it serves for both";

  const AssetData scene = load_gltf(file, {.texture_budget_mb = 1});
  ASSERT_EQ(scene.images.size(), 2u);
  const Material& material = scene.materials[0];
  const auto& colour = *scene.images[static_cast<std::size_t>(material.base_colour_map.image)].pixels;
  const auto& data = *scene.images[static_cast<std::size_t>(material.normal_map.image)].pixels;
  EXPECT_NE(material.base_colour_map.image, material.normal_map.image);
  EXPECT_LE(map_bytes(colour.width, colour.height, true) + map_bytes(data.width, data.height, false),
            1'000'000u);
}

TEST(TextureBudget, EveryHeaderIsReadBeforeAnyPictureIsDecoded) {
  const TempFolder folder;
  write_text(folder.path() / "map0.png",
             one_bit_png(512, 512).substr(0, 100));  // damaged, but not its header
  write_text(folder.path() / "map1.png", "no picture at all");
  Builder b = with_maps(2);
  b.json["materials"][0]["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
  b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 1}};
  const tests::LogLines said;
  EXPECT_ERROR(error_of(b.write(folder.path())), "image 'map1.png'");
  EXPECT_TRUE(said.all.empty()) << "an error is one line";
}

// 33 million pixels are 134 MB at full size: a child that reads them at a quarter of each side takes little.
TEST(TextureBudget, TheLargePictureIsNeverInMemory) {
#ifdef DERMIS_SANITIZED
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  const TempFolder folder;
  write_text(folder.path() / "map0.png", one_bit_png(8192, 4096));
  const fs::path file = with_maps(1).write(folder.path());
  EXPECT_LT(peak_mb(file, {.texture_budget_mb = 40},
                    [](const AssetData& scene) { return scene.images[0].pixels->width == 2048; }),
            60);
}

// Exporters write an image for each texture. One that is named twice, by its place or its bytes, is decoded
// once and held once; and an asset that is loaded again takes it from the one before.
TEST(TextureBudget, APictureIsHeldOnceHoweverManyImagesNameIt) {
  const TempFolder folder;
  const std::string png = one_bit_png(64, 32);
  Builder b = with_maps(40);
  for (int i = 0; i < 40; ++i) write_text(folder.path() / ("map" + std::to_string(i) + ".png"), png);
  for (int i = 0; i < 40; ++i) {
    b.json["materials"][static_cast<std::size_t>(i)] = {
        {"name", "skin" + std::to_string(i)},
        {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}}};
    if (i > 0) b.json["meshes"][0]["primitives"].push_back(b.json["meshes"][0]["primitives"][0]);
    b.json["meshes"][0]["primitives"][static_cast<std::size_t>(i)]["material"] = i;
  }
  b.json["images"][7]["uri"] = "./map0.png";
  b.json["images"][8]["uri"] = "map0.png";
  write_text(folder.path() / "map9.png", one_bit_png(64, 16));

  const fs::path file = b.write(folder.path());
  const AssetData scene = load_gltf(file);
  ASSERT_EQ(scene.materials.size(), 40u);
  ASSERT_EQ(scene.images.size(), 2u);
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_EQ(scene.materials[i].base_colour_map.image, i == 9 ? 1 : 0) << i;
  EXPECT_EQ(scene.images[1].pixels->height, 16);

  const AssetData again = load_gltf(file);
  EXPECT_EQ(again.images[0].pixels, scene.images[0].pixels);
  EXPECT_EQ(again.images[1].pixels, scene.images[1].pixels);
}

// docs/assets.md states these.
constexpr double mb_per_mb_of_json = 600, bytes_per_vertex = 300, mb_at_least = 16;

double most_mb(const fs::path& file, double vertices) {
  return mb_at_least + mb_per_mb_of_json * double(fs::file_size(file)) / 1e6 +
         bytes_per_vertex * vertices / 1e6;
}

TEST(MemoryOfAFile, IsAMultipleOfItsBytesAndVertices) {
#ifdef DERMIS_SANITIZED
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  const TempFolder folder;
  const auto expect_within = [&](const Builder& b, const char* what, double vertices) {
    const fs::path file = b.write(folder.path());
    const double peak = peak_mb(file, {}, [](const AssetData&) { return true; });
    EXPECT_LT(peak, most_mb(file, vertices)) << what << " of " << fs::file_size(file) << " bytes";
  };
  const auto many = [](const char* member, const Json& value, std::size_t count) {
    Builder b;
    b.triangle();
    for (std::size_t i = 0; i < count; ++i) b.json[member].push_back(value);
    return b;
  };

  expect_within(many("nodes", Json::object(), 100'000), "nodes", 3);
  expect_within(many("materials", Json::object(), 65'000), "materials", 3);
  expect_within(many("bufferViews", {{"buffer", 0}, {"byteLength", 1}}, 100'000), "views", 3);
  expect_within(many("accessors", {{"componentType", 5120}, {"count", 1}, {"type", "SCALAR"}}, 100'000),
                "accessors", 3);

  Builder clips = many("nodes", Json::object(), 1);
  const int times = clips.accessor({0, 1}, "SCALAR"), moves = clips.accessor({0, 0, 0, 0, 1, 0}, "VEC3");
  const Json clip = {{"samplers", {{{"input", times}, {"output", moves}}}},
                     {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}};
  for (int i = 0; i < 50'000; ++i) clips.json["animations"].push_back(clip);
  expect_within(clips, "animations", 3);

  Builder copies;
  copies.triangle();
  const Json node = copies.json["nodes"][0];
  for (int i = 1; i < 16'384; ++i) {
    copies.json["nodes"].push_back(node);
    copies.json["scenes"][0]["nodes"].push_back(i);
  }
  copies.json["materials"] = {{{"name", "metal"}, {"extras", {{"dermis", {{"skin", false}}}}}}};
  copies.json["meshes"][0]["primitives"][0]["material"] = 0;
  expect_within(copies, "copies of a mesh that is not skin", 3);
  clips.json["meshes"][0]["primitives"] = Json::array();
  for (int i = 0; i < 20'000; ++i)
    clips.json["meshes"][0]["primitives"].push_back(copies.json["meshes"][0]["primitives"][0]);
  clips.json["nodes"] = {node};
  clips.json["scenes"][0]["nodes"] = {0};
  clips.json["materials"] = copies.json["materials"];
  expect_within(clips, "primitives of a mesh that moves", 60'000);
}

TEST(MemoryOfAFile, WhatStandsInThreeBytesIsCounted) {
  Builder b;
  b.triangle();
  for (int i = 0; i < 65'537; ++i) b.json["materials"].push_back(Json::object());
  EXPECT_ERROR(b.error(), "materials: has 65537 elements, the limit is 65536");
}

// Few bytes may name the same vertices over and over.
TEST(MemoryOfAFile, CopiesOfVerticesAreLimitedByTheBytesOfTheFile) {
  Builder b;
  const std::size_t count = 40'000;
  const int position = b.accessor(std::vector<float>(3 * count, 0.1f), "VEC3");
  b.mesh({{"POSITION", position}});
  const Json primitive = b.json["meshes"][0]["primitives"][0];
  for (int i = 1; i < 450; ++i) b.json["meshes"][0]["primitives"].push_back(primitive);
  EXPECT_ERROR(b.error(), "vertices, the limit for a file of");

  b.json["meshes"][0]["primitives"] = Json::array();
  for (int i = 0; i < 40; ++i) b.json["meshes"][0]["primitives"].push_back(primitive);
#ifndef DERMIS_SANITIZED
  const TempFolder folder;
  const fs::path file = b.write(folder.path());
  EXPECT_LT(peak_mb(file, {}, [](const AssetData&) { return true; }), most_mb(file, 40.0 * count));
#endif
}

}  // namespace
}  // namespace dermis::scene::test
