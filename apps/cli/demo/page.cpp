// SPDX-License-Identifier: MIT
#include "cli/demo/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/bench/passes.h"
#include "report/charts.h"
#include "report/escape.h"
#include "report/html.h"

namespace dermis::cli::demo {
namespace {

std::string caption(const char* what, const Shown& shown) {
  return fmt::format("{}<br><code>{}</code>", what, report::escape(shown.command));
}

std::string pictures(const Pair& pair, std::size_t number) {
  const std::string left = fmt::format("scattered-{}", number), right = fmt::format("lambert-{}", number);
  return "<h2>" + report::escape(pair.name) + "</h2>\n<div class=\"figures\">\n" +
         report::figure(caption("with light that scatters beneath the skin", pair.scattered),
                        report::picture(left, pair.scattered.pixels, "texture-space")) +
         report::figure(caption("without", pair.lambert),
                        report::picture(right, pair.lambert.pixels, "lambert")) +
         "</div>\n" + report::slider(left, right, "texture-space", "lambert");
}

std::vector<std::string> row(const PassStatistics& pass) {
  return {pass.name, bench::pass_groups()[bench::group_of(pass.name)], fmt::format("{:.2f}", pass.ms),
          fmt::format("{}", pass.calls)};
}

std::string times(const Page& page) {
  report::BarChart chart{.unit = "ms", .parts = bench::pass_groups(), .bars = {}};
  for (const Pair& pair : page.heads) {
    chart.bars.push_back({pair.name + ", texture-space", bench::group_ms(pair.scattered.cost.passes)});
    chart.bars.push_back({pair.name + ", lambert", bench::group_ms(pair.lambert.cost.passes)});
  }

  const Statistics& cost = page.heads.front().scattered.cost;
  std::vector<std::vector<std::string>> rows;
  for (const PassStatistics& pass : bench::merge_passes(cost.passes)) rows.push_back(row(pass));
  std::sort(rows.begin(), rows.end(),
            [](const auto& a, const auto& b) { return std::stod(a[2]) > std::stod(b[2]); });

  return "<h2>What a frame costs</h2>\n<p>" +
         report::escape(fmt::format("{}, {}; {} x {} pixels, light maps of {} texels; medians of {} frames.",
                                    cost.device, cost.driver, cost.width, cost.height, cost.map_size,
                                    cost.frames)) +
         "</p>\n" + report::legend(chart.parts) + report::bar_chart(chart) + "<h3>" +
         report::escape("Passes of " + page.heads.front().name) + "</h3>\n" +
         report::grid({"pass", "group", "ms", "calls"}, rows);
}

}  // namespace

std::string html(const Page& page) {
  std::string body;
  for (std::size_t i = 0; i < page.heads.size(); ++i) body += pictures(page.heads[i], i);
  if (!page.strip_command.empty())
    body +=
        "<h2>Six moments</h2>\n" + report::figure("<code>" + report::escape(page.strip_command) + "</code>",
                                                  report::picture("strip", page.strip, "six frames"));
  return report::page("dermis: skin in real time", body + times(page));
}

}  // namespace dermis::cli::demo
