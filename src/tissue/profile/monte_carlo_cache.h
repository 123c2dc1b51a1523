// SPDX-License-Identifier: MIT
// Keeps results of tissue/profile/monte_carlo.h in memory and, if a folder is given, in files.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "tissue/profile/monte_carlo.h"

namespace dermis::profile {

/// Returns everything that a result depends on, exactly (hexadecimal floats), as one line that begins with
/// the version of the file layout.
std::string cache_key(const ScatterScene& scene, const MonteCarloOptions& options);
/// Returns a kept result, or null. A file that is damaged (wrong checksum) or belongs to another key counts
/// as absent.
std::shared_ptr<const MonteCarloResult> cached(const std::string& key, const std::filesystem::path& folder);
/// Keeps a result. If the folder cannot be written, it warns and keeps the result in memory only.
void remember(const std::string& key, const std::filesystem::path& folder,
              const std::shared_ptr<const MonteCarloResult>& result);

}  // namespace dermis::profile
