// SPDX-License-Identifier: MIT
// The time of samples, by its parts.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "tools/dataset/worker.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t most_in_turn = 16;  // samples; both ways draw in turns

double since_s(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("dermis-bench-" + std::to_string(::getpid()))) {
    fs::create_directory(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// The whole recipe in shards of a turn: people sit as often as they do in its data set, so that heads are
// loaded as rarely.
Lock lock_of(const fs::path& path, std::uint64_t samples) {
  const Recipe::State whole = Recipe::load(path).state();
  const std::uint64_t wanted = std::min(samples, whole.samples),
                      turns = (wanted + most_in_turn - 1) / most_in_turn;
  Json json = whole.json;
  json["samples_per_shard"] = (wanted + turns - 1) / turns;
  Lock lock;
  lock.recipe = std::make_shared<const Recipe::State>(Recipe::parse(json.dump(), whole.folder).state());
  return lock;
}

void draw_bare(Studio& studio, Recipe::Range range) {
  std::optional<Ordered> before;
  for (std::uint64_t i = range.first; i < range.first + range.count; ++i) {
    Ordered now = studio.begin(i);
    if (before) studio.finish(std::move(*before));
    before = std::move(now);
  }
  studio.finish(std::move(*before));
}

}  // namespace

Benchmark bench(const fs::path& path, std::uint64_t samples, const Options& options) {
  const HookScope scope(options.hooks);
  if (samples == 0) throw input_error("", "0 samples take no time");
  const Lock lock = lock_of(path, samples);
  const Recipe recipe = recipe_of(lock);
  const Folder folder;
  Worker worker(lock, folder.path(), options);
  Studio bare(lock.recipe, options.device, Hooks{.log = options.hooks.log, .stop = options.hooks.stop});

  // Heads, pipelines and surroundings of the first turn are there before time counts.
  worker.draw(0);
  draw_bare(bare, recipe.samples_of(0));
  fs::remove(shard_path(folder.path(), recipe, 0));
  fs::remove(manifest_path(shard_path(folder.path(), recipe, 0)));

  const Times before = worker.times();
  const std::uint64_t heads_before = worker.heads();
  const double encoding_before = worker.encoding_s();
  const std::uint64_t bytes_before = worker.bytes();
  Benchmark b;
  Steps steps("drawing samples", (std::min(samples, recipe.samples()) + most_in_turn - 1) / most_in_turn);
  for (std::uint64_t shard = 0; shard < recipe.shards() && b.samples < samples; ++shard) {
    auto start = Clock::now();
    worker.draw(shard);
    b.total_s += since_s(start);
    start = Clock::now();
    draw_bare(bare, recipe.samples_of(shard));
    b.bare_s += since_s(start);
    b.samples += recipe.samples_of(shard).count;
    steps.done();
  }
  const Times& after = worker.times();
  b.setting_s = after.setting - before.setting;
  b.drawing_s = after.drawing - before.drawing;
  b.waiting_s = after.waiting - before.waiting;
  b.writing_s = after.writing - before.writing;
  b.encoding_s = worker.encoding_s() - encoding_before;
  b.bytes = worker.bytes() - bytes_before;
  b.heads = worker.heads() - heads_before;
  return b;
}

}  // namespace dermis::dataset
