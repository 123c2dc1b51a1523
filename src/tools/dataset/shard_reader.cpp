// SPDX-License-Identifier: MIT
#include "tools/dataset/shard_reader.h"

#include "base/core/error.h"
#include "image/codec.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/members.h"

namespace dermis::dataset {

namespace fs = std::filesystem;

ShardReader::ShardReader(const Recipe::State& recipe, const fs::path& shard) : recipe_(recipe), tar_(shard) {
  for (const TarReader::File& file : tar_.files()) files_[file.name] = &file;
}

std::vector<std::byte> ShardReader::read(std::uint64_t sample, const std::string& ending) {
  const std::string name = stem_of(recipe_, sample) + "." + ending;
  const auto file = files_.find(name);
  if (file == files_.end()) throw input_error(tar_.path().string(), "has no {}", name);
  return tar_.read(*file->second);
}

image::Image8 ShardReader::picture(std::uint64_t sample) {
  return image::decode_image8(read(sample, "png"), stem_of(recipe_, sample) + ".png");
}

image::Image8 ShardReader::label(std::uint64_t sample, const std::string& name) {
  return image::decode_image8(read(sample, name + ".png"), stem_of(recipe_, sample) + "." + name + ".png", {},
                              {.deep = true});
}

std::vector<std::uint64_t> shards_there(const fs::path& folder, const Recipe& recipe) {
  std::vector<std::uint64_t> numbers;
  std::error_code ignored;
  for (std::uint64_t shard = 0; shard < recipe.shards(); ++shard) {
    const fs::path path = shard_path(folder, recipe, shard);
    if (fs::exists(path, ignored) && fs::exists(manifest_path(path), ignored)) numbers.push_back(shard);
  }
  if (numbers.empty()) throw input_error(folder.string(), "holds no shard yet");
  return numbers;
}

}  // namespace dermis::dataset
