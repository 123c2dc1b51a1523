// SPDX-License-Identifier: MIT
#include "api/prepare/label_forms.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/core/error.h"

namespace dermis::api {
namespace {

using Json = nlohmann::ordered_json;

constexpr LabelForm forms[] = {
    {Output::instance, {"id"}, 1},    {Output::material, {"id"}, 1},
    {Output::depth, {"Z"}, 1e-4},     {Output::normal, {"X", "Y", "Z"}, 1.0 / 32767, 1 + 1.0 / 32767},
    {Output::uv, {"U", "V"}},         {Output::region, {"id"}, 1},
    {Output::skin_mesh, {"id"}, 1},   {Output::unwrap, {"U", "V"}},
    {Output::thickness, {"Y"}, 1e-3}, {Output::matte, {"A"}, 1.0 / 65535},
    {Output::part, {"id"}, 1},        {Output::front, {"A"}, 1.0 / 65535},
    {Output::front_part, {"id"}, 1}};

double number_at(const Results& results, const OutputRow& row, std::size_t i) {
  const std::byte* bytes = results.bytes(row.output).data();
  if (row.type == OutputRow::Type::uint8) return static_cast<double>(bytes[i]);
  if (row.type == OutputRow::Type::uint32) return reinterpret_cast<const std::uint32_t*>(bytes)[i];
  return double{reinterpret_cast<const float*>(bytes)[i]};
}

Json number_json(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

}  // namespace

std::span<const LabelForm> label_forms() { return forms; }

const OutputRow& row_of(Output output) { return output_rows()[static_cast<std::size_t>(output)]; }

std::vector<std::uint16_t> png_values(const Results& results, const LabelForm& in_file) {
  const OutputRow& row = row_of(in_file.output);
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
            "", "label {} reaches {:.6g}{}{}, over the {:.6g} that a PNG holds in steps of {:g}", row.name,
            number, *row.unit != 0 ? " " : "", row.unit, 65535 * in_file.step, in_file.step);
      values[pixel * channels + c] = static_cast<std::uint16_t>(value);
    }
  }
  return values;
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

Json png_label_json(const LabelForm& form, const std::string& file) {
  Json json = label_json(row_of(form.output));
  json["nothing"] = 0;
  json["file"] = file;
  json["step"] = form.step;
  json["offset"] = form.offset == 0 ? 0 : -form.offset;
  json["number"] = "value * step + offset";
  return json;
}

Json camera_json(const ResolvedCamera& camera) {
  const auto matrix = [](const std::array<double, 9>& m) {
    return Json{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}};
  };
  return {
      {"convention",
       "OpenCV: a point x of the world (m, +Y up) lies at c = R x + t, +x right, +y down, +z ahead. It is "
       "seen at K c / c.z, of an orthographic camera at K (c.x, c.y, 1). The middle of the first pixel is "
       "0 0"},
      {"orthographic", camera.orthographic},
      {"width", camera.width},
      {"height", camera.height},
      {"K", matrix(camera.k)},
      {"R", matrix(camera.r)},
      {"t_m", camera.t_m},
      {"near_m", camera.near_m}};
}

Json landmark_points_json(std::span<const Landmark> landmarks) {
  Json points = Json::array();
  for (const Landmark& mark : landmarks)
    points.push_back(
        {number_json(mark.x), number_json(mark.y), number_json(mark.depth_m), mark.seen ? 1 : 0});
  return points;
}

Json landmark_columns_json() {
  return {{"values", {"x", "y", "depth", "seen"}}, {"units", {"px", "px", "m", ""}}};
}

Json landmarks_json(const Scene& scene, const ResolvedCamera& camera, const Results& results) {
  Json instances = Json::array();
  bool some = false;
  for (const InstanceId id : scene.instances()) {
    const auto marks = Landmarks::of(scene.instance(id).asset);
    some |= marks.has_value();
    instances.push_back(marks ? landmark_points_json(marks->in_picture(scene, id, camera, results.depth_m))
                              : Json(nullptr));
  }
  if (!some) return nullptr;

  Json json{{"about",
             "iBUG's 68 points, then the right and the left pupil; right is the person's. Fixed to the skin, "
             "also along the jaw. seen: the picture shows the point, whatever hair lies before it"}};
  json.update(landmark_columns_json());
  json["instances"] = instances;
  return json;
}

}  // namespace dermis::api
