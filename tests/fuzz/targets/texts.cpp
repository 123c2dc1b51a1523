// SPDX-License-Identifier: MIT
// Scene files, profiles in all the forms in which they are read, and records of the benchmark.
#include <cmath>
#include <memory>
#include <string>

#include "api/prepare/scene_file.h"
#include "api/scene_state.h"
#include "cli/bench/recorded.h"
#include "support.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/gaussians/json.h"
#include "tissue/optics/layers.h"
#include "tissue/profile/tabulated.h"

namespace dermis::fuzz {
namespace {

/// The text that is written of what was read of this one.
std::string written_again(std::string_view text) {
  const std::filesystem::path path = scratch_folder() / "scene.json";
  const json::Document document(text, path.string(), api::scene_file_limits);
  const api::SceneFile file = api::read_scene_file(document.root(), path, {});

  dermis::Scene::State state = file.scene.state();
  for (std::size_t i = 0; i < state.instances.size(); ++i)
    state.instances[i].instance.asset = Asset::State::make(std::make_shared<const scene::AssetData>(),
                                                           file.assets.at(file.asset_of_instance.at(i)));
  return api::scene_file_text(dermis::Scene::State::make(std::move(state)), path);
}

}  // namespace

bool scene_file(Bytes json) {
  return accepts([&] {
    // What is written of it reads back to the same text.
    const std::string text = written_again(as_text(json));
    DERMIS_ASSERT_EQ(written_again(text), text);
  });
}

bool profile(Bytes json) {
  return accepts([&] {
    const ScatterProfile read = gaussians::parse_json(as_text(json), "profile");

    // What is written of it reads back to the same text.
    const std::string text = gaussians::to_json(read);
    DERMIS_ASSERT_EQ(gaussians::to_json(gaussians::parse_json(text, "written")), text);

    // Weights that need it are normalised to what is accepted as it is.
    const ScatterProfile normalised = gaussians::parse_json(text, "normalised", true);
    gaussians::parse_json(gaussians::to_json(normalised), "written");
  });
}

bool layers(Bytes json) {
  return accepts([&] {
    const optics::RgbLayers read = optics::parse_layers(as_text(json), "layers");
    DERMIS_ASSERT(!read.empty());
    for (const optics::RgbLayer& layer : read)
      for (const double sigma : layer.sigma_a_per_mm) DERMIS_ASSERT(std::isfinite(sigma) && sigma >= 0);
  });
}

bool table(Bytes csv) {
  return accepts([&] {
    for (const profile::ProfilePtr& channel : profile::parse_csv(as_text(csv), "table")) {
      DERMIS_ASSERT(std::isfinite(channel->total()) && channel->total() > 0);
      DERMIS_ASSERT(channel->inner_mm() > 0);
      DERMIS_ASSERT(std::isfinite(channel->outer_mm()));
      for (const double radius_mm : channel->break_points_mm())
        DERMIS_ASSERT(std::isfinite(channel->at(radius_mm)) && channel->at(radius_mm) >= 0);
    }
  });
}

bool exchange(Bytes text) {
  return accepts([&] {
    const gaussians::Imported read = gaussians::parse_import(std::string(as_text(text)), "--import");
    for (std::size_t c = 0; c < 3; ++c) {
      DERMIS_ASSERT(read.total_reflectance[c] > 0 && read.total_reflectance[c] <= 1);
      if (read.is_burley)
        DERMIS_ASSERT(std::isfinite(read.burley_shape_mm[c]) && read.burley_shape_mm[c] > 0);
      else
        optics::check(read.medium[c], "medium");
    }
  });
}

bool benchmark(Bytes json) {
  return accepts([&] {
    const std::filesystem::path path = put_file("bench.json", json);
    const cli::bench::Recorded recorded = cli::bench::read_recorded(path.string());

    const cli::bench::RunComparison same = cli::bench::compare_runs(recorded, recorded);
    DERMIS_ASSERT(same.changes.empty());
    DERMIS_ASSERT(!cli::bench::comparison_text(same).empty());
    DERMIS_ASSERT(!cli::bench::comparison_json(same).empty());
  });
}

}  // namespace dermis::fuzz
