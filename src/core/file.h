// SPDX-License-Identifier: MIT
// Files in and out: whole reads with a limit, and writes that appear under their name only when complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace dermis {

/// Reads a whole regular file. InputError names the path and the reason (missing, a directory, empty if
/// !allow_empty, over limit_bytes).
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::uint64_t limit_bytes = std::uint64_t{2} << 30,
                                 bool allow_empty = false);

/// Writes to "PATH.part", then renames: the old file or the new one, never a half. InputError if the folder
/// is missing or the disk is full.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// InputError if path could not be written (its folder is missing, it is a directory). Creates nothing:
/// called before long work.
void check_writable(const std::filesystem::path& path);

/// Do both names lead to one place, whether or not it exists?
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace dermis
