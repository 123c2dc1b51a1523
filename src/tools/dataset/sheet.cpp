// SPDX-License-Identifier: MIT
// A page of samples, and of what was drawn.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "api/prepare/label_forms.h"
#include "base/core/error.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/members.h"
#include "tools/dataset/shard_reader.h"
#include "tools/dataset/skin_tone.h"
#include "tools/report/charts.h"
#include "tools/report/escape.h"
#include "tools/report/html.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t whole_samples = 4;        // shown with each label
constexpr std::uint64_t most_counted = 20'000;  // samples behind a histogram
constexpr std::size_t bins = 12, longest_word = 60;
// Of masks; the first eight stay apart for colour-blind eyes.
constexpr std::array<std::array<std::uint8_t, 3>, 16> palette{{{0, 114, 178},
                                                               {230, 159, 0},
                                                               {0, 158, 115},
                                                               {204, 121, 167},
                                                               {86, 180, 233},
                                                               {213, 94, 0},
                                                               {240, 228, 66},
                                                               {150, 150, 150},
                                                               {120, 70, 180},
                                                               {160, 220, 60},
                                                               {250, 200, 200},
                                                               {90, 50, 20},
                                                               {30, 60, 90},
                                                               {0, 220, 210},
                                                               {255, 80, 120},
                                                               {70, 110, 30}}};
constexpr std::array<std::uint8_t, 3> seen_point{90, 255, 90}, hidden_point{255, 60, 60};

bool is_mask(Output output) {
  return Outputs{Output::instance,  Output::material, Output::region,
                 Output::skin_mesh, Output::part,     Output::front_part}
      .has(output);
}

// A mask over its picture.
image::Image8 over(image::Image8 picture, const image::Image8& mask) {
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const std::uint16_t value = mask.rgba16[i];
    if (value == 0) continue;
    for (std::size_t c = 0; c < 3; ++c)
      picture.rgba[i + c] =
          static_cast<std::uint8_t>((picture.rgba[i + c] + palette[(value - 1u) % palette.size()][c]) / 2);
  }
  return picture;
}

// Landmarks as dots of two pixels a side.
image::Image8 dotted(image::Image8 picture, const std::vector<std::byte>& file) {
  const Json points = Json::parse(reinterpret_cast<const char*>(file.data()),
                                  reinterpret_cast<const char*>(file.data()) + file.size());
  for (const Json& point : points.at("points")) {
    if (!point[0].is_number() || !point[1].is_number()) continue;
    for (int corner = 0; corner < 4; ++corner) {
      const double x = std::floor(point[0].get<double>()) + corner % 2,
                   y = std::floor(point[1].get<double>()) + corner / 2;
      if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
      std::ranges::copy(point[3] == 1 ? seen_point : hidden_point,
                        picture.at(static_cast<int>(x), static_cast<int>(y)));
    }
  }
  return picture;
}

// Numbers in grey, from the least (dark) to the greatest (white); normals as they are.
image::Image8 shown(image::Image8 label, bool in_grey) {
  std::uint16_t least = 65535, most = 0;
  for (std::size_t i = 0; i < label.rgba16.size(); i += 4)
    if (const std::uint16_t v = label.rgba16[i]; v != 0) least = std::min(least, v), most = std::max(most, v);
  for (std::size_t i = 0; i < label.rgba16.size(); ++i) {
    const double v = label.rgba16[i];
    const double grey = v == 0 ? 0 : 40 + 215 * (v - least) / std::max(1, most - least);
    label.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(in_grey ? grey : v / 257);
  }
  return label;
}

std::string word(const Json& value) {
  const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  return text.size() <= longest_word ? text : text.substr(0, longest_word - 3) + "...";
}

/// The values that distributions gave, by their path.
using Values = std::map<std::string, std::vector<Json>>;

void collect(const Json& tree, const Json& value, const std::string& path, Values& into) {
  if (is_distribution(tree)) {
    into[path].push_back(value);
  } else if (tree.is_object()) {
    for (const auto& [key, member] : tree.items()) collect(member, value.at(key), path + "." + key, into);
  } else if (tree.is_array()) {
    for (std::size_t i = 0; i < tree.size(); ++i)
      collect(tree[i], value.at(i), fmt::format("{}[{}]", path, i), into);
  }
}

