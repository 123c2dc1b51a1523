// SPDX-License-Identifier: MIT
// Reads samples out of shards that are there.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"
#include "tools/dataset/lock.h"
#include "tools/dataset/tar.h"

namespace dermis::dataset {

/// The samples of one shard.
class ShardReader {
 public:
  ShardReader(const Recipe::State& recipe, const std::filesystem::path& shard);

  /// Throws InputError: the shard has no such file.
  std::vector<std::byte> read(std::uint64_t sample, const std::string& ending);
  image::Image8 picture(std::uint64_t sample);
  /// The 16 bits of a label as its PNG has them: rgba16 of the picture.
  image::Image8 label(std::uint64_t sample, const std::string& name);

 private:
  const Recipe::State& recipe_;
  TarReader tar_;
  std::map<std::string, const TarReader::File*> files_;
};

/// Numbers of the shards that are there. Throws InputError: none is.
std::vector<std::uint64_t> shards_there(const std::filesystem::path& folder, const Recipe& recipe);

}  // namespace dermis::dataset
