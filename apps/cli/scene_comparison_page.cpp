// SPDX-License-Identifier: MIT
// What `dermis compare --scene` found, as text, JSON and a page.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "cli/scene_comparison.h"
#include "image/compare_flip.h"
#include "image/compare_map.h"
#include "report/escape.h"
#include "report/html.h"

namespace dermis::cli {
namespace {

using Errors = std::vector<std::optional<RegionError>>;
using Row = std::vector<std::string>;

const Row error_headings{"FLIP", "HDR-FLIP", "PSNR dB", "relMSE", "less noise"};

Row error_cells(const std::optional<RegionError>& e) {
  if (!e) return Row(error_headings.size(), "-");
  return {fmt::format("{:.4f}", e->flip), fmt::format("{:.4f}", e->hdr_flip),
          fmt::format("{:.2f}", e->psnr_db), fmt::format("{:.3g}", e->rel_mse),
          e->rel_mse_unbiased ? fmt::format("{:.3g}", *e->rel_mse_unbiased) : "-"};
}

Row joined(Row a, const Row& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Row headings(std::size_t region) {
  return region == 0 ? joined({"technique", "frame ms"}, error_headings)
                     : joined({"technique", "of all error"}, error_headings);
}

/// Over skin with the cost, over other regions with their share of the error.
std::vector<Row> rows(const SceneComparison& c, std::size_t region) {
  std::vector<Row> out;
  for (const ComparedTechnique& t : c.techniques) {
    const auto& e = t.errors[region];
    const std::string second = region == 0 ? fmt::format("{:.1f}", t.statistics.frame_ms_median)
                               : e         ? fmt::format("{:.0f} %", 100 * e->share)
                                           : "-";
    out.push_back(joined({t.name, second}, error_cells(e)));
  }
  if (c.noise) out.push_back(joined({"noise of the reference", "-"}, error_cells((*c.noise)[region])));
  return out;
}

std::string title_of(const PictureRegion& r) {
  return r.pixels == 0 ? fmt::format("{}: empty", r.name) : fmt::format("{}: {} pixels", r.name, r.pixels);
}

std::string reference_line(const SceneComparison& c) {
  if (!c.reference_file.empty()) return fmt::format("reference: {}", c.reference_file);
  return fmt::format("reference: {}, {} samples per pixel, noise {:.3f} %, {:.1f} s", c.model, c.samples,
                     c.noise_percent, c.reference_seconds);
}

std::string picture_line(const SceneComparison& c) {
  std::string text = fmt::format("{}, {}x{}, tone map {}, exposure {:g} EV", c.scene, c.width, c.height,
                                 c.tone_map, c.exposure_ev);
  if (c.supersample > 1) text += fmt::format(", errors of {0} x {0} pictures a pixel", c.supersample);
  return text;
}

std::string device_line(const SceneComparison& c) {
  if (c.techniques.empty()) return "";
  const Statistics& s = c.techniques.front().statistics;
  return fmt::format("{} ({}, Vulkan {}), {} light{}, median of {} frame{}", s.device, s.driver, s.api,
                     s.lights, s.lights == 1 ? "" : "s", s.frames, s.frames == 1 ? "" : "s");
}

std::string text_table(const Row& head, const std::vector<Row>& body) {
  std::size_t first = head[0].size();
  for (const Row& row : body) first = std::max(first, row[0].size());
  const auto line = [&](const Row& row) {
    std::string text = fmt::format("  {:<{}}", row[0], first);
    for (std::size_t i = 1; i < row.size(); ++i) text += fmt::format("  {:>12}", row[i]);
    return text + "\n";
  };
  std::string text = line(head);
  for (const Row& row : body) text += line(row);
  return text;
}

nlohmann::ordered_json errors_json(const SceneComparison& c, const Errors& errors) {
  using nlohmann::ordered_json;
  ordered_json out;
  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    ordered_json& region = out[c.regions[i].name];
    const auto& e = errors[i];
    if (!e) continue;  // null
    region = {{"flip", e->flip}, {"hdr_flip", e->hdr_flip}, {"psnr_db", e->psnr_db}, {"rel_mse", e->rel_mse}};
    region["rel_mse_unbiased"] =
        e->rel_mse_unbiased ? ordered_json(*e->rel_mse_unbiased) : ordered_json(nullptr);
    region["share"] = e->share;
  }
  return out;
}

constexpr std::array<std::array<int, 3>, 6> region_colours{
    {{230, 90, 60}, {240, 200, 40}, {70, 150, 255}, {60, 220, 120}, {220, 90, 220}, {240, 240, 240}}};

/// The reference in grey, one region in colour.
image::Image8 region_picture(const SceneComparison& c, std::size_t region) {
  image::Image8 out = c.shown_reference;
  const auto& colour = region_colours[(region - 1) % region_colours.size()];
  for (std::size_t i = 0; i < out.rgba.size() / 4; ++i) {
    std::uint8_t* p = out.rgba.data() + 4 * i;
    const int grey = (2 * p[0] + 5 * p[1] + p[2]) / 8;
    for (std::size_t k = 0; k < 3; ++k) {
      const int value = c.regions[region].mask[i] ? (grey + colour[k]) / 2 : grey;
      p[k] = static_cast<std::uint8_t>(value);
    }
  }
  return out;
}

}  // namespace

std::string scene_comparison_text(const SceneComparison& c) {
  std::string text = picture_line(c) + "\n" + reference_line(c) + "\n" + device_line(c) + "\n";
  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    text += title_of(c.regions[i]) + "\n";
    if (c.regions[i].pixels > 0) text += text_table(headings(i), rows(c, i));
  }
  return text;
}

