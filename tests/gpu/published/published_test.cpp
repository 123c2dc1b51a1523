// SPDX-License-Identifier: MIT
// Pictures by the papers' technique, to the bit: tests/golden/published.txt. What they must look like is held
// by tests of every technique; this tells a change that only moves code from one that does more.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "base/core/hash.h"
#include "cli/command.h"
#include "gpu/support/renderer.h"

namespace dermis::tests {
namespace {

namespace fs = std::filesystem;

const fs::path file = fs::path(DERMIS_SOURCE_DIR) / "tests" / "golden" / "published.txt";

struct Row {
  std::string name, picture, counts, options;  ///< picture, counts: hashes
};

/// The file, cut at its tabs.
struct Guards {
  std::string head;  ///< lines of comment
  std::string device, options;
  std::vector<Row> rows;

  Guards() {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with('#')) {
        head += line + "\n";
        continue;
      }
      std::vector<std::string> cells;
      std::istringstream cut(line);
      for (std::string cell; std::getline(cut, cell, '\t');) cells.push_back(cell);
      cells.resize(4);
      if (cells[0] == "device")
        device = cells[1];
      else if (cells[0] == "all")
        options = cells[1];
      else
        rows.push_back({cells[0], cells[1], cells[2], cells[3]});
    }
  }

  void write() const {
    std::ofstream out(file);
    out << head << "device\t" << device << "\nall\t" << options << "\n";
    for (const Row& row : rows)
      out << fmt::format("{}\t{}\t{}\t{}\n", row.name, row.picture, row.counts, row.options);
  }
};

Picture drawn(const std::string& options) {
  static const Scene head = Scene::built_in();  // sculpted once for all of them
  CLI::App command;
  cli::SceneArguments arguments;
  cli::add_scene_arguments(command, arguments, cli::SceneUse::render);
  fs::current_path(DERMIS_SOURCE_DIR);  // where options name files from
  command.parse(options);
  return renderer().render(head, arguments.settings);
}

std::string hash_of_picture(const Picture& picture) {
  Hash hash;
  hash.bytes(picture.linear_rgba.data(), picture.linear_rgba.size() * sizeof(float));
  hash.bytes(picture.display_rgba.data(), picture.display_rgba.size());
  return fmt::format("{:016x}", hash.value());
}

std::string hash_of_counts(const Statistics& s) {
  Hash hash;
  for (const std::uint64_t count : {s.skin_pixels, s.irradiance_texels, s.convolved_texels, s.launched,
                                    s.unshaded_reads, s.transmission_misses, s.light_reads})
    hash.add(count);
  for (const int side : s.used_size) hash.add(side);
  return fmt::format("{:016x}", hash.value());
}

TEST(Published, PicturesAreEqualToTheBit) {
  Guards guards;
  ASSERT_GE(guards.rows.size(), 60u) << file;
  const bool update = std::getenv("DERMIS_UPDATE") != nullptr;
  std::string device;

  for (Row& row : guards.rows) {
    const Picture picture = drawn(guards.options + " " + row.options);
    device = fmt::format("{}, {}", picture.statistics.device, picture.statistics.driver);
    if (!update && device != guards.device)
      GTEST_SKIP() << "the bits are those of " << guards.device << ", this is " << device;

    const std::string of_picture = hash_of_picture(picture), of_counts = hash_of_counts(picture.statistics);
    if (!update) {
      EXPECT_EQ(of_picture, row.picture) << "dermis render " << guards.options << " " << row.options;
      EXPECT_EQ(of_counts, row.counts) << "what is counted for " << row.name;
    }
    row.picture = of_picture;
    row.counts = of_counts;
  }

  if (!update) return;
  guards.device = device;
  guards.write();
}

}  // namespace
}  // namespace dermis::tests
