// SPDX-License-Identifier: MIT
// The results of `dermis compare --scene` as text, JSON and a page.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "cli/comparison/table.h"
#include "cli/scene_comparison.h"
#include "image/compare_flip.h"
#include "image/compare_map.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"
#include "tools/report/point_chart.h"

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
  if (region > 0) return joined({"technique", "of all error"}, error_headings);
  return joined(joined({"technique", "frame ms", "taps/pixel", "MB"}, error_headings), {"at size"});
}

std::string taps_text(double taps) { return taps > 0 ? fmt::format("{:.0f}", taps) : "-"; }

Row cost_cells(const ComparedTechnique& t) {
  const Statistics& s = t.statistics;
  return {fmt::format("{:.1f}", t.ms()), taps_text(taps_per_pixel(s)),
          fmt::format("{:.0f}", static_cast<double>(s.image_bytes + s.buffer_bytes) / 1e6)};
}

/// Over skin with the cost, over other regions with their share of the error.
std::vector<Row> rows(const SceneComparison& c, std::size_t region) {
  std::vector<Row> out;
  for (const ComparedTechnique& t : c.techniques) {
    const auto& e = t.errors[region];
    if (region > 0) {
      out.push_back(joined({t.name, e ? fmt::format("{:.0f} %", 100 * e->share) : "-"}, error_cells(e)));
      continue;
    }
    const std::optional<RegionError>& at_size = c.supersample > 1 ? t.at_size : e;
    out.push_back(joined(joined(joined({t.name}, cost_cells(t)), error_cells(e)),
                         {at_size ? fmt::format("{:.3g}", at_size->rel_mse) : "-"}));
  }

  if (!c.noise) return out;
  Row noise = joined({"noise of the reference", "-"}, error_cells((*c.noise)[region]));
  if (region == 0) {
    noise.insert(noise.begin() + 2, 2, "-");
    noise.push_back("-");
  }
  out.push_back(std::move(noise));
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
  if (c.supersample > 1)
    text += fmt::format(", errors of {0} x {0} pictures per pixel; at size: relMSE of the picture itself",
                        c.supersample);
  return text;
}

std::string device_line(const SceneComparison& c) {
  if (c.techniques.empty()) return "";
  const Statistics& s = c.techniques.front().statistics;
  return fmt::format("{} ({}, Vulkan {}), {} light{}, median of {} frame{} in turns", s.device, s.driver,
                     s.api, s.lights, s.lights == 1 ? "" : "s", s.frames, s.frames == 1 ? "" : "s");
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

nlohmann::ordered_json error_json(const RegionError& e) {
  using nlohmann::ordered_json;
  return {
      {"flip", e.flip},
      {"hdr_flip", e.hdr_flip},
      {"psnr_db", e.psnr_db},
      {"rel_mse", e.rel_mse},
      {"rel_mse_unbiased", e.rel_mse_unbiased ? ordered_json(*e.rel_mse_unbiased) : ordered_json(nullptr)},
      {"share", e.share}};
}

nlohmann::ordered_json errors_json(const SceneComparison& c, const Errors& errors) {
  nlohmann::ordered_json out;
  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    nlohmann::ordered_json& region = out[c.regions[i].name];
    if (errors[i]) region = error_json(*errors[i]);  // else null
  }
  return out;
}

constexpr std::array<std::array<int, 3>, 6> region_colours{
    {{230, 90, 60}, {240, 200, 40}, {70, 150, 255}, {60, 220, 120}, {220, 90, 220}, {240, 240, 240}}};

image::Image8 image_of(const SceneComparison& c, const std::vector<std::uint8_t>& rgba) {
  return {.width = c.width, .height = c.height, .rgba = rgba};
}

image::ImageF flip_map(const SceneComparison& c, const ComparedTechnique& t) {
  return {.width = c.width, .height = c.height, .channels = 1, .values = t.flip};
}

