// SPDX-License-Identifier: MIT
/// Data sets: pictures with labels, drawn from a recipe in shards, by any number of workers in any order.
/// Link dermis::dataset.
///
///   dermis::dataset::prepare("faces.json", "faces");   // checks all that can be checked before
///   dermis::dataset::write("faces");                   // draws the shards that are missing
///   dermis::dataset::Verified found = dermis::dataset::verify("faces");
///
/// A sample is a function of the recipe and its number alone. Its parameters are equal everywhere, its
/// pictures on one class of device (name and driver). Shards are tars as WebDataset reads them, equal to the
/// byte however they were drawn. python/datasets.md describes recipes, files and clusters.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "dermis/error.h"
#include "dermis/hooks.h"

namespace dermis::dataset {

/// The work may succeed elsewhere or later: a full disk, a lost device, a worker that was told to end. No
/// shard is half-written. The program ends with status 75. what() is one line.
class TryAgain : public std::runtime_error {
 public:
  explicit TryAgain(const std::string& message) : std::runtime_error(message) {}
};

/// Whose work an asset is, and under what terms.
struct Licence {
  std::string spdx;     ///< "MIT", "CC-BY-3.0", or "LicenseRef-..." where SPDX has none
  std::string author;   ///< as it is to be named
  std::string source;   ///< where it comes from
  std::string changes;  ///< against the source; empty: none
  bool operator==(const Licence&) const = default;
};

/// A recipe, read and checked as far as that needs no asset and no device.
class Recipe {
 public:
  /// Throws InputError with file and place: not JSON, a key that is not known, a value or an end of a
  /// distribution out of range.
  static Recipe load(const std::filesystem::path& path);
  /// Likewise; names of files are relative to `folder`.
  static Recipe parse(std::string_view json, const std::filesystem::path& folder);

  const std::string& name() const;
  std::uint64_t samples() const;
  std::uint64_t identities() const;       ///< number of those that are drawn from
  std::uint64_t shards() const;           ///< those of the split "train" first
  std::string sha256() const;             ///< of its values: not of spaces, comments and order
  std::string text() const;               ///< JSON, its keys sorted
  std::vector<Licence> licences() const;  ///< of its assets, in its order

  /// The samples of a shard, from `first` on.
  struct Range {
    std::uint64_t first = 0, count = 0;
  };
  Range samples_of(std::uint64_t shard) const;
  /// "train-000012.tar". Throws InputError: no such shard.
  std::string file_of(std::uint64_t shard) const;
  /// The values of sample i as a JSON object: identity, split, settings, head, pose. Throws InputError: no
  /// such sample.
  std::string parameters(std::uint64_t sample) const;

  struct State;  // of the library
  const State& state() const { return *state_; }

