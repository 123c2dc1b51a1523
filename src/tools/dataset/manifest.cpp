// SPDX-License-Identifier: MIT
#include "tools/dataset/manifest.h"

#include <set>

#include "base/core/error.h"
#include "base/core/one_line.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_manifest_bytes = std::uint64_t{512} << 20;
constexpr json::Limits manifest_limits{.depth = 8, .values = 20'000'000};

std::string joined_hash(const std::vector<SampleHashes>& samples, std::string SampleHashes::*which) {
  Sha256 hash;
  for (const SampleHashes& sample : samples) hash.add(sample.*which + "\n");
  return hash.digest();
}

// The licences of the assets that a shard shows.
Json licences_json(const Manifest& manifest, const Recipe::State& recipe) {
  std::set<std::size_t> entries;
  for (const SampleHashes& sample : manifest.samples) entries.insert(recipe.place_of(sample.sample).entry);
  Json licences = Json::array();
  for (const std::size_t i : entries) {
    Json licence{{"asset", recipe.entries[i].asset}};
    licence.update(json_of(recipe.entries[i].licence));
    licences.push_back(licence);
  }
  return licences;
}

Manifest read(const json::Value& root) {
  root.object();
  root.only_keys({"schema", "file", "shard", "bytes", "sha256", "parameters_sha256", "pictures_sha256",
                  "dermis", "recipe", "inputs", "device", "licences", "drawn_on", "samples"});
  root.at("schema").count(schema, schema);
  Manifest m{.shard = root.at("shard").count(),
             .bytes = root.at("bytes").count(),
             .file = root.at("file").text(),
             .sha256 = root.at("sha256").text(),
             .dermis = root.at("dermis").text(),
             .recipe_sha256 = root.at("recipe").text(),
             .inputs_sha256 = root.at("inputs").text(),
             .device = device_of(root.at("device")),
             .samples = {},
             .host = root.at("drawn_on").text()};
  root.for_each("samples", [&](const json::Value& sample) {
    sample.only_keys({"sample", "json_sha256", "pictures_sha256"});
    m.samples.push_back(
        {sample.at("sample").count(), sample.at("json_sha256").text(), sample.at("pictures_sha256").text()});
  });
  if (root.at("parameters_sha256").text() != parameters_hash(m.samples))
    root.at("parameters_sha256").fail("is not that of the samples");
  if (root.at("pictures_sha256").text() != pictures_hash(m.samples))
    root.at("pictures_sha256").fail("is not that of the samples");
  return m;
}

}  // namespace

fs::path shard_path(const fs::path& folder, const Recipe& recipe, std::uint64_t shard) {
  return folder / recipe.file_of(shard);
}
fs::path manifest_path(const fs::path& shard) { return fs::path(shard).replace_extension(".json"); }

std::string parameters_hash(const std::vector<SampleHashes>& samples) {
  return joined_hash(samples, &SampleHashes::json_sha256);
}
std::string pictures_hash(const std::vector<SampleHashes>& samples) {
  return joined_hash(samples, &SampleHashes::pictures_sha256);
}

std::string text_of(const Manifest& m, const Recipe::State& recipe) {
  Json samples = Json::array();
  for (const SampleHashes& sample : m.samples)
    samples.push_back({{"sample", sample.sample},
                       {"json_sha256", sample.json_sha256},
                       {"pictures_sha256", sample.pictures_sha256}});
  const Json json{{"schema", schema},
                  {"file", m.file},
                  {"shard", m.shard},
                  {"bytes", m.bytes},
                  {"sha256", m.sha256},
                  {"parameters_sha256", parameters_hash(m.samples)},
                  {"pictures_sha256", pictures_hash(m.samples)},
                  {"dermis", m.dermis},
                  {"recipe", m.recipe_sha256},
                  {"inputs", m.inputs_sha256},
                  {"device", json_of(m.device)},
                  {"licences", licences_json(m, recipe)},
                  {"drawn_on", m.host},
                  {"samples", samples}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Manifest load_manifest(const fs::path& path) {
  return with_one_line_errors([&] {
    const json::Document document = json::load(path, most_manifest_bytes, manifest_limits);
    return read(document.root());
  });
}

}  // namespace dermis::dataset
