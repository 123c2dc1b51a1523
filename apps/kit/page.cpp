// SPDX-License-Identifier: MIT
#include "kit/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "image/codec.h"
#include "tools/report/charts.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::kit {
namespace {

using Row = std::vector<std::string>;
using Rows = std::vector<Row>;

std::string text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  return value.is_null() ? "-" : value.dump();
}

/// Returns the member, or null where there is none.
const Json& at(const Json& object, const char* key) {
  static const Json none;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() ? *found : none;
}

std::string megabytes(const Json& bytes) {
  return bytes.is_number() ? fmt::format("{:.1f}", 1e-6 * bytes.get<double>()) : "-";
}

std::string section(const std::string& title, const std::string& body) {
  return fmt::format("<h2>{}</h2>\n{}", report::escape(title), body);
}

std::string facts(const Json& r) {
  const Json& machine = at(r, "machine");
  return report::table(
      {{"device", fmt::format("{} ({}), {:.1f} GiB", text(at(r, "device")), text(at(r, "type")),
                              at(r, "device_memory_bytes").get<double>() / (std::uint64_t{1} << 30))},
       {"driver", fmt::format("{}, Vulkan {}", text(at(r, "driver")), text(at(r, "api")))},
       {"machine",
        fmt::format("{}, {} cores, {}, C library {}", text(at(machine, "processor")),
                    text(at(machine, "cores")), text(at(machine, "system")), text(at(machine, "c_library")))},
       {"program", fmt::format("dermis {}, commit {}", text(at(r, "dermis")), text(at(r, "commit")))},
       {"command", fmt::format("{} ({})", text(at(r, "command")), text(at(r, "extent")))},
       {"validation layer", at(r, "validated") == true ? "on" : "not there"},
       {"complete", at(r, "complete") == true ? "yes" : "no: it was stopped"},
       {"took", fmt::format("{:.0f} s", at(r, "seconds").get<double>())}});
}

std::string verdict(const Json& r) {
  const Json& failed = at(r, "failed");
  if (failed.empty()) return "<p>Everything that was tried holds.</p>\n";
  std::string list;
  for (const Json& one : failed) list += fmt::format("<li>{}</li>\n", report::escape(text(one)));
  return section(fmt::format("{} did not hold", failed.size()), fmt::format("<ul>\n{}</ul>\n", list));
}

std::string invariants(const Json& all) {
  Rows rows;
  for (const Json& one : all)
    rows.push_back({text(at(one, "name")), text(at(one, "result")), text(at(one, "passed")),
                    text(at(one, "skipped")), text(at(one, "cases")), text(at(one, "seconds"))});
  return report::grid({"invariant", "result", "passed", "skipped", "cases", "seconds"}, rows);
}

std::string switches(const Json& all) {
  struct Count {
    int drawn = 0, not_offered = 0, failed = 0;
  };
  std::map<std::string, Count> counts;
  for (const Json& one : all) {
    Count& count = counts[fmt::format("{}, {}", text(at(one, "scene")), text(at(one, "technique")))];
    if (at(one, "offered") == false)
      ++count.not_offered;
    else
      ++(at(one, "ok") == true ? count.drawn : count.failed);
  }
  Rows rows;
  for (const auto& [name, count] : counts)
    rows.push_back({name, fmt::format("{}", count.drawn), fmt::format("{}", count.not_offered),
                    fmt::format("{}", count.failed)});
  return "<p>Every setting away from its default, one at a time, each a process of its own.</p>\n" +
         report::grid({"head, technique", "drawn", "not offered", "failed"}, rows);
}

std::string equality(const Json& all) {
  Rows rows;
  for (const Json& one : all)
    rows.push_back({text(at(one, "scene")), text(at(one, "technique")),
                    at(one, "equal") == true ? "equal to the bit" : "DIFFER",
                    at(one, "counts_equal") == true ? "equal" : "DIFFER"});
  return report::grid({"head", "technique", "two pictures", "counts"}, rows);
}

std::string frame_name(const Json& one) {
  const Json& statistics = at(one, "statistics");
  return fmt::format("{}{}", text(at(statistics, "technique")),
                     at(statistics, "optimise").empty() && at(statistics, "technique") == "texture-space"
                         ? ", not optimised"
                         : "");
}

