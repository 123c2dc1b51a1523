// SPDX-License-Identifier: MIT
#include "tools/dataset/members.h"

#include <algorithm>
#include <cstring>

#include "api/prepare/label_forms.h"
#include "base/core/error.h"
#include "image/codec.h"
#include "image/layers.h"
#include "tools/dataset/sha256.h"

namespace dermis::dataset {
namespace {

constexpr double point_steps = 1e4;  // in a pixel, in a metre

std::string ending_of(const api::LabelForm& form) {
  return fmt::format("{}.{}", api::row_of(form.output).name, form.step == 0 ? "npy" : "png");
}

// NumPy's format, version 1.0: a header of a multiple of 64 bytes, then the values.
std::vector<std::byte> encode_npy(const Results& results, const OutputRow& row) {
  std::string header = fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, {}, {}), }}",
                                   results.height, results.width, row.channels);
  constexpr std::size_t before = 10;
  header.append(63 - (before + header.size()) % 64, ' ');
  header += '\n';

  std::string start("\x93NUMPY\x01\x00", 8);
  start += static_cast<char>(header.size() % 256);
  start += static_cast<char>(header.size() / 256);
  start += header;
  const std::span<std::byte> values = results.bytes(row.output);
  std::vector<std::byte> file(start.size() + values.size());
  std::memcpy(file.data(), start.data(), start.size());
  std::memcpy(file.data() + start.size(), values.data(), values.size());
  return file;
}

std::vector<std::byte> encode_display(const Results& results) {
  image::Image8 picture{.width = results.width, .height = results.height, .rgba = {}};
  picture.rgba.assign(results.display.begin(), results.display.end());
  return image::encode_png(picture, false, image::PngEffort::fast);
}

Member text_member(const char* ending, const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {ending, {bytes.begin(), bytes.end()}};
}

// Returns the landmarks as a file of their own: the JSON of a sample is equal on every device, and whether a
// point is seen is of the picture.
std::string landmarks_text(const std::vector<Landmark>& landmarks) {
  Json json = api::landmark_columns_json();
  json["points"] = api::landmark_points_json(landmarks);
  round_numbers(json["points"], point_steps);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

// Returns the labels in the JSON of a sample: file, and the way from its values to numbers.
Json labels_json(const Recipe::State& recipe, const std::string& stem) {
  Json labels = Json::object();
  for (const api::LabelForm& form : api::label_forms()) {
    if (!recipe.labels.has(form.output)) continue;
    const OutputRow& row = api::row_of(form.output);
    const std::string file = stem + "." + ending_of(form);
    Json json = form.step == 0 ? api::label_json(row) : api::png_label_json(form, file);
    json["file"] = file;
    labels[row.name] = json;
  }
  if (recipe.landmarks)
    labels["landmarks"] = {
        {"about", "iBUG's 68 points, then the right and the left pupil; right is the person's"},
        {"file", stem + "." + landmarks_ending}};
  return labels;
}

std::string sample_text(const Recipe::State& recipe, const Drawn& drawn, const std::string& stem) {
  Json json{{"schema", schema}, {"dermis", DERMIS_VERSION}, {"recipe", recipe.sha256}};
  json.update(drawn.json);
  json["labels"] = labels_json(recipe, stem);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string stem_of(const Recipe::State& recipe, std::uint64_t sample) {
  const std::size_t digits = std::max<std::size_t>(6, std::to_string(recipe.samples - 1).size());
  return fmt::format("{:0{}}", sample, digits);
}

std::vector<std::string> endings_of(const Recipe::State& recipe) {
  std::vector<std::string> endings{"png", "json"};
  for (const api::LabelForm& form : api::label_forms())
    if (recipe.labels.has(form.output)) endings.push_back(ending_of(form));
  if (recipe.landmarks) endings.emplace_back(landmarks_ending);
  return endings;
}

std::string hash_of_pictures(const Recipe::State& recipe, const Drawn& drawn) {
  Sha256 hash;
  for (const OutputRow& row : output_rows()) {
    if (row.output != Output::display && !recipe.labels.has(row.output)) continue;
    hash.add(std::string_view(row.name));
    hash.add(drawn.results.bytes(row.output));
  }
  if (recipe.landmarks) hash.add(std::string_view(landmarks_text(drawn.landmarks)));
  return hash.digest();
}

Encoded encoded(const Recipe::State& recipe, const Drawn& drawn) {
  const std::string stem = stem_of(recipe, drawn.place.sample), text = sample_text(recipe, drawn, stem);
  Encoded out{
      .sample = drawn.place.sample, .members = {}, .json_sha256 = sha256(text), .pictures_sha256 = {}};
  out.pictures_sha256 = hash_of_pictures(recipe, drawn);
  out.members.push_back({"png", encode_display(drawn.results)});
  out.members.push_back(text_member("json", text));

  for (const api::LabelForm& form : api::label_forms()) {
    if (!recipe.labels.has(form.output)) continue;
    const OutputRow& row = api::row_of(form.output);
    const std::string ending = ending_of(form);
    try {
      if (form.step == 0)
        out.members.push_back({ending, encode_npy(drawn.results, row)});
      else
        out.members.push_back({ending, image::encode_png16(drawn.results.width, drawn.results.height,
                                                           row.channels, api::png_values(drawn.results, form),
                                                           stem, image::PngEffort::fast)});
    } catch (const InputError& error) {
      throw input_error("recipe '" + recipe.name + "'", "sample {}: {}", drawn.place.sample, error.what());
    }
  }
  if (recipe.landmarks) out.members.push_back(text_member(landmarks_ending, landmarks_text(drawn.landmarks)));
  return out;
}

}  // namespace dermis::dataset
