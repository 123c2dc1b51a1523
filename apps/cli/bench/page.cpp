// SPDX-License-Identifier: MIT
#include "cli/bench/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "cli/bench/paper.h"
#include "cli/bench/passes.h"
#include "tools/report/charts.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"
#include "tools/report/svg.h"

namespace dermis::cli::bench {
namespace {

using Row = std::vector<std::string>;

std::string time_text(double ms) { return ms >= 100 ? fmt::format("{:.0f}", ms) : fmt::format("{:.3g}", ms); }

std::string ms_text(const Measured& m) {
  const Spread s = m.spread();
  return fmt::format("{} \u00b1{}", time_text(s.median), time_text((s.max - s.min) / 2));
}

std::string ratio_text(std::optional<double> ratio) { return ratio ? fmt::format("{:.2f}", *ratio) : "-"; }

std::string place_text(const Cell& cell) {
  return fmt::format("{} head{} at {:g} radii", cell.heads, cell.heads == 1 ? "" : "s", cell.distance);
}

std::string facts(const Run& run) {
  const RenderSettings& s = run.settings;
  std::vector<std::pair<std::string, std::string>> rows{
      {"command", run.command},
      {"program", fmt::format("dermis {}, commit {}", run.version, run.commit)},
      {"device",
       fmt::format("{}, {}, Vulkan {}, {} processor cores", run.device, run.driver, run.api, run.cores)},
      {"scene", run.scene},
      {"picture", fmt::format("{} x {} pixels, {} samples per pixel", s.output.width, s.output.height,
                              s.quality.samples)},
      {"maps", fmt::format("light {0} x {0}, shadows at most {1} x {1} texels; {2} lights, {3} Gaussians",
                           s.quality.map_size, s.quality.shadow_size, run.lights, run.gaussians)},
      {"times", fmt::format("medians of {} rounds \u00b1 half of the way from the least to the greatest; a "
                            "round draws every column once; {}",
                            run.rounds,
                            run.timing == "submit" ? "each pass is its own submission, timed on the host"
                                                   : "time stamps of the device")},
  };

  if (!run.complete) rows.emplace_back("stopped", "not all cells were measured");
  return report::table(rows);
}

std::string paper_section(const Run& run) {
  Row headings{"heads"};
  const std::vector<double> distances = distances_of(run.cells);
  for (const double distance : distances) headings.push_back(fmt::format("at {:g} radii", distance));

  std::vector<Row> rows;
  for (const int heads : heads_of(run.cells)) {
    Row row{std::to_string(heads)};
    for (const double distance : distances) {
      const Cell* cell = find_cell(run.cells, heads, distance);
      row.push_back(fmt::format("{} | {} | {}", cell ? ratio_text(cell->speedup()) : "-",
                                cell ? ratio_text(cell->speedup_over_skipping()) : "-",
                                ratio_text(paper_speedup(heads, distance))));
    }
    rows.push_back(std::move(row));
  }

  return "<h2>Speed-up of the three optimisations together</h2>\n<p>Over the baseline | over the baseline "
         "that skips heads outside the picture | the paper's. (Jimenez and Gutierrez 2008, table 1: GeForce "
         "8800 GTX, 1920 x 1200 pixels, maps of 2048 texels.)</p>\n" +
         report::grid(headings, rows);
}

// Ours over both baselines, and the paper's, along one side of the table.
template <class X>
report::LineChart chart(const std::string& title, const std::string& x_name, const std::vector<X>& xs,
                        const std::function<std::pair<int, double>(X)>& place, const Run& run) {
  report::LineChart chart{.title = title, .x_name = x_name, .x = {}, .lines = {}};
  report::Line baseline{"over the baseline", 0, false, {}},
      skipping{"over the baseline that skips heads outside", 2, false, {}},
      paper{"the paper, over its baseline", 1, true, {}};
  for (const X x : xs) {
    const auto [heads, distance] = place(x);
    const Cell* cell = find_cell(run.cells, heads, distance);
    chart.x.push_back(fmt::format("{:g}", static_cast<double>(x)));
    baseline.values.push_back(cell ? std::optional(cell->speedup()) : std::nullopt);
    skipping.values.push_back(cell ? std::optional(cell->speedup_over_skipping()) : std::nullopt);
    paper.values.push_back(paper_speedup(heads, distance));
  }
  chart.lines = {baseline, skipping, paper};
  return chart;
}

std::string charts_section(const Run& run) {
  const std::vector<int> heads = heads_of(run.cells);
  const std::vector<double> distances = distances_of(run.cells);
  std::vector<report::LineChart> against_heads, against_distance;
  for (const double distance : distances)
    against_heads.push_back(chart<int>(
        fmt::format("at {:g} radii", distance), "heads", heads, [&](int h) { return std::pair(h, distance); },
        run));
  for (const int h : heads)
    against_distance.push_back(chart<double>(
        fmt::format("{} head{}", h, h == 1 ? "" : "s"), "distance, radii", distances,
        [&](double d) { return std::pair(h, d); }, run));

  // Give all charts one scale; those against distance hold the same values.
  double most = 1;
  for (const report::LineChart& c : against_heads)
    for (const report::Line& line : c.lines)
      for (const std::optional<double>& value : line.values)
        if (value && std::isfinite(*value)) most = std::max(most, *value);
  const double step = report::tick_step(most, 6), y_max = std::ceil(most / step) * step;

  const auto together = [&](std::vector<report::LineChart>& charts) {
    std::string text = "<div class=\"figures\">\n";
    for (report::LineChart& c : charts) {
      c.y_max = y_max;
      text += report::line_chart(c);
    }
    return text + "</div>\n";
  };

  return "<h2>Speed-up against heads and distance</h2>\n" + report::legend(against_heads.front().lines) +
         together(against_heads) + together(against_distance);
}

std::string frames_section(const Run& run) {
  Row headings{"heads, distance"};
  std::vector<Row> rows;
  std::vector<std::pair<std::string, std::string>> meanings;
  for (const Measured& m : run.cells.front().measured) {
    headings.push_back(m.variant.heading);
    meanings.emplace_back(m.variant.heading, m.variant.meaning);
  }
  meanings.emplace_back("PSNR, FLIP", difference_meaning(run));
  for (const char* heading : {"PSNR", "FLIP"}) headings.emplace_back(heading);
  for (const Cell& cell : run.cells) {
    Row row{fmt::format("{}, {:g}", cell.heads, cell.distance)};
    for (const Measured& m : cell.measured) row.push_back(ms_text(m));
    const PictureDifference* d = cell.difference(optimised_key);
    row.push_back(d ? fmt::format("{:.2f} dB", d->psnr_db) : "-");
    row.push_back(d ? fmt::format("{:.4f}", d->flip_mean) : "-");
    rows.push_back(std::move(row));
  }
  return "<h2>Frames, ms</h2>\n" + report::table(meanings) + report::grid(headings, rows);
}

std::string texels_table(const Cell& cell) {
  std::vector<Row> rows;
  for (const Measured& m : cell.measured) {
    if (m.variant.settings.technique == "lambert") continue;
    Row row{m.variant.heading};
    const Statistics& c = m.counts;
    for (const std::uint64_t count : {c.irradiance_texels, c.convolved_texels, c.launched, c.unshaded_reads})
      row.push_back(std::to_string(count));
    std::string sizes;
    for (const int size : c.used_size)
      sizes += (sizes.empty() ? "" : " ") + (size ? std::to_string(size) : std::string("-"));
    row.push_back(sizes);
    rows.push_back(std::move(row));
  }
  return report::grid({"texels", "lit", "convolved", "launched", "read unlit", "map of each head"}, rows);
}

std::string bars(const Cell& cell, const std::vector<std::size_t>& groups) {
  report::BarChart chart{.unit = "ms", .parts = {}, .bars = {}};
  for (const std::size_t group : groups) chart.parts.push_back(pass_groups()[group]);
  for (const Measured& m : cell.measured) {
    report::Bar bar{m.variant.heading, {}};
    const std::vector<double> all = group_ms(m.passes);
    for (const std::size_t group : groups) bar.parts.push_back(all[group]);
    chart.bars.push_back(std::move(bar));
  }
  return report::bar_chart(chart);
}

// A group that no frame spends time on needs no colour.
std::vector<std::size_t> groups_of(const Run& run) {
  std::vector<double> sums(pass_groups().size());
  for (const Cell& cell : run.cells)
    for (const Measured& m : cell.measured) {
      const std::vector<double> all = group_ms(m.passes);
      for (std::size_t group = 0; group < sums.size(); ++group) sums[group] += all[group];
    }
  std::vector<std::size_t> groups;
  for (std::size_t group = 0; group < sums.size(); ++group)
    if (sums[group] > 0) groups.push_back(group);
  return groups;
}

std::string cells_section(const Run& run) {
  const std::vector<std::size_t> groups = groups_of(run);
  std::vector<std::string> names;
  for (const std::size_t group : groups) names.push_back(pass_groups()[group]);

  std::string text = "<h2>Every cell</h2>\n" + report::legend(names);
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    const Cell& cell = run.cells[i];
    text += "<h3>" + report::escape(place_text(cell)) +
            fmt::format(": speed-up {}, {} over skipping", ratio_text(cell.speedup()),
                        ratio_text(cell.speedup_over_skipping()));
    if (const PictureDifference* d = cell.difference(optimised_key))
      text += fmt::format("; pictures {:.2f} dB, FLIP {:.4f} apart over {} pixels", d->psnr_db, d->flip_mean,
                          d->pixels);
    text += "</h3>\n";

    if (i < run.pictures.size()) {
      const std::string left = fmt::format("baseline-{}", i), right = fmt::format("all-{}", i);
      text += "<div hidden>" + report::picture(left, run.pictures[i].baseline, "baseline") +
              report::picture(right, run.pictures[i].optimised, "all") + "</div>\n" +
              report::slider(left, right, "baseline", "all");
    }

    text += "<div>" + bars(cell, groups) + "</div>\n" + texels_table(cell);
  }
  return text;
}

std::string maps_section(const Run& run) {
  if (!run.maps) return "";
  const MapPictures& maps = *run.maps;
  const std::string whose = maps.heads == 1 ? "the head" : fmt::format("the nearest of {} heads", maps.heads);
  return fmt::format("<h2>What is lit of {} at {:g} radii</h2>\n<div class=\"figures\">\n", whose,
                     maps.distance) +
         report::figure("The light map of the baseline",
                        report::picture("map-irradiance", maps.irradiance, "light map")) +
         report::figure(
             "The same with all optimisations: culled blue, clipped red, both purple, lit green",
             report::picture("map-visibility", maps.visibility, "culled, clipped and lit texels")) +
         report::figure("The picture", report::picture("map-picture", maps.picture, "picture")) + "</div>\n";
}

}  // namespace

std::string run_page(const Run& run) {
  return report::page("dermis bench: " + run.scene, facts(run) + paper_section(run) + charts_section(run) +
                                                        frames_section(run) + maps_section(run) +
                                                        cells_section(run));
}

}  // namespace dermis::cli::bench
