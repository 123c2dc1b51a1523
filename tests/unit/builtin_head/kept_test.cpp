// SPDX-License-Identifier: MIT
// The head in the cache: the same bits, never those of another code or size, damage is noticed.
#include "head/builtin_head/kept.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "head/builtin_head/builtin_head.h"

namespace dermis::builtin_head {
namespace {

namespace fs = std::filesystem;

class Kept : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("dermis_kept_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path file() const { return kept_file(folder_, Tone::medium, 64); }

  /// Puts the file of a head that was just made into the folder, and returns that head.
  const scene::AssetData& keep_one() const {
    static const scene::AssetData head = make({.map_size = 64, .cache = folder_});
    static const std::optional<Baked> baked = kept(file(), 64);
    if (baked) keep(file(), *baked);
    return head;
  }

  fs::path folder_;
};

void expect_equal(const scene::AssetData& a, const scene::AssetData& b) {
  ASSERT_EQ(a.images.size(), b.images.size());
  for (std::size_t k = 0; k < a.images.size(); ++k)
    EXPECT_TRUE(a.images[k].pixels->rgba == b.images[k].pixels->rgba) << a.images[k].name;
  ASSERT_EQ(a.primitives.size(), b.primitives.size());
  for (std::size_t p = 0; p < a.primitives.size(); ++p) {
    ASSERT_EQ(a.primitives[p].vertices.size(), b.primitives[p].vertices.size());
    for (std::size_t v = 0; v < a.primitives[p].vertices.size(); ++v) {
      const scene::Vertex &x = a.primitives[p].vertices[v], &y = b.primitives[p].vertices[v];
      ASSERT_EQ(x.position_m, y.position_m);
      ASSERT_EQ(x.normal, y.normal);
      ASSERT_EQ(x.tangent, y.tangent);
    }
  }
}

TEST_F(Kept, TheHeadOfTheCacheHasTheSameBits) {
  const scene::AssetData& made = keep_one();
  ASSERT_TRUE(fs::exists(file()));
  expect_equal(make({.map_size = 64, .cache = folder_}), made);
  expect_equal(make({.map_size = 64}), made);
}

TEST_F(Kept, ItIsReadNotMadeAgain) {
  const scene::AssetData& made = keep_one();
  std::optional<Baked> baked = kept(file(), 64);
  ASSERT_TRUE(baked);
  baked->maps.colour.rgba[0] ^= 1;
  keep(file(), *baked);
  const scene::AssetData changed = make({.map_size = 64, .cache = folder_});
  EXPECT_EQ(changed.images[0].pixels->rgba[0] ^ 1, made.images[0].pixels->rgba[0]);
}

TEST_F(Kept, DamageAndOtherSizesAreMadeAgain) {
  const scene::AssetData& made = keep_one();
  EXPECT_FALSE(kept(file(), 128));
  const auto size = fs::file_size(file());
  {
    std::fstream out(file(), std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(static_cast<std::streamoff>(size / 2));
    out.put('!');
  }
  EXPECT_FALSE(kept(file(), 64));
  expect_equal(make({.map_size = 64, .cache = folder_}), made);
  fs::resize_file(file(), 100);
  EXPECT_FALSE(kept(file(), 64));
  EXPECT_FALSE(kept({}, 64));
}

TEST_F(Kept, TonesSizesAndCodesHaveFilesOfTheirOwn) {
  EXPECT_NE(kept_file(folder_, Tone::light, 64), kept_file(folder_, Tone::medium, 64));
  EXPECT_NE(kept_file(folder_, Tone::light, 128), kept_file(folder_, Tone::light, 64));
  EXPECT_NE(file().filename().string().find(code_hash()), std::string::npos);
  EXPECT_EQ(std::string(code_hash()).size(), 16u);
  EXPECT_TRUE(kept_file({}, Tone::light, 64).empty());
}

}  // namespace
}  // namespace dermis::builtin_head
