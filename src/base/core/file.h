// SPDX-License-Identifier: MIT
// Reads whole files with a limit, and writes files that appear under their name only when complete.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dermis {

/// Reads a whole regular file. Throws InputError (names the path) if it is missing, a directory, over
/// limit_bytes, or empty and !allow_empty.
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::uint64_t limit_bytes = std::uint64_t{2} << 30,
                                 bool allow_empty = false);

/// Writes to a file beside PATH, then renames it: PATH holds the old content or the new, never a part. The
/// target of a symbolic link is written, and the link stays. Throws InputError if the folder is missing or
/// the disk is full.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

/// Throws InputError if path could not be written (its folder is missing, it is a directory). Creates
/// nothing; called before long work.
void check_writable(const std::filesystem::path& path);

/// Returns what a name stands for: what a symbolic link names, existing or not, or the name itself. Throws
/// InputError if links go round in circles.
std::filesystem::path followed_links(const std::filesystem::path& path);

/// Returns the name of a file, cut where it is too long to have anything added.
std::string file_stem(const std::filesystem::path& path);
/// Returns the name of a file that belongs to another and lies beside it: its file_stem(), then `ending`.
std::filesystem::path file_beside(const std::filesystem::path& path, std::string_view ending);
/// Returns the name of a file that is not yet whole, ".PID.NUMBER.part" beside it: process and number
/// separate two runs, or two threads, that write the same name.
std::filesystem::path unfinished_path(const std::filesystem::path& path, unsigned number);

/// Returns the ending of a name in small letters, with its dot: ".png" for "A.PNG".
std::string ending_of(const std::filesystem::path& path);

/// Returns whether both names refer to one place, existing or not.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace dermis
