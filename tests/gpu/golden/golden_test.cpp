// SPDX-License-Identifier: MIT
// Pictures of the built-in head that were looked at once, for what no invariant catches: which light shines
// from where and in which colour, where brows are, that a pass is there at all. tests/golden/drawn.txt has
// the command of each; DERMIS_UPDATE=1 draws them anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/command.h"
#include "gpu/support/failure.h"
#include "gpu/support/heads.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "image/codec.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

const fs::path folder = fs::path(DERMIS_SOURCE_DIR) / "tests" / "golden";

struct Golden {
  std::string name, options;  ///< of `dermis render`
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << "dermis render " << golden.options << " -o " << golden.name << ".exr";
}

std::vector<Golden> all_golden() {
  std::vector<Golden> all;
  std::ifstream list(folder / "drawn.txt");
  for (std::string line; std::getline(list, line);) {
    const std::size_t tab = line.find('\t');
    if (line.starts_with('#') || tab == std::string::npos) continue;
    all.push_back({line.substr(0, tab), line.substr(tab + 1)});
  }
  return all;
}

/// The built-in head is sculpted once for all of them.
Picture drawn(const Golden& golden) {
  static const Scene head = Scene::built_in();
  CLI::App command;
  cli::SceneArguments arguments;
  cli::add_scene_arguments(command, arguments, cli::SceneUse::render);
  fs::current_path(DERMIS_SOURCE_DIR);  // where options name files from
  command.parse(golden.options);
  return renderer().render(head, arguments.settings);
}

/// Red, green and blue of each pixel; what the file holds.
image::ImageF colours(const Picture& picture) {
  image::ImageF out{.width = picture.width, .height = picture.height, .channels = 3, .values = {}};
  for (std::size_t i = 0; i < picture.linear_rgba.size(); ++i)
    if (i % 4 != 3) out.values.push_back(picture.linear_rgba[i]);
  return out;
}

/// Between the least and the greatest value around a pixel.
float span_around(const image::ImageF& picture, int x, int y, int channel) {
  float low = 1e30f, high = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, picture.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, picture.width - 1); ++u) {
      low = std::min(low, picture.at(u, v)[channel]);
      high = std::max(high, picture.at(u, v)[channel]);
    }
  return high - low;
}

// The pictures were drawn by one software driver, and hold on any: bounds say in what devices may differ, so
// nothing is skipped elsewhere, and bits need not be equal.
//
// Light is stored in half floats about twenty times between a lamp and the picture: in the light map, after
// each of two passes for each of six Gaussians, where transmitted light is added, in the picture, in bloom.
// Each rounds by 2^-11 of the value at most, so two devices are no more than this share apart. Arithmetic in
// between rounds to floats, 2^-24.
constexpr float rounding = 20.0f / 2048;

// Of a pixel's four samples one may lie on the other side of an edge (of the head, of a shadow, of a texel):
// rules for that differ between devices. Reads of maps differ less: between texels, and between levels, a
// device takes steps of 1/16 (the least that Vulkan asks for) or finer, a sixteenth of what neighbours span.
constexpr float share_of_a_sample = 0.25f;

// Half floats end at 2^-24; what is darker than this shows as black.
constexpr float black = 1e-3f;

/// What one channel of a picture sums up to, and how far devices may be apart in it.
struct Sum {
  double wanted = 0, found = 0, edges_squared = 0;

  // Edges fall to either side independently, so their squares add up; half of the bound for roundings would
  // need most of them to go one way.
  double bound() const { return std::sqrt(edges_squared) + rounding / 2 * wanted; }
};

/// Pixels that are further from the golden picture than devices may be, and sums that are.
std::string deviations(const image::ImageF& golden, const image::ImageF& found) {
  std::string text;
  std::array<Sum, 3> sums{};
  int beyond = 0;

  for (int y = 0; y < golden.height; ++y)
    for (int x = 0; x < golden.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const float wanted = golden.at(x, y)[c], value = found.at(x, y)[c];
        const float edge = share_of_a_sample * span_around(golden, x, y, c),
                    bound = rounding * wanted + edge + black;
        Sum& sum = sums[static_cast<std::size_t>(c)];
        sum.wanted += double{wanted};
        sum.found += double{value};
        sum.edges_squared += double{edge} * edge;

        if (std::abs(value - wanted) <= bound) continue;  // what is no number goes on
        if (++beyond <= 3)
          text += fmt::format("pixel {}, {}, channel {}: {} instead of {} +- {}\n", x, y, c, value, wanted,
                              bound);
      }

  // GPUs also filter maps along the slant of a surface, and keep corners of triangles in other places. On an
  // NVIDIA H200 at most 11 of 7,776 values of a picture are beyond.
  if (!on_software() && beyond <= golden.width * golden.height * 3 / 500) beyond = 0, text.clear();

  if (beyond > 0) text += fmt::format("{} values are beyond what devices differ in\n", beyond);
  for (std::size_t c = 0; c < 3; ++c)
    if (!(std::abs(sums[c].found - sums[c].wanted) <= sums[c].bound()))
      text += fmt::format("channel {}: {} in sum instead of {} +- {}\n", c, sums[c].found, sums[c].wanted,
                          sums[c].bound());
  return text;
}

class GoldenPicture : public testing::TestWithParam<Golden> {};
INSTANTIATE_TEST_SUITE_P(BuiltInHead, GoldenPicture, testing::ValuesIn(all_golden()),
                         [](const auto& golden) { return test_name_of(golden.param.name); });

TEST_P(GoldenPicture, IsDrawn) {
  const fs::path file = folder / (GetParam().name + ".exr");
  const image::ImageF found = colours(drawn(GetParam()));
  if (std::getenv("DERMIS_UPDATE")) {
    image::save_exr(file, found, true);
    return;
  }

  const image::ImageF golden = image::load_image_f(file);
  ASSERT_EQ(golden.width, found.width);
  ASSERT_EQ(golden.height, found.height);
  const std::string said = deviations(golden, found);
  EXPECT_EQ(said, "") << testing::PrintToString(GetParam()) << "\n"
                      << write_failure(golden, found, GetParam().name)
                      << "if the change is meant: DERMIS_UPDATE=1 before it\n";
}

}  // namespace
}  // namespace dermis::tests
