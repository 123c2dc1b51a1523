// SPDX-License-Identifier: MIT
#include "tools/dataset/lock.h"

#include "base/core/error.h"
#include "base/core/one_line.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_lock_bytes = std::uint64_t{64} << 20;
constexpr json::Limits lock_limits{.depth = 26, .values = 2'000'000};

// As a worker on another machine finds it: relative where there is a way.
std::string folder_from(const fs::path& recipe_folder, const fs::path& folder) {
  const fs::path whole = fs::weakly_canonical(fs::absolute(recipe_folder.empty() ? "." : recipe_folder));
  const fs::path relative = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder)));
  return relative.empty() ? whole.generic_string() : relative.generic_string();
}

Licence licence_of(const json::Value& value) {
  return {value.at("spdx").text(), value.at("author").text(), value.at("source").text(),
          value.at("changes").text()};
}

Lock read(const json::Value& root, const fs::path& folder) {
  root.object();
  root.only_keys({"schema", "dermis", "recipe", "recipe_sha256", "folder", "one_device", "device", "inputs",
                  "inputs_sha256", "licences", "ita_deg"});
  root.at("schema").count(schema, schema);
  if (root.at("dermis").text() != DERMIS_VERSION)
    root.at("dermis").fail(
        "was prepared by dermis {}, and this is {}: samples of two versions do not go together",
        root.at("dermis").text(), DERMIS_VERSION);

  Recipe::State recipe = Recipe::parse(root.at("recipe").dump(), folder / root.at("folder").text()).state();
  if (recipe.sha256 != root.at("recipe_sha256").text())
    root.at("recipe").fail("has been changed since it was prepared");
  const json::Value licences = root.at("licences");
  licences.array_size(recipe.entries.size(), recipe.entries.size());
  for (std::size_t i = 0; i < recipe.entries.size(); ++i)
    recipe.entries[i].licence = licence_of(licences.element(i));

  Lock lock;
  lock.ita_deg.resize(recipe.entries.size());
  const json::Value angles = root.at("ita_deg");
  angles.array_size(recipe.entries.size(), recipe.entries.size());
  for (std::size_t i = 0; i < recipe.entries.size(); ++i)
    if (!angles.element(i).is_null()) lock.ita_deg[i] = angles.element(i).number();
  lock.recipe = std::make_shared<const Recipe::State>(std::move(recipe));
  lock.device = device_of(root.at("device"));
  lock.one_device = root.at("one_device").boolean();
  const json::Value inputs = root.at("inputs");
  for (std::size_t i = 0; i < inputs.array_size(0); ++i) {
    const json::Value input = inputs.element(i);
    lock.inputs.push_back({input.at("file").text(), {input.at("sha256").text(), input.at("bytes").count()}});
  }
  lock.inputs_sha256 = hash_of_inputs(lock.inputs);
  if (lock.inputs_sha256 != root.at("inputs_sha256").text())
    root.at("inputs").fail("have been changed since it was prepared");
  return lock;
}

}  // namespace

fs::path lock_file(const fs::path& folder) { return folder / "recipe.lock.json"; }

Json json_of(const DeviceClass& device) {
  return {{"name", device.name}, {"driver", device.driver}, {"api", device.api}};
}
DeviceClass device_of(const json::Value& object) {
  object.object();
  object.only_keys({"name", "driver", "api"});
  return {object.at("name").text(), object.at("driver").text(), object.at("api").text()};
}

Json json_of(const Licence& licence) {
  return {{"spdx", licence.spdx},
          {"author", licence.author},
          {"source", licence.source},
          {"changes", licence.changes}};
}

std::string hash_of_inputs(const std::vector<Input>& inputs) {
  Sha256 hash;
  for (const Input& input : inputs) hash.add(input.file + '\0' + input.hash.sha256 + '\n');
  return hash.digest();
}

std::string text_of(const Lock& lock, const fs::path& folder) {
  Json inputs = Json::array(), licences = Json::array();
  for (const Input& input : lock.inputs)
    inputs.push_back({{"file", input.file}, {"bytes", input.hash.bytes}, {"sha256", input.hash.sha256}});
  for (const Entry& entry : lock.recipe->entries) {
    Json licence{{"asset", entry.asset}};
    licence.update(json_of(entry.licence));
    licences.push_back(licence);
  }
  Json angles = Json::array();
  for (const std::optional<double>& angle : lock.ita_deg) angles.push_back(angle ? Json(*angle) : Json());
  const Json json{{"schema", schema},
                  {"dermis", DERMIS_VERSION},
                  {"recipe", lock.recipe->json},
                  {"recipe_sha256", lock.recipe->sha256},
                  {"folder", folder_from(lock.recipe->folder, folder)},
                  {"one_device", lock.one_device},
                  {"device", json_of(lock.device)},
                  {"inputs", inputs},
                  {"inputs_sha256", hash_of_inputs(lock.inputs)},
                  {"licences", licences},
                  {"ita_deg", angles}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Lock load_lock(const fs::path& folder) {
  std::error_code ignored;
  const fs::path file = lock_file(folder);
  if (!fs::exists(file, ignored))
    throw input_error(folder.string(), "is no prepared data set: it has no {}", file.filename().string());
  return with_one_line_errors([&] {
    const json::Document document = json::load(file, most_lock_bytes, lock_limits);
    return read(document.root(), folder);
  });
}

void check_inputs(const Lock& lock) {
  for (const Input& input : lock.inputs)
    if (hash_of_file(lock.recipe->file(input.file)) != input.hash)
      throw input_error(lock.recipe->file(input.file),
                        "has changed since the data set was prepared; prepare another folder from it");
}

}  // namespace dermis::dataset
