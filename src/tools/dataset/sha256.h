// SPDX-License-Identifier: MIT
// SHA-256, FIPS 180-4: by which whoever receives a file knows that it is the one that was drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace dermis::dataset {

class Sha256 {
 public:
  void add(std::span<const std::byte> bytes);
  void add(std::string_view text) { add(std::as_bytes(std::span(text.data(), text.size()))); }
  /// Returns 64 hexadecimal digits; the object has then done its work.
  std::string digest();

 private:
  void block(const std::byte* bytes);

  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::byte, 64> rest_{};
  std::uint64_t size_ = 0;  ///< bytes so far
};

std::string sha256(std::span<const std::byte> bytes);
std::string sha256(std::string_view text);

/// Of a file of any length, read in pieces.
struct FileHash {
  std::string sha256;
  std::uint64_t bytes = 0;
  bool operator==(const FileHash&) const = default;
};
/// Throws InputError: it cannot be read.
FileHash hash_of_file(const std::filesystem::path& path);

}  // namespace dermis::dataset
