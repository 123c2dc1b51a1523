// SPDX-License-Identifier: MIT
// A table as text, JSON and a page.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "cli/comparison/table.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::cli::comparison {
namespace {

using Cells = std::vector<std::string>;

/// Names of all rows of all cases, in the order in which they come.
Cells row_names(const std::vector<const Case*>& cases) {
  Cells names;
  for (const Case* one : cases)
    for (const ComparedTechnique& t : one->found.techniques)
      if (std::find(names.begin(), names.end(), t.name) == names.end()) names.push_back(t.name);
  return names;
}

const ComparedTechnique* find_row(const Case& one, const std::string& name) {
  for (const ComparedTechnique& t : one.found.techniques)
    if (t.name == name) return &t;
  return nullptr;
}

std::vector<const Case*> cases_of(const Table& table, bool tests) {
  std::vector<const Case*> cases;
  for (const Case& one : table.cases)
    if (one.is_test == tests) cases.push_back(&one);
  return cases;
}

/// One figure of each technique in each case.
struct Sheet {
  std::string_view title;
  std::string (*cell)(const ComparedTechnique& technique);
};

std::string ms_cell(const ComparedTechnique& t) { return fmt::format("{:.1f}", t.ms()); }

std::string taps_cell(const ComparedTechnique& t) {
  const Figures f = figures_of(t);
  return fmt::format("{} / {:.0f}", f.taps_per_pixel > 0 ? fmt::format("{:.0f}", f.taps_per_pixel) : "-",
                     f.device_mb);
}

std::string at_size_cell(const ComparedTechnique& t) { return fmt::format("{:.2g}", figures_of(t).rel_mse); }

std::string larger_cell(const ComparedTechnique& t) {
  const Figures f = figures_of(t);
  return fmt::format("{:.2g} / {:.4f}", f.larger, f.flip);
}

constexpr Sheet sheets[] = {{"frame, ms", ms_cell},
                            {"taps per pixel of skin / MB on the device", taps_cell},
                            {"relMSE over skin less noise, of the picture that took this time", at_size_cell},
                            {"the same of larger pictures, averaged down / FLIP", larger_cell}};

Cells sheet_head(const std::vector<const Case*>& cases) {
  Cells head{"technique"};
  for (const Case* one : cases) head.push_back(one->name);
  return head;
}

std::vector<Cells> sheet_rows(const Sheet& sheet, const std::vector<const Case*>& cases) {
  std::vector<Cells> rows;
  for (const std::string& name : row_names(cases)) {
    Cells row{name};
    for (const Case* one : cases) {
      const ComparedTechnique* technique = find_row(*one, name);
      row.push_back(technique ? sheet.cell(*technique) : "-");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string sheet_text(const Cells& head, const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(head.size());
  const auto widen = [&](const Cells& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  };
  widen(head);
  for (const Cells& row : rows) widen(row);

  const auto line = [&](const Cells& row) {
    std::string text = fmt::format("  {:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) text += fmt::format("  {:>{}}", row[i], widths[i]);
    return text + "\n";
  };
  std::string text = line(head);
  for (const Cells& row : rows) text += line(row);
  return text;
}

std::string anchor_of(std::size_t number) { return fmt::format("case-{}", number); }

std::string sheets_html(const Table& table) {
  std::string html;
  for (const bool tests : {false, true}) {
    const std::vector<const Case*> cases = cases_of(table, tests);
    if (cases.empty()) continue;
    html += tests ? "<h2>Test scenes</h2>\n" : "<h2>Sizes and distances</h2>\n";
    for (const Sheet& sheet : sheets)
      html += "<h3>" + report::escape(sheet.title) + "</h3>\n" +
              report::grid(sheet_head(cases), sheet_rows(sheet, cases));
  }
  return html;
}

}  // namespace

std::string table_text(const Table& table) {
  std::string text = fmt::format("{}: {} cases{}\n", table.scene, table.cases.size(),
                                 table.complete ? "" : ", stopped before the last");
  for (const bool tests : {false, true}) {
    const std::vector<const Case*> cases = cases_of(table, tests);
    if (cases.empty()) continue;
    for (const Sheet& sheet : sheets)
      text += fmt::format("\n{}\n", sheet.title) + sheet_text(sheet_head(cases), sheet_rows(sheet, cases));
  }

  text += "\n";
  for (const std::string& sentence : verdict(table)) text += sentence + "\n";
  return text;
}

std::string table_json(const Table& table) {
  using nlohmann::ordered_json;
  ordered_json json{{"scene", table.scene},
                    {"settings", json_of(table.settings)},
                    {"complete", table.complete},
                    {"verdict", verdict(table)},
                    {"cases", ordered_json::array()}};
  for (const Case& one : table.cases) {
    ordered_json found = scene_comparison_object(one.found);
    json["cases"].push_back({{"name", one.name}, {"shows", one.shows}, {"comparison", std::move(found)}});
  }
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string table_page(const Table& table) {
  using report::escape;
  std::string body = "<h2>Which is the right choice?</h2>\n<ul>\n";
  for (const std::string& sentence : verdict(table)) body += "<li>" + escape(sentence) + "</li>\n";
  body += "</ul>\n" + sheets_html(table) + "<h2>Cases</h2>\n<ul>\n";
  for (std::size_t i = 0; i < table.cases.size(); ++i)
    body += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", anchor_of(i), escape(table.cases[i].name));
  body += "</ul>\n";

  for (std::size_t i = 0; i < table.cases.size(); ++i) {
    const Case& one = table.cases[i];
    body += fmt::format("<h1 id=\"{}\">{}</h1>\n", anchor_of(i), escape(one.name));
    if (!one.shows.empty()) body += "<p>" + escape(one.shows) + "</p>\n";
    body += scene_comparison_body(one.found, anchor_of(i) + "-");
  }
  return report::page(table.scene + ": techniques against ground truth", body);
}

}  // namespace dermis::cli::comparison
