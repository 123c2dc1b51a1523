// SPDX-License-Identifier: MIT
// Files that save work in the next run. All kinds share one folder, one checksum and one limit. A cache that
// cannot be read or written costs only time: no function here throws.
//
// Several processes may use one folder at once. A file appears under its name only when complete (written
// beside it and renamed). A reader keeps an open file even if it is removed meanwhile. Every file is checked
// against its checksum.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dermis::cache {

/// Returns $XDG_CACHE_HOME/dermis or ~/.cache/dermis; empty if neither variable is set, then nothing is kept.
std::filesystem::path default_folder();

/// Returns the most bytes that a folder may hold: $DERMIS_CACHE_LIMIT (MB, 1e6 bytes), else 1000 MB.
std::uint64_t limit_bytes();

/// FNV-1a, 64 bits. Detects damage, not malice: the files are in the user's own cache.
std::uint64_t checksum(std::span<const std::byte> bytes);

/// Returns what write() was given, and sets the time of last use to now. Returns nothing if the file is
/// missing, larger than `most_bytes`, or damaged (with a note).
std::optional<std::vector<std::byte>> read(const std::filesystem::path& file, std::uint64_t most_bytes);

/// Writes the bytes and their checksum (a last line of text, "checksum 0123456789abcdef"); creates the folder
/// if needed. Then removes the least recently used files until the folder is within the limit. Does not keep
/// a file larger than the limit. Returns whether it was written. If it cannot be, a call of the library warns
/// once, whatever else it cannot write.
bool write(const std::filesystem::path& file, std::vector<std::byte> bytes,
           std::uint64_t limit = limit_bytes());

/// Files of one kind: "occlusion", "monte-carlo", "pipelines", "built-in" (head), "unfinished" (left by a run
/// that ended while writing).
struct Usage {
  std::string kind;
  std::size_t files = 0;
  std::uint64_t bytes = 0;
};
/// Returns the usage of all kinds, in the order above, including empty ones.
std::vector<Usage> usage(const std::filesystem::path& folder);

/// Removes the files of all kinds and returns what was removed. Other files stay.
std::vector<Usage> clear(const std::filesystem::path& folder);

}  // namespace dermis::cache
