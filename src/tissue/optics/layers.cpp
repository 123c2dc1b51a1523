// SPDX-License-Identifier: MIT
#include "tissue/optics/layers.h"

#include <cmath>
#include <limits>

#include "base/core/error.h"
#include "base/core/one_line.h"
#include "base/json/document.h"

namespace dermis::optics {
namespace {

constexpr double largest_mm = 1e6;  // a kilometre of skin: numbers stay far from overflow
constexpr json::Limits limits{.depth = 3, .values = 10'000};

double number(const json::Value& value) {
  constexpr double any = std::numeric_limits<double>::max();
  return value.number(-any, any) + 0.0;  // -0 becomes 0: its inverse must not be -inf
}

Rgb triple(const json::Value& value) {
  if (value.is_number()) return {number(value), number(value), number(value)};
  if (!value.is_array() || value.array_size(0) != 3) value.fail("must be a number or [R, G, B]");
  return {number(value.element(0)), number(value.element(1)), number(value.element(2))};
}

RgbLayer read_layer(const json::Value& value) {
  value.only_keys({"sigma_a_per_mm", "sigma_s_reduced_per_mm", "eta", "thickness_mm"});
  RgbLayer layer;
  layer.sigma_a_per_mm = triple(value.at("sigma_a_per_mm"));
  layer.sigma_s_reduced_per_mm = triple(value.at("sigma_s_reduced_per_mm"));
  if (const auto eta = value.find("eta")) layer.eta = number(*eta);
  const auto thickness = value.find("thickness_mm");
  if (thickness && !thickness->is_null()) layer.thickness_mm = number(*thickness);
  return layer;
}

RgbLayers read_layers(const json::Value& list) {
  const std::size_t size = list.array_size(0);
  if (size < 1 || size > max_layers) list.fail("1 to {} layers, got {}", max_layers, size);

  RgbLayers layers;
  for (std::size_t i = 0; i < size; ++i)
    layers.push_back(read_layer(list.element(i).called(fmt::format("layer {}", i))));
  for (int c = 0; c < 3; ++c) check(channel(layers, c), list.file());
  return layers;
}

}  // namespace

Layers channel(const RgbLayers& layers, int c) {
  Layers one;
  for (const RgbLayer& layer : layers)
    one.push_back({.sigma_a_per_mm = layer.sigma_a_per_mm[c],
                   .sigma_s_reduced_per_mm = layer.sigma_s_reduced_per_mm[c],
                   .eta = layer.eta,
                   .thickness_mm = layer.thickness_mm});
  return one;
}

void check(const Layers& layers, const std::string& where) {
  if (layers.empty() || layers.size() > max_layers)
    throw input_error(where, "1 to {} layers, got {}", max_layers, layers.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::string place = fmt::format("{}: layer {}", where, i);
    check(layers[i].medium(), place);
    const double thickness_mm = layers[i].thickness_mm;
    if (!(thickness_mm > 0)) throw input_error(place, "thickness_mm must be above 0, got {}", thickness_mm);
    if (std::isfinite(thickness_mm) && thickness_mm > largest_mm)
      throw input_error(place,
                        "thickness_mm must be at most {:g}, got {}; a last layer without it is a half-space",
                        largest_mm, thickness_mm);
    if (!std::isfinite(thickness_mm) && i + 1 < layers.size())
      throw input_error(place, "only the last layer may be without thickness_mm");
    if (std::isfinite(thickness_mm) && thickness_mm * layers[i].medium().sigma_t_reduced_per_mm() < 1e-9)
      throw input_error(place, "thickness_mm {} is no layer: less than 1e-9 mean free paths", thickness_mm);
  }
}

RgbLayers parse_layers(std::string_view text, const std::string& where) {
  return with_one_line_errors([&] { return read_layers(json::Document(text, where, limits).root()); });
}

RgbLayers load_layers(const std::filesystem::path& path) {
  return with_one_line_errors([&] { return read_layers(json::load(path, 1 << 20, limits).root()); });
}

}  // namespace dermis::optics
