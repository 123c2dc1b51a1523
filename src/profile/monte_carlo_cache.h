// SPDX-License-Identifier: MIT
// Results of profile/monte_carlo.h, kept in memory and, where a folder is given, in files.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "profile/monte_carlo.h"

namespace dermis::profile {

/// Everything a result depends on, exactly (hexadecimal floats), one line; it begins with the version of the
/// file's layout.
std::string cache_key(const ScatterScene& scene, const MonteCarloOptions& options);
/// A kept result, or null. A file that is damaged (its checksum is wrong) or belongs to another key counts as
/// absent.
std::shared_ptr<const MonteCarloResult> cached(const std::string& key, const std::filesystem::path& folder);
/// Keeps a result. A folder that cannot be written is a warning: the result is right all the same.
void remember(const std::string& key, const std::filesystem::path& folder,
              const std::shared_ptr<const MonteCarloResult>& result);

}  // namespace dermis::profile
