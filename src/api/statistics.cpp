// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "base/settings/json.h"
#include "dermis/renderer.h"

namespace dermis {

std::string Statistics::json() const {
  nlohmann::ordered_json j;
  j["dermis"] = DERMIS_VERSION;
  j["device"] = device;
  j["driver"] = driver;
  j["api"] = api;
  j["technique"] = technique;
  j["settings"] = json_of(settings);
  j["optimise"] = optimise;
  j["mask"] = mask.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(mask);

  j["size"] = {width, height};
  j["map_size"] = map_size;
  j["heads"] = heads;
  j["distance"] = distance ? nlohmann::ordered_json(*distance) : nlohmann::ordered_json(nullptr);
  j["lights"] = lights;
  j["environment_lights"] = environment_lights;
  j["gaussians"] = gaussians;
  j["translucency"] = translucency;
  j["shape_aware"] = shape_aware;
  j["tone_map"] = tone_map;
  j["exposure_ev"] = exposure_ev;
  j["skin_mean"] = skin_mean ? nlohmann::ordered_json(*skin_mean) : nlohmann::ordered_json(nullptr);

  j["frame_ms"] = {
      {"median", frame_ms_median}, {"min", frame_ms_min}, {"max", frame_ms_max}, {"frames", frames}};
  j["passes"] = nlohmann::ordered_json::array();
  for (const PassStatistics& pass : passes)
    j["passes"].push_back({{"name", pass.name},
                           {"ms", pass.ms},
                           {"calls", pass.calls},
                           {"texels", pass.texels},
                           {"image_bytes", pass.image_bytes}});
  j["load_ms"] = load_ms;
  j["upload_ms"] = upload_ms;
  j["pipeline_ms"] = pipeline_ms;
  j["timing"] = timing;

  j["skin_materials"] = skin_materials;
  j["skin_pixels"] = skin_pixels;
  j["d_ref"] = d_ref;
  j["texels"] = {{"irradiance", irradiance_texels},
                 {"convolved", convolved_texels},
                 {"launched", launched},
                 {"unshaded_reads", unshaded_reads},
                 {"transmission_misses", transmission_misses},
                 {"light_reads", light_reads},
                 {"used_size", used_size},
                 {"mapped_terms", mapped_terms}};

  j["shadow_maps_drawn"] = shadow_maps_drawn;
  j["barriers"] = recorded.barriers;
  j["dispatches"] = recorded.dispatches;
  j["renderings"] = recorded.renderings;
  j["draws"] = recorded.draws;
  j["switches"] = recorded.switches;
  j["cleared_pixels"] = recorded.cleared_pixels;
  j["memory_bytes"] = {{"images", image_bytes},
                       {"buffers", buffer_bytes},
                       {"peak", peak_bytes},
                       {"light_maps", light_map_bytes}};
  return j.dump(2) + "\n";
}

}  // namespace dermis
