// SPDX-License-Identifier: MIT
// Reads whole files with a limit, and writes files that appear under their name only when complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace dermis {

/// Reads a whole regular file. Throws InputError (names the path) if it is missing, a directory, over
/// limit_bytes, or empty and !allow_empty.
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::uint64_t limit_bytes = std::uint64_t{2} << 30,
                                 bool allow_empty = false);

/// Writes to a file beside PATH, then renames it: PATH holds the old content or the new, never a part. Throws
/// InputError if the folder is missing or the disk is full.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Throws InputError if path could not be written (its folder is missing, it is a directory). Creates
/// nothing; called before long work.
void check_writable(const std::filesystem::path& path);

/// Returns whether both names refer to one place, existing or not.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace dermis
