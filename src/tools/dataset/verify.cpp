// SPDX-License-Identifier: MIT
// Holds what is there against the recipe.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "image/codec.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/members.h"
#include "tools/dataset/shard_file.h"
#include "tools/dataset/studio.h"
#include "tools/dataset/tar.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_faults = 1000;
constexpr double other_device_bound = 2;  // of 255, on average over the display values
constexpr json::Limits sample_limits{.depth = 24, .values = 200'000};

class Check {
 public:
  Check(const fs::path& folder, const Lock& lock)
      : folder_(folder), lock_(lock), recipe_(recipe_of(lock)), endings_(endings_of(*lock.recipe)) {}

  void all() {
    Steps steps("reading shards", recipe_.shards());
    for (std::uint64_t shard = 0; shard < recipe_.shards(); ++shard) {
      read_shard(shard);
      steps.done();
    }
    look_at_devices();
    look_for_temporaries();
    if (samples_.size() != recipe_.samples()) return;
    found.parameters_sha256 = parameters_hash(samples_);
    found.pictures_sha256 = pictures_hash(samples_);
  }

  void redraw(double share, const Options& options) {
    if (share == 0 || sound_.empty()) return;
    std::uint64_t sound_samples = 0;
    for (const Manifest& manifest : sound_) sound_samples += manifest.samples.size();
    const auto count = std::max<std::uint64_t>(
        1, static_cast<std::uint64_t>(std::floor(share * static_cast<double>(sound_samples) + 0.5)));
    Studio studio(lock_.recipe, options.device, Hooks{.log = options.hooks.log, .stop = options.hooks.stop});
    Steps steps("drawing samples again", count);
    for (std::uint64_t k = 0; k < count; ++k) {
      std::uint64_t i = (2 * k + 1) * sound_samples / (2 * count);
      auto manifest = sound_.begin();
      while (i >= manifest->samples.size()) i -= (manifest++)->samples.size();
      redraw_one(studio, *manifest, manifest->samples[i]);
      steps.done();
    }
  }

  Verified found;

 private:
  template <class... Args>
  void fault(fmt::format_string<Args...> format, Args&&... args) {
    if (found.faults.size() == most_faults) found.faults.push_back("and more");
    if (found.faults.size() < most_faults)
      found.faults.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  void read_shard(std::uint64_t shard) {
    const fs::path path = shard_path(folder_, recipe_, shard);
    const std::string name = path.filename().string();
    std::error_code ignored;
    for (const fs::path& file : {path, manifest_path(path)})
      if (!fs::exists(file, ignored)) return fault("{}: is missing", file.filename().string());

    const std::size_t faults_before = found.faults.size();
    try {
      const Manifest manifest = load_manifest(manifest_path(path));
      devices_[manifest.device.text()].push_back(shard);
      check_manifest(manifest, shard, name);
      check_tar(manifest, path, name);
      samples_.insert(samples_.end(), manifest.samples.begin(), manifest.samples.end());
      ++found.shards;
      found.samples += manifest.samples.size();
      if (found.faults.size() == faults_before) sound_.push_back(manifest);
    } catch (const InputError& error) { fault("{}", error.what()); }
  }

  void check_manifest(const Manifest& manifest, std::uint64_t shard, const std::string& name) {
    if (manifest.shard != shard || manifest.file != name)
      fault("{}: its manifest is that of shard {}, {}", name, manifest.shard, manifest.file);
    if (manifest.dermis != DERMIS_VERSION)
      fault("{}: was drawn by dermis {}, the set is of {}", name, manifest.dermis, DERMIS_VERSION);
    if (manifest.recipe_sha256 != lock_.recipe->sha256) fault("{}: is of another recipe", name);
    if (manifest.inputs_sha256 != lock_.inputs_sha256) fault("{}: was drawn from other files", name);

    const Recipe::Range range = recipe_.samples_of(shard);
    for (std::uint64_t i = 0; i < range.count; ++i) {
      if (i < manifest.samples.size() && manifest.samples[i].sample == range.first + i) continue;
      return fault("{}: its manifest lacks sample {}", name, range.first + i);
    }
    if (manifest.samples.size() > range.count)
      fault("{}: its manifest has {} samples, expected {}", name, manifest.samples.size(), range.count);
  }

  void check_tar(const Manifest& manifest, const fs::path& path, const std::string& name) {
    const FileHash hash = hash_of_file(path);
    if (hash.bytes != manifest.bytes)
      fault("{}: has {} bytes, its manifest says {}", name, hash.bytes, manifest.bytes);
    else if (hash.sha256 != manifest.sha256)
      fault("{}: its SHA-256 is not that of its manifest: its bytes were changed", name);

    TarReader tar(path);
    std::map<std::string, const TarReader::File*> files;
    for (const TarReader::File& file : tar.files()) files[file.name] = &file;
    std::size_t expected = 0;
    for (const SampleHashes& sample : manifest.samples) {
      const std::string stem = stem_of(*lock_.recipe, sample.sample);
      for (const std::string& ending : endings_) {
        const auto file = files.find(stem + "." + ending);
        ++expected;
        if (file == files.end())
          fault("{}: sample {} has no {}.{}", name, sample.sample, stem, ending);
        else if (ending == "json")
          check_sample(name, sample, tar.read(*file->second));
      }
    }
    if (tar.files().size() > expected)
      fault("{}: has {} files, expected {}", name, tar.files().size(), expected);
  }

  void check_sample(const std::string& name, const SampleHashes& hashes,
                    const std::vector<std::byte>& bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string place = fmt::format("{}: sample {}", name, hashes.sample);
    if (sha256(text) != hashes.json_sha256) fault("{}: its JSON is not that of the manifest", place);
    try {
      const json::Document document(text, place, sample_limits);
      const json::Value root = document.root().object();
      root.only_keys({"schema", "dermis", "recipe", "sample", "split", "sitting", "view", "identity",
                      "settings", "head", "pose", "camera", "labels"});
      root.at("schema").count(schema, schema);
      const json::Value camera = root.at("camera").object();
      for (const char* key : {"K", "R", "t_m"}) camera.at(key).array_size(3, 3);
      root.at("labels").object();
      if (root.at("dermis").text() != DERMIS_VERSION)
        root.at("dermis").fail("is of version {}, the set of {}", root.at("dermis").text(), DERMIS_VERSION);
      if (root.at("recipe").text() != lock_.recipe->sha256) root.at("recipe").fail("is another one");
      check_parameters(root, hashes.sample);
    } catch (const InputError& error) { fault("{}", error.what()); }
  }

  void check_parameters(const json::Value& root, std::uint64_t sample) const {
    const Json wanted = lock_.recipe->parameters(lock_.recipe->place_of(sample));
    for (const auto& [key, value] : wanted.items()) {
      // Both with sorted keys.
      if (nlohmann::json::parse(root.at(key).dump()) != nlohmann::json::parse(value.dump()))
        root.at(key).fail("is not what the recipe gives: {}", value.dump().substr(0, 200));
    }
  }

  void look_at_devices() {
    if (devices_.size() <= 1) return;
    std::string text;
    for (const auto& [device, shards] : devices_)
      text += fmt::format("{}{}: shards {}", text.empty() ? "" : "; ", device, ranges_text(shards));
    if (lock_.one_device)
      fault("drawn on several classes of devices, and the set is for one: {}", text);
    else
      found.warnings.push_back("drawn on several classes of devices, whose pictures differ in last bits: " +
                               text);
  }

  void look_for_temporaries() {
    std::error_code ignored;
    std::size_t count = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored)) {
      const std::string name = entry.path().filename().string();
      const std::size_t at = std::min(name.find(".tar."), name.find(".json."));
      const bool is_shard = name.starts_with("train-") || name.starts_with("test-");
      count += is_shard && at != std::string::npos ? 1 : 0;
    }
    if (count > 0)
      found.warnings.push_back(fmt::format("{} temporary file{}, of workers that draw now or have died",
                                           count, count == 1 ? "" : "s"));
  }

  void redraw_one(Studio& studio, const Manifest& manifest, const SampleHashes& sample) {
    const Drawn drawn = studio.finish(studio.begin(sample.sample));
    ++found.redrawn;
    if (hash_of_pictures(*lock_.recipe, drawn) == sample.pictures_sha256) return;
    if (studio.device_class() == manifest.device)
      return fault("{}: sample {}: drawn again, its pictures differ", manifest.file, sample.sample);

    const double difference = difference_of(manifest, sample.sample, drawn.results);
    if (!(difference <= other_device_bound))
      fault("{}: sample {}: drawn again on {}, its picture differs by {:.3g} of 255 on average, over {:g}",
            manifest.file, sample.sample, studio.device_class().text(), difference, other_device_bound);
  }

  double difference_of(const Manifest& manifest, std::uint64_t sample, const Results& results) const {
    TarReader tar(folder_ / manifest.file);
    const std::string name = stem_of(*lock_.recipe, sample) + ".png";
    const auto file = std::ranges::find(tar.files(), name, &TarReader::File::name);
    const image::Image8 picture = image::decode_image8(tar.read(*file), name);
    if (picture.width != results.width || picture.height != results.height) return 255;
    double sum = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
      sum += std::abs(int{picture.rgba[i]} - int{results.display[i]});
    return sum / (0.75 * static_cast<double>(picture.rgba.size()));
  }

  const fs::path& folder_;
  const Lock& lock_;
  Recipe recipe_;
  std::vector<std::string> endings_;
  std::vector<SampleHashes> samples_;
  std::vector<Manifest> sound_;
  std::map<std::string, std::vector<std::uint64_t>> devices_;
};

}  // namespace

Verified verify(const fs::path& folder, double redrawn_share, const Options& options) {
  const HookScope scope(options.hooks);
  if (!(redrawn_share >= 0 && redrawn_share <= 1))
    throw input_error("", "the share that is drawn again must be 0 to 1, got {:g}", redrawn_share);
  const Lock lock = load_lock(folder);
  Check check(folder, lock);
  check.all();
  if (redrawn_share > 0) check_inputs(lock);
  check.redraw(redrawn_share, options);
  return std::move(check.found);
}

}  // namespace dermis::dataset
