// SPDX-License-Identifier: MIT
// Opens a file: text or .glb, and the chunks of a .glb.
#include <algorithm>
#include <cstring>

#include "base/core/file.h"
#include "head/scene/gltf/document.h"
#include "head/scene/gltf/lenient.h"

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

/// Returns the end of the chunks: what the header says, or the end of the file where that cannot be.
std::size_t end_of_chunks(const std::string& file, std::span<const std::byte> all) {
  if (all.size() < header_bytes) throw input_error(file, "the .glb header is cut off: {} bytes", all.size());
  const std::uint32_t version = u32_at(all, 4);
  if (version != 2) throw input_error(file, "has .glb version {}, expected 2", version);
  const std::uint32_t length = u32_at(all, 8);
  if (length >= header_bytes + chunk_header_bytes && length <= all.size()) return length;
  warn_in(file, "its .glb header says {} bytes, there are {}; its chunks are read", length, all.size());
  return all.size();
}

/// Returns where the chunk after `end` begins: a writer that pads a chunk may not count the padding.
std::size_t next_chunk(std::span<const std::byte> all, std::size_t end) {
  const std::size_t aligned = (end + 3) / 4 * 4;
  const bool padded = aligned + chunk_header_bytes <= all.size() && u32_at(all, aligned + 4) == chunk_bin;
  return padded ? aligned : end;
}

void take_chunk(const std::string& file, int number, std::uint32_t type, std::span<const std::byte> data,
                Container& container) {
  if (number == 0) {
    if (type != chunk_json) throw input_error(file, "the first .glb chunk is not JSON");
    if (data.empty()) throw input_error(file, "the JSON chunk is empty");
    container.json = as_text(data);
  } else if (type == chunk_json || (type == chunk_bin && container.binary)) {
    warn_in(file, "has two {} chunks, the second is left out", type == chunk_bin ? "binary" : "JSON");
  } else if (type == chunk_bin) {
    if (number != 1) warn_in(file, "the binary chunk must be the second, is number {}", number + 1);
    container.binary = data;
  }  // the specification asks to skip chunks of other types
}

void split_chunks(const std::string& file, Container& container) {
  const std::span<const std::byte> all = container.bytes;
  std::size_t end = end_of_chunks(file, all), offset = header_bytes;
  for (int number = 0; offset < end; ++number) {
    if (all.size() - offset < chunk_header_bytes) {
      if (number == 0) throw input_error(file, "the header of .glb chunk {} is cut off", number);
      warn_in(file, "{} bytes behind the chunks are left out", all.size() - offset);
      return;
    }
    const std::uint32_t length = u32_at(all, offset), type = u32_at(all, offset + 4);
    offset += chunk_header_bytes;

    if (length > all.size() - offset)
      throw input_error(file, ".glb chunk {} of {} bytes reaches past the end of the file", number, length);
    if (length > end - std::min(end, offset)) {
      warn_in(file, ".glb chunk {} reaches past the length in the header, and is read", number);
      end = all.size();
    }
    if (length % 4 != 0) warn_in(file, ".glb chunk {} has {} bytes, not a multiple of 4", number, length);
    take_chunk(file, number, type, all.subspan(offset, length), container);
    offset = next_chunk(all, offset + length);
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
    if (container.json.empty()) throw input_error(file, "the .glb has no JSON chunk");
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