std::string histogram(const std::vector<Json>& values) {
  const bool numbers = std::ranges::all_of(values, [](const Json& v) { return v.is_number(); });
  std::map<std::string, double> words;
  for (const Json& value : values) ++words[word(value)];
  report::BarChart chart{.unit = "samples", .parts = {"samples"}, .bars = {}};
  if (!numbers || words.size() <= bins) {
    for (const auto& [name, count] : words)
      if (chart.bars.size() < 2 * bins) chart.bars.push_back({name, {count}});
    return report::bar_chart(chart);
  }

  const auto [low, high] = std::ranges::minmax(values, {}, [](const Json& v) { return v.get<double>(); });
  const double first = low, width = (high.get<double>() - first) / bins;
  std::array<double, bins> counts{};
  for (const Json& value : values)
    ++counts[std::min(bins - 1, static_cast<std::size_t>((value.get<double>() - first) / width))];
  for (std::size_t i = 0; i < bins; ++i) {
    const double from = first + width * static_cast<double>(i);
    chart.bars.push_back({fmt::format("{:.3g} to {:.3g}", from, from + width), {counts[i]}});
  }
  return report::bar_chart(chart);
}

class Page {
 public:
  Page(const fs::path& folder, const Lock& lock) : folder_(folder), lock_(lock), recipe_(recipe_of(lock)) {
    for (const std::uint64_t shard : shards_there(folder, recipe_)) {
      ranges_.emplace_back(shard, recipe_.samples_of(shard));
      there_ += ranges_.back().second.count;
    }
  }

  std::string html(std::size_t samples) {
    count_values();
    std::string body = report::table(facts()) + "<h2>Samples</h2>";
    const std::uint64_t shown_samples = std::min<std::uint64_t>(std::max<std::size_t>(samples, 1), there_);
    for (std::uint64_t k = 0; k < shown_samples; ++k) body += sample(k * there_ / shown_samples, k);
    body += "<h2>Values that were drawn</h2>";
    for (const auto& [path, values] : values_)
      body += report::figure(report::escape(path), histogram(values));
    body += report::figure("ITA class of the skin, by the typology angle of its colour map", tones());
    body += "<h2>Whose work is shown</h2>" + licences();
    return report::page(lock_.recipe->name, body);
  }

 private:
  void count_values() {
    const std::uint64_t counted = std::min(there_, most_counted);
    for (std::uint64_t k = 0; k < counted; ++k) {
      const Place place = lock_.recipe->place_of(sample_at(k * there_ / counted).second);
      const Entry& entry = lock_.recipe->entries[place.entry];
      const Json json = lock_.recipe->parameters(place);
      collect(lock_.recipe->settings, json["settings"], "settings", values_);
      collect(lock_.recipe->head, json["head"], "head", values_);
      collect(entry.pose.is_null() ? lock_.recipe->pose : entry.pose, json["pose"], "pose", values_);
      collect(entry.options, json["identity"]["options"], "options of " + entry.asset, values_);
      collect(entry.morphs, json["identity"]["morphs"], "morphs of " + entry.asset, values_);
      values_["asset"].push_back(entry.asset);
      const std::optional<double>& angle = lock_.ita_deg[place.entry];
      ++tones_[angle ? ita_class(*angle) : "not measured"];
      people_[place.test].insert(place.identity);
    }
  }

  std::vector<std::pair<std::string, std::string>> facts() const {
    std::vector<std::pair<std::string, std::string>> rows{
        {"samples", fmt::format("{} of {}", there_, recipe_.samples())},
        {"shards", fmt::format("{} of {}", ranges_.size(), recipe_.shards())},
        {"identities shown",
         fmt::format("{} to train, {} to test, of {}", people(false), people(true), recipe_.identities())},
        {"size", fmt::format("{} x {}", lock_.recipe->width, lock_.recipe->height)},
        {"recipe", lock_.recipe->sha256},
        {"drawn by", fmt::format("dermis {}, prepared on {}", DERMIS_VERSION, lock_.device.text())}};
    if (lock_.recipe->json.contains("about"))
      rows.insert(rows.begin(), {"about", lock_.recipe->json["about"]});
    return rows;
  }
  std::size_t people(bool test) const {
    const auto found = people_.find(test);
    return found == people_.end() ? 0 : found->second.size();
  }