std::string scene_comparison_json(const SceneComparison& c) {
  using nlohmann::ordered_json;
  ordered_json json{
      {"scene", c.scene},       {"settings", json_of(c.settings)}, {"size", {c.width, c.height}},
      {"tone_map", c.tone_map}, {"exposure_ev", c.exposure_ev},    {"supersample", c.supersample}};

  if (c.reference_file.empty())
    json["reference"] = {{"model", c.model},
                         {"samples", c.samples},
                         {"noise_percent", c.noise_percent},
                         {"seconds", c.reference_seconds}};
  else
    json["reference"] = {{"file", c.reference_file}};

  if (!c.techniques.empty()) {
    const Statistics& s = c.techniques.front().statistics;
    json["device"] = s.device;
    json["driver"] = s.driver;
    json["api"] = s.api;
    json["lights"] = s.lights;
  }

  json["regions"] = ordered_json::array();
  for (const PictureRegion& r : c.regions)
    json["regions"].push_back({{"name", r.name}, {"pixels", r.pixels}});

  json["techniques"] = ordered_json::array();
  for (const ComparedTechnique& t : c.techniques) {
    const Statistics& s = t.statistics;
    json["techniques"].push_back({{"name", t.name},
                                  {"technique", s.technique},
                                  {"optimise", s.optimise},
                                  {"gaussians", s.gaussians},
                                  {"map_size", s.map_size},
                                  {"frame_ms",
                                   {{"median", s.frame_ms_median},
                                    {"min", s.frame_ms_min},
                                    {"max", s.frame_ms_max},
                                    {"frames", s.frames}}},
                                  {"error", errors_json(c, t.errors)}});
  }

  json["noise"] = c.noise ? errors_json(c, *c.noise) : ordered_json(nullptr);
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string scene_comparison_page(const SceneComparison& c) {
  using namespace report;
  std::string body = fmt::format("<p>{}<br>{}<br>{}</p>\n", escape(picture_line(c)),
                                 escape(reference_line(c)), escape(device_line(c)));

  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    body += "<h2>" + escape(title_of(c.regions[i])) + "</h2>\n";
    if (c.regions[i].pixels > 0) body += grid(headings(i), rows(c, i));
  }

  // Give all maps of errors one scale, up to the largest error on skin.
  double full_scale = 0;
  for (const ComparedTechnique& t : c.techniques)
    full_scale = std::max(full_scale, image::summarise_flip(t.flip_map, c.regions[0].mask).max);
  if (full_scale <= 0) full_scale = 1;

  body += "<h2>Against the reference</h2>\n<div class=\"figures\">\n" +
          figure("the reference", picture("reference", c.shown_reference, "the reference")) + "</div>\n";
  for (std::size_t i = 0; i < c.techniques.size(); ++i) {
    const ComparedTechnique& t = c.techniques[i];
    const std::string id = fmt::format("technique-{}", i);
    body += "<h2>" + escape(t.name) + "</h2>\n<div class=\"figures\">\n";
    body += figure(escape(t.name), picture(id, t.shown, t.name));
    const image::Image8 colours =
        image::error_colours(t.flip_map, static_cast<float>(full_scale), c.regions[0].mask);
    body += figure("FLIP; grey: no skin",
                   picture(id + "-error", colours, "map of errors") + magma_scale(full_scale));
    body += figure("left: the reference", slider("reference", id, "reference", t.name)) + "</div>\n";
  }

  body += "<h2>Regions</h2>\n<div class=\"figures\">\n";
  for (std::size_t i = 1; i < c.regions.size(); ++i)
    if (c.regions[i].pixels > 0)
      body += figure(escape(title_of(c.regions[i])),
                     picture(fmt::format("region-{}", i), region_picture(c, i), c.regions[i].name));
  return page(c.scene + " against ground truth", body + "</div>\n");
}

}  // namespace dermis::cli