/// The reference in grey, one region in colour.
image::Image8 region_picture(const SceneComparison& c, std::size_t region) {
  image::Image8 out = image_of(c, c.reference_display);
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

std::string scene_comparison_json(const SceneComparison& c, const SettingsFile& settings) {
  nlohmann::ordered_json json{{"scene", c.scene}, {"settings", json_of(settings)}};
  json.update(scene_comparison_object(c));
  // Names of files need not be UTF-8.
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

nlohmann::ordered_json scene_comparison_object(const SceneComparison& c) {
  using nlohmann::ordered_json;
  ordered_json json{{"scene", c.scene},
                    {"size", {c.width, c.height}},
                    {"tone_map", c.tone_map},
                    {"exposure_ev", c.exposure_ev},
                    {"supersample", c.supersample}};

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
                                  {"taps_per_pixel", taps_per_pixel(s)},
                                  {"device_bytes", s.image_bytes + s.buffer_bytes},
                                  {"at_size", t.at_size ? error_json(*t.at_size) : ordered_json(nullptr)},
                                  {"error", errors_json(c, t.errors)}});
  }

  json["curves"] = ordered_json::array();
  for (const QualityPoint& p : c.curves)
    json["curves"].push_back({{"curve", p.curve},
                              {"setting", p.label},
                              {"frame_ms", p.ms},
                              {"taps_per_pixel", p.taps_per_pixel},
                              {"error", error_json(p.error)},
                              {"at_size", error_json(p.at_size)}});

  json["noise"] = c.noise ? errors_json(c, *c.noise) : ordered_json(nullptr);
  return json;
}

std::string error_over_cost(const SceneComparison& c) {
  report::PointChart chart{.title = "error over cost, over skin",
                           .x_name = "frame, ms",
                           .y_name = "relMSE at size, less noise",
                           .curves = {}};
  const auto curve_of = [&](const std::string& name) -> report::PointCurve& {
    for (report::PointCurve& curve : chart.curves)
      if (curve.name == name) return curve;
    return chart.curves.emplace_back(report::PointCurve{.name = name, .points = {}});
  };

  for (const QualityPoint& p : c.curves)
    curve_of(p.curve).points.push_back({.x = p.ms, .y = comparison::less_noise(p.at_size), .name = p.label});
  if (c.curves.empty())
    for (const ComparedTechnique& t : c.techniques) {
      const std::optional<RegionError>& e = t.at_size ? t.at_size : t.errors.front();
      if (e)
        curve_of(t.name).points.push_back({.x = t.ms(), .y = comparison::less_noise(*e), .name = t.name});
    }
  return report::point_chart(chart);
}

std::string scene_comparison_body(const SceneComparison& c, const std::string& id) {
  using namespace report;
  std::string body = fmt::format("<p>{}<br>{}<br>{}</p>\n", escape(picture_line(c)),
                                 escape(reference_line(c)), escape(device_line(c)));

  for (std::size_t i = 0; i < c.regions.size(); ++i) {
    body += "<h2>" + escape(title_of(c.regions[i])) + "</h2>\n";
    if (c.regions[i].pixels > 0) body += grid(headings(i), rows(c, i));
  }
  body += "<h2>Error over cost</h2>\n" + error_over_cost(c);

  // Give all maps of errors one scale, up to the largest error on skin.
  double full_scale = 0;
  for (const ComparedTechnique& t : c.techniques)
    full_scale = std::max(full_scale, image::summarise_flip(flip_map(c, t), c.regions[0].mask).max);
  if (full_scale <= 0) full_scale = 1;

  const std::string truth = id + "reference";
  body += "<h2>Against the reference</h2>\n<div class=\"figures\">\n" +
          figure("the reference", picture(truth, image_of(c, c.reference_display), "the reference")) +
          "</div>\n";
  for (std::size_t i = 0; i < c.techniques.size(); ++i) {
    const ComparedTechnique& t = c.techniques[i];
    const std::string own = fmt::format("{}technique-{}", id, i);
    body += "<h2>" + escape(t.name) + "</h2>\n<div class=\"figures\">\n";
    body += figure(escape(t.name), picture(own, image_of(c, t.display_rgba), t.name));
    const image::Image8 colours =
        image::error_colours(flip_map(c, t), static_cast<float>(full_scale), c.regions[0].mask);
    body += figure("FLIP; grey: no skin",
                   picture(own + "-error", colours, "map of errors") + magma_scale(full_scale));
    body += figure("left: the reference", slider(truth, own, "reference", t.name)) + "</div>\n";
  }

  body += "<h2>Regions</h2>\n<div class=\"figures\">\n";
  for (std::size_t i = 1; i < c.regions.size(); ++i)
    if (c.regions[i].pixels > 0)
      body += figure(escape(title_of(c.regions[i])),
                     picture(fmt::format("{}region-{}", id, i), region_picture(c, i), c.regions[i].name));
  return body + "</div>\n";
}

std::string scene_comparison_page(const SceneComparison& c) {
  return report::page(c.scene + " against ground truth", scene_comparison_body(c, ""));
}

}  // namespace dermis::cli
