// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/settings/json.h"
#include "cli/bench/passes.h"
#include "cli/bench/technique_grid.h"
#include "tools/report/charts.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::cli::bench {
namespace {

std::string grid_ms(double ms) { return ms >= 100 ? fmt::format("{:.0f}", ms) : fmt::format("{:.3g}", ms); }

// The time of a column, with what it takes beyond a frame without scattering if there is one.
std::string column_text(const Cell& cell, const Measured& column) {
  const std::optional<double> over = cell.ms_over(column.variant.key, "lambert");
  if (!over || column.variant.key == "lambert") return grid_ms(column.ms());
  return fmt::format("{} ({}{})", grid_ms(column.ms()), *over < 0 ? "-" : "+", grid_ms(std::abs(*over)));
}

std::size_t column_width(const Variant& column) { return std::max<std::size_t>(14, column.heading.size()); }

std::string place_name(const Cell& cell, const RenderSettings& settings) {
  return fmt::format("{} head{} at {:g} radii, {:.1f} % skin", cell.heads, cell.heads == 1 ? "" : "s",
                     cell.distance, 100 * coverage_of(cell, settings));
}

/// The least number of views, up to 64, with which `ours` takes less time than `other` if what both compute
/// once is shared; 0: with none.
int views_to_win(const ViewCost& ours, const ViewCost& other) {
  for (int views = 1; views <= 64; ++views)
    if (ours.of(views) < other.of(views)) return views;
  return 0;
}

struct Duel {
  std::vector<std::string> won, lost;
  double least_won = std::numeric_limits<double>::infinity(), most_won = 0;  // coverage
  double least_lost = std::numeric_limits<double>::infinity(), most_lost = 0;
  std::vector<std::string> views;
};

const std::string& technique_of(const Measured& column) { return column.variant.settings.technique; }

/// Returns the fastest column of the technique that comes first.
const Measured& fastest_of_first(const Cell& cell) {
  const Measured* fastest = &cell.measured.front();
  for (const Measured& column : cell.measured)
    if (technique_of(column) == technique_of(cell.measured.front()) && column.ms() < fastest->ms())
      fastest = &column;
  return *fastest;
}

Duel fought(const Run& run, std::size_t other) {
  Duel duel;
  for (const Cell& cell : run.cells) {
    const Measured &ours = fastest_of_first(cell), &theirs = cell.measured[other];
    const double coverage = coverage_of(cell, run.settings);
    const bool wins = ours.ms() < theirs.ms();
    (wins ? duel.won : duel.lost).push_back(place_name(cell, run.settings));
    double &least = wins ? duel.least_won : duel.least_lost, &most = wins ? duel.most_won : duel.most_lost;
    least = std::min(least, coverage), most = std::max(most, coverage);

    const int views = views_to_win(view_cost(ours), view_cost(theirs));
    if (!wins && views > 0)
      duel.views.push_back(fmt::format("{} views of {}", views, place_name(cell, run.settings)));
  }
  return duel;
}

}  // namespace

double coverage_of(const Cell& cell, const RenderSettings& settings) {
  const double pixels = double{static_cast<double>(settings.output.width)} * settings.output.height;
  std::uint64_t most = 0;
  for (const Measured& m : cell.measured) most = std::max(most, m.counts.skin_pixels);
  return static_cast<double>(most) / pixels;
}

ViewCost view_cost(const Measured& measured) {
  const std::vector<double> groups = group_ms(measured.passes);
  // Shadow maps; irradiance, masks and convolutions of light maps. In the picture convolutions are per view.
  const std::size_t shared = measured.counts.irradiance_texels == 0 ? 1 : 4;
  ViewCost cost;
  for (std::size_t i = 0; i < groups.size(); ++i)
    (i < shared ? cost.shared_ms : cost.per_view_ms) += groups[i];
  return cost;
}

std::vector<std::string> crossovers(const Run& run) {
  std::vector<std::string> sentences;
  if (run.cells.empty()) return sentences;
  const std::vector<Measured>& columns = run.cells.front().measured;
  const std::string& first = technique_of(columns.front());
  for (std::size_t i = 1; i < columns.size(); ++i) {
    if (technique_of(columns[i]) == first) continue;
    const Duel duel = fought(run, i);
    std::string text = fmt::format("{} against {}: faster in {} of {} cells", first,
                                   columns[i].variant.heading, duel.won.size(), run.cells.size());
    if (!duel.won.empty()) text += fmt::format(" ({})", fmt::join(duel.won, "; "));
    if (!duel.won.empty() && !duel.lost.empty())
      text +=
          fmt::format(", at coverages of {:.1f} to {:.1f} %; slower at {:.1f} to {:.1f} %",
                      100 * duel.least_won, 100 * duel.most_won, 100 * duel.least_lost, 100 * duel.most_lost);
    if (!duel.views.empty())
      text +=
          fmt::format("; would be faster with {}, if views shared light maps", fmt::join(duel.views, "; "));
    sentences.push_back(text + ".");
  }
  return sentences;
}

