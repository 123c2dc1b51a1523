// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/core/error.h"
#include "cli/bench/recorded.h"

namespace dermis::cli::bench {
namespace {

void check_same(const Recorded& before, const Recorded& after) {
  const auto differ = [&](const std::string& what, const std::string& a, const std::string& b) {
    throw input_error(after.file, "{} is {}, in {} it is {}; only runs of the same test can be compared",
                      what, b, before.file, a);
  };
  if (before.scene != after.scene) differ("the scene", before.scene, after.scene);
  for (const auto& setting : after.settings) {
    const auto other = std::find_if(before.settings.begin(), before.settings.end(),
                                    [&](const auto& s) { return s.first == setting.first; });
    // An older program did not change settings that it did not know.
    if (other != before.settings.end() && other->second != setting.second)
      differ("setting '" + setting.first + "'", other->second, setting.second);
  }
}

// The pass that explains most of a change.
void find_pass(const RecordedTimes& before, const RecordedTimes& after, TimeChange& change) {
  const double sign = change.found.change == Change::slower ? 1 : -1;
  double most = 0;
  const auto old_ms = [&](const std::string& name) {
    const auto same = std::find_if(before.passes.begin(), before.passes.end(),
                                   [&](const PassStatistics& p) { return p.name == name; });
    return same == before.passes.end() ? 0 : same->ms;
  };
  for (const PassStatistics& pass : after.passes) {
    const double difference = pass.ms - old_ms(pass.name);
    if (sign * difference <= most) continue;
    most = sign * difference;
    change.pass = pass.name, change.pass_ms = difference;
  }
}

const RecordedTimes* find_times(const Recorded& run, int heads, double distance, const std::string& variant) {
  for (const RecordedCell& cell : run.cells)
    if (cell.heads == heads && cell.distance == distance)
      for (const RecordedTimes& times : cell.times)
        if (times.variant == variant) return &times;
  return nullptr;
}

std::size_t count(const Recorded& run) {
  std::size_t times = 0;
  for (const RecordedCell& cell : run.cells) times += cell.times.size();
  return times;
}

}  // namespace

RunComparison compare_runs(Recorded before, Recorded after) {
  check_same(before, after);
  RunComparison all{.before = std::move(before), .after = std::move(after), .changes = {}};

  for (const RecordedCell& cell : all.after.cells)
    for (const RecordedTimes& times : cell.times) {
      const RecordedTimes* old = find_times(all.before, cell.heads, cell.distance, times.variant);
      if (!old) continue;
      ++all.compared;
      all.by_chance += chance(old->rounds_ms.size(), times.rounds_ms.size());

      TimeChange change{.heads = cell.heads,
                        .distance = cell.distance,
                        .variant = times.variant,
                        .before_ms = spread_of(old->rounds_ms).median,
                        .after_ms = spread_of(times.rounds_ms).median,
                        .found = compare_times(old->rounds_ms, times.rounds_ms),
                        .pass = {}};
      if (change.found.change == Change::none) continue;
      ++(change.found.change == Change::slower ? all.slower : all.faster);
      find_pass(*old, times, change);
      all.changes.push_back(std::move(change));
    }

  if (all.compared == 0) throw input_error(all.after.file, "has no cell in common with {}", all.before.file);
  all.only_before = count(all.before) - all.compared;
  all.only_after = count(all.after) - all.compared;

  // Sort the slower before the faster, each from furthest beyond the spread.
  std::stable_sort(all.changes.begin(), all.changes.end(), [](const TimeChange& a, const TimeChange& b) {
    return std::pair(a.found.change == Change::faster, -a.found.beyond) <
           std::pair(b.found.change == Change::faster, -b.found.beyond);
  });
  return all;
}

std::string comparison_text(const RunComparison& all) {
  std::string text;
  for (const auto& [name, run] : {std::pair("old", &all.before), std::pair("new", &all.after)})
    text += fmt::format("{}: {}, commit {}, {}\n", name, run->file, run->commit, run->device);
  if (all.before.device != all.after.device)
    text += "the devices differ: this compares devices, not programs\n";

  if (!all.changes.empty())
    text += fmt::format("\n{:>5} {:>8}  {:<14} {:>10} {:>10} {:>9} {:>18}  {}\n", "heads", "distance", "what",
                        "old ms", "new ms", "change", "beyond the spread", "most of it");
  for (const TimeChange& c : all.changes) {
    const std::string pass = c.pass.empty() ? "" : fmt::format("{} {:+.3g} ms", c.pass, c.pass_ms);
    text += fmt::format("{:>5} {:>8g}  {:<14} {:>10.4g} {:>10.4g} {:>+8.1f}% {:>17.1f}%  {}\n", c.heads,
                        c.distance, c.variant, c.before_ms, c.after_ms, 100 * (c.found.ratio - 1),
                        100 * c.found.beyond, pass);
  }

  text += fmt::format("\n{} of {} times are slower, {} are faster: all new rounds beyond all old ones\n",
                      all.slower, all.compared, all.faster);
  text += fmt::format("if nothing had changed, about {:.1f} of each would come out so by chance\n",
                      all.by_chance);
  if (all.only_before + all.only_after > 0)
    text += fmt::format("not compared: {} times that only the old run has, {} that only the new one has\n",
                        all.only_before, all.only_after);
  return text;
}

std::string comparison_json(const RunComparison& all) {
  using nlohmann::ordered_json;
  ordered_json json;
  for (const auto& [name, run] : {std::pair("old", &all.before), std::pair("new", &all.after)})
    json[name] = {{"file", run->file}, {"commit", run->commit}, {"device", run->device}};

  json["compared"] = all.compared;
  json["by_chance"] = all.by_chance;

  json["slower"] = json["faster"] = ordered_json::array();
  for (const TimeChange& c : all.changes)
    json[c.found.change == Change::slower ? "slower" : "faster"].push_back({{"heads", c.heads},
                                                                            {"distance", c.distance},
                                                                            {"what", c.variant},
                                                                            {"old_ms", c.before_ms},
                                                                            {"new_ms", c.after_ms},
                                                                            {"ratio", c.found.ratio},
                                                                            {"beyond", c.found.beyond},
                                                                            {"pass", c.pass},
                                                                            {"pass_ms", c.pass_ms}});

  json["only_old"] = all.only_before;
  json["only_new"] = all.only_after;
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace dermis::cli::bench
