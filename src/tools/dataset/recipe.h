// SPDX-License-Identifier: MIT
// A recipe, as the rest of the room reads it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/json/document.h"
#include "dermis/dataset.h"
#include "dermis/outputs.h"
#include "dermis/scene.h"
#include "dermis/settings.h"
#include "tools/dataset/distribution.h"

namespace dermis::dataset {

inline constexpr int schema = 1;  ///< of recipes, samples, manifests and locks

/// People who are made of one asset: as many as `count`, each with morph weights and options of its own.
struct Entry {
  std::string asset;  ///< as the recipe names it
  std::uint64_t count = 1;
  Licence licence;       ///< empty spdx: the recipe says none
  Json options, morphs;  ///< objects with distributions
  Json pose;             ///< likewise; null: that of the recipe
};

/// The person of a sample, and the picture of that person.
struct Place {
  std::uint64_t sample = 0;
  std::uint64_t sitting = 0, view = 0;  ///< a sitting has views_per_identity views
  std::uint64_t identity = 0;           ///< of all of the recipe
  std::size_t entry = 0;
  std::uint64_t member = 0;  ///< of the entry
  bool test = false;
};

struct Recipe::State {
  Json json;         ///< its keys sorted
  std::string text;  ///< the same, on one line
  std::string sha256;
  std::filesystem::path folder;  ///< names of files are relative to it
  std::string name;
  std::uint32_t seed = 0;
  std::uint64_t samples = 0, per_shard = 0, views = 1;
  double test_share = 0;
  int width = 0, height = 0;  ///< pixels
  Outputs labels;
  bool landmarks = false;  ///< a label, too: a file of points
  std::vector<Entry> entries;
  Json settings, head, pose;
  std::vector<std::string> shared;         ///< paths whose values the views of a sitting share
  std::vector<std::uint64_t> train, test;  ///< numbers of identities
  std::uint64_t train_samples = 0;         ///< before those of the test split

  static Recipe recipe(std::shared_ptr<const State> state) { return Recipe(std::move(state)); }

  std::uint64_t train_shards() const { return (train_samples + per_shard - 1) / per_shard; }
  Place place_of(std::uint64_t sample) const;  ///< throws InputError: no such sample
  Json parameters(const Place& place) const;
  /// Returns the name of a file as this machine finds it.
  std::string file(const std::string& name) const;
};

/// Place of a head in the scene.
struct HeadPlace {
  std::array<double, 3> turn_deg{0, 0, 0};  ///< yaw, pitch, roll about the middle of its sphere
  std::array<double, 3> tint{1, 1, 1};
  std::optional<double> mix{};
};

// Read the objects of parameters(); names of files become those of this machine. Throw InputError with the
// place.
RenderSettings settings_of(const Recipe::State& recipe, const Json& settings);
SceneOptions options_of(const Recipe::State& recipe, const Json& options);
HeadPlace head_of(const Json& head);
/// The morph weights of the identity, then what the pose says. None: nothing moves.
std::optional<RigPose> pose_of(const Json& morphs, const Json& pose);

/// Holds the ends of all distributions against the rows of the settings. InputError names the place.
void check_values(const Recipe::State& recipe);

}  // namespace dermis::dataset
