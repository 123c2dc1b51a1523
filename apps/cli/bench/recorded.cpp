// SPDX-License-Identifier: MIT
#include "cli/bench/recorded.h"

#include <set>

#include "json/document.h"

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
  const json::Value settings = root.at("settings");
  for (const std::string& name : settings.keys())
    recorded.settings.emplace_back(name, settings.at(name).dump());

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
