// SPDX-License-Identifier: MIT
// Shards: their bytes follow from the recipe, whoever draws them, and nothing is ever half there.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "gpu/dataset/small_set.h"
#include "image/codec.h"
#include "support/full_disk.h"
#include "support/thrown.h"
#include "tools/dataset/shard_file.h"
#include "tools/dataset/tar.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;
using tests::thrown;

class Prepare : public SmallSet {
 protected:
  void expect_refused(const std::string& says) {
    const std::string found = thrown<InputError>([&] { prepared("refused"); });
    EXPECT_NE(found.find(says), std::string::npos) << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
    EXPECT_FALSE(fs::exists(folder() / "refused"));
  }
};
class Write : public SmallSet {};

TEST_F(Prepare, WritesALock) {
  const Tree lock = Tree::parse(tests::read_text(prepared("set") / "recipe.lock.json"));
  EXPECT_EQ(lock["inputs"].size(), 2u);
  EXPECT_EQ(lock["inputs"][0]["file"], "free.gltf");
  EXPECT_EQ(lock["licences"][0]["spdx"], "MIT");
  EXPECT_EQ(lock["licences"][1]["spdx"], "CC-BY-4.0") << "as the file says";
  EXPECT_EQ(lock["licences"][1]["author"], "A. Author, CC BY 4.0");
  EXPECT_EQ(lock["folder"], "..");
  EXPECT_FALSE(lock["device"]["driver"].get<std::string>().empty());
  EXPECT_EQ(missing(folder() / "set"), (std::vector<std::uint64_t>{0, 1, 2, 3, 4}));
  prepared("set");  // again, the same
  recipe["seed"] = 4;
  EXPECT_NE(thrown<InputError>([&] { prepared("set"); }).find("holds another recipe"), std::string::npos);
}

TEST_F(Prepare, FindsWhatCannotBeDrawn) {
  const Tree good = recipe;
  recipe["identities"][0]["asset"] = "none.gltf";
  expect_refused("none.gltf: no such file");
  tests::write_text(folder() / "broken.gltf", tests::read_text(folder() / "plain.gltf").substr(0, 500));
  recipe["identities"][0]["asset"] = "broken.gltf";
  expect_refused("broken.gltf");

  recipe = good;
  recipe["identities"][0].erase("licence");
  expect_refused("plain.gltf has no licence");
  recipe = good;
  recipe["identities"][1]["morphs"]["grw"] = 0.5;
  expect_refused("grow");
  recipe = good;
  recipe["pose"]["weights"]["grow"] = {{"choice", {0, {{"uniform", {1, 2}}}}}};
  recipe["pose"]["weights"]["jawOpen"] = 0;
  expect_refused("jawOpen");
  recipe = good;
  recipe["settings"]["lighting"]["environment"] = {{"choice", {"studio", "sky.hdr"}}, {"weights", {1, 0}}};
  expect_refused("sky.hdr");
  recipe = good;
  recipe["settings"]["lighting"]["environment"] = {{"choice", {"", "sky.hdr"}}};
  tests::write_text(folder() / "sky.hdr", "#?RADIANCE\nno sky");
  expect_refused("sky.hdr");
  recipe = good;
  recipe["settings"]["technique"] = "lambertian";
  expect_refused("lambert");
  recipe = good;
  recipe["settings"]["camera"].update({{"distance", 60}, {"fov_deg", 2}});
  expect_refused("label depth reaches");
}