std::string frames(const Json& all) {
  Rows rows;
  report::BarChart chart{.unit = "ms", .parts = {}, .bars = {}};
  std::vector<std::string>& parts = chart.parts;
  const auto part_of = [&](const std::string& name) {
    const auto found = std::ranges::find(parts, name);
    if (found != parts.end()) return static_cast<std::size_t>(found - parts.begin());
    parts.push_back(name);
    return parts.size() - 1;
  };
  // Passes of one kind ("blur 3 u") are one part.
  const auto kind = [](const std::string& name) { return name.substr(0, name.find(' ')); };
  for (const Json& one : all)
    for (const Json& pass : at(at(one, "statistics"), "passes")) part_of(kind(text(at(pass, "name"))));

  for (const Json& one : all) {
    const Json& s = at(one, "statistics");
    if (!s.is_object()) continue;
    const Json& ms = at(s, "frame_ms");
    rows.push_back({frame_name(one), text(at(ms, "median")), text(at(ms, "min")), text(at(ms, "max")),
                    text(at(s, "load_ms")), text(at(s, "upload_ms")), text(at(s, "pipeline_ms")),
                    megabytes(at(at(s, "memory_bytes"), "peak"))});
    report::Bar bar{frame_name(one), std::vector<double>(parts.size())};
    for (const Json& pass : at(s, "passes"))
      bar.parts[part_of(kind(text(at(pass, "name"))))] += at(pass, "ms").get<double>();
    chart.bars.push_back(std::move(bar));
  }
  return report::grid({"technique", "frame ms", "least", "greatest", "load ms", "upload ms", "pipelines ms",
                       "device MB"},
                      rows) +
         (chart.bars.empty() ? "" : report::bar_chart(chart) + report::legend(parts));
}

std::string bench(const Json& part) {
  const Json& run = at(part, "run");
  constexpr std::pair<const char*, const char*> columns[] = {{"baseline_ms", "baseline"},
                                                             {"skip_ms", "skipping"},
                                                             {"cull_ms", "cull"},
                                                             {"depth_ms", "depth"},
                                                             {"clip_ms", "clip"},
                                                             {"all_ms", "all"},
                                                             {"all_margin_0_ms", "margin 0"},
                                                             {"lambert_ms", "lambert"},
                                                             {"speedup", "speed-up"},
                                                             {"speedup_over_skip", "over skipping"},
                                                             {"paper_speedup", "the paper's"},
                                                             {"psnr_db", "PSNR dB"},
                                                             {"flip_mean", "FLIP"}};
  Row headings{"heads", "radii"};
  for (const auto& [key, name] : columns) headings.emplace_back(name);
  Rows rows;
  for (const Json& cell : at(run, "cells")) {
    Row row{text(at(cell, "heads")), text(at(cell, "distance"))};
    for (const auto& [key, name] : columns) row.push_back(text(at(cell, key)));
    rows.push_back(std::move(row));
  }
  return fmt::format("<p>Milliseconds, medians of {} rounds: <code>{}</code></p>\n",
                     report::escape(text(at(run, "rounds"))), report::escape(text(at(part, "command")))) +
         report::grid(headings, rows);
}

std::string sessions(const Json& part) {
  Rows rows;
  for (const Json& run : at(part, "runs"))
    rows.push_back({text(at(run, "instances")), text(at(run, "host_ms")), text(at(run, "frame_ms")),
                    at(run, "steady") == true ? "yes" : "NO"});
  return report::grid({"instances", "host ms per frame", "frame ms", "steady"}, rows);
}

std::string many(const Json& all) {
  Rows rows;
  for (const Json& one : all) {
    const Json& s = at(one, "statistics");
    const Json& passes = at(s, "passes").is_array() ? Json(at(s, "passes").size()) : at(one, "passes");
    rows.push_back({text(at(one, "heads")), text(at(one, "assets")), text(at(one, "map_size")),
                    text(at(at(s, "frame_ms"), "median")), text(passes),
                    megabytes(at(at(s, "memory_bytes"), "images")),
                    megabytes(at(at(s, "memory_bytes"), "buffers")),
                    megabytes(at(at(s, "memory_bytes"), "peak")), text(at(one, "process_peak_mb"))});
  }
  return report::grid({"heads", "assets", "maps", "frame ms", "passes", "images MB", "buffers MB",
                       "device peak MB", "process peak MB"},
                      rows);
}

std::string pictures(const std::vector<Measurement::Shot>& shots) {
  std::string all;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    try {
      const image::Image8 pixels = image::load_image8(shots[i].file);
      all += report::figure(report::escape(shots[i].what),
                            report::picture(fmt::format("shot{}", i), pixels, shots[i].what));
    } catch (const std::exception&) { continue; }
  }
  return all;
}

}  // namespace

std::string page(const Json& record, const std::vector<Measurement::Shot>& shots) {
  struct Part {
    const char *key, *title;
    std::string (*body)(const Json&);
  };
  constexpr Part shown[] = {{"invariants", "Invariants", invariants},
                            {"switches", "Switches", switches},
                            {"equality", "Two runs", equality},
                            {"frame", "One frame", frames},
                            {"bench", "The paper's test", bench},
                            {"sessions", "Sessions", sessions},
                            {"crowd", "Many heads", many},
                            {"memory", "Memory", many}};

  std::string body = facts(record) + verdict(record);
  for (const Part& part : shown)
    if (const Json& found = at(record, part.key); !found.is_null())
      body += section(part.title, part.body(found));
  if (const std::string seen = pictures(shots); !seen.empty()) body += section("Pictures", seen);
  return report::page("dermis on " + text(at(record, "device")), body);
}

}  // namespace dermis::kit
