// SPDX-License-Identifier: MIT
// Boxes as COCO has them (cocodataset.org, "Data format"). Keypoints belong here once samples have landmarks.
#include <set>

#include "core/error.h"
#include "core/hooks.h"
#include "dataset/boxes.h"
#include "dataset/manifest.h"
#include "dataset/members.h"
#include "dataset/shard_reader.h"

namespace dermis::dataset {
namespace {

constexpr int head = 1, nose = 2, ear = 3;  // categories
constexpr std::uint64_t least_pixels = 4;   // of a nose or an ear

class Coco {
 public:
  explicit Coco(const Lock& lock) : lock_(lock) {
    for (std::size_t i = 0; i < lock.recipe->entries.size(); ++i) {
      const Licence& licence = lock.recipe->entries[i].licence;
      licences_.push_back(
          {{"id", i + 1}, {"name", licence.spdx + ", " + licence.author}, {"url", licence.source}});
    }
  }

  void add_shard(const std::filesystem::path& path, Recipe::Range range) {
    ShardReader shard(*lock_.recipe, path);
    for (std::uint64_t i = range.first; i < range.first + range.count; ++i) {
      const Place place = lock_.recipe->place_of(i);
      images_.push_back({{"id", i},
                         {"file_name", path.filename().string() + "/" + stem_of(*lock_.recipe, i) + ".png"},
                         {"width", lock_.recipe->width},
                         {"height", lock_.recipe->height},
                         {"license", place.entry + 1}});
      if (lock_.recipe->labels.has(Output::instance)) add(i, head, box_of(shard.label(i, "instance"), 0));
      if (!lock_.recipe->labels.has(Output::region)) continue;
      const image::Image8 regions = shard.label(i, "region");
      for (const Box& box : boxes_of_parts(regions, Results::nose, least_pixels)) add(i, nose, box);
      for (const Box& box : boxes_of_parts(regions, Results::ear, least_pixels)) add(i, ear, box);
    }
  }

  std::string text() const {
    const Json json{{"info",
                     {{"description", lock_.recipe->name},
                      {"version", DERMIS_VERSION},
                      {"recipe_sha256", lock_.recipe->sha256}}},
                    {"licenses", licences_},
                    {"categories",
                     {{{"id", head}, {"name", "head"}, {"supercategory", "person"}},
                      {{"id", nose}, {"name", "nose"}, {"supercategory", "head"}},
                      {{"id", ear}, {"name", "ear"}, {"supercategory", "head"}}}},
                    {"images", images_},
                    {"annotations", annotations_}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  void add(std::uint64_t image, int category, const Box& box) {
    if (box.area == 0) return;
    annotations_.push_back({{"id", annotations_.size() + 1},
                            {"image_id", image},
                            {"category_id", category},
                            {"bbox", {box.x, box.y, box.width, box.height}},
                            {"area", box.area},
                            {"iscrowd", 0}});
  }

  const Lock& lock_;
  Json licences_ = Json::array(), images_ = Json::array(), annotations_ = Json::array();
};

}  // namespace

std::string coco(const std::filesystem::path& folder) {
  const Lock lock = load_lock(folder);
  if (!lock.recipe->labels.has_any({Output::instance, Output::region}))
    throw input_error(folder.string(),
                      "has no boxes: they come from the labels instance and region, and its recipe "
                      "has neither");
  const Recipe recipe = recipe_of(lock);
  Coco coco(lock);
  const std::vector<std::uint64_t> shards = shards_there(folder, recipe);
  Steps steps("reading shards", shards.size());
  for (const std::uint64_t shard : shards) {
    coco.add_shard(shard_path(folder, recipe, shard), recipe.samples_of(shard));
    steps.done();
  }
  return coco.text();
}

}  // namespace dermis::dataset
