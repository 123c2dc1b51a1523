// SPDX-License-Identifier: MIT
#include "cli/label_files.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>

#include "api/prepare/label_forms.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/known_names.h"
#include "dermis/session.h"
#include "image/layers.h"

namespace dermis::cli {
namespace {

using Json = nlohmann::ordered_json;
using api::label_forms, api::LabelForm, api::row_of;

std::string beside(const std::string& picture, const std::string& ending) {
  return std::filesystem::path(picture).replace_extension(ending).string();
}

Json instances_json(const Scene& scene) {
  Json all = Json::array();
  for (const InstanceId id : scene.instances()) {
    const Instance& instance = scene.instance(id);
    all.push_back({{"name", instance.name},
                   {"asset", instance.asset.name()},
                   {"materials", instance.asset.materials()}});
  }
  return all;
}

[[noreturn]] void refuse_landmarks(const Scene& scene, const RenderSettings& settings) {
  if (settings.camera.heads > 1)
    throw input_error("--labels", "landmarks are of a scene's instances, and camera.heads is {}",
                      settings.camera.heads);
  throw input_error(scene.name(),
                    "has no landmarks: beside its file is no NAME.landmarks.json, and the mesh "
                    "is none that dermis knows");
}

// Layers of one file, with the linear picture.
PendingFile layers_file(const Results& results, const Picture& picture, const std::string& path,
                        Json& labels) {
  std::vector<image::LayerChannel> channels;
  const auto bytes = std::as_bytes(std::span(picture.linear_rgba));
  for (std::size_t c = 0; c < 4; ++c)
    channels.push_back({.name = std::string(1, "RGBA"[c]), .first = &bytes[4 * c], .pixel_bytes = 16});

  std::vector<std::vector<std::uint32_t>> widened;  // layers have no bytes
  widened.reserve(label_forms().size());
  for (const LabelForm& in_file : label_forms()) {
    const OutputRow& row = row_of(in_file.output);
    if (results.bytes(row.output).empty()) continue;
    const std::byte* first = results.bytes(row.output).data();
    if (row.type == OutputRow::Type::uint8) {
      const auto* values = reinterpret_cast<const std::uint8_t*>(first);
      widened.emplace_back(values, values + results.bytes(row.output).size());
      first = reinterpret_cast<const std::byte*>(widened.back().data());
    }
    Json json = api::label_json(row);
    if (row.output == Output::depth)
      json["nothing"] = "infinity";
    else
      json["nothing"] = 0;
    for (int c = 0; c < row.channels; ++c) {
      const std::string name = fmt::format("{}.{}", row.name, in_file.channels[static_cast<std::size_t>(c)]);
      channels.push_back({.name = name,
                          .whole = row.type != OutputRow::Type::float32,
                          .first = first + 4 * c,
                          .pixel_bytes = 4 * static_cast<std::size_t>(row.channels)});
      json["channels"].push_back(name);
    }
    labels[row.name] = json;
  }
  return {path, image::encode_layers(results.width, results.height, channels, path)};
}

std::vector<PendingFile> png_files(const Results& results, const std::string& path, Json& labels) {
  std::vector<PendingFile> files;
  for (const LabelForm& in_file : label_forms()) {
    const OutputRow& row = row_of(in_file.output);
    if (results.bytes(row.output).empty()) continue;
    const std::string file = beside(path, fmt::format(".{}.png", row.name));
    std::vector<std::uint16_t> values;
    try {
      values = api::png_values(results, in_file);
    } catch (const InputError& error) {
      throw input_error("", "{}; an output that ends in .exr holds it", error.what());
    }
    files.push_back({file, image::encode_png16(results.width, results.height, row.channels, values, file)});
    labels[row.name] = api::png_label_json(in_file, std::filesystem::path(file).filename().string());
  }
  return files;
}

}  // namespace

WantedLabels labels_of(const std::string& list, const std::string& ending) {
  std::vector<std::string> names{"all", "landmarks"};
  for (const LabelForm& row : label_forms()) names.emplace_back(row_of(row.output).name);
  const bool in_png = ending == ".png";

  WantedLabels wanted;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find(',', from), list.size());
    const std::string name = list.substr(from, to - from);
    from = to + 1;
    if (std::ranges::find(names, name) == names.end())
      throw input_error("--labels", "{}", unknown_name(name, names));
    wanted.landmarks |= name == "landmarks";
    wanted.all |= name == "all";
    for (const LabelForm& row : label_forms()) {
      if (name != "all" && name != row_of(row.output).name) continue;
      if (name != "all" && in_png && row.step == 0)
        throw input_error("--labels",
                          "{} has any numbers, which no PNG holds; an output that ends in .exr does", name);
      if (!in_png || row.step != 0) wanted.outputs = wanted.outputs | Outputs{row.output};
    }
  }
  return wanted;
}

std::string label_sheet(const std::string& picture) { return beside(picture, ".json"); }

std::vector<PendingFile> label_files(Renderer& renderer, const Scene& scene, const RenderSettings& settings,
                                     const Picture& picture, const WantedLabels& labels,
                                     const std::string& path) {
  if (settings.output.show != OutputSettings{}.show)
    throw input_error("--labels", "are of the picture, and output.show is '{}'", settings.output.show);
  RenderSettings unlit = settings;
  unlit.output.exposure_ev = settings.output.exposure_ev.value_or(0);
  const bool marked = labels.landmarks || labels.all;
  const Outputs drawn = marked ? labels.outputs | Outputs{Output::depth} : labels.outputs;
  Session session(renderer, {.frames_in_flight = 1, .wanted = drawn});
  Results results = session.results(session.draw(scene, unlit));

  Json of_labels = Json::object(), marks;
  const ResolvedCamera camera = resolved_camera(scene, settings);
  // The heads of a row are no instances.
  if (marked && settings.camera.heads == 1) marks = api::landmarks_json(scene, camera, results);
  if (labels.landmarks && marks.is_null()) refuse_landmarks(scene, settings);
  if (!labels.outputs.has(Output::depth)) results.depth_m = {};
  std::vector<PendingFile> files;
  if (ending_of(path) == ".png")
    files = png_files(results, path, of_labels);
  else
    files.push_back(layers_file(results, picture, path, of_labels));
  Json sheet{
      {"schema", 1},
      {"picture", std::filesystem::path(path).filename().string()},
      {"camera", api::camera_json(camera)},
      {"sampling", "one sample at the middle of each pixel; blended parts leave front and front_part alone"},
      {"labels", of_labels},
      {"instances", instances_json(scene)}};
  if (!marks.is_null()) sheet["landmarks"] = marks;
  const std::string text = sheet.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  const auto bytes = std::as_bytes(std::span(text));
  files.push_back({label_sheet(path), {bytes.begin(), bytes.end()}});
  return files;
}

}  // namespace dermis::cli
