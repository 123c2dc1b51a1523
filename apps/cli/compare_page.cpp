// SPDX-License-Identifier: MIT
#include "cli/compare_page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "image/compare_map.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::cli {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

Rows rows(const Compared& c) {
  const image::FlipSummary& flip = c.found.flip;
  const char* name = c.found.exposures == 0 ? "FLIP" : "HDR-FLIP";
  Rows rows;
  const auto add = [&](const char* what, double value) {
    rows.emplace_back(fmt::format("{}, {}", name, what), fmt::format("{:.6f}", value));
  };

  add("mean", flip.mean);
  add("weighted median", flip.weighted_median);
  add("first weighted quartile", flip.q1);
  add("third weighted quartile", flip.q3);
  add("least", flip.min);
  add("greatest", flip.max);

  if (c.found.exposures != 0)
    rows.emplace_back("exposures", fmt::format("{} from {:.4f} to {:.4f} EV", c.found.exposures,
                                               c.found.start_exposure, c.found.stop_exposure));
  rows.emplace_back(c.tone_map.empty() ? "PSNR" : fmt::format("PSNR (tone map {})", c.tone_map),
                    fmt::format("{:.2f} dB", c.found.psnr_db));
  rows.emplace_back("relative MSE", fmt::format("{:.6g}", c.found.rel_mse));

  if (c.found.z) {
    rows.emplace_back("beyond 2 standard errors",
                      fmt::format("{:.3f} % (noise alone: 4.550 %)", 100 * c.found.z->beyond_2));
    rows.emplace_back("beyond 3 standard errors",
                      fmt::format("{:.3f} % (noise alone: 0.270 %)", 100 * c.found.z->beyond_3));
  }
  return rows;
}

std::string extent(const Compared& c) {
  const std::uint64_t all =
      static_cast<std::uint64_t>(c.shown_a.width) * static_cast<std::uint64_t>(c.shown_a.height);
  const std::string which = c.region.empty()
                                ? "all compared"
                                : fmt::format("{} of {} compared ({})", c.found.pixels, all, c.region_name);
  return fmt::format("{} x {} pixels, {}", c.shown_a.width, c.shown_a.height, which);
}

}  // namespace

std::string compared_text(const Compared& c) {
  std::string text = fmt::format("A, the reference: {}\nB: {}\n{}\n", c.a, c.b, extent(c));
  for (const auto& [name, value] : rows(c)) text += fmt::format("  {:<34} {}\n", name, value);
  return text;
}

std::string compared_json(const Compared& c) {
  using nlohmann::ordered_json;
  const image::FlipSummary& flip = c.found.flip;
  ordered_json json{
      {"a", c.a}, {"b", c.b}, {"size", {c.shown_a.width, c.shown_a.height}}, {"pixels", c.found.pixels}};
  json["region"] = c.region_name.empty() ? ordered_json(nullptr) : ordered_json(c.region_name);

  json["flip"] = {{"mean", flip.mean}, {"weighted_median", flip.weighted_median},
                  {"q1", flip.q1},     {"q3", flip.q3},
                  {"min", flip.min},   {"max", flip.max}};
  if (c.found.exposures != 0)
    json["exposures"] = {
        {"start", c.found.start_exposure}, {"stop", c.found.stop_exposure}, {"count", c.found.exposures}};

  if (!c.tone_map.empty()) json["tone_map"] = c.tone_map;
  json["psnr_db"] = c.found.psnr_db;
  json["rel_mse"] = c.found.rel_mse;
  if (c.found.z)
    json["z"] = {
        {"beyond_2", c.found.z->beyond_2}, {"beyond_3", c.found.z->beyond_3}, {"values", c.found.z->values}};

  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string compared_page(const Compared& c) {
  using namespace report;
  std::string body = "<p>" + escape(extent(c)) + "</p>\n" + table(rows(c));
  body += "<h2>Side by side</h2>\n<div class=\"figures\">\n" +
          figure("A, the reference: " + escape(c.a), picture("a", c.shown_a, "A")) +
          figure("B: " + escape(c.b), picture("b", c.shown_b, "B")) + "</div>\n";
  body += "<h2>One over the other</h2>\n" + slider("a", "b", "A", "B");

  const std::string name = c.found.exposures == 0 ? "FLIP" : "HDR-FLIP",
                    outside = c.region.empty() ? "" : "; grey: outside of the region";
  const auto map = [&](const char* id, double full_scale, const std::string& caption) {
    const image::Image8 colours =
        image::error_colours(c.found.flip_map, static_cast<float>(full_scale), c.region);
    return figure(escape(caption + outside), picture(id, colours, caption) + magma_scale(full_scale));
  };

  body += "<h2>Error</h2>\n<div class=\"figures\">\n" + map("error", 1, name + ", on the whole scale");
  // Errors of good pictures are dark on the whole scale.
  if (c.found.flip.max > 0)
    body += map("error-stretched", c.found.flip.max, name + ", up to its greatest value");
  return page(fmt::format("{} and {}", c.a, c.b), body + "</div>\n");
}

}  // namespace dermis::cli
