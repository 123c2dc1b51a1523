// SPDX-License-Identifier: MIT
// A JSON value of a glTF file together with its place ("accessors[3].count"), so that every error names file
// and place. All reading of the document goes through here: types, ranges and references are checked before
// anything is used.
//
// Why not tinygltf: it skips optional members of a wrong type, reads files and decodes Draco before anything
// is validated, and refuses meshopt fallback buffers. The checks below would all have to be written around it
// anyway; on the plain JSON they are the reader.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace dermis::scene::gltf {

/// Counts, offsets and lengths of a file stay below this, so that sums and products of a few of them fit 64
/// bits.
inline constexpr std::uint64_t max_count = std::uint64_t{1} << 48;

/// Text of a file for a message: without control characters, so that the message stays one line, and cut to
/// `most` bytes.
std::string printable(std::string_view text, std::size_t most = 80);

/// The parsed text; Values point into it.
class JsonText {
 public:
  /// `file` names the file in errors. InputError: not JSON, not UTF-8, too deep, too many values, not an
  /// object.
  JsonText(std::string_view text, std::string file);
  ~JsonText();
  JsonText(const JsonText&) = delete;
  JsonText& operator=(const JsonText&) = delete;
  class Value root() const;

 private:
  std::unique_ptr<nlohmann::json> json_;
  std::string file_;
};

class Value {
 public:
  Value(const nlohmann::json& json, const std::string& file, std::string place)
      : json_(&json), file_(&file), place_(std::move(place)) {}

  const std::string& place() const { return place_; }
  const std::string& file() const { return *file_; }
  const nlohmann::json& json() const { return *json_; }
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw input_error(*file_, "{}{}{}", place_, place_.empty() ? "" : ": ",
                      fmt::format(format, std::forward<Args>(args)...));
  }

  // What this value is. Each fails with place and expected type.
  const Value& object() const;
  std::size_t array_size() const;  ///< of a non-empty array
  Value element(std::size_t index) const;
  /// finite, and finite as a float
  double number() const;
  /// integer; 3.0 is one
  std::uint64_t count(std::uint64_t least = 0, std::uint64_t most = max_count) const;
  const std::string& text() const;
  bool boolean() const;
  bool is_object() const;
  bool is_text() const;
  bool is_integer() const;

  // Members of this object.
  bool has(const char* key) const;
  std::optional<Value> find(const char* key) const;
  Value at(const char* key) const;  ///< required
  double number_or(const char* key, double otherwise, double least = -std::numeric_limits<float>::max(),
                   double most = std::numeric_limits<float>::max()) const;
  std::uint64_t count_or(const char* key, std::uint64_t otherwise, std::uint64_t least = 0,
                         std::uint64_t most = max_count) const;
  bool boolean_or(const char* key, bool otherwise) const;
  std::string text_or(const char* key, const std::string& otherwise) const;
  /// An index below `size` of what is called `what`; absent: -1.
  int index_or_none(const char* key, std::size_t size, const char* what) const;
  int index(const char* key, std::size_t size, const char* what) const;  ///< required
  /// Exactly `size` numbers (0: any number of them, at least one); absent: empty.
  std::vector<double> numbers(const char* key, std::size_t size) const;
  /// Each different, each below `size`; absent: empty.
  std::vector<int> indices(const char* key, std::size_t size, const char* what) const;
  /// Calls body for each object of the array `key`; nothing if absent. An empty array fails, as glTF has it.
  void for_each(const char* key, const std::function<void(const Value&)>& body) const;
  std::size_t size_of(const char* key) const;  ///< elements of the array `key`, 0 if absent
  std::optional<Value> extension(const char* name) const;
  /// The keys of this object; InputError for one that is not among `known`, listing them.
  void only_keys(const std::vector<std::string_view>& known) const;
  std::vector<std::string> keys() const;

 private:
  int as_index(std::size_t size, const char* what) const;
  [[noreturn]] void expected(const char* what) const;
  std::string child_place(std::string_view key) const;

  const nlohmann::json* json_;
  const std::string* file_;
  std::string place_;
};

}  // namespace dermis::scene::gltf
