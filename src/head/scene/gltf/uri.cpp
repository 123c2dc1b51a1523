// SPDX-License-Identifier: MIT
#include "head/scene/gltf/uri.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/core/error.h"

namespace dermis::scene::gltf {

namespace {

constexpr std::uint8_t not_a_digit = 255;

constexpr std::array<std::uint8_t, 256> base64_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(not_a_digit);
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < digits.size(); ++i)
    values[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
  return values;
}

/// Returns nothing unless the text is base64 with its padding (which may be missing entirely).
std::optional<std::vector<std::byte>> decode_base64(std::string_view text) {
  static constexpr auto values = base64_values();
  while (!text.empty() && text.back() == '=' && text.size() % 4 != 1) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;

  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int held = 0;

  for (const char c : text) {
    const std::uint8_t value = values[static_cast<unsigned char>(c)];
    if (value == not_a_digit) return std::nullopt;
    bits = (bits << 6 | value) & 0xFFFFFF;
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::byte>(bits >> held & 0xFF));
    }
  }
  return bytes;
}

int hex_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Returns nothing if a % is not followed by two digits, or if the result holds a zero byte.
std::optional<std::string> decode_percent(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = hex_value(text[i + 1]), low = hex_value(text[i + 2]);
    if (high < 0 || low < 0 || (high == 0 && low == 0)) return std::nullopt;
    out += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return out;
}

bool has_scheme(const std::string& uri) {
  const std::size_t colon = uri.find(':');
  return colon != std::string::npos && uri.find_first_of("/?#") > colon;
}

}  // namespace

std::optional<std::vector<std::byte>> data_uri(std::string_view uri, const std::string& where) {
  if (!uri.starts_with("data:")) return std::nullopt;
  const std::size_t comma = uri.find(',');
  const std::string_view head = uri.substr(0, comma);
  if (comma == std::string_view::npos || !head.ends_with(";base64"))
    throw input_error(where, "the data uri is not of the form data:TYPE;base64,...");
  std::optional<std::vector<std::byte>> bytes = decode_base64(uri.substr(comma + 1));
  if (!bytes) throw input_error(where, "the data uri is not valid base64");
  return bytes;
}

std::filesystem::path uri_path(const std::filesystem::path& folder, const std::string& uri,
                               const std::string& where) {
  namespace fs = std::filesystem;
  const std::string shown = uri.substr(0, 120);
  if (uri.empty()) throw input_error(where, "the uri is empty");
  if (uri.find('\0') != std::string::npos) throw input_error(where, "the uri holds a zero byte");
  if (has_scheme(uri))
    throw input_error(where, "'{}' is not a relative uri; only files beside the scene are read", shown);
  const std::optional<std::string> decoded = decode_percent(uri);
  for (const std::string& name : {uri, decoded.value_or(uri)})
    if (fs::path(name).is_absolute())
      throw input_error(where, "'{}' is an absolute path; only files beside the scene are read", shown);
  std::error_code ignored;
  if (decoded && fs::exists(folder / *decoded, ignored)) return folder / *decoded;
  if (fs::exists(folder / uri, ignored)) return folder / uri;

  // As writers on Windows have it.
  std::string slashes = decoded.value_or(uri);
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  if (!fs::path(slashes).is_absolute() && fs::exists(folder / slashes, ignored)) return folder / slashes;
  return folder / decoded.value_or(uri);
}

}  // namespace dermis::scene::gltf
