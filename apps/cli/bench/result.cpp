// SPDX-License-Identifier: MIT
#include "cli/bench/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "base/core/assert.h"
#include "base/settings/json.h"
#include "base/settings/names.h"
#include "cli/bench/paper.h"

namespace dermis::cli::bench {
namespace {

using nlohmann::ordered_json;

template <class T>
ordered_json or_null(const std::optional<T>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json texels_json(const Statistics& s) {
  return {{"irradiance", s.irradiance_texels},
          {"convolved", s.convolved_texels},
          {"launched", s.launched},
          {"unshaded_reads", s.unshaded_reads},
          {"used_size", s.used_size},
          {"mapped_terms", s.mapped_terms}};
}

ordered_json cell_json(const Cell& cell) {
  ordered_json json{{"heads", cell.heads}, {"distance", cell.distance}};
  for (const Measured& m : cell.measured) json[m.variant.key + "_ms"] = m.ms();

  json["speedup"] = cell.speedup();
  json["speedup_over_skip"] = cell.speedup_over_skipping();
  json["speedup_margin_0"] =
      cell.of(baseline_key).ms() / cell.of(cell.has(at_edge_key) ? at_edge_key : optimised_key).ms();
  for (const char* key : {compute_key, still_key}) {
    json[fmt::format("speedup_{}", key)] = or_null(cell.speedup_of(key, baseline_key));
    json[fmt::format("{}_over_all", key)] = or_null(cell.speedup_of(key, optimised_key));
    json[fmt::format("{}_over_lambert", key)] = or_null(cell.speedup_of(key, floor_key));
    json[fmt::format("{}_minus_lambert_ms", key)] = or_null(cell.ms_over(key, floor_key));
  }
  json["paper_speedup"] = or_null(paper_speedup(cell.heads, cell.distance));

  const PictureDifference* d = cell.difference(optimised_key);
  json["psnr_db"] = d ? ordered_json(d->psnr_db) : ordered_json(nullptr);
  json["flip_mean"] = d ? ordered_json(d->flip_mean) : ordered_json(nullptr);
  json["compared_pixels"] = d ? d->pixels : 0;
  json["picture_samples"] = d ? d->samples : 0;
  for (const auto& [key, of] : cell.differences)
    json["pictures"][key] = {{"psnr_db", of.psnr_db}, {"flip_mean", of.flip_mean}};

  for (const Measured& m : cell.measured)
    if (m.variant.settings.technique != "lambert") json["texels"][m.variant.key] = texels_json(m.counts);
  for (const Measured& m : cell.measured) json["variants"][m.variant.key] = variant_object(m);
  return json;
}

}  // namespace

nlohmann::ordered_json variant_object(const Measured& m) {
  const Spread spread = m.spread();
  ordered_json passes = ordered_json::array();
  for (const PassStatistics& pass : m.passes)
    passes.push_back({{"name", pass.name},
                      {"ms", pass.ms},
                      {"calls", pass.calls},
                      {"texels", pass.texels},
                      {"image_bytes", pass.image_bytes}});
  return {{"meaning", m.variant.meaning},
          {"technique", m.counts.technique},
          {"optimise", m.counts.optimise},
          {"mask", m.counts.mask.empty() ? ordered_json(nullptr) : ordered_json(m.counts.mask)},
          {"skip_unseen_heads", or_null(m.variant.settings.quality.skip_unseen_heads)},
          {"ms", {{"median", spread.median}, {"min", spread.min}, {"max", spread.max}}},
          {"rounds_ms", m.rounds_ms},
          {"passes", passes}};
}

bool Cell::has(const std::string& key) const {
  return std::any_of(measured.begin(), measured.end(),
                     [&](const Measured& m) { return m.variant.key == key; });
}

const Measured& Cell::of(const std::string& key) const {
  const auto found =
      std::find_if(measured.begin(), measured.end(), [&](const Measured& m) { return m.variant.key == key; });
  DERMIS_ASSERT(found != measured.end());
  return *found;
}

std::optional<double> Cell::speedup_of(const std::string& key, const std::string& over) const {
  if (!has(key)) return std::nullopt;
  return of(over).ms() / of(key).ms();
}

std::optional<double> Cell::ms_over(const std::string& key, const std::string& floor) const {
  if (!has(key) || !has(floor)) return std::nullopt;
  return of(key).ms() - of(floor).ms();
}

const PictureDifference* Cell::difference(const std::string& key) const {
  const auto found = differences.find(key);
  return found == differences.end() ? nullptr : &found->second;
}

std::string run_json(const Run& run) {
  ordered_json json{
      {"dermis", run.version},  {"commit", run.commit},
      {"command", run.command}, {"device", run.device},
      {"driver", run.driver},   {"api", run.api},
      {"cores", run.cores},     {"timing", run.timing},
      {"scene", run.scene},     {"settings", json_of(SettingsFile{run.settings, run.options, {}})},
      {"lights", run.lights},   {"gaussians", run.gaussians},
      {"rounds", run.rounds},   {"complete", run.complete}};
  json["cells"] = ordered_json::array();
  for (const Cell& cell : run.cells) json["cells"].push_back(cell_json(cell));
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string difference_meaning(const Run& run) {
  return fmt::format("all against the baseline, of display values (tone map {})",
                     name_of(run.settings.output.tone_map));
}

std::vector<int> heads_of(const std::vector<Cell>& cells) {
  std::set<int> found;
  for (const Cell& cell : cells) found.insert(cell.heads);
  return {found.begin(), found.end()};
}

std::vector<double> distances_of(const std::vector<Cell>& cells) {
  std::set<double> found;
  for (const Cell& cell : cells) found.insert(cell.distance);
  return {found.begin(), found.end()};
}

const Cell* find_cell(const std::vector<Cell>& cells, int heads, double distance) {
  const auto found = std::find_if(cells.begin(), cells.end(), [&](const Cell& cell) {
    return cell.heads == heads && cell.distance == distance;
  });
  return found == cells.end() ? nullptr : &*found;
}

}  // namespace dermis::cli::bench
