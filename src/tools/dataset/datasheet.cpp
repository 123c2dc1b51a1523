// SPDX-License-Identifier: MIT
// A datasheet, filled from recipe and manifests. Its questions are those of
// [GMV+21] Gebru, Morgenstern, Vecchione et al.: Datasheets for Datasets. Communications of the ACM 64, 2021
#include <algorithm>
#include <map>
#include <set>

#include "api/prepare/label_forms.h"
#include "base/core/error.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/shard_reader.h"
#include "tools/dataset/skin_tone.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t few_identities = 100;
constexpr const char* not_measured = "not measured";

// Text of others, which must not become markup.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("\\`*_[]#|~").find(c) != std::string_view::npos) out += '\\';
    if (c == '<')
      out += "&lt;";
    else
      out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

// The same within a table and in a code span, where only these two mean something.
std::string code(std::string text) {
  std::ranges::replace(text, '`', '\'');
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, "\\");
  return "`" + text + "`";
}

std::string text_of_json(const Json& value) {
  return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

struct Count {
  std::uint64_t train = 0, test = 0, samples = 0;
};

class Datasheet {
 public:
  Datasheet(const fs::path& folder, const Lock& lock)
      : lock_(lock), s_(*lock.recipe), recipe_(recipe_of(lock)) {
    for (const std::uint64_t shard : shards_there(folder, recipe_)) {
      there_ += recipe_.samples_of(shard).count;
      devices_.insert(load_manifest(manifest_path(shard_path(folder, recipe_, shard))).device.text());
    }
    count(s_.train, s_.train_samples, &Count::train);
    count(s_.test, s_.samples - s_.train_samples, &Count::test);
  }

  std::string text() const {
    return fmt::format(
               "# Datasheet: {}\n\nThe questions are those of Gebru et al., Datasheets for Datasets "
               "(Communications of the ACM 64, 2021). dermis {} has answered those that the recipe answers; "
               "**to fill in** marks the others.\n\n",
               plain(s_.name), DERMIS_VERSION) +
           motivation() + composition() + collection() + labelling() + uses() + distribution() +
           maintenance();
  }

 private:
  // People of one split, and their samples: a person's sittings follow each other.
  void count(const std::vector<std::uint64_t>& people, std::uint64_t samples, std::uint64_t Count::*split) {
    const std::uint64_t sittings = samples / s_.views, all = people.size();
    for (std::uint64_t p = 0; p < all; ++p) {
      std::uint64_t member = people[p];
      std::size_t entry = 0;
      while (member >= s_.entries[entry].count) member -= s_.entries[entry++].count;
      const std::uint64_t first = (p * sittings + all - 1) / all, end = ((p + 1) * sittings + all - 1) / all;
      const std::optional<double>& angle = lock_.ita_deg[entry];
      Count& tone = tones_[angle ? ita_class(*angle) : not_measured];
      tone.*split += 1;
      tone.samples += (end - first) * s_.views;
    }
  }

  std::string motivation() const {
    return "## Motivation\n\n" + (s_.json.contains("about") ? plain(s_.json["about"]) + "\n\n" : "") +
           "- For which purpose, by whom, with whose money: **to fill in**\n\n";
  }

  std::string composition() const {
    std::string text = fmt::format(
        "## Composition\n\n"
        "- {} samples, of which {} are drawn: a picture of {} x {} pixels each, with parameters and labels\n"
        "- {} identities: {} to train, {} to test. Nobody is in both. An identity is an asset with weights "
        "of its morph targets and options\n"
        "- {} pictures in a row show one person\n"
        "- The pictures are rendered. A photograph is in them only as far as an asset holds one\n\n",
        s_.samples, there_, s_.width, s_.height, recipe_.identities(), s_.train.size(), s_.test.size(),
        s_.views);

    text += "| ITA class of the skin | identities to train | to test | samples |\n|---|---|---|---|\n";
    std::string without;
    for (const char* name : ita_classes) {
      const auto found = tones_.find(name);
      if (found == tones_.end())
        without += (without.empty() ? "" : ", ") + std::string(name);
      else
        text += row(name, found->second);
    }
    if (const auto found = tones_.find(not_measured); found != tones_.end())
      text += row(not_measured, found->second);
    text += "\nThe class is that of the colour map, before tints and lamps.";
    if (!without.empty()) text += fmt::format(" Nobody has a skin of the classes: {}.", without);
    return text + "\n\n";
  }
  static std::string row(const std::string& name, const Count& count) {
    return fmt::format("| {} | {} | {} | {} |\n", name, count.train, count.test, count.samples);
  }

  std::string collection() const {
    std::string text =
        fmt::format("## Collection process\n\nDrawn by dermis {} from the recipe with SHA-256 {}, on:\n\n",
                    DERMIS_VERSION, s_.sha256);
    for (const std::string& device : devices_) text += "- " + plain(device) + "\n";

    text +=
        fmt::format("\nEach value is a function of the seed, {}, and the number of the sample.\n\n", s_.seed);
    text += "| parameter | value or distribution |\n|---|---|\n";
    add_leaves(s_.settings, "settings", text);
    add_leaves(s_.head, "head", text);
    add_leaves(s_.pose, "pose", text);
    for (std::size_t i = 0; i < s_.entries.size(); ++i) {
      const std::string person = fmt::format("identities[{}]", i);
      add_leaves(s_.entries[i].options, person + ".options", text);
      add_leaves(s_.entries[i].morphs, person + ".morphs", text);
      if (!s_.entries[i].pose.is_null()) add_leaves(s_.entries[i].pose, person + ".pose", text);
    }
    return text + "\nAll other settings are the defaults of this version.\n\n";
  }
  static void add_leaves(const Json& tree, const std::string& path, std::string& text) {
    if (tree.is_object() && !is_distribution(tree)) {
      for (const auto& [key, member] : tree.items()) add_leaves(member, path + "." + key, text);
    } else {
      text += fmt::format("| {} | {} |\n", code(path), code(text_of_json(tree)));
    }
  }

  std::string labelling() const {
    std::string text =
        "## Preprocessing, cleaning, labelling\n\nNone was done by hand. Labels come from the frame of the "
        "picture.\n\n| label | about |\n|---|---|\n| `png` | the picture, sRGB, 8 bits, after the tone map "
        "|\n";
    for (const api::LabelForm& form : api::label_forms())
      if (s_.labels.has(form.output)) {
        const OutputRow& row = api::row_of(form.output);
        text += fmt::format("| `{}` | {} |\n", row.name, plain(row.help));
      }
    if (s_.landmarks) text += "| `landmarks` | iBUG's 68 points, and two pupils |\n";
    return text + "\n";
  }

  std::string uses() const {
    std::string text = "## Uses\n\n- Intended, done so far, not to be done: **to fill in**\n";
    if (recipe_.identities() < few_identities)
      text += fmt::format(
          "- {} identities do not show how people differ: numbers on the test split say little about other "
          "people\n",
          recipe_.identities());
    return text + "\n";
  }

  std::string distribution() const {
    std::string text =
        "## Distribution\n\n| asset | licence | author | source | changes |\n|---|---|---|---|---|\n";
    for (const Entry& entry : s_.entries)
      text += fmt::format("| {} | {} | {} | {} | {} |\n", plain(entry.asset), plain(entry.licence.spdx),
                          plain(entry.licence.author), plain(entry.licence.source),
                          entry.licence.changes.empty() ? "none" : plain(entry.licence.changes));
    return text + "\n- Licence of the pictures: **to fill in**; those of the assets bind it\n\n";
  }

  std::string maintenance() const {
    std::string text =
        "## Maintenance\n\n- By whom, how long, how mistakes are reported: **to fill in**\n"
        "- `recipe.lock.json` draws the same bytes again on the same class of device, out of these files:\n\n"
        "| file | SHA-256 |\n|---|---|\n";
    for (const Input& input : lock_.inputs)
      text += fmt::format("| {} | {} |\n", plain(input.file), input.hash.sha256);
    if (lock_.inputs.empty()) text += "| none: all is built in | |\n";
    return text;
  }

  const Lock& lock_;
  const Recipe::State& s_;
  Recipe recipe_;
  std::uint64_t there_ = 0;
  std::set<std::string> devices_;
  std::map<std::string, Count> tones_;
};

}  // namespace

std::string datasheet(const fs::path& folder) {
  const Lock lock = load_lock(folder);
  return Datasheet(folder, lock).text();
}

}  // namespace dermis::dataset
