// SPDX-License-Identifier: MIT
#include "cli/bench/recorded.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/one_line.h"

namespace dermis::cli::bench {
namespace {

using nlohmann::ordered_json;

constexpr std::uint64_t largest_file = std::uint64_t{256} << 20;  // bytes
constexpr std::size_t most_rounds = 1'000'000;

// A value of the file and the way to it.
struct Place {
  const std::string& file;
  std::string path;
  const ordered_json& json;

  Place at(const std::string& key) const {
    if (!json.is_object() || !json.contains(key))
      throw input_error(file, "{}has no '{}': not a result of `dermis bench --json`", where(), key);
    return {file, path.empty() ? key : path + "." + key, json.at(key)};
  }
  Place at(std::size_t i) const { return {file, fmt::format("{}[{}]", path, i), json.at(i)}; }
  std::size_t list() const {
    if (!json.is_array()) throw input_error(file, "{}expected a list", where());
    return json.size();
  }
  std::string text() const {
    if (!json.is_string()) throw input_error(file, "{}expected text", where());
    return json.get<std::string>();
  }
  double number(double low, double high) const {
    const double value = json.is_number() ? json.get<double>() : NAN;
    if (!(value >= low && value <= high))
      throw input_error(file, "{}expected a number from {:g} to {:g}", where(), low, high);
    return value;
  }
  std::string where() const { return path.empty() ? "" : path + ": "; }
};

RecordedTimes read_times(const std::string& variant, const Place& place) {
  RecordedTimes times{.variant = variant, .rounds_ms = {}, .passes = {}};
  const Place rounds = place.at("rounds_ms");
  if (rounds.list() == 0 || rounds.list() > most_rounds)
    throw input_error(rounds.file, "{}expected 1 to {} times", rounds.where(), most_rounds);
  for (std::size_t i = 0; i < rounds.list(); ++i) times.rounds_ms.push_back(rounds.at(i).number(0, 1e12));
  const Place passes = place.at("passes");
  for (std::size_t i = 0; i < passes.list(); ++i) {
    std::string name = passes.at(i).at("name").text();
    if (name == "view") name = "tone map";  // as it was called
    times.passes.push_back(
        {.name = std::move(name), .ms = passes.at(i).at("ms").number(0, 1e12), .calls = 1});
  }
  return times;
}

RecordedCell read_cell(const Place& place) {
  RecordedCell cell{.heads = static_cast<int>(place.at("heads").number(1, 1e6)),
                    .distance = place.at("distance").number(0, 1e9),
                    .times = {}};
  const Place variants = place.at("variants");
  if (!variants.json.is_object()) throw input_error(place.file, "{}expected an object", variants.where());
  for (const auto& [variant, value] : variants.json.items())
    cell.times.push_back(read_times(variant, variants.at(variant)));
  return cell;
}

Recorded read(const std::string& path) {
  const std::vector<std::byte> bytes = read_file(path, largest_file);
  const auto* const begin = reinterpret_cast<const char*>(bytes.data());

  // Deep nesting would exhaust the stack of who writes it out again; a result has six levels.
  const auto shallow = [](int depth, ordered_json::parse_event_t, ordered_json&) { return depth < 64; };
  const ordered_json json = ordered_json::parse(begin, begin + bytes.size(), shallow, false);
  if (json.is_discarded()) throw input_error(path, "is no JSON");

  Recorded recorded{.file = path, .commit = {}, .device = {}, .scene = {}, .settings = {}, .cells = {}};
  const Place root{recorded.file, "", json};
  recorded.commit = root.at("commit").text();
  recorded.device = root.at("device").text();
  recorded.scene = root.at("scene").text();
  const Place settings = root.at("settings");
  for (const auto& [name, value] : settings.json.items())
    recorded.settings.emplace_back(name, value.dump(-1, ' ', false, ordered_json::error_handler_t::replace));

  const Place cells = root.at("cells");
  std::set<std::pair<int, double>> seen;
  for (std::size_t i = 0; i < cells.list(); ++i) {
    recorded.cells.push_back(read_cell(cells.at(i)));
    if (!seen.emplace(recorded.cells.back().heads, recorded.cells.back().distance).second)
      throw input_error(path, "{}is there twice", cells.at(i).where());
  }
  return recorded;
}

}  // namespace

Recorded read_recorded(const std::string& path) {
  return with_one_line_errors([&] { return read(path); });
}

}  // namespace dermis::cli::bench