  // The k-th sample that is there: its shard and its number.
  std::pair<std::uint64_t, std::uint64_t> sample_at(std::uint64_t k) const {
    auto range = ranges_.begin();
    while (k >= range->second.count) k -= (range++)->second.count;
    return {range->first, range->second.first + k};
  }

  std::string sample(std::uint64_t k, std::uint64_t place_on_page) {
    const auto [shard, i] = sample_at(k);
    if (!reader_ || shard_ != shard) {
      reader_ = std::make_unique<ShardReader>(*lock_.recipe, shard_path(folder_, recipe_, shard));
      shard_ = shard;
    }
    const image::Image8 picture = reader_->picture(i);
    const std::string stem = stem_of(*lock_.recipe, i);
    const Place place = lock_.recipe->place_of(i);
    std::string html = report::figure(fmt::format("{}, identity {}", stem, place.identity),
                                      report::picture("s" + stem, picture, "sample " + stem));
    bool is_over = false;
    for (const api::LabelForm& form : api::label_forms()) {
      if (!lock_.recipe->labels.has(form.output) || form.step == 0) continue;
      const bool mask = is_mask(form.output);
      // Of most samples one mask: that which says most.
      const bool wanted = mask && !is_over && (form.output == telling_mask() || !telling_mask());
      if (place_on_page >= whole_samples && !wanted) continue;
      is_over = is_over || wanted;
      const std::string name = api::row_of(form.output).name;
      const image::Image8 label = reader_->label(i, name);
      html += report::figure(
          stem + " " + name,
          report::picture("s" + stem + name,
                          mask ? over(picture, label) : shown(label, form.output != Output::normal), name));
    }
    if (lock_.recipe->landmarks)
      html += report::figure(
          stem + " landmarks",
          report::picture("s" + stem + "landmarks", dotted(picture, reader_->read(i, landmarks_ending)),
                          "landmarks: green, seen; red, hidden"));
    return html;
  }
  std::optional<Output> telling_mask() const {
    for (const Output mask : {Output::part, Output::region})
      if (lock_.recipe->labels.has(mask)) return mask;
    return std::nullopt;
  }

  // All classes, those without a sample too.
  std::string tones() const {
    report::BarChart chart{.unit = "samples", .parts = {"samples"}, .bars = {}};
    for (const char* name : ita_classes) chart.bars.push_back({name, {count_of(name)}});
    if (count_of("not measured") > 0) chart.bars.push_back({"not measured", {count_of("not measured")}});
    return report::bar_chart(chart);
  }
  double count_of(const std::string& tone) const {
    const auto found = tones_.find(tone);
    return found == tones_.end() ? 0 : found->second;
  }

  std::string licences() const {
    std::vector<std::vector<std::string>> rows;
    for (const Entry& entry : lock_.recipe->entries)
      rows.push_back({entry.asset, entry.licence.spdx, entry.licence.author, entry.licence.source,
                      entry.licence.changes.empty() ? "none" : entry.licence.changes});
    return report::grid({"asset", "licence", "author", "source", "changes"}, rows);
  }

  const fs::path& folder_;
  const Lock& lock_;
  Recipe recipe_;
  std::vector<std::pair<std::uint64_t, Recipe::Range>> ranges_;
  std::uint64_t there_ = 0, shard_ = 0;
  Values values_;
  std::map<std::string, double> tones_;
  std::map<bool, std::set<std::uint64_t>> people_;
  std::unique_ptr<ShardReader> reader_;
};

}  // namespace

std::string sheet(const fs::path& folder, std::size_t samples) {
  const Lock lock = load_lock(folder);
  return Page(folder, lock).html(samples);
}

}  // namespace dermis::dataset
