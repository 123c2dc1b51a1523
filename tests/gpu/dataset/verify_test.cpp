// SPDX-License-Identifier: MIT
// verify() finds each kind of damage, and nothing where there is none.
#include "gpu/dataset/small_set.h"
#include "support/thrown.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/tar.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

class Verify : public SmallSet {
 protected:
  Verify() : set(prepared("set")) { write(set, {}, quiet); }

  void expect_fault(const std::string& file, const std::string& says, double redrawn = 0) {
    const Verified found = verify(set, redrawn, quiet);
    ASSERT_FALSE(found.faults.empty()) << says;
    EXPECT_NE(found.faults[0].find(file), std::string::npos) << found.faults[0];
    EXPECT_NE(found.faults[0].find(says), std::string::npos) << found.faults[0];
    EXPECT_EQ(found.faults[0].find('\n'), std::string::npos);
  }
  Tree sample(const fs::path& shard, const std::string& name) {
    TarReader tar(shard);
    for (const TarReader::File& file : tar.files())
      if (file.name == name) {
        const std::vector<std::byte> bytes = tar.read(file);
        return Tree::parse(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
      }
    ADD_FAILURE() << "no " << name;
    return {};
  }

  fs::path set;
  const fs::path shard = set / "train-000001.tar";
};

TEST_F(Verify, FindsNothingWhereNothingIs) {
  const Verified found = verify(set, 0.3, quiet);
  EXPECT_EQ(found.faults, std::vector<std::string>{});
  EXPECT_EQ(found.warnings, std::vector<std::string>{});
  EXPECT_EQ(found.shards, 5u);
  EXPECT_EQ(found.samples, 18u);
  EXPECT_EQ(found.redrawn, 5u);
  EXPECT_EQ(found.parameters_sha256.size(), 64u);
  EXPECT_EQ(found.pictures_sha256.size(), 64u);
  EXPECT_NE(found.parameters_sha256, found.pictures_sha256);
}

TEST_F(Verify, FindsAFlippedBit) {
  flip_bit(shard, 700);  // of a picture
  expect_fault("train-000001.tar", "its bytes were changed");
}

TEST_F(Verify, FindsAFlippedBitOfAHeader) {
  flip_bit(shard, 3);
  expect_fault("train-000001.tar", "its bytes were changed");
}

TEST_F(Verify, FindsAShardCutShort) {
  fs::resize_file(shard, fs::file_size(shard) - 2000);
  expect_fault("train-000001.tar", "its manifest says");
}

TEST_F(Verify, FindsAMissingShardAndAMissingManifest) {
  fs::remove(shard);
  expect_fault("train-000001.tar", "is missing");
  fs::remove(set / "train-000000.json");
  expect_fault("train-000000.json", "is missing");
  EXPECT_TRUE(verify(set, 0, quiet).parameters_sha256.empty());
}

TEST_F(Verify, FindsJsonAgainstTheSchema) {
  Tree changed = sample(shard, "000005.json");
  changed["colour"] = "red";
  replace_member(shard, "000005.json", changed.dump());
  expect_fault("sample 5", "colour");
  replace_member(shard, "000005.json", "{");
  expect_fault("sample 5", "JSON");
}

TEST_F(Verify, FindsASampleOfAnotherVersion) {
  Tree changed = sample(shard, "000006.json");
  changed["dermis"] = "0.1.0";
  replace_member(shard, "000006.json", changed.dump());
  expect_fault("sample 6", "version 0.1.0");
}

TEST_F(Verify, FindsParametersThatAreNotTheRecipes) {
  Tree changed = sample(shard, "000006.json");
  changed["settings"]["lighting"]["ambient"] = 0.3;
  replace_member(shard, "000006.json", changed.dump());
  expect_fault("sample 6", "is not what the recipe gives");
}

TEST_F(Verify, FindsAPictureThatIsNotTheRecipes) {
  Tree manifest = Tree::parse(tests::read_text(set / "train-000001.json"));
  // What another picture would have given. The hash of all must agree, or the manifest itself is refused.
  manifest["samples"][0]["pictures_sha256"] = std::string(64, '0');
  tests::write_text(set / "train-000001.json", manifest.dump());
  expect_fault("train-000001.json", "is not that of the samples");
}

TEST_F(Verify, DrawsAgainAndCompares) {
  // The pictures of two samples change their places: hashes agree, and only drawing shows it.
  Tree manifest = Tree::parse(tests::read_text(set / "train-000001.json"));
  Manifest changed = load_manifest(set / "train-000001.json");
  std::swap(changed.samples[0].pictures_sha256, changed.samples[1].pictures_sha256);
  tests::write_text(set / "train-000001.json", text_of(changed, *load_lock(set).recipe));
  EXPECT_TRUE(verify(set, 0, quiet).faults.empty());
  expect_fault("train-000001.tar: sample 4", "its pictures differ", 1);

  // Of another class of device, pictures are held against a bound.
  for (const char* name : {"train-000000", "train-000001", "train-000002", "train-000003", "test-000004"}) {
    Manifest elsewhere = load_manifest(set / (std::string(name) + ".json"));
    elsewhere.device.driver = "another";
    tests::write_text(set / (std::string(name) + ".json"), text_of(elsewhere, *load_lock(set).recipe));
  }
  EXPECT_TRUE(verify(set, 1, quiet).faults.empty());
  TarReader tar(shard);
  const std::vector<std::byte> other = tar.read(tar.files()[6]);
  replace_member(shard, "000004.png", std::string(reinterpret_cast<const char*>(other.data()), other.size()));
  expect_fault("train-000001.tar: sample 4", "of 255 on average", 1);
}

TEST_F(Verify, WarnsOfSeveralDevices) {
  Manifest manifest = load_manifest(set / "train-000001.json");
  manifest.device.name = "another";
  tests::write_text(set / "train-000001.json", text_of(manifest, *load_lock(set).recipe));
  const Verified found = verify(set, 0, quiet);
  EXPECT_TRUE(found.faults.empty());
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_NE(found.warnings[0].find("shards 0,2-4"), std::string::npos) << found.warnings[0];

  Tree lock = Tree::parse(tests::read_text(set / "recipe.lock.json"));
  lock["one_device"] = true;
  tests::write_text(set / "recipe.lock.json", lock.dump());
  expect_fault("", "several classes of devices");
}

TEST_F(Verify, AnEditedLockIsRefused) {
  Tree lock = Tree::parse(tests::read_text(set / "recipe.lock.json"));
  lock["recipe"]["seed"] = 9;
  tests::write_text(set / "recipe.lock.json", lock.dump());
  EXPECT_NE(tests::thrown<InputError>([&] { verify(set, 0, quiet); }).find("has been changed"),
            std::string::npos);
  lock["recipe"]["seed"] = 3;
  lock["dermis"] = "0.0.9";
  tests::write_text(set / "recipe.lock.json", lock.dump());
  EXPECT_NE(tests::thrown<InputError>([&] { verify(set, 0, quiet); }).find("0.0.9"), std::string::npos);
}

TEST(Ranges, AreThoseOfSlurm) {
  EXPECT_EQ(ranges_text(std::vector<std::uint64_t>{}), "");
  EXPECT_EQ(ranges_text(std::vector<std::uint64_t>{0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
  EXPECT_EQ(ranges_of("0-3,7,9-10"), (std::vector<std::uint64_t>{0, 1, 2, 3, 7, 9, 10}));
  for (const char* text : {"", "a", "3-1", "1,,2", "-1", "1-", "0-99999999999", "18446744073709551616"})
    EXPECT_NE(tests::thrown<InputError>([&] { ranges_of(text); }).find("expected numbers"), std::string::npos)
        << text;
}

}  // namespace
}  // namespace dermis::dataset
