// SPDX-License-Identifier: MIT
// A data set that takes seconds: squares of skin, 24 x 20 pixels.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "dermis/dataset.h"
#include "support/files.h"

namespace dermis::dataset {

using Tree = nlohmann::json;  // json is a namespace here

class SmallSet : public testing::Test {
 protected:
  SmallSet();

  std::filesystem::path folder() const { return temporary_.path(); }
  /// Writes the recipe, with changes, and prepares a folder of that name.
  std::filesystem::path prepared(const std::string& name, bool one_device = false);
  std::filesystem::path write_recipe() const;
  /// Replaces a file of a shard, and makes tar and manifest agree with it again.
  static void replace_member(const std::filesystem::path& shard, const std::string& name,
                             const std::string& content);
  /// Like this, and the manifest stays as it is.
  static void flip_bit(const std::filesystem::path& file, std::size_t at);

  Tree recipe;
  Options quiet;  ///< says nothing

 private:
  tests::TempFolder temporary_;
};

/// Name and SHA-256 of each tar of a folder.
std::map<std::string, std::string> hashes_of(const std::filesystem::path& folder);
/// Names of all files of a folder.
std::vector<std::string> files_of(const std::filesystem::path& folder);

}  // namespace dermis::dataset