TEST_F(Write, ShardsAreTarsOfTheirSamples) {
  const fs::path set = prepared("set");
  const Written written = write(set, {}, quiet);
  EXPECT_EQ(written.shards, 5u);
  EXPECT_EQ(written.samples, 18u);
  EXPECT_TRUE(missing(set).empty());
  EXPECT_EQ(files_of(set),
            (std::vector<std::string>{"recipe.lock.json", "test-000004.json", "test-000004.tar",
                                      "train-000000.json", "train-000000.tar", "train-000001.json",
                                      "train-000001.tar", "train-000002.json", "train-000002.tar",
                                      "train-000003.json", "train-000003.tar"}));

  TarReader tar(set / "train-000003.tar");
  ASSERT_EQ(tar.files().size(), 2u * 6);
  EXPECT_EQ(tar.files()[0].name, "000012.png");
  EXPECT_EQ(tar.files()[1].name, "000012.json");
  EXPECT_EQ(tar.files()[7].name, "000013.json");
  const image::Image8 picture = image::decode_image8(tar.read(tar.files()[0]), "picture");
  EXPECT_EQ(picture.width, 24);
  EXPECT_EQ(picture.height, 20);
  const std::vector<std::byte> bytes = tar.read(tar.files()[1]);
  const Tree sample = Tree::parse(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  EXPECT_EQ(sample["sample"], 12);
  EXPECT_EQ(sample["labels"]["depth"]["file"], "000012.depth.png");
  EXPECT_EQ(sample["camera"]["width"], 24);
  const Tree parameters = Tree::parse(recipe_of(set).parameters(12));
  for (const auto& [key, value] : parameters.items()) EXPECT_EQ(sample[key], value) << key;
  EXPECT_EQ(write(set, {}, quiet).there, 5u) << "nothing is drawn twice";
}

TEST_F(Write, ShardsAreEqualHoweverTheyAreDrawn) {
  const fs::path a = prepared("a"), b = prepared("b");
  write(a, {}, quiet);
  for (const std::uint64_t shard : {3u, 0u, 4u, 2u, 1u}) {
    Options options = quiet;
    options.threads = 1 + static_cast<int>(shard % 3);
    const std::vector<std::uint64_t> one{shard};
    EXPECT_EQ(write(b, one, options).shards, 1u);
  }
  EXPECT_EQ(hashes_of(a).size(), 5u);
  EXPECT_EQ(hashes_of(a), hashes_of(b));

  recipe["seed"] = 4;
  const fs::path c = prepared("c");
  write(c, {}, quiet);
  for (const auto& [name, hash] : hashes_of(c)) EXPECT_NE(hash, hashes_of(a)[name]) << name;
}

TEST_F(Write, TwoWorkersOnOneShardDoNoHarm) {
  const fs::path set = prepared("set"), alone = prepared("alone");
  write(alone, {}, quiet);
  const std::vector<std::uint64_t> shards{0, 1, 2, 3, 4};
  std::vector<Written> written(2);
  std::vector<std::thread> workers;
  for (Written& w : written) workers.emplace_back([&] { w = write(set, shards, quiet); });
  for (std::thread& worker : workers) worker.join();
  EXPECT_EQ(written[0].shards + written[1].shards, 5u);
  EXPECT_EQ(written[0].there + written[1].there, 5u);
  EXPECT_EQ(hashes_of(set), hashes_of(alone));
  EXPECT_EQ(files_of(set), files_of(alone));
}

TEST_F(Write, AFullDiskLeavesNothingAndMayBeTriedAgain) {
  const fs::path set = prepared("set"), alone = prepared("alone");
  write(alone, {}, quiet);
  const std::vector<std::string> before = files_of(set);
  for (const rlim_t bytes : {0u, 700u, 9'000u}) {
    const tests::FullDisk full(bytes);
    const std::string found = thrown<TryAgain>([&] { write(set, {}, quiet); });
    EXPECT_NE(found.find("cannot be written"), std::string::npos) << found;
    EXPECT_EQ(files_of(set), before) << bytes;
  }
  write(set, {}, quiet);
  EXPECT_EQ(hashes_of(set), hashes_of(alone));
}

TEST_F(Write, ALostDeviceIsOpenedAnewOnce) {
  const fs::path set = prepared("set"), alone = prepared("alone");
  write(alone, {}, quiet);
  int losses = 1, calls = 0;
  std::vector<std::string> lines;
  Options options = quiet;
  options.hooks.log = [&](LogLevel, const std::string& line) { lines.push_back(line); };
  options.hooks.progress = [&](const WorkProgress&) {
    if (++calls >= 3 && losses-- > 0) throw DeviceError("VK_ERROR_DEVICE_LOST, injected");
    return true;
  };
  EXPECT_EQ(write(set, {}, options).shards, 5u);
  EXPECT_EQ(hashes_of(set), hashes_of(alone));
  EXPECT_TRUE(std::ranges::any_of(
      lines, [](const std::string& line) { return line.find("opened anew") != std::string::npos; }));

  const fs::path other = prepared("other");
  losses = 100;
  EXPECT_NE(thrown<TryAgain>([&] { write(other, {}, options); }).find("DEVICE_LOST"), std::string::npos);
  EXPECT_EQ(files_of(other), std::vector<std::string>{"recipe.lock.json"});
}

TEST_F(Write, AWorkerThatIsStoppedKeepsWholeShards) {
  const fs::path set = prepared("set");
  Options options = quiet;
  options.hooks.progress = [&](const WorkProgress& work) {
    return work.what != "train-000001.tar" || work.share < 0.5;
  };
  EXPECT_NE(thrown<TryAgain>([&] { write(set, {}, options); }).find("stopped in shard 1"), std::string::npos);
  EXPECT_EQ(missing(set), (std::vector<std::uint64_t>{1, 2, 3, 4}));
  EXPECT_EQ(files_of(set).size(), 3u);
}

TEST_F(Write, FilesOfDeadWorkersAreRemovedAndThoseOfTheLivingStay) {
  const fs::path set = prepared("set"), dead = temporary_of(set / "train-000001.tar"),
                 alive = temporary_of(set / "train-000002.tar"), far = set / "train-000003.tar.elsewhere.1";
  for (const fs::path& file : {dead, alive, far}) tests::write_text(file, "half a shard");
  const int held = ::open(alive.c_str(), O_RDWR);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);

  const Written written = write(set, {}, quiet);
  EXPECT_EQ(written.elsewhere, 2u)
      << "one that is held, and one of another machine, whose locks may not be seen";
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(alive));
  EXPECT_TRUE(fs::exists(far));
  EXPECT_EQ(missing(set), (std::vector<std::uint64_t>{2, 3}));
  ::close(held);

  fs::last_write_time(far, fs::file_time_type::clock::now() - std::chrono::hours(2));
  EXPECT_EQ(write(set, {}, quiet).shards, 2u);
  EXPECT_FALSE(fs::exists(alive));
  EXPECT_FALSE(fs::exists(far));
}

