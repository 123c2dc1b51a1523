// SPDX-License-Identifier: MIT
#include "scene/gltf/value.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace dermis::scene::gltf {

using Json = nlohmann::json;

namespace {

constexpr int max_json_depth = 128;
constexpr std::size_t max_json_values = 5'000'000;  // a DOM takes 16 to 100 bytes a value

/// What a parser's message says, without its own numbering.
std::string short_reason(const char* what) {
  const std::string_view reason(what);
  const std::size_t end = reason.find("] ");
  return printable(end == std::string_view::npos ? reason : reason.substr(end + 2), 160);
}

/// Reads a text without keeping anything, to hold it against the limits before a DOM takes memory. (A parser
/// with a callback could do both at once, but looks through all children of an array at the end of each.)
class Limits : public nlohmann::json_sax<Json> {
 public:
  explicit Limits(const std::string& file) : file_(&file) {}

  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return count(); }
  bool key(string_t&) override { return count(); }
  bool start_object(std::size_t) override { return count() && ++depth_ > 0; }
  bool end_object() override { return --depth_ >= 0 && count(); }
  bool start_array(std::size_t) override { return count() && ++depth_ > 0; }
  bool end_array() override { return --depth_ >= 0 && count(); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

 private:
  bool count() {
    if (depth_ > max_json_depth)
      throw input_error(*file_, "the JSON is nested deeper than {} levels", max_json_depth);
    if (++values_ > max_json_values)
      throw input_error(*file_, "the JSON has more than {} values", max_json_values);
    return true;
  }

  const std::string* file_;
  int depth_ = 0;
  std::size_t values_ = 0;
};

}  // namespace

std::string printable(std::string_view text, std::size_t most) {
  std::string out(text.substr(0, most));
  std::replace_if(
      out.begin(), out.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
  return out;
}

JsonText::JsonText(std::string_view text, std::string file) : file_(std::move(file)) {
  if (text.starts_with("\xEF\xBB\xBF"))
    throw input_error(file_, "the JSON starts with a byte-order mark, which glTF forbids");
  Limits limits(file_);
  Json::sax_parse(text.begin(), text.end(), &limits);  // what is no JSON is said below
  try {
    json_ = std::make_unique<Json>(Json::parse(text.begin(), text.end()));
  } catch (const Json::exception& error) {
    throw input_error(file_, "is not valid JSON: {}", short_reason(error.what()));
  }
  if (!json_->is_object()) throw input_error(file_, "the JSON is not an object");
}
JsonText::~JsonText() = default;
Value JsonText::root() const { return {*json_, file_, ""}; }

void Value::expected(const char* what) const { fail("must be {}, is {}", what, json_->type_name()); }

std::string Value::child_place(std::string_view key) const {
  return place_.empty() ? printable(key) : fmt::format("{}.{}", place_, printable(key));
}

const Value& Value::object() const {
  if (!json_->is_object()) expected("an object");
  return *this;
}
std::size_t Value::array_size() const {
  if (!json_->is_array()) expected("an array");
  if (json_->empty()) fail("is an empty array");
  return json_->size();
}
Value Value::element(std::size_t index) const {
  return {(*json_)[index], *file_, fmt::format("{}[{}]", place_, index)};
}

double Value::number() const {
  if (!json_->is_number()) expected("a number");
  const auto value = json_->get<double>();
  if (!(std::abs(value) <= std::numeric_limits<float>::max())) fail("the number {} is out of range", value);
  return value;
}
std::uint64_t Value::count(std::uint64_t least, std::uint64_t most) const {
  if (!is_integer()) expected("an integer");
  const auto value = json_->get<double>();  // exact below 2^53, and max_count is less
  if (value < static_cast<double>(least) || value > static_cast<double>(most))
    fail("must be {} to {}, is {}", least, most, value);
  return static_cast<std::uint64_t>(value);
}
const std::string& Value::text() const {
  if (!json_->is_string()) expected("a string");
  return json_->get_ref<const std::string&>();
}
bool Value::boolean() const {
  if (!json_->is_boolean()) expected("true or false");
  return json_->get<bool>();
}
bool Value::is_object() const { return json_->is_object(); }
bool Value::is_text() const { return json_->is_string(); }
bool Value::is_integer() const {
  if (json_->is_number_integer()) return true;
  return json_->is_number_float() && std::floor(json_->get<double>()) == json_->get<double>();
}

bool Value::has(const char* key) const { return object().json_->contains(key); }
std::optional<Value> Value::find(const char* key) const {
  const auto found = object().json_->find(key);
  if (found == json_->end()) return std::nullopt;
  return Value(*found, *file_, child_place(key));
}
Value Value::at(const char* key) const {
  const std::optional<Value> found = find(key);
  if (!found) fail("'{}' is missing", key);
  return *found;
}
double Value::number_or(const char* key, double otherwise, double least, double most) const {
  const std::optional<Value> found = find(key);
  if (!found) return otherwise;
  const double value = found->number();
  if (value < least || value > most) found->fail("must be {} to {}, is {}", least, most, value);
  return value;
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

std::vector<double> Value::numbers(const char* key, std::size_t size) const {
  const std::optional<Value> found = find(key);
  if (!found) return {};
  const std::size_t actual = found->array_size();
  if (size != 0 && actual != size) found->fail("must have {} numbers, has {}", size, actual);
  std::vector<double> values(actual);
  for (std::size_t i = 0; i < actual; ++i) values[i] = found->element(i).number();
  return values;
}
std::vector<int> Value::indices(const char* key, std::size_t size, const char* what) const {
  const std::optional<Value> found = find(key);
  if (!found) return {};
  std::vector<int> values(found->array_size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = found->element(i).as_index(size, what);
  std::vector<int> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    found->fail("names {} {} twice", what, *twice);
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
std::optional<Value> Value::extension(const char* name) const {
  const std::optional<Value> all = find("extensions");
  if (!all) return std::nullopt;
  const std::optional<Value> one = all->find(name);
  if (one) one->object();
  return one;
}

std::vector<std::string> Value::keys() const {
  std::vector<std::string> names;
  for (const auto& [key, value] : object().json_->items()) names.push_back(key);
  return names;
}
void Value::only_keys(const std::vector<std::string_view>& known) const {
  for (const std::string& key : keys())
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail("unknown key '{}'; known are: {}", printable(key), fmt::join(known, ", "));
}

}  // namespace dermis::scene::gltf
