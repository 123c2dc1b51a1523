// SPDX-License-Identifier: MIT
#include "kit/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace dermis::kit {
namespace {

using Json = nlohmann::ordered_json;

// Clipped at the edge of the picture, as in the paper: it reads unlit texels there, which is its error.
constexpr const char* without_margin = "all_margin_0";

// A message of GoogleTest is file and line, then what was expected, over several lines.
std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

void add_once(Json& list, const std::string& text) {
  if (std::ranges::find(list, Json(text)) == list.end()) list.push_back(text);
}

void add_case(Json& note, const std::string& suite, const Json& test) {
  const std::string name = suite + "." + test.value("name", "?");
  if (test.contains("failures")) {
    for (const Json& failure : test["failures"])
      note["failures"].push_back(name + ": " + one_line(failure.value("failure", "")));
    return;
  }
  if (test.value("result", "") != "SKIPPED") {
    note["passed"] = note["passed"].get<int>() + 1;
    return;
  }
  note["skipped"] = note["skipped"].get<int>() + 1;
  for (const Json& why : test.value("skipped", Json::array()))
    add_once(note["why_skipped"], one_line(why.value("message", "")));
}

}  // namespace

Json read_json(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  Json json = Json::parse(std::istreambuf_iterator<char>(in), {}, nullptr, false);
  return json.is_discarded() ? Json::object() : json;
}

bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
  if (!first || !second) return false;
  using Bytes = std::istreambuf_iterator<char>;
  return std::equal(Bytes(first), Bytes(), Bytes(second), Bytes());
}

void add_cases(Json& note, const Json& report) {
  note["cases"] = report.value("tests", 0);
  note["passed"] = 0;
  note["skipped"] = 0;
  note["why_skipped"] = Json::array();
  note["failures"] = Json::array();
  for (const Json& suite : report.value("testsuites", Json::array()))
    for (const Json& test : suite.value("testsuite", Json::array()))
      add_case(note, suite.value("name", "?"), test);
}

std::string result_of(const Json& note, const Ended& ended) {
  if (!ended.ok() || !note.at("failures").empty()) return "failed";
  if (note.at("passed") > 0) return "holds";
  return note.at("skipped") > 0 ? "skipped" : "failed";
}

std::string why_not(const Json& note, const Ended& ended) {
  const Json& failures = note.at("failures");
  if (!failures.empty())
    return fmt::format("{} of {} cases; {}", failures.size(), note.value("cases", 0),
                       failures.front().get<std::string>());
  return ended.ok() ? "no case ran" : ended.why();
}

std::uint64_t unshaded_reads(const Json& cell) {
  std::uint64_t sum = 0;
  if (!cell.contains("texels")) return 0;
  for (const auto& [name, counts] : cell["texels"].items())
    if (name != without_margin) sum += counts.value("unshaded_reads", std::uint64_t{0});
  return sum;
}

void drop_repeated_statistics(Json& note) {
  if (!note.contains("statistics")) return;
  Json kept;
  for (const char* key : {"frame_ms", "load_ms", "upload_ms", "pipeline_ms", "texels", "memory_bytes"})
    if (note["statistics"].contains(key)) kept[key] = note["statistics"][key];
  note["passes"] = note["statistics"].value("passes", Json::array()).size();
  note["statistics"] = std::move(kept);
}

std::string file_part(const std::string& device) {
  std::string part;
  for (const char c : device) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    const bool large = c >= 'A' && c <= 'Z';
    if (plain || large)
      part += large ? static_cast<char>(c - 'A' + 'a') : c;
    else if (!part.empty() && part.back() != '-')
      part += '-';
  }
  while (!part.empty() && part.back() == '-') part.pop_back();
  return part.empty() ? "unknown" : part.substr(0, 60);
}

}  // namespace dermis::kit
