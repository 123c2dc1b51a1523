// SPDX-License-Identifier: MIT
#include "optics/layers.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/file.h"
#include "core/one_line.h"

namespace dermis::optics {
namespace {

using Json = nlohmann::json;

constexpr double largest_mm = 1e6;  // a kilometre of skin: numbers stay far from overflow

double number(const Json& value, const std::string& where) {
  if (!value.is_number()) throw input_error(where, "expected a number, got {}", value.type_name());
  return value.get<double>() + 0.0;  // -0 becomes 0: its inverse must not be -inf
}

Rgb triple(const Json& value, const std::string& where) {
  if (value.is_number()) return {number(value, where), number(value, where), number(value, where)};
  if (!value.is_array() || value.size() != 3) throw input_error(where, "expected a number or [R, G, B]");
  return {number(value[0], where), number(value[1], where), number(value[2], where)};
}

RgbLayer parse_layer(const Json& json, const std::string& where) {
  if (!json.is_object()) throw input_error(where, "expected an object, got {}", json.type_name());

  RgbLayer layer;
  for (const auto& [key, value] : json.items()) {
    const std::string place = where + "." + key;
    if (key == "sigma_a_per_mm")
      layer.sigma_a_per_mm = triple(value, place);
    else if (key == "sigma_s_reduced_per_mm")
      layer.sigma_s_reduced_per_mm = triple(value, place);
    else if (key == "eta")
      layer.eta = number(value, place);
    else if (key == "thickness_mm") {
      if (!value.is_null()) layer.thickness_mm = number(value, place);
    } else {
      throw input_error(
          where, "unknown key '{}'; known: sigma_a_per_mm, sigma_s_reduced_per_mm, eta, thickness_mm", key);
    }
  }

  for (const char* key : {"sigma_a_per_mm", "sigma_s_reduced_per_mm"})
    if (!json.contains(key)) throw input_error(where, "'{}' is missing", key);
  return layer;
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

namespace {

RgbLayers parse(std::string_view json, const std::string& where) {
  Json document;
  try {
    std::set<std::string> keys;
    document = Json::parse(json, [&](int, Json::parse_event_t event, Json& parsed) {
      if (event == Json::parse_event_t::object_start) keys.clear();
      if (event == Json::parse_event_t::key && !keys.insert(parsed.get<std::string>()).second)
        throw input_error(where, "'{}' is given twice in one layer", parsed.get<std::string>());
      return true;
    });
  } catch (const Json::parse_error& error) {
    throw input_error(where, "not JSON (byte {})", error.byte);
  } catch (const Json::exception&) { throw input_error(where, "a number is too large"); }

  if (!document.is_array())
    throw input_error(where, "expected a list of layers, got {}", document.type_name());
  if (document.empty() || document.size() > max_layers)
    throw input_error(where, "1 to {} layers, got {}", max_layers, document.size());

  RgbLayers layers;
  for (std::size_t i = 0; i < document.size(); ++i)
    layers.push_back(parse_layer(document[i], fmt::format("{}: layer {}", where, i)));
  for (int c = 0; c < 3; ++c) check(channel(layers, c), where);
  return layers;
}

}  // namespace

RgbLayers parse_layers(std::string_view json, const std::string& where) {
  return with_one_line_errors([&] { return parse(json, where); });
}

RgbLayers load_layers(const std::filesystem::path& path) {
  const auto bytes = read_file(path, 1 << 20);
  return parse_layers({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
}

}  // namespace dermis::optics
