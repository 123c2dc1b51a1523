// SPDX-License-Identifier: MIT
// Files that save work in the next run. All kinds share one folder, one checksum, one limit. A cache that
// cannot be read or written costs time and nothing else: no function here throws.
//
// Several processes may use one folder at once. A file appears under its name only when it is complete (it is
// written beside it and renamed), a reader keeps what it has opened even if the file is removed meanwhile,
// and whatever is found is held against its checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dermis::cache {

/// $XDG_CACHE_HOME or ~/.cache, then dermis; empty if neither is set: then nothing is kept.
std::filesystem::path default_folder();

/// How much a folder may hold, bytes: $DERMIS_CACHE_LIMIT (MB, 1e6 bytes), else 1000 MB.
std::uint64_t limit_bytes();

/// FNV-1a, 64 bits: finds damage; malice is out of scope for a file in the user's own cache.
std::uint64_t checksum(std::span<const std::byte> bytes);

/// What write() was given, if the file is whole; its last use is now. None: missing, over `most_bytes`, or
/// damaged, which a note says.
std::optional<std::vector<std::byte>> read(const std::filesystem::path& file, std::uint64_t most_bytes);

/// Writes the bytes and their checksum (a last line of text, "checksum 0123456789abcdef"), making the folder
/// if need be; then removes what was not used for longest until the folder is within the limit. A file that
/// is larger than the limit is not kept. Failing is a warning.
void write(const std::filesystem::path& file, std::vector<std::byte> bytes,
           std::uint64_t limit = limit_bytes());

/// Files of one kind: "occlusion", "monte-carlo", "pipelines", "unfinished" (left by a run that was ended
/// while it wrote).
struct Usage {
  std::string kind;
  std::size_t files = 0;
  std::uint64_t bytes = 0;
};
/// Of all kinds, in the order above, also where there are none.
std::vector<Usage> usage(const std::filesystem::path& folder);

/// Removes the files of all kinds and returns what they were. Files of others stay.
std::vector<Usage> clear(const std::filesystem::path& folder);

}  // namespace dermis::cache
