// SPDX-License-Identifier: MIT
#include "tools/dataset/recipe.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "api/prepare/label_forms.h"
#include "base/core/error.h"
#include "base/core/known_names.h"
#include "base/core/one_line.h"
#include "tools/dataset/philox.h"
#include "tools/dataset/sha256.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_recipe_bytes = std::uint64_t{16} << 20;
constexpr json::Limits recipe_limits{.depth = 24, .values = 200'000};
constexpr double most_samples = 1e9;
constexpr std::uint64_t most_identities = 1'000'000;

std::uint64_t count(const json::Value& root, const char* key, double otherwise, double most = most_samples) {
  return root.count_or(key, static_cast<std::uint64_t>(otherwise), 1, static_cast<std::uint64_t>(most));
}

Json object_at(const json::Value& root, const char* key) {
  const auto value = root.find(key);
  if (!value) return Json::object();
  value->object();
  check_distributions(*value);
  return Json::parse(value->dump());
}

Licence read_licence(const json::Value& value) {
  value.object();
  value.only_keys({"spdx", "author", "source", "changes"});
  Licence licence{value.at("spdx").text(), value.at("author").text(), value.at("source").text(),
                  value.text_or("changes", "")};
  constexpr std::string_view letters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-+: ()";
  if (licence.spdx.empty() || licence.spdx.find_first_not_of(letters) != std::string::npos)
    value.at("spdx").fail("is no SPDX identifier: '{}'", licence.spdx);
  if (licence.author.empty()) value.at("author").fail("is empty");
  if (licence.source.empty()) value.at("source").fail("is empty");
  return licence;
}

Entry read_entry(const json::Value& value) {
  value.object();
  value.only_keys({"asset", "count", "licence", "options", "morphs", "pose"});
  Entry entry;
  entry.asset = value.at("asset").text();
  if (entry.asset.empty()) value.at("asset").fail("is empty");
  entry.count = value.count_or("count", 1, 1, most_identities);
  if (const auto licence = value.find("licence")) entry.licence = read_licence(*licence);
  if (entry.licence.spdx.empty() && entry.asset.starts_with("built-in"))
    entry.licence = {"MIT", "the authors of dermis", "built into dermis", ""};
  entry.options = object_at(value, "options");
  entry.morphs = object_at(value, "morphs");
  if (value.has("pose")) entry.pose = object_at(value, "pose");

  const bool differ = !paths_of(entry.options, "").empty() || !paths_of(entry.morphs, "").empty();
  if (entry.count > 1 && !differ)
    value.at("count").fail(
        "is {}, but nothing tells these identities apart: give morphs or options a distribution",
        entry.count);
  return entry;
}

void read_labels(const json::Value& root, Recipe::State& s) {
  std::vector<std::string> names{"landmarks"};
  for (const api::LabelForm& form : api::label_forms()) names.emplace_back(api::row_of(form.output).name);

  const auto value = root.find("labels");
  if (!value) return;
  for (std::size_t i = 0; i < value->array_size(0); ++i) {
    const std::string& name = value->element(i).text();
    if (name == "motion") value->element(i).fail("motion is between frames, and a sample is one");
    if (std::ranges::find(names, name) == names.end())
      value->element(i).fail("label {}", unknown_name(name, names));
    s.landmarks |= name == "landmarks";
    for (const api::LabelForm& form : api::label_forms())
      if (name == api::row_of(form.output).name) s.labels = s.labels | Outputs{form.output};
  }
}

void read_size(const json::Value& root, Recipe::State& s) {
  const std::vector<double> size = root.numbers("size", 2);
  if (size.empty()) root.fail("\"size\": [width, height] is missing");
  for (std::size_t i = 0; i < 2; ++i) root.at("size").element(i).count(1, 65536);
  s.width = static_cast<int>(size[0]);
  s.height = static_cast<int>(size[1]);
}

// The identities of the test split depend on the seed and on their number.
void split(const json::Value& root, Recipe::State& s) {
  const std::uint64_t all = std::accumulate(s.entries.begin(), s.entries.end(), std::uint64_t{0},
                                            [](std::uint64_t sum, const Entry& e) { return sum + e.count; });
  if (all > most_identities) root.at("identities").fail("are {}, more than {}", all, most_identities);
  const std::uint64_t sittings = s.samples / s.views;

  std::vector<std::pair<double, std::uint64_t>> ranked;
  for (std::uint64_t k = 0; k < all; ++k) ranked.emplace_back(Stream(s.seed, "split", k).next(), k);
  std::ranges::sort(ranked);
  const auto share_of = [&](std::uint64_t whole) {
    if (s.test_share == 0) return std::uint64_t{0};
    return std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::floor(s.test_share * static_cast<double>(whole) + 0.5)));
  };
  const std::uint64_t test = share_of(all), test_sittings = share_of(sittings);
  if (test > 0 && (test == all || test_sittings == sittings))
    root.at("test_share")
        .fail("leaves nobody to train on: {} identities in {} sittings, {} of them for tests", all, sittings,
              test);

  for (std::uint64_t i = 0; i < all; ++i) (i < test ? s.test : s.train).push_back(ranked[i].second);
  std::ranges::sort(s.train);
  std::ranges::sort(s.test);
  s.train_samples = (sittings - test_sittings) * s.views;
}