 private:
  explicit Recipe(std::shared_ptr<const State> state) : state_(std::move(state)) {}
  std::shared_ptr<const State> state_;
};

/// Options of the work; no picture depends on them.
struct Options {
  std::string device = "best";  ///< as Renderer::Options::device
  int threads = 0;              ///< that encode pictures; 0: one for each core
  Hooks hooks{};                ///< progress counts samples; `stop` ends after the sample that is drawn
};

/// Checks the recipe, loads each asset once and draws a sample of each. Writes recipe.lock.json into the
/// folder, which it makes: the recipe, SHA-256 of all files that it names, licences, the class of the device.
/// `one_device`: workers on another class are then refused. Throws InputError: see Recipe; an asset without
/// licence, or one that cannot be drawn (names entry, sample and parameter); a folder that holds another
/// recipe.
void prepare(const std::filesystem::path& recipe, const std::filesystem::path& folder,
             bool one_device = false, const Options& options = {});

/// Returns the recipe of a prepared folder. Throws InputError: it is none.
Recipe recipe_of(const std::filesystem::path& folder);

struct Written {
  std::uint64_t shards = 0, samples = 0;  ///< drawn and published by this call
  std::uint64_t there = 0;                ///< shards that were there, or came meanwhile from another worker
  std::uint64_t elsewhere = 0;            ///< that other workers draw now; left to them
};

/// Draws shards that are missing; empty: all of them, but those that another worker draws. Throws
/// - InputError: the folder is not prepared; a file has changed since; a shard number that the recipe has
/// not;
/// - TryAgain: see there. A device that is lost is opened anew, once.
Written write(const std::filesystem::path& folder, std::span<const std::uint64_t> shards = {},
              const Options& options = {});

/// Returns the numbers of the shards that are not there, or have no manifest, rising.
std::vector<std::uint64_t> missing(const std::filesystem::path& folder);
/// Returns numbers as Slurm's --array takes them: "0-3,7". Empty of none.
std::string ranges_text(std::span<const std::uint64_t> numbers);
/// Reads the same. Throws InputError: something else.
std::vector<std::uint64_t> ranges_of(std::string_view text);

struct Verified {
  std::vector<std::string> faults;    ///< one line each: file, sample, what is wrong
  std::vector<std::string> warnings;  ///< several classes of devices, temporary files of workers that died
  std::uint64_t shards = 0, samples = 0, redrawn = 0;
  /// of all parameters, and of all pictures, in the order of the samples; empty if something is missing
  std::string parameters_sha256, pictures_sha256;
};

/// Reads all shards: hashes, members, every JSON against the recipe. Then draws `redrawn_share` of the
/// samples again, at least one. They must be equal to the bit on the class of device that drew them, else
/// within 2 of 255 on average over the display values. 0: draws none, and needs no device.
Verified verify(const std::filesystem::path& folder, double redrawn_share = 1e-3,
                const Options& options = {});

/// For slurm_script(), with which `sbatch` runs an array of workers.
struct SlurmOptions {
  std::string program = "dermis";   ///< the command of a worker
  std::string partition{};          ///< empty: the cluster's default
  int minutes = 60;                 ///< limit of a task
  std::uint64_t most_tasks = 1000;  ///< of the array; more shards than that share tasks
  std::string device = "best";
};
/// Returns a job script for all shards of a folder, which needs nothing of the administrator. A task whose
/// worker was killed or cannot go on requeues itself, at most three times.
std::string slurm_script(const std::filesystem::path& folder, const SlurmOptions& options = {});

/// Returns a page of at most so many samples, evenly spread: pictures, labels over them, histograms of all
/// parameters, licences. Throws InputError: no shard is there.
std::string sheet(const std::filesystem::path& folder, std::size_t samples = 60);

/// Returns a datasheet (Gebru et al. 2021) as Markdown: identities, skin tones, ranges of all parameters,
/// labels, licences, devices; what only people can answer is left to fill in. Throws InputError: no shard is
/// there.
std::string datasheet(const std::filesystem::path& folder);

/// Returns boxes of heads, noses and ears as COCO's JSON, from the labels `instance` and `region` of all
/// shards that are there, and with `landmarks` the keypoints of heads. Throws InputError: the recipe has
/// neither `instance` nor `region`.
std::string coco(const std::filesystem::path& folder);

/// The time of samples by its parts, seconds. Encoding runs beside drawing, on `threads`.
struct Benchmark {
  std::uint64_t samples = 0;
  double total_s = 0;
  double setting_s = 0;   ///< parameters, assets, poses
  double drawing_s = 0;   ///< waiting for the device
  double encoding_s = 0;  ///< of all threads together
  double writing_s = 0;   ///< tar, hashes, disk
  double waiting_s = 0;   ///< of the drawing thread, for encoders
  double bare_s = 0;      ///< the same frames by a session alone, nothing encoded or written
  std::uint64_t bytes = 0;
  std::uint64_t heads = 0;  ///< loaded meanwhile; that of sample 0 is there before time counts
};
/// Draws the first samples of a recipe twice, in turns: as write() does, into a temporary folder that is
/// removed, and by a bare session.
Benchmark bench(const std::filesystem::path& recipe, std::uint64_t samples = 64, const Options& options = {});

}  // namespace dermis::dataset
