// SPDX-License-Identifier: MIT
#include "kit/plan.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/settings/fields.h"
#include "base/settings/json.h"
#include "base/settings/names.h"

namespace dermis::kit {
namespace {

using Json = nlohmann::ordered_json;

// Values of settings that are numbers or texts: one or two that take another path through a frame.
struct Sample {
  const char* path;
  const char* value;  // JSON
};

constexpr Sample samples[] = {{"camera.fov_deg", "40"},
                              {"camera.distance", "20"},
                              {"camera.orbit_deg", "[60, 20]"},
                              {"camera.eye_m", "[0.3, 0.2, 1]"},
                              {"camera.heads", "4"},

                              {"lighting.rig_lights", "0"},
                              {"lighting.rig_lights", "5"},
                              {"lighting.placed_lights", R"([{"azimuth_deg": 170, "elevation_deg": 10}])"},
                              {"lighting.light_radius_m", "0.1"},
                              {"lighting.ambient", "0"},
                              {"lighting.environment", R"("studio")"},
                              {"lighting.environment_intensity", "2"},
                              {"lighting.environment_rotation_deg", "90"},

                              {"skin.profile", R"("skin")"},
                              {"skin.mix", "0"},
                              {"skin.mix", "1"},

                              {"quality.samples", "1"},
                              {"quality.light_samples", "1"},
                              {"quality.taps", "17"},
                              {"quality.d_ref", "1"},
                              {"quality.clip_margin_mm", "0"},
                              {"quality.map_budget_mb", "8"},

                              {"output.exposure_ev", "null"},
                              {"output.bloom", "0"},
                              {"output.background", R"("studio")"},
                              {"output.background", R"("environment")"},
                              {"output.background", R"("#336699")"},
                              {"output.frames", "3"},
                              {"output.show", R"("irradiance")"},
                              {"output.show", R"("visibility")"},
                              {"output.show", R"("stretch")"},
                              {"output.show", R"("texel-density")"},
                              {"output.show", R"("blur:5")"},
                              {"output.show", R"("shadow:0")"}};

// Settings that a switch needs beside itself to show.
constexpr Sample companions[] = {
    {"camera.eye_m", R"({"camera": {"target_m": [0, 0, 0]}})"},
    {"lighting.environment_intensity", R"({"lighting": {"environment": "studio"}})"},
    {"lighting.environment_rotation_deg", R"({"lighting": {"environment": "studio"}})"},
    {"quality.skip_unseen_heads", R"({"camera": {"heads": 4, "distance": 2.5}})"},
    {"quality.map_budget_mb", R"({"camera": {"heads": 4, "distance": 10}})"}};

// skin.shape_aware needs a file, which knows its medium: the tests of the device write one.
constexpr const char* fixed[] = {"technique",        "camera.name",         "camera.target_m",
                                 "quality.map_size", "quality.shadow_size", "skin.shape_aware",
                                 "output.width",     "output.height"};

Json* place_of(Json& settings, const std::string& path) {
  Json* at = &settings;
  for (std::size_t from = 0, dot; from <= path.size(); from = dot + 1) {
    dot = std::min(path.find('.', from), path.size());
    at = &(*at)[path.substr(from, dot - from)];
  }
  return at;
}

template <class Value>
void add_choices(const std::string& path, const Value& now, std::vector<Switch>& all) {
  const auto add = [&](const Json& value) { all.push_back({path, value.dump()}); };
  if constexpr (is_optional<Value>) {
    using Inner = typename Value::value_type;
    if constexpr (std::is_same_v<Inner, bool>) {
      add(false);
      add(true);
    } else if constexpr (std::is_enum_v<Inner>)
      for (const std::string_view name : names_of<Inner>) add(name);
  } else if constexpr (std::is_same_v<Value, bool>)
    add(!now);
  else if constexpr (std::is_enum_v<Value>) {
    for (const std::string_view name : names_of<Value>)
      if (name != name_of(now)) add(name);
  }
}

const std::vector<Invariant>& all_invariants() {
  static const std::vector<Invariant> all{
      {"no light is black", "*/EveryTechnique.NoLightIsBlack/*", true},
      {"a white furnace is white", "*/EveryHead.IsWhiteInAWhiteFurnace/*:*/CutOut.WhiteFurnace/*", true},
      {"white surroundings are a white furnace", "*/EveryHeadInSurroundings.IsWhiteInAWhiteFurnace/*", false},
      {"scattering keeps the light", "*/EveryTechnique.ScatteringKeepsTheLight/*", true},
      {"halving the map keeps the colour", "*/EveryTechnique.HalvingTheMapKeepsTheMeanColour/*", true},
      {"two runs are equal to the bit",
       "*/EveryTechnique.TwoRunsAreBitEqual/*:*.ThePictureDoesNotDependOnTheNumberOfFrames/*", true},
      {"validation is silent", "*ValidationIsSilent*", true},
      {"a knife edge is blurred as computed", "KnifeEdge.*", true},
      {"bands of a small sphere are damped as computed", "SmallSphere.*", true},
      {"counts are what they say", "FrameStatistics.*", true},
      {"optimisations do not show", "OnTheScan.*", true},
      {"optimisations show from no side", "Views.*:*ScanInSurroundings.*", false},
      {"nothing unlit is read", "*Stale*.*:CoarseHeads.*", false},
      {"seams do not show", "Seams*.*", false},
      {"device and processor agree on tone maps", "ToneMapAgreement.*", true},
      {"device and processor agree on light", "Agreement.*", false},
      {"surroundings", "Surroundings.*:*/EveryTechniqueInSurroundings.*", false},
      {"light comes through the body as computed", "Slab.*:Ear.*", false},
      {"skin knows its shape", "ShapeAware.*", false},
      {"soft shadows are as computed", "SoftShadow.*:SoftScan.*", false},
      {"instances", "Instances.*:Nodes.*:MemoryOfHeads.*", false},
      {"sessions are steady and draw the same", "Sessions.*:ScanSessions.*", false},
      {"labels", "Labels.*:ScanLabels.*:Outputs.*", false},
      {"backgrounds", "*/Background.*:Backgrounds.*", false},
      {"skin is shaded as its ids say", "*/Shading.*:Shading*.*", false},
      {"texels lit in compute are those that are drawn", "Texels.*:*TexelPictures*.*", false},
      {"techniques in screen space", "Separable.*:BurleyDisc.*:ScreenSpace.*", true},
      {"without width all techniques make one picture", "*/ZeroWidth.*", false},
      {"error against ground truth", "Truth*.*", false},
      {"the device does what is asked of it",
       "Devices.*:Memory.*:SmallHeap.*:Transfer.*:Pipelines.*:Draw.*:External.*:Validation.*", true}};
  return all;
}

}  // namespace

const char* name_of(Extent extent) {
  switch (extent) {
    case Extent::full: return "full";
    case Extent::quick: return "quick";
    case Extent::smoke: return "smoke";
  }
  return "";
}

Json Switch::value() const { return Json::parse(text); }

bool is_of_light_maps(const std::string& path) {
  return path.starts_with("skin.") || (path.starts_with("quality.") && path != "quality.samples");
}

bool is_fixed(const std::string& path) { return std::ranges::find(fixed, path) != std::end(fixed); }

std::vector<Switch> switches(Extent extent) {
  std::vector<Switch> all{{"", "null"}};
  if (extent == Extent::smoke) {
    all.push_back({"quality.mask", R"("alpha")"});
    return all;
  }

  const RenderSettings defaults;
  for_each_setting(defaults, [&](const std::string& path, const About&, const auto& now, std::string_view) {
    if (is_fixed(path)) return;
    const std::size_t before = all.size();
    add_choices(path, now, all);
    for (const Sample& sample : samples)
      if (path == sample.path) all.push_back({path, sample.value});
    if (all.size() == before)
      throw std::logic_error("the kit has no value for the setting " + path + "; plan.cpp needs one");
  });
  return all;
}

Json settings_with(const std::string& technique, const Switch& change) {
  Json settings = {{"technique", technique},
                   {"quality", {{"map_size", 256}, {"shadow_size", 256}}},
                   {"output", {{"width", 192}, {"height", 120}}}};
  for (const Sample& companion : companions)
    if (change.path == companion.path) settings.update(Json::parse(companion.value), true);
  if (!change.path.empty()) *place_of(settings, change.path) = change.value();
  return settings;
}

std::vector<Invariant> invariants(Extent extent) {
  std::vector<Invariant> chosen = all_invariants();
  if (extent == Extent::quick) std::erase_if(chosen, [](const Invariant& i) { return !i.quick; });
  if (extent == Extent::smoke) chosen.resize(1);
  return chosen;
}

}  // namespace dermis::kit
