// SPDX-License-Identifier: MIT
// The steps of a data set: prepared, drawn, and what is missing.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "base/core/log.h"
#include "image/codec.h"
#include "tools/dataset/shard_file.h"
#include "tools/dataset/skin_tone.h"
#include "tools/dataset/worker.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_poses = 1000;

bool is_there(const fs::path& shard) {
  std::error_code ignored;
  return fs::exists(shard, ignored) && fs::exists(manifest_path(shard), ignored);
}

// Surroundings are read when a sample needs them, perhaps hours later on another machine.
void check_pictures(const Lock& lock) {
  for (const Input& input : lock.inputs) {
    const std::string ending = ending_of(input.file);
    if (ending == ".hdr" || ending == ".exr") image::load_image_f(lock.recipe->file(input.file));
  }
}

// Poses at the ends of their distributions, of a head that was drawn.
void check_poses(const Lock& lock, std::size_t entry_number, Scene scene) {
  const Entry& entry = lock.recipe->entries[entry_number];
  const InstanceId id = scene.instances().front();
  try {
    for (const Json& tree :
         extremes(entry.pose.is_null() ? lock.recipe->pose : entry.pose, "pose", most_poses))
      scene.set_pose(id, pose_of(Json::object(), tree));
    for (const Json& tree : extremes(entry.morphs, "morphs", most_poses))
      scene.set_pose(id, pose_of(tree, Json::object()));
  } catch (const InputError& error) {
    throw input_error("recipe '" + lock.recipe->name + "'", "identities[{}] ({}): {}", entry_number,
                      entry.asset, error.what());
  }
}

// The typology angle of the head that was drawn last, in tenths; none: each person of its entry has another.
std::optional<double> tone_of(const Entry& entry, const Scene& scene) {
  if (!paths_of(entry.options, "").empty()) return std::nullopt;
  const std::optional<double> angle = ita_deg_of(scene.instance(scene.instances().front()).asset);
  return angle ? std::optional(std::round(10 * *angle) / 10) : std::nullopt;
}

// One sample of each entry: its asset is loaded, its names are looked up, its labels are encoded, its skin is
// measured.
void draw_one_of_each(Lock& lock, Studio& studio) {
  const std::size_t entries = lock.recipe->entries.size();
  lock.ita_deg.resize(entries);
  std::set<std::size_t> seen;
  Steps steps("drawing a sample of each asset", entries);
  for (std::uint64_t i = 0; i < lock.recipe->samples && seen.size() < entries; i += lock.recipe->views) {
    const std::size_t entry = lock.recipe->place_of(i).entry;
    if (!seen.insert(entry).second) continue;
    encoded(*lock.recipe, studio.finish(studio.begin(i)));
    check_poses(lock, entry, studio.scene());
    lock.ita_deg[entry] = tone_of(lock.recipe->entries[entry], studio.scene());
    steps.done();
  }
  if (seen.size() < entries)
    warn("recipe '{}': {} of its {} assets are in no sample: it has fewer sittings than identities",
         lock.recipe->name, entries - seen.size(), entries);
}

void check_same(const fs::path& folder, const Lock& lock) {
  std::error_code ignored;
  if (!fs::exists(lock_file(folder), ignored)) return;
  const Lock before = load_lock(folder);
  if (before.recipe->sha256 != lock.recipe->sha256 || before.inputs != lock.inputs)
    throw input_error(folder.string(), "holds another recipe, or one of other files; prepare a new folder");
}

std::uint64_t number_of(std::string_view text, std::string_view whole) {
  std::uint64_t number = 0;
  const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || at != text.data() + text.size())
    throw input_error("", "expected numbers and ranges such as 0-3,7, got '{}'", whole);
  return number;
}

constexpr std::uint64_t most_numbers = 10'000'000;

}  // namespace

Recipe recipe_of(const Lock& lock) { return Recipe::State::recipe(lock.recipe); }
Recipe recipe_of(const fs::path& folder) { return recipe_of(load_lock(folder)); }

void prepare(const fs::path& recipe, const fs::path& folder, bool one_device, const Options& options) {
  const HookScope scope(options.hooks);
  Recipe::State state = Recipe::load(recipe).state();
  Lock lock;
  lock.inputs = inputs_of(state);
  find_licences(state);
  lock.recipe = std::make_shared<const Recipe::State>(std::move(state));
  lock.inputs_sha256 = hash_of_inputs(lock.inputs);
  lock.one_device = one_device;
  check_same(folder, lock);
  check_pictures(lock);

  Studio studio(lock.recipe, options.device, options.hooks);
  draw_one_of_each(lock, studio);
  lock.device = studio.device_class();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw input_error(folder.string(), "cannot be made: {}", error.message());
  write_file(lock_file(folder), text_of(lock, folder));
}

std::vector<std::uint64_t> missing(const fs::path& folder) {
  const Recipe recipe = recipe_of(folder);
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t shard = 0; shard < recipe.shards(); ++shard)
    if (!is_there(shard_path(folder, recipe, shard))) numbers.push_back(shard);
  return numbers;
}

Written write(const fs::path& folder, std::span<const std::uint64_t> shards, const Options& options) {
  const HookScope scope(options.hooks);
  const Lock lock = load_lock(folder);
  const Recipe recipe = recipe_of(lock);
  std::vector<std::uint64_t> wanted(shards.begin(), shards.end());
  for (std::uint64_t shard = 0; shards.empty() && shard < recipe.shards(); ++shard) wanted.push_back(shard);
  for (const std::uint64_t shard : wanted) recipe.file_of(shard);  // throws if there is none

  Written written;
  std::optional<Worker> worker;
  for (const std::uint64_t shard : wanted) {
    const fs::path path = shard_path(folder, recipe, shard);
    held_temporaries(manifest_path(path), true);
    const bool drawn_elsewhere = !held_temporaries(path, true).empty();
    if (is_there(path)) {
      ++written.there;
      continue;
    }
    if (drawn_elsewhere && shards.empty()) {
      ++written.elsewhere;
      continue;
    }
    try {
      if (!worker) {
        check_inputs(lock);
        worker.emplace(lock, folder, options);
      }
      if (worker->draw_again_if_lost(shard)) {
        ++written.shards;
        written.samples += recipe.samples_of(shard).count;
      } else {
        ++written.there;
      }
    } catch (const Cancelled&) {
      throw TryAgain(fmt::format("stopped in shard {}: {} shards are drawn, this one is not kept", shard,
                                 written.shards));
    }
  }
  return written;
}

std::string ranges_text(std::span<const std::uint64_t> numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) text += "-" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

std::vector<std::uint64_t> ranges_of(std::string_view text) {
  std::vector<std::uint64_t> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string_view part = text.substr(from, to - from);
    const std::size_t dash = part.find('-');
    const std::uint64_t first = number_of(part.substr(0, dash), text),
                        last =
                            dash == std::string_view::npos ? first : number_of(part.substr(dash + 1), text);
    if (last < first || last - first >= most_numbers || numbers.size() > most_numbers)
      throw input_error("", "expected numbers and ranges such as 0-3,7, got '{}'", text);
    for (std::uint64_t n = first; n <= last; ++n) numbers.push_back(n);
    from = to + 1;
  }
  return numbers;
}

}  // namespace dermis::dataset
