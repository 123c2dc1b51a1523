// SPDX-License-Identifier: MIT
#include "tools/dataset/tar.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "base/core/error.h"

namespace dermis::dataset {
namespace {

using Block = std::array<std::byte, tar_block>;

constexpr std::size_t longest_name = 100;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 33;
// Where fields of a header begin: name, mode, owner, group, size, time, checksum, kind, magic.
constexpr std::size_t at_mode = 100, at_owner = 108, at_group = 116, at_size = 124, at_time = 136,
                      at_sum = 148, at_kind = 156, at_magic = 257;

void put(Block& block, std::size_t at, std::string_view text) {
  std::memcpy(block.data() + at, text.data(), text.size());
}

unsigned sum_of(Block block) {
  std::fill_n(block.begin() + at_sum, 8, std::byte{' '});
  unsigned sum = 0;
  for (const std::byte b : block) sum += std::to_integer<unsigned>(b);
  return sum;
}

bool is_zero(const Block& block) {
  return std::ranges::all_of(block, [](std::byte b) { return b == std::byte{0}; });
}

}  // namespace

Block tar_header(const std::string& name, std::uint64_t size) {
  if (name.empty() || name.size() > longest_name)
    throw input_error(name, "is no name of a file in a tar: 1 to {} bytes", longest_name);
  if (size >= most_bytes) throw input_error(name, "has {} bytes, and a tar holds files below 8 GiB", size);
  Block block{};
  put(block, 0, name);
  put(block, at_mode, "0000644");
  put(block, at_owner, "0000000");
  put(block, at_group, "0000000");
  put(block, at_size, fmt::format("{:011o}", size));
  put(block, at_time, "00000000000");
  put(block, at_kind, "0");
  put(block, at_magic, std::string_view("ustar\00000", 8));
  put(block, at_sum, fmt::format("{:06o}", sum_of(block)));
  block[at_sum + 6] = std::byte{0};
  block[at_sum + 7] = std::byte{' '};
  return block;
}

std::size_t tar_padding(std::uint64_t size) { return (tar_block - size % tar_block) % tar_block; }

TarReader::TarReader(const std::filesystem::path& path) : path_(path), in_(path, std::ios::binary) {
  std::error_code error;
  const std::uint64_t whole = std::filesystem::file_size(path, error);
  if (!in_ || error) throw input_error(path.string(), "cannot be opened");
  std::uint64_t at = 0;
  while (true) {
    Block block{};
    if (at + tar_block > whole || !in_.seekg(static_cast<std::streamoff>(at)) ||
        !in_.read(reinterpret_cast<char*>(block.data()), tar_block))
      throw input_error(path.string(), "is cut short: it ends at byte {} without an end of its files", whole);
    if (is_zero(block)) break;

    const std::string name(reinterpret_cast<const char*>(block.data()),
                           strnlen(reinterpret_cast<const char*>(block.data()), longest_name));
    const std::string digits(reinterpret_cast<const char*>(block.data()) + at_size, 11);
    if (digits.find_first_not_of("01234567") != std::string::npos || name.empty())
      throw input_error(path.string(), "byte {}: no header of a file", at);
    const std::uint64_t size = std::stoull(digits, nullptr, 8);
    if (block != tar_header(name, size))
      throw input_error(path.string(), "byte {}: the header of '{}' is damaged, or not ours", at, name);
    files_.push_back({name, at + tar_block, size});
    at += tar_block + size + tar_padding(size);
  }
  if (at + tar_end != whole)
    throw input_error(path.string(), "has {} bytes, and its files end at {}", whole, at + tar_end);
}

std::vector<std::byte> TarReader::read(const File& file) {
  std::vector<std::byte> bytes(file.size);
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(file.offset));
  if (!in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
    throw input_error(path_.string(), "'{}' cannot be read", file.name);
  return bytes;
}

}  // namespace dermis::dataset
