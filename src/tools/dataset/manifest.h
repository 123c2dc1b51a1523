// SPDX-License-Identifier: MIT
// Manifest beside a shard: its hashes, its device, whose work it shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/dataset/lock.h"
#include "tools/dataset/members.h"

namespace dermis::dataset {

struct SampleHashes {
  std::uint64_t sample = 0;
  std::string json_sha256, pictures_sha256;
  bool operator==(const SampleHashes&) const = default;
};

struct Manifest {
  std::uint64_t shard = 0, bytes = 0;
  std::string file, sha256;  ///< of the tar
  std::string dermis, recipe_sha256, inputs_sha256;
  DeviceClass device;
  std::vector<SampleHashes> samples;
  std::string host;  ///< that drew it; nothing depends on it
};

/// "DIR/train-000003.tar" and "DIR/train-000003.json".
std::filesystem::path shard_path(const std::filesystem::path& folder, const Recipe& recipe,
                                 std::uint64_t shard);
std::filesystem::path manifest_path(const std::filesystem::path& shard);

/// The hashes of many samples as one.
std::string parameters_hash(const std::vector<SampleHashes>& samples);
std::string pictures_hash(const std::vector<SampleHashes>& samples);

std::string text_of(const Manifest& manifest, const Recipe::State& recipe);
/// Throws InputError: it cannot be read, or is none.
Manifest load_manifest(const std::filesystem::path& path);

Recipe recipe_of(const Lock& lock);

}  // namespace dermis::dataset
