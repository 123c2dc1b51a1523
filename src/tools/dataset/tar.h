// SPDX-License-Identifier: MIT
// Tar files as POSIX.1-1988 has them (USTAR): every byte follows from names and contents. No owner, no time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace dermis::dataset {

inline constexpr std::size_t tar_block = 512;

/// Returns the header of a file. Throws InputError: a name of more than 100 bytes, a file of 8 GiB or more.
std::array<std::byte, tar_block> tar_header(const std::string& name, std::uint64_t size);
/// Bytes of zeros after a file of that size.
std::size_t tar_padding(std::uint64_t size);
/// Bytes of zeros at the end.
inline constexpr std::size_t tar_end = 2 * tar_block;

/// Reads what tar_header() makes, and refuses anything else.
class TarReader {
 public:
  struct File {
    std::string name;
    std::uint64_t offset = 0, size = 0;
  };
  /// Reads all headers. Throws InputError with file and place: cut short, a checksum that is wrong, another
  /// kind of entry, bytes after the end.
  explicit TarReader(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const std::vector<File>& files() const { return files_; }
  std::vector<std::byte> read(const File& file);

 private:
  std::filesystem::path path_;
  std::ifstream in_;
  std::vector<File> files_;
};

}  // namespace dermis::dataset
