// SPDX-License-Identifier: MIT
#include "cli/bench/recorded.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

#include "base/json/document.h"
#include "base/settings/fields.h"

namespace dermis::cli::bench {
namespace {

constexpr std::uint64_t largest_file = std::uint64_t{256} << 20;  // bytes
constexpr json::Limits limits{.depth = 64, .values = 50'000'000};
constexpr std::size_t most_rounds = 1'000'000;
constexpr double longest_ms = 1e12;

RecordedTimes read_times(const std::string& variant, const json::Value& value) {
  RecordedTimes times{.variant = variant, .rounds_ms = {}, .passes = {}};
  const json::Value rounds = value.at("rounds_ms");
  for (std::size_t i = 0; i < rounds.array_size(1, most_rounds); ++i)
    times.rounds_ms.push_back(rounds.element(i).number(0, longest_ms));

  const json::Value passes = value.at("passes");
  for (std::size_t i = 0; i < passes.array_size(0); ++i) {
    const json::Value pass = passes.element(i);
    std::string name = pass.at("name").text();
    if (name == "view") name = "tone map";  // as it was called
    times.passes.push_back({.name = std::move(name), .ms = pass.at("ms").number(0, longest_ms), .calls = 1});
  }
  return times;
}

RecordedCell read_cell(const json::Value& value) {
  RecordedCell cell{.heads = static_cast<int>(value.at("heads").count(1, 1'000'000)),
                    .distance = value.at("distance").number(0, 1e9),
                    .times = {}};
  const json::Value variants = value.at("variants");
  for (const std::string& variant : variants.keys())
    cell.times.push_back(read_times(variant, variants.at(variant)));
  return cell;
}

using Settings = std::vector<std::pair<std::string, std::string>>;

// By path, without their sections.
void flatten(const json::Value& value, const std::string& path, Settings& into) {
  if (!value.is_object()) {
    into.emplace_back(path, value.dump());
    return;
  }
  for (const std::string& name : value.keys()) flatten(value.at(name), path_of(path, name), into);
}

// "[[30,20,3]]", as lamps were once recorded.
std::string lamps_of(const json::Value& placed) {
  std::vector<std::string> lamps;
  for (std::size_t i = 0; i < placed.array_size(0, 64); ++i) {
    const json::Value lamp = placed.element(i);
    lamp.array_size(3, 3);
    lamps.push_back(fmt::format(R"({{"azimuth_deg":{},"elevation_deg":{},"irradiance":{}}})",
                                lamp.element(0).dump(), lamp.element(1).dump(), lamp.element(2).dump()));
  }
  return fmt::format("[{}]", fmt::join(lamps, ","));
}

// Older records have no sections, and name a setting by the end of its path.
Settings old_settings(const json::Value& settings) {
  std::map<std::string, std::string> path_by_name;
  const RenderSettings rows;
  for_each_setting(rows, [&](const std::string& path, const About&, const auto&, std::string_view) {
    path_by_name.emplace(path.substr(path.rfind('.') + 1), path);
  });

  Settings found;
  for (const std::string& name : settings.keys()) {
    const json::Value value = settings.at(name);
    const auto row = path_by_name.find(name);
    if (name == "size") {
      value.array_size(2, 2);
      found.emplace_back("output.width", value.element(0).dump());
      found.emplace_back("output.height", value.element(1).dump());
    } else if (name == "placed_lights") {
      found.emplace_back("lighting.placed_lights", lamps_of(value));
    } else {
      found.emplace_back(row == path_by_name.end() ? name : row->second, value.dump());
    }
  }
  return found;
}

Settings read_settings(const json::Value& root) {
  const json::Value settings = root.at("settings");
  if (!settings.object().has("quality")) return old_settings(settings);

  Settings found;
  flatten(settings, "", found);
  for (const char* name : {"lights", "gaussians"})
    if (root.has(name)) found.emplace_back(name, root.at(name).dump());
  return found;
}

}  // namespace

Recorded read_recorded(const std::string& path) {
  const json::Document document = json::load(path, largest_file, limits);
  const json::Value root = document.root();
  for (const char* key : {"commit", "device", "scene", "settings", "cells"})
    if (!root.is_object() || !root.has(key))
      root.fail("has no '{}': not a result of `dermis bench --json`", key);

  Recorded recorded{.file = path, .commit = {}, .device = {}, .scene = {}, .settings = {}, .cells = {}};
  recorded.commit = root.at("commit").text();
  recorded.device = root.at("device").text();
  recorded.scene = root.at("scene").text();
  recorded.settings = read_settings(root);

  const json::Value cells = root.at("cells");
  std::set<std::pair<int, double>> seen;
  for (std::size_t i = 0; i < cells.array_size(0); ++i) {
    recorded.cells.push_back(read_cell(cells.element(i)));
    if (!seen.emplace(recorded.cells.back().heads, recorded.cells.back().distance).second)
      cells.element(i).fail("is there twice");
  }
  return recorded;
}

}  // namespace dermis::cli::bench