void read_shared(const json::Value& root, Recipe::State& s) {
  const auto value = root.find("shared_by_views");
  if (!value) return;
  for (std::size_t i = 0; i < value->array_size(0); ++i) {
    const std::string& path = value->element(i).text();
    const bool known = path == "settings" || path == "head" || path == "pose" ||
                       path.starts_with("settings.") || path.starts_with("head.") ||
                       path.starts_with("pose.");
    if (!known) value->element(i).fail("begins with none of settings, head, pose: '{}'", path);
    s.shared.push_back(path);
  }
}

void read(const json::Value& root, Recipe::State& s) {
  root.object();
  root.only_keys({"schema", "name", "about", "seed", "samples", "samples_per_shard", "views_per_identity",
                  "test_share", "size", "labels", "identities", "settings", "head", "pose",
                  "shared_by_views"});
  root.at("schema").count(schema, schema);
  s.name = root.at("name").text();
  root.text_or("about", "");
  s.seed = static_cast<std::uint32_t>(root.count_or("seed", 0, 0, 0xFFFFFFFFu));
  root.at("samples");
  s.samples = count(root, "samples", 0);
  s.per_shard = count(root, "samples_per_shard", 1000, 1e6);
  s.views = count(root, "views_per_identity", 1);
  s.test_share = root.number_or("test_share", 0, 0, 1);
  if (s.samples % s.views != 0)
    root.at("samples").fail("must be a multiple of views_per_identity ({}), got {}", s.views, s.samples);
  read_size(root, s);
  read_labels(root, s);

  const json::Value identities = root.at("identities");
  for (std::size_t i = 0; i < identities.array_size(); ++i)
    s.entries.push_back(read_entry(identities.element(i)));
  s.settings = object_at(root, "settings");
  s.head = object_at(root, "head");
  s.pose = object_at(root, "pose");
  read_shared(root, s);
  split(root, s);
}

Recipe::State state_of(const json::Document& document, const fs::path& folder) {
  Recipe::State s;
  s.folder = folder;
  read(document.root(), s);
  s.text = document.root().dump();
  s.json = Json::parse(s.text);
  s.sha256 = sha256(s.text);
  check_values(s);
  return s;
}

bool is_within(const std::string& path, const std::string& prefix) {
  return path.starts_with(prefix) &&
         (path.size() == prefix.size() || path[prefix.size()] == '.' || path[prefix.size()] == '[');
}

}  // namespace

Recipe Recipe::load(const fs::path& path) {
  return with_one_line_errors([&] {
    const json::Document document = json::load(path, most_recipe_bytes, recipe_limits);
    return Recipe(std::make_shared<const State>(state_of(document, path.parent_path())));
  });
}

