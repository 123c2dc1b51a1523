// SPDX-License-Identifier: MIT
// Opens a file: text or .glb, and the chunks of a .glb.
#include <cstring>

#include "core/file.h"
#include "scene/gltf/document.h"

namespace dermis::scene::gltf {

namespace {

constexpr std::uint32_t magic_gltf = 0x46546C67, chunk_json = 0x4E4F534A, chunk_bin = 0x004E4942;
constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;

std::uint32_t u32_at(std::span<const std::byte> bytes, std::size_t offset) {
  // glTF is little-endian, and so is every machine that runs Vulkan drivers we know of
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns the part of the file that its header claims.
std::span<const std::byte> checked_extent(const std::string& file, std::span<const std::byte> all) {
  if (all.size() < header_bytes) throw input_error(file, "the .glb header is cut off: {} bytes", all.size());
  const std::uint32_t version = u32_at(all, 4);
  if (version != 2) throw input_error(file, "has .glb version {}, expected 2", version);
  const std::uint32_t length = u32_at(all, 8);
  if (length > all.size())
    throw input_error(file, "is cut off: its header says {} bytes, there are {}", length, all.size());
  if (length < header_bytes + chunk_header_bytes)
    throw input_error(file, "the .glb length {} is too short to hold a chunk", length);
  return all.first(length);
}

void split_chunks(const std::string& file, Container& container) {
  const std::span<const std::byte> all = checked_extent(file, container.bytes);
  std::size_t offset = header_bytes;
  for (int number = 0; offset < all.size(); ++number) {
    if (all.size() - offset < chunk_header_bytes)
      throw input_error(file, "the header of .glb chunk {} is cut off", number);
    const std::uint32_t length = u32_at(all, offset), type = u32_at(all, offset + 4);
    offset += chunk_header_bytes;

    if (length > all.size() - offset)
      throw input_error(file, ".glb chunk {} of {} bytes reaches past the end of the file", number, length);
    if (length % 4 != 0)
      throw input_error(file, ".glb chunk {} has {} bytes, not a multiple of 4", number, length);
    const auto data = all.subspan(offset, length);
    offset += length;

    if (number == 0) {
      if (type != chunk_json) throw input_error(file, "the first .glb chunk is not JSON");
      if (data.empty()) throw input_error(file, "the JSON chunk is empty");
      container.json = as_text(data);
    } else if (type == chunk_json) {
      throw input_error(file, "has two JSON chunks");
    } else if (type == chunk_bin) {
      if (number != 1)
        throw input_error(file, "the binary chunk must be the second, is number {}", number + 1);
      container.binary = data;
    }  // the specification asks to skip chunks of other types
  }
}

}  // namespace

Container open_container(const std::filesystem::path& path) {
  const std::string file = path.string();
  Container container;
  container.bytes = read_file(path);
  const std::string_view text = as_text(container.bytes);
  if (container.bytes.size() >= 4 && u32_at(container.bytes, 0) == magic_gltf) {
    split_chunks(file, container);
    return container;
  }
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json_like =
      first != std::string_view::npos && (text[first] == '{' || text.starts_with("\xEF\xBB\xBF"));
  if (!json_like)
    throw input_error(file, "is not glTF: it starts with neither 'glTF' (.glb) nor '{{' (.gltf)");
  container.json = text;
  return container;
}

}  // namespace dermis::scene::gltf
