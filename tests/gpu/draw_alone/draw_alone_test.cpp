// SPDX-License-Identifier: MIT
// A program that links dermis::draw alone.
#include <gtest/gtest.h>
#include <link.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "dermis/asset_arrays.h"
#include "dermis/error.h"
#include "dermis/renderer.h"

namespace dermis {
namespace {

/// Names without versions of what this program has loaded, before any driver adds its own: "libfmt".
std::set<std::string> loaded_libraries() {
  std::set<std::string> names;
  const auto add = [](dl_phdr_info* info, std::size_t, void* to) {
    const std::string file = std::filesystem::path(info->dlpi_name).filename().string();
    if (!file.empty())
      static_cast<std::set<std::string>*>(to)->insert(file.substr(0, file.find_first_of(".-")));
    return 0;
  };
  dl_iterate_phdr(add, &names);
  return names;
}

// Taken before main(): a later case would see the driver's.
const std::set<std::string> libraries = loaded_libraries();

Scene ball() {
  constexpr int sides = 32;
  std::vector<std::array<float, 3>> positions_m;
  std::vector<std::array<float, 2>> uv;
  std::vector<std::uint32_t> indices;
  for (int row = 0; row <= sides; ++row)
    for (int column = 0; column <= sides; ++column) {
      const double u = double(column) / sides, v = double(row) / sides;
      const double around = 2 * std::numbers::pi * u, down = std::numbers::pi * v;
      positions_m.push_back({float(0.1 * std::sin(down) * std::sin(around)), float(0.1 * std::cos(down)),
                             float(0.1 * std::sin(down) * std::cos(around))});
      uv.push_back({float(u), float(v)});
    }
  for (std::uint32_t row = 0; row < sides; ++row)
    for (std::uint32_t column = 0; column < sides; ++column) {
      const std::uint32_t corner = row * (sides + 1) + column, below = corner + sides + 1;
      indices.insert(indices.end(), {corner, below, corner + 1, corner + 1, below, below + 1});
    }

  AssetArrays arrays;
  arrays.name = "ball";
  arrays.meshes = {
      {.name = "ball", .material = 0, .positions_m = positions_m, .uv0 = uv, .indices = indices}};
  arrays.materials = {{.name = "skin", .metallic = 0}};
  return Scene(Asset::from_arrays(arrays));
}

RenderSettings small() {
  return {.quality = {.map_size = 256, .shadow_size = 256}, .output = {.width = 64, .height = 64}};
}

std::string refusal(const auto& draw) {
  try {
    draw();
  } catch (const InputError& error) { return error.what(); }
  return "nothing is refused";
}

TEST(DrawAlone, LinksNoLibraryForRaysOrFiles) {
  const std::set<std::string> may{"libc",       "libm",     "libgcc_s", "libstdc++", "libdl",
                                  "libpthread", "linux",    "ld",       "libfmt",    "libspirv",
                                  "libasan",    "libubsan", "libtsan"};
  for (const std::string& library : libraries) EXPECT_TRUE(may.contains(library)) << library;
  EXPECT_TRUE(libraries.contains("libstdc++")) << "the list is not one of libraries";
}

TEST(DrawAlone, DrawsAHeadOfArrays) {
  Renderer renderer;
  const Picture picture = renderer.render(ball(), small());
  const float* middle = &picture.linear_rgba[4 * (32 * 64 + 32)];
  EXPECT_GT(middle[2], 0.02f);
  EXPECT_GT(middle[0], middle[2]) << "skin is red";
  EXPECT_EQ(middle[3], 1);
}

TEST(DrawAlone, KnowsTheStudio) {
  // The picture of the light is built in; what skin sees of it takes rays.
  RenderSettings settings = small();
  settings.lighting.environment = "studio";
  EXPECT_EQ(refusal([&] { Renderer().render(ball(), settings); }),
            "the surroundings that skin sees: dermis::dermis finds it, and this program links dermis::draw "
            "alone");
}

TEST(DrawAlone, NamesTheLibraryThatItLacks) {
  RenderSettings settings = small();
  settings.lighting.environment = "sky.hdr";
  EXPECT_EQ(refusal([&] { Renderer().render(ball(), settings); }),
            "the environment 'sky.hdr': dermis::dermis finds it, and this program links dermis::draw alone");
}

}  // namespace
}  // namespace dermis
