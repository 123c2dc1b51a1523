// SPDX-License-Identifier: MIT
// A JSON value together with its place ("accessors[3].count"), so that every error names file and place:
//
//   const json::Document document = json::load(path, 1 << 20);
//   const json::Value root = document.root();
//   root.only_keys({"name", "samples", "mix"});
//   const std::string name = root.at("name").text();       // must be there
//   const auto samples = root.count_or("samples", 4, 1, 64);  // may be left out; 1 to 64
//   if (const auto mix = root.find("mix")) settings.mix = mix->number(0, 1);
//
// Nothing is used before its type and range are checked, and nothing is converted in silence.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/core/error.h"

namespace dermis::json {

/// Counts, offsets and lengths of a file stay below this, so that sums and products of a few of them fit 64
/// bits.
inline constexpr std::uint64_t max_count = std::uint64_t{1} << 48;
/// Numbers stay finite when they become floats, unless a reader asks for more.
inline constexpr double max_number = std::numeric_limits<float>::max();

class Value {
 public:
  Value(const nlohmann::json& json, const std::string& file, std::string place)
      : json_(&json), file_(&file), place_(std::move(place)) {}

  const std::string& place() const { return place_; }
  const std::string& file() const { return *file_; }
  /// The same value under another name for its place, which errors then show: "layer 2" says more than "[2]".
  Value called(std::string place) const { return {*json_, *file_, std::move(place)}; }
  /// Throws InputError of one line: file, place, message.
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    refuse(fmt::format(format, std::forward<Args>(args)...));
  }

  // The value, by its type. Each fails with place and expected type, or the range.
  const Value& object() const;
  double number(double least = -max_number, double most = max_number) const;
  double any_number() const;  ///< of any size
  /// An integer; 3.0 is one.
  std::uint64_t count(std::uint64_t least = 0, std::uint64_t most = max_count) const;
  /// Any integer of 64 bits without a sign, to the last bit; 3.0 is none.
  std::uint64_t whole() const;
  const std::string& text() const;
  bool boolean() const;
  /// Elements of an array; an empty one fails unless `least` is 0.
  std::size_t array_size(std::size_t least = 1, std::size_t most = max_count) const;
  Value element(std::size_t index) const;  ///< below array_size()

  bool is_null() const;
  bool is_object() const;
  bool is_array() const;
  bool is_text() const;
  bool is_number() const;
  bool is_boolean() const;
  bool is_integer() const;

  // Members of this object.
  bool has(const std::string& key) const;
  std::optional<Value> find(const std::string& key) const;
  Value at(const std::string& key) const;  ///< required
  double number_or(const char* key, double otherwise, double least = -max_number,
                   double most = max_number) const;
  std::uint64_t count_or(const char* key, std::uint64_t otherwise, std::uint64_t least = 0,
                         std::uint64_t most = max_count) const;
  bool boolean_or(const char* key, bool otherwise) const;
  std::string text_or(const char* key, const std::string& otherwise) const;
  std::vector<std::string> keys() const;  ///< sorted
  /// InputError for a key that is not among `known`, listing them.
  void only_keys(const std::vector<std::string_view>& known) const;

  // Members that are arrays. An empty one fails.
  /// Exactly `size` numbers (0: any number of them, at least one); absent: empty.
  std::vector<double> numbers(const char* key, std::size_t size) const;
  /// Calls body for each object of the array `key`; nothing if absent.
  void for_each(const char* key, const std::function<void(const Value&)>& body) const;
  std::size_t size_of(const char* key) const;  ///< elements of the array `key`, 0 if absent

  // Members that refer to elements of another array by their index.
  /// An index below `size` of what is called `what`; absent: -1.
  int index_or_none(const char* key, std::size_t size, const char* what) const;
  int index(const char* key, std::size_t size, const char* what) const;  ///< required
  /// Each below `size`; absent: empty.
  std::vector<int> indices(const char* key, std::size_t size, const char* what) const;

  /// This value as JSON on one line, its keys sorted: equal values give equal texts.
  std::string dump() const;

 private:
  int as_index(std::size_t size, const char* what) const;
  [[noreturn]] void expected(const char* what) const;
  [[noreturn]] void refuse(const std::string& message) const;

  const nlohmann::json* json_;
  const std::string* file_;
  std::string place_;
};

/// InputError of one line, whatever a file put into place or message.
InputError error_at(const std::string& file, const std::string& place, const std::string& message);
std::string place_of_member(const std::string& object, std::string_view key);
std::string place_of_element(const std::string& array, std::size_t index);

}  // namespace dermis::json