std::string technique_grid_head(const Run& run, const std::vector<Variant>& columns) {
  const RenderSettings& s = run.settings;
  std::string text = fmt::format(
      "{}: {}x{} pixels, maps of {}, shadow maps of at most {}, {} samples\nframes in ms, medians of {} "
      "rounds in turns; in brackets what is beyond lambert\n\n",
      run.scene, s.output.width, s.output.height, s.quality.map_size, s.quality.shadow_size,
      s.quality.samples, run.rounds);
  text += fmt::format("{:>5} {:>8} {:>6} |", "heads", "distance", "skin");
  for (const Variant& column : columns) text += fmt::format(" {:>{}}", column.heading, column_width(column));
  return text + "\n";
}

std::string technique_grid_line(const Cell& cell, const RenderSettings& settings) {
  std::string text =
      fmt::format("{:>5} {:>8g} {:>5.1f}% |", cell.heads, cell.distance, 100 * coverage_of(cell, settings));
  for (const Measured& m : cell.measured)
    text += fmt::format(" {:>{}}", column_text(cell, m), column_width(m.variant));
  return text + "\n";
}

std::string technique_grid_foot(const Run& run) {
  std::string text = fmt::format("\n{} ({}, Vulkan {})\n", run.device, run.driver, run.api);
  for (const std::string& sentence : crossovers(run)) text += sentence + "\n";
  return text;
}

std::string technique_grid_json(const Run& run) {
  using nlohmann::ordered_json;
  ordered_json json{{"dermis", run.version},
                    {"commit", run.commit},
                    {"command", run.command},
                    {"device", run.device},
                    {"driver", run.driver},
                    {"api", run.api},
                    {"cores", run.cores},
                    {"timing", run.timing},
                    {"scene", run.scene},
                    {"settings", json_of(SettingsFile{run.settings, run.options, {}})},
                    {"lights", run.lights},
                    {"gaussians", run.gaussians},
                    {"rounds", run.rounds},
                    {"complete", run.complete},
                    {"crossovers", crossovers(run)},
                    {"cells", ordered_json::array()}};

  for (const Cell& cell : run.cells) {
    ordered_json found{
        {"heads", cell.heads}, {"distance", cell.distance}, {"coverage", coverage_of(cell, run.settings)}};
    for (const Measured& m : cell.measured) found[m.variant.key + "_ms"] = m.ms();
    for (const Measured& m : cell.measured) {
      ordered_json& variant = found["variants"][m.variant.key];
      variant = variant_object(m);
      const ViewCost views = view_cost(m);
      variant["light_reads"] = m.counts.light_reads;
      variant["shared_by_views_ms"] = views.shared_ms;
      variant["per_view_ms"] = views.per_view_ms;
      if (const auto over = cell.ms_over(m.variant.key, "lambert")) variant["minus_lambert_ms"] = *over;
    }
    json["cells"].push_back(std::move(found));
  }
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string technique_grid_page(const Run& run) {
  using namespace report;
  std::string body = table(
      {{"command", run.command},
       {"program", fmt::format("dermis {}, commit {}", run.version, run.commit)},
       {"device", fmt::format("{}, {}, Vulkan {}", run.device, run.driver, run.api)},
       {"picture", fmt::format("{} x {} pixels", run.settings.output.width, run.settings.output.height)}});

  std::vector<std::string> headings{"heads", "radii", "skin, %"};
  std::vector<std::vector<std::string>> rows;
  for (const Measured& m : run.cells.front().measured) headings.push_back(m.variant.heading);
  for (const Cell& cell : run.cells) {
    rows.push_back({std::to_string(cell.heads), fmt::format("{:g}", cell.distance),
                    fmt::format("{:.1f}", 100 * coverage_of(cell, run.settings))});
    for (const Measured& m : cell.measured) rows.back().push_back(column_text(cell, m));
  }
  body += "<h2>Frames, ms, in brackets what is beyond lambert</h2>\n" + grid(headings, rows) +
          "<div class=\"figures\">\n";

  const std::vector<double> distances = distances_of(run.cells);
  std::vector<Line> names;
  for (const int heads : heads_of(run.cells)) {
    LineChart chart{.title = fmt::format("{} head{}", heads, heads == 1 ? "" : "s"),
                    .x_name = "radii",
                    .x = {},
                    .lines = {},
                    .y_max = 0};
    for (const double distance : distances) chart.x.push_back(fmt::format("{:g}", distance));
    for (std::size_t i = 0; i < run.cells.front().measured.size(); ++i) {
      Line line{
          .name = run.cells.front().measured[i].variant.heading, .colour = i, .dashed = false, .values = {}};
      for (const double distance : distances) {
        const Cell* cell = find_cell(run.cells, heads, distance);
        line.values.push_back(cell ? std::optional(cell->measured[i].ms()) : std::nullopt);
        if (cell) chart.y_max = std::max(chart.y_max, cell->measured[i].ms());
      }
      chart.lines.push_back(std::move(line));
    }
    names = chart.lines;
    body += figure("ms over distance", line_chart(chart));
  }
  body += "</div>\n" + legend(names) + "<h2>Where they cross</h2>\n<ul>\n";
  for (const std::string& sentence : crossovers(run)) body += "<li>" + escape(sentence) + "</li>\n";
  return page(run.scene + ": techniques over heads and distances", body + "</ul>\n");
}

}  // namespace dermis::cli::bench
