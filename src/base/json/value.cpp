// SPDX-License-Identifier: MIT
#include "base/json/value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/core/known_names.h"
#include "base/core/one_line.h"

namespace dermis::json {

using Json = nlohmann::json;

InputError error_at(const std::string& file, const std::string& place, const std::string& message) {
  return InputError("", one_line(file + (place.empty() ? "" : ": " + place) + ": " + message));
}
std::string place_of_member(const std::string& object, std::string_view key) {
  return object.empty() ? one_line(key, 80) : fmt::format("{}.{}", object, one_line(key, 80));
}
std::string place_of_element(const std::string& array, std::size_t index) {
  return fmt::format("{}[{}]", array, index);
}

void Value::refuse(const std::string& message) const { throw error_at(*file_, place_, message); }
void Value::expected(const char* what) const {
  fail("{}must be {}, is {}", place_.empty() ? "the JSON " : "", what, json_->type_name());
}

bool Value::is_null() const { return json_->is_null(); }
bool Value::is_object() const { return json_->is_object(); }
bool Value::is_array() const { return json_->is_array(); }
bool Value::is_text() const { return json_->is_string(); }
bool Value::is_number() const { return json_->is_number(); }
bool Value::is_boolean() const { return json_->is_boolean(); }
bool Value::is_integer() const {
  if (json_->is_number_integer()) return true;
  return json_->is_number_float() && std::floor(json_->get<double>()) == json_->get<double>();
}

const Value& Value::object() const {
  if (!is_object()) expected("an object");
  return *this;
}

double Value::any_number() const {
  if (!is_number()) expected("a number");
  return json_->get<double>();
}
double Value::number(double least, double most) const {
  const double value = any_number();
  if (value >= least && value <= most) return value;

  const bool no_least = least <= -max_number, no_most = most >= max_number;
  if (no_most && (no_least || value > most)) fail("the number {} is out of range", value);
  if (no_most) fail("must be at least {}, is {}", least, value);
  fail("must be {} to {}, is {}", least, most, value);
}
std::uint64_t Value::count(std::uint64_t least, std::uint64_t most) const {
  if (!is_integer()) expected("an integer");
  const auto value = json_->get<double>();  // exact below 2^53, and max_count is less
  if (value < static_cast<double>(least) || value > static_cast<double>(most))
    fail("must be {} to {}, is {}", least, most, value);
  return static_cast<std::uint64_t>(value);
}
std::uint64_t Value::whole() const {
  if (!json_->is_number_unsigned()) expected("an integer of 0 to 2^64 - 1");
  return json_->get<std::uint64_t>();
}
const std::string& Value::text() const {
  if (!is_text()) expected("a string");
  return json_->get_ref<const std::string&>();
}
bool Value::boolean() const {
  if (!json_->is_boolean()) expected("true or false");
  return json_->get<bool>();
}

std::size_t Value::array_size(std::size_t least, std::size_t most) const {
  if (!is_array()) expected("an array");
  const std::size_t size = json_->size();
  if (size >= least && size <= most) return size;

  if (most < max_count) fail("must have {} to {} elements, has {}", least, most, size);
  if (size == 0) fail("is an empty array");
  fail("must have at least {} elements, has {}", least, size);
}
Value Value::element(std::size_t index) const {
  return {(*json_)[index], *file_, place_of_element(place_, index)};
}

bool Value::has(const std::string& key) const { return object().json_->contains(key); }
std::optional<Value> Value::find(const std::string& key) const {
  const auto found = object().json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return Value(*found, *file_, place_of_member(place_, key));
}
Value Value::at(const std::string& key) const {
  const std::optional<Value> found = find(key);
  if (!found) fail("'{}' is missing", key);
  return *found;
}
double Value::number_or(const char* key, double otherwise, double least, double most) const {
  const std::optional<Value> found = find(key);
  return found ? found->number(least, most) : otherwise;
}
std::uint64_t Value::count_or(const char* key, std::uint64_t otherwise, std::uint64_t least,
                              std::uint64_t most) const {
  const std::optional<Value> found = find(key);
  return found ? found->count(least, most) : otherwise;
}
bool Value::boolean_or(const char* key, bool otherwise) const {
  const std::optional<Value> found = find(key);
  return found ? found->boolean() : otherwise;
}
std::string Value::text_or(const char* key, const std::string& otherwise) const {
  const std::optional<Value> found = find(key);
  return found ? found->text() : otherwise;
}

std::vector<std::string> Value::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : object().json_->items()) names.push_back(key);
  return names;
}
void Value::only_keys(const std::vector<std::string_view>& known) const {
  for (const std::string& key : keys())
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail("unknown key '{}'; {}", one_line(key, 80), listed_names(key, known));
}

std::vector<double> Value::numbers(const char* key, std::size_t size) const {
  const std::optional<Value> found = find(key);
  if (!found) return {};

  const std::size_t actual = found->array_size();
  if (size != 0 && actual != size) found->fail("must have {} numbers, has {}", size, actual);
  std::vector<double> values(actual);
  for (std::size_t i = 0; i < actual; ++i) values[i] = found->element(i).number();
  return values;
}
void Value::for_each(const char* key, const std::function<void(const Value&)>& body) const {
  const std::optional<Value> found = find(key);
  if (!found) return;
  const std::size_t size = found->array_size();
  for (std::size_t i = 0; i < size; ++i) body(found->element(i).object());
}
std::size_t Value::size_of(const char* key) const {
  const std::optional<Value> found = find(key);
  return found ? found->array_size() : 0;
}

int Value::as_index(std::size_t size, const char* what) const {
  if (!is_integer()) expected("an integer");
  const auto value = json_->get<double>();
  if (value < 0 || value >= static_cast<double>(size))
    fail("there is no {} {} ({} in all)", what, value, size);
  if (value > std::numeric_limits<int>::max()) fail("index {} is too large", value);
  return static_cast<int>(value);
}
int Value::index_or_none(const char* key, std::size_t size, const char* what) const {
  const std::optional<Value> found = find(key);
  return found ? found->as_index(size, what) : -1;
}
int Value::index(const char* key, std::size_t size, const char* what) const {
  return at(key).as_index(size, what);
}
std::vector<int> Value::indices(const char* key, std::size_t size, const char* what) const {
  const std::optional<Value> found = find(key);
  if (!found) return {};

  std::vector<int> values(found->array_size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = found->element(i).as_index(size, what);
  return values;
}

std::string Value::dump() const { return json_->dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace dermis::json