TEST_F(Write, AShardWithoutManifestIsDrawnAgain) {
  const fs::path set = prepared("set"), alone = prepared("alone");
  write(alone, {}, quiet);
  write(set, {}, quiet);
  fs::remove(set / "train-000001.json");  // its worker died between the two
  fs::remove(set / "train-000002.json");
  flip_bit(set / "train-000002.tar", 600);
  EXPECT_EQ(missing(set), (std::vector<std::uint64_t>{1, 2}));
  write(set, {}, quiet);
  EXPECT_EQ(hashes_of(set), hashes_of(alone));
  EXPECT_TRUE(missing(set).empty());
}

TEST_F(Write, ChangedFilesAreRefused) {
  const fs::path set = prepared("set");
  tests::write_text(folder() / "free.gltf", tests::read_text(folder() / "free.gltf") + " ");
  EXPECT_NE(thrown<InputError>([&] { write(set, {}, quiet); }).find("has changed since"), std::string::npos);
  EXPECT_EQ(files_of(set).size(), 1u);
  EXPECT_NE(thrown<InputError>([&] { write(folder(), {}, quiet); }).find("no prepared data set"),
            std::string::npos);
  const std::vector<std::uint64_t> none{5};
  EXPECT_NE(thrown<InputError>([&] { write(set, none, quiet); }).find("no shard 5"), std::string::npos);
}

TEST_F(Write, AnotherClassOfDeviceIsRefusedWhereOneIsAskedFor) {
  const fs::path set = prepared("set", true);
  EXPECT_EQ(write(set, std::vector<std::uint64_t>{0}, quiet).shards, 1u);
  Tree lock = Tree::parse(tests::read_text(set / "recipe.lock.json"));
  lock["device"]["driver"] = "another";
  tests::write_text(set / "recipe.lock.json", lock.dump());
  EXPECT_NE(thrown<InputError>([&] { write(set, {}, quiet); }).find("one class of device"),
            std::string::npos);
}

}  // namespace
}  // namespace dermis::dataset
