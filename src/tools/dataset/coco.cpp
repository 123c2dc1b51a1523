// SPDX-License-Identifier: MIT
// Boxes and keypoints as COCO has them (cocodataset.org, "Data format").
#include <set>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "dermis/landmarks.h"
#include "tools/dataset/boxes.h"
#include "tools/dataset/manifest.h"
#include "tools/dataset/members.h"
#include "tools/dataset/shard_reader.h"

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
      if (lock_.recipe->labels.has(Output::instance)) {
        const std::size_t before = annotations_.size();
        add(i, head, box_of(shard.label(i, "instance"), 0));
        if (lock_.recipe->landmarks && annotations_.size() > before)
          add_keypoints(annotations_.back(), shard.read(i, landmarks_ending));
      }
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
                     {head_category(),
                      {{"id", nose}, {"name", "nose"}, {"supercategory", "head"}},
                      {{"id", ear}, {"name", "ear"}, {"supercategory", "head"}}}},
                    {"images", images_},
                    {"annotations", annotations_}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  Json head_category() const {
    Json category{{"id", head}, {"name", "head"}, {"supercategory", "person"}};
    if (!lock_.recipe->landmarks) return category;
    for (std::size_t i = 1; i <= Landmarks::count - 2; ++i)
      category["keypoints"].push_back(fmt::format("ibug_{}", i));
    category["keypoints"].push_back("right_pupil");
    category["keypoints"].push_back("left_pupil");
    return category;
  }

  // COCO's visibility: 0 not known (nearer than the near plane, or outside the picture), 1 hidden, 2 seen.
  void add_keypoints(Json& annotation, const std::vector<std::byte>& file) const {
    const Json points = Json::parse(reinterpret_cast<const char*>(file.data()),
                                    reinterpret_cast<const char*>(file.data()) + file.size());
    std::size_t known = 0;
    Json keypoints = Json::array();
    for (const Json& point : points.at("points")) {
      const bool there = point[0].is_number() && point[0] >= -0.5 && point[0] < lock_.recipe->width - 0.5 &&
                         point[1] >= -0.5 && point[1] < lock_.recipe->height - 0.5;
      known += there ? 1 : 0;
      for (const Json& value : {there ? point[0] : Json(0), there ? point[1] : Json(0),
                                Json(there ? point[3].get<int>() + 1 : 0)})
        keypoints.push_back(value);
    }
    annotation["keypoints"] = keypoints;
    annotation["num_keypoints"] = known;
  }

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
