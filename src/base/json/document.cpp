// SPDX-License-Identifier: MIT
#include "base/json/document.h"

#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/one_line.h"

namespace dermis::json {
namespace {

using Json = nlohmann::json;

/// Returns the parser's message without its own numbering.
std::string short_reason(const char* what) {
  const std::string_view reason(what);
  const std::size_t end = reason.find("] ");
  return one_line(end == std::string_view::npos ? reason : reason.substr(end + 2), 160);
}

/// Reads a text without keeping it, to hold it against the limits before the values take memory. (A parser
/// with a callback could do both at once, but looks through all children of an array at the end of each.)
class Checker : public nlohmann::json_sax<Json> {
 public:
  Checker(const std::string& file, const Limits& limits) : file_(file), limits_(limits) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }
  bool start_object(std::size_t) override { return value() && open(false); }
  bool start_array(std::size_t) override { return value() && open(true); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  // The parser that keeps what it reads says what is wrong.
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override { return false; }

  bool key(string_t& name) override {
    count();
    Open& object = open_.back();
    if (!limits_.repeated_keys && !object.keys.insert(name).second)
      throw error_at(file_, place(), fmt::format("key '{}' is given twice", one_line(name, 80)));
    object.key = name;
    return true;
  }

 private:
  /// An object or array whose end has not been read.
  struct Open {
    bool is_array = false;
    std::size_t elements = 0;    ///< begun so far
    std::string key;             ///< the latest
    std::set<std::string> keys;  ///< all so far
  };

  void count() {
    if (++values_ > limits_.values)
      throw input_error(file_, "the JSON has more than {} values", limits_.values);
  }
  bool value() {
    count();
    if (!open_.empty() && open_.back().is_array) ++open_.back().elements;
    return true;
  }
  bool open(bool is_array) {
    if (open_.size() == limits_.depth)
      throw input_error(file_, "the JSON is nested deeper than {} levels", limits_.depth);
    open_.push_back({.is_array = is_array, .key = {}, .keys = {}});
    return true;
  }
  bool close() {
    count();
    open_.pop_back();
    return true;
  }

  /// Returns the place of the innermost open object.
  std::string place() const {
    std::string place;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i)
      place = open_[i].is_array ? place_of_element(place, open_[i].elements - 1)
                                : place_of_member(place, open_[i].key);
    return place;
  }

  const std::string& file_;
  const Limits& limits_;
  std::vector<Open> open_;
  std::size_t values_ = 0;
};

}  // namespace

struct Document::Parsed {
  std::string file;
  Json json;
  LeftOut left_out;
};

namespace {

void leave_out_empty(Json& json, const std::string& place, bool counts, LeftOut& left_out) {
  if (json.is_array()) {
    // An element keeps its number: among objects, what is none is one without members.
    const bool of_objects =
        std::any_of(json.begin(), json.end(), [](const Json& e) { return e.is_object(); });
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (json[i].is_structured()) leave_out_empty(json[i], place_of_element(place, i), counts, left_out);
      if (json[i].is_object() || !of_objects) continue;
      left_out.count += counts ? 1 : 0;
      if (counts && left_out.first.size() < 3) left_out.first.push_back(place_of_element(place, i));
      json[i] = Json::object();
    }
    return;
  }
  for (auto member = json.begin(); member != json.end();) {
    Json& value = member.value();
    const std::string& key = member.key();
    if (key == "extras") {
      ++member;
      continue;
    }
    if (value.is_null() || (value.is_array() && value.empty())) {
      left_out.count += counts ? 1 : 0;
      if (counts && left_out.first.size() < 3) left_out.first.push_back(place_of_member(place, key));
      member = json.erase(member);
      continue;
    }
    if (value.is_structured())
      leave_out_empty(value, place_of_member(place, key), counts && key != "extensions", left_out);
    ++member;
  }
}

}  // namespace

Document::Document(std::string_view text, std::string file, const Limits& limits)
    : parsed_(std::make_unique<Parsed>(Parsed{std::move(file), {}, {}})) {
  Checker checker(parsed_->file, limits);
  Json::sax_parse(text.begin(), text.end(), &checker);

  try {
    parsed_->json = Json::parse(text.begin(), text.end());
  } catch (const Json::exception& error) {
    throw input_error(parsed_->file, "is not valid JSON: {}", short_reason(error.what()));
  }
  if (limits.empty_is_absent && parsed_->json.is_structured())
    leave_out_empty(parsed_->json, "", true, parsed_->left_out);
}

Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

const LeftOut& Document::left_out() const { return parsed_->left_out; }
Value Document::root() const { return {parsed_->json, parsed_->file, ""}; }

Document load(const std::filesystem::path& path, std::uint64_t most_bytes, const Limits& limits) {
  const std::vector<std::byte> bytes = with_one_line_errors([&] { return read_file(path, most_bytes); });
  return {{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string(), limits};
}

}  // namespace dermis::json
