// SPDX-License-Identifier: MIT
// Large maps: headers first, a budget for all maps of a file, and what a process takes on the way.
#include <spng.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "image/codec.h"
#include "scene/texture_budget.h"
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
    const Scene scene = load_gltf(file, {.texture_budget_mb = 6});
    EXPECT_EQ(scene.images[0].pixels->width, 512);
    EXPECT_FALSE(lines.any_with("texture_budget_mb"));
  }

  // 3.8 + 1.2 MB: the first to a quarter.
  const Warnings lines;
  const Scene scene = load_gltf(file, {.texture_budget_mb = 3});
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

  const Scene scene = load_gltf(file, {.texture_budget_mb = 1});
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
             one_bit_png(512, 512).substr(0, 200));  // damaged, but not its header
  write_text(folder.path() / "map1.png", "no picture at all");
  const Warnings quiet;
  EXPECT_ERROR(error_of(with_maps(2).write(folder.path())), "image 'map1.png'");
}

// 33 million pixels are 134 MB at full size: a child that reads them at a quarter of each side takes little.
TEST(TextureBudget, TheLargePictureIsNeverInMemory) {
#ifdef DERMIS_SANITIZED
  GTEST_SKIP() << "the sanitizer takes memory of its own";
#endif
  const TempFolder folder;
  write_text(folder.path() / "map0.png", one_bit_png(8192, 4096));
  const fs::path file = with_maps(1).write(folder.path());
  const auto peak_kib = [] {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };

  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const Warnings quiet;
    const long before = peak_kib();
    const Scene scene = load_gltf(file, {.texture_budget_mb = 40});
    const bool small = scene.images[0].pixels->width == 2048;
    ::_exit(small && peak_kib() - before < 60 * 1024 ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace dermis::scene::test
