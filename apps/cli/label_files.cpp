// SPDX-License-Identifier: MIT
#include "cli/label_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "core/error.h"
#include "core/file.h"
#include "core/known_names.h"
#include "dermis/camera.h"
#include "dermis/landmarks.h"
#include "dermis/session.h"
#include "image/layers.h"

namespace dermis::cli {
namespace {

using Json = nlohmann::ordered_json;

/// How a label lies in files. In PNG: value = zero + round(number / step), and 0 where nothing is.
struct FileRow {
  Output output{};
  std::array<const char*, 3> channels{};  ///< of its layer
  double step = 0;                        ///< in PNG; 0: a PNG does not hold it
  double offset = 0;                      ///< added to the number before
};
// Motion is since the frame before, and here is none.
constexpr FileRow file_rows[] = {
    {Output::instance, {"id"}, 1},    {Output::material, {"id"}, 1},
    {Output::depth, {"Z"}, 1e-4},     {Output::normal, {"X", "Y", "Z"}, 1.0 / 32767, 1 + 1.0 / 32767},
    {Output::uv, {"U", "V"}},         {Output::region, {"id"}, 1},
    {Output::skin_mesh, {"id"}, 1},   {Output::unwrap, {"U", "V"}},
    {Output::thickness, {"Y"}, 1e-3}, {Output::matte, {"A"}, 1.0 / 65535},
    {Output::part, {"id"}, 1},        {Output::front, {"A"}, 1.0 / 65535},
    {Output::front_part, {"id"}, 1}};

const OutputRow& row_of(Output output) { return output_rows()[static_cast<std::size_t>(output)]; }

double number_at(const Results& results, const OutputRow& row, std::size_t i) {
  const std::byte* bytes = results.bytes(row.output).data();
  if (row.type == OutputRow::Type::uint8) return static_cast<double>(bytes[i]);
  if (row.type == OutputRow::Type::uint32) return reinterpret_cast<const std::uint32_t*>(bytes)[i];
  return double{reinterpret_cast<const float*>(bytes)[i]};
}

std::vector<std::uint16_t> png_values(const Results& results, const OutputRow& row, const FileRow& in_file) {
  const auto pixels = static_cast<std::size_t>(results.width) * static_cast<std::size_t>(results.height);
  const auto channels = static_cast<std::size_t>(row.channels);
  std::vector<std::uint16_t> values(pixels * channels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    bool is_there = false;
    for (std::size_t c = 0; c < channels; ++c) {
      const double number = number_at(results, row, pixel * channels + c);
      is_there |= number != 0 && std::isfinite(number);
    }
    if (!is_there) continue;
    for (std::size_t c = 0; c < channels; ++c) {
      const double number = number_at(results, row, pixel * channels + c);
      const double value = std::round((number + in_file.offset) / in_file.step);
      if (!(value >= 0 && value <= 65535))
        throw input_error(
            "",
            "label {} reaches {:.6g}{}{}, over the {:.6g} that a PNG holds in steps of {:g}; an "
            "output that ends in .exr holds it",
            row.name, number, *row.unit != 0 ? " " : "", row.unit, 65535 * in_file.step, in_file.step);
      values[pixel * channels + c] = static_cast<std::uint16_t>(value);
    }
  }
  return values;
}

std::string beside(const std::string& picture, const std::string& ending) {
  return std::filesystem::path(picture).replace_extension(ending).string();
}

Json camera_json(const Scene& scene, const RenderSettings& settings) {
  const ResolvedCamera camera = resolved_camera(scene, settings);
  const auto matrix = [](const std::array<double, 9>& m) {
    return Json{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}};
  };
  return {
      {"convention",
       "OpenCV: a point x of the world (m, +Y up) lies at c = R x + t, +x right, +y down, +z ahead; it is "
       "seen at K c / c.z, of an orthographic camera at K (c.x, c.y, 1); the middle of the first pixel is "
       "0 0"},
      {"orthographic", camera.orthographic},
      {"width", camera.width},
      {"height", camera.height},
      {"K", matrix(camera.k)},
      {"R", matrix(camera.r)},
      {"t_m", camera.t_m},
      {"near_m", camera.near_m}};
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

Json number_json(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

// Of each instance; null where it has none, and null if none has.
Json landmarks_json(const Scene& scene, const RenderSettings& settings, const Results& results) {
  if (settings.camera.heads > 1) return nullptr;  // the heads of a row are no instances
  const ResolvedCamera camera = resolved_camera(scene, settings);
  Json instances = Json::array();
  bool some = false;
  for (const InstanceId id : scene.instances()) {
    const auto marks = Landmarks::of(scene.instance(id).asset);
    some |= marks.has_value();
    Json points = marks ? Json::array() : Json(nullptr);
    if (marks)
      for (const Landmark& mark : marks->in_picture(scene, id, camera, results.depth_m))
        points.push_back(
            {number_json(mark.x), number_json(mark.y), number_json(mark.depth_m), mark.seen ? 1 : 0});
    instances.push_back(points);
  }
  if (!some) return nullptr;
  return {{"about",
           "iBUG's 68 points, then the right and the left pupil; right is the person's. Fixed to the skin, "
           "also along the jaw. seen: the picture shows the point, whatever hair lies before it"},
          {"values", {"x", "y", "depth", "seen"}},
          {"units", {"px", "px", "m", ""}},
          {"instances", instances}};
}

[[noreturn]] void refuse_landmarks(const Scene& scene, const RenderSettings& settings) {
  if (settings.camera.heads > 1)
    throw input_error("--labels", "landmarks are of a scene's instances, and camera.heads is {}",
                      settings.camera.heads);
  throw input_error(scene.name(),
                    "has no landmarks: beside its file is no NAME.landmarks.json, and the mesh "
                    "is none that dermis knows");
}

Json label_json(const OutputRow& row) {
  Json json{{"about", row.help}};
  if (*row.unit != 0) json["unit"] = row.unit;
  if (row.output == Output::part || row.output == Output::front_part) {
    for (const PartRow& part : part_rows()) {
      json["names"].push_back(part.name);
      json["classes"]["FaceSynthetics"].push_back(part.face_synthetics);
      json["classes"]["CelebAMask-HQ"].push_back(part.celeba_mask_hq);
    }
  }
  if (row.output == Output::region) json["names"] = {"no skin", "nose", "ear", "other skin"};
  if (row.output == Output::normal)
    json["about"] =
        "of the vertices, interpolated, without normal maps; unit, in the world; R n is in the camera";
  if (row.output == Output::depth) json["about"] = "along the axis of the camera, not along the ray";
  return json;
}

// Layers of one file, with the linear picture.
PendingFile layers_file(const Results& results, const Picture& picture, const std::string& path,
                        Json& labels) {
  std::vector<image::LayerChannel> channels;
  const auto bytes = std::as_bytes(std::span(picture.linear_rgba));
  for (std::size_t c = 0; c < 4; ++c)
    channels.push_back({.name = std::string(1, "RGBA"[c]), .first = &bytes[4 * c], .pixel_bytes = 16});

  std::vector<std::vector<std::uint32_t>> widened;  // layers have no bytes
  widened.reserve(std::size(file_rows));
  for (const FileRow& in_file : file_rows) {
    const OutputRow& row = row_of(in_file.output);
    if (results.bytes(row.output).empty()) continue;
    const std::byte* first = results.bytes(row.output).data();
    if (row.type == OutputRow::Type::uint8) {
      const auto* values = reinterpret_cast<const std::uint8_t*>(first);
      widened.emplace_back(values, values + results.bytes(row.output).size());
      first = reinterpret_cast<const std::byte*>(widened.back().data());
    }
    Json json = label_json(row);
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
  for (const FileRow& in_file : file_rows) {
    const OutputRow& row = row_of(in_file.output);
    if (results.bytes(row.output).empty()) continue;
    const std::string file = beside(path, fmt::format(".{}.png", row.name));
    files.push_back({file, image::encode_png16(results.width, results.height, row.channels,
                                               png_values(results, row, in_file), file)});
    Json json = label_json(row);
    json["nothing"] = 0;
    json["file"] = std::filesystem::path(file).filename().string();
    json["step"] = in_file.step;
    json["offset"] = in_file.offset == 0 ? 0 : -in_file.offset;
    json["number"] = "value * step + offset";
    labels[row.name] = json;
  }
  return files;
}

}  // namespace

WantedLabels labels_of(const std::string& list, const std::string& ending) {
  std::vector<std::string> names{"all", "landmarks"};
  for (const FileRow& row : file_rows) names.emplace_back(row_of(row.output).name);
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
    for (const FileRow& row : file_rows) {
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
  if (marked) marks = landmarks_json(scene, settings, results);
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
      {"camera", camera_json(scene, settings)},
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
