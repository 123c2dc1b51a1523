// SPDX-License-Identifier: MIT
// JSON text that came from outside, held against limits before it takes memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/json/value.h"

namespace dermis::json {

/// Limits of a text.
struct Limits {
  std::size_t depth = 16;          ///< objects and arrays within each other
  std::size_t values = 1'000'000;  ///< keys and ends of objects and arrays count, too
  /// Whether an object may hold a key twice. The last of them counts then, in silence: for formats that do
  /// not forbid it.
  bool repeated_keys = false;
  /// Whether members that are null or an empty array are read as if they were not there, but for "extras" and
  /// what is below them. For formats whose writers have such members.
  bool empty_is_absent = false;
};

/// Members that were left out, see Limits::empty_is_absent. Those of extensions do not count.
struct LeftOut {
  std::size_t count = 0;
  std::vector<std::string> first;  ///< places of the first three
};

/// A parsed text. Values point into it and may not outlive it.
class Document {
 public:
  /// `file` names the text in errors. InputError: not JSON, not UTF-8, beyond the limits, a key given twice.
  Document(std::string_view text, std::string file, const Limits& limits = {});
  ~Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;

  Value root() const;
  const LeftOut& left_out() const;

 private:
  struct Parsed;
  std::unique_ptr<Parsed> parsed_;
};

/// Reads a file. InputError, beside those above: it cannot be read, or has more than `most_bytes`.
Document load(const std::filesystem::path& path, std::uint64_t most_bytes, const Limits& limits = {});

}  // namespace dermis::json