Recipe Recipe::parse(std::string_view json, const fs::path& folder) {
  return with_one_line_errors([&] {
    const json::Document document(json, "recipe", recipe_limits);
    return Recipe(std::make_shared<const State>(state_of(document, folder)));
  });
}

const std::string& Recipe::name() const { return state_->name; }
std::uint64_t Recipe::samples() const { return state_->samples; }
std::uint64_t Recipe::identities() const { return state_->train.size() + state_->test.size(); }
std::string Recipe::sha256() const { return state_->sha256; }
std::string Recipe::text() const { return state_->text; }

std::vector<Licence> Recipe::licences() const {
  std::vector<Licence> licences;
  for (const Entry& entry : state_->entries) licences.push_back(entry.licence);
  return licences;
}

std::uint64_t Recipe::shards() const {
  const std::uint64_t tests = state_->samples - state_->train_samples;
  return state_->train_shards() + (tests + state_->per_shard - 1) / state_->per_shard;
}

Recipe::Range Recipe::samples_of(std::uint64_t shard) const {
  if (shard >= shards()) throw input_error("", "there is no shard {}: the recipe has {}", shard, shards());
  const bool test = shard >= state_->train_shards();
  const std::uint64_t begin = test ? state_->train_samples : 0,
                      end = test ? state_->samples : state_->train_samples;
  const std::uint64_t first = begin + (shard - (test ? state_->train_shards() : 0)) * state_->per_shard;
  return {first, std::min(state_->per_shard, end - first)};
}

std::string Recipe::file_of(std::uint64_t shard) const {
  const Range range = samples_of(shard);
  return fmt::format("{}-{:06}.tar", range.first < state_->train_samples ? "train" : "test", shard);
}

std::string Recipe::parameters(std::uint64_t sample) const {
  return state_->parameters(state_->place_of(sample)).dump();
}

Place Recipe::State::place_of(std::uint64_t sample) const {
  if (sample >= samples) throw input_error("", "there is no sample {}: the recipe has {}", sample, samples);
  Place place{.sample = sample, .sitting = sample / views, .view = sample % views};
  place.test = sample >= train_samples;
  // The sittings of a person follow each other, so that a head is imported and its surroundings are computed
  // once.
  const std::vector<std::uint64_t>& people = place.test ? test : train;
  const std::uint64_t first = place.test ? train_samples / views : 0,
                      sittings = (place.test ? samples - train_samples : train_samples) / views;
  place.identity = people[(place.sitting - first) * people.size() / sittings];

  place.member = place.identity;
  while (place.member >= entries[place.entry].count) place.member -= entries[place.entry++].count;
  return place;
}

Json Recipe::State::parameters(const Place& place) const {
  const Entry& entry = entries[place.entry];
  const auto of_person = [&](const std::string&) { return place.member; };
  const auto of_sample = [&](const std::string& path) {
    const bool is_shared =
        std::ranges::any_of(shared, [&](const std::string& prefix) { return is_within(path, prefix); });
    return is_shared ? place.sitting : place.sample;
  };
  const std::string person = fmt::format("identities[{}]", place.entry);

  Json identity{{"number", place.identity}, {"entry", place.entry}, {"asset", entry.asset}};
  identity["options"] = drawn(entry.options, person + ".options", seed, of_person);
  identity["morphs"] = drawn(entry.morphs, person + ".morphs", seed, of_person);
  Json out{{"sample", place.sample},
           {"split", place.test ? "test" : "train"},
           {"sitting", place.sitting},
           {"view", place.view}};
  out["identity"] = std::move(identity);
  out["settings"] = drawn(settings, "settings", seed, of_sample);
  out["head"] = drawn(head, "head", seed, of_sample);
  out["pose"] = drawn(entry.pose.is_null() ? pose : entry.pose, "pose", seed, of_sample);
  return out;
}

std::string Recipe::State::file(const std::string& name_of_file) const {
  return fs::path(name_of_file).is_absolute() ? name_of_file : (folder / name_of_file).string();
}

}  // namespace dermis::dataset
