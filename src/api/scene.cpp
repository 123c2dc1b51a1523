// SPDX-License-Identifier: MIT
#include "dermis/scene.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <utility>

#include "api/asset_state.h"
#include "api/rig_pose.h"
#include "api/scene_state.h"
#include "api/vectors.h"
#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "environment/environment.h"
#include "head/scene/views.h"
#include "tissue/gaussians/scatter_profile.h"

namespace dermis {
namespace {

using api::array_of, api::vector_of;

// Numbers of edits are of the whole program, so that copies of a scene never give one number to two contents.
std::uint64_t next_change() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

// Entries are sorted by their ids: each new one is larger than all before.
template <class Entries, class Id>
auto find(Entries& entries, Id id, const char* what) {
  const auto found = std::lower_bound(entries.begin(), entries.end(), id,
                                      [](const auto& entry, Id wanted) { return entry.id < wanted; });
  if (found == entries.end() || found->id != id)
    throw input_error("", "no {} {} in this scene", what, static_cast<std::uint32_t>(id));
  return found;
}

void require(bool holds, const char* member, const std::string& what, double got) {
  if (!holds) throw input_error("", "{} must be {}, got {}", member, what, got);
}

void require_finite(const std::array<double, 3>& values, const char* member) {
  for (const double value : values)
    require(std::isfinite(value) && std::abs(value) <= 1e9, member, "finite, at most 1e9 in size", value);
}

scene::Similarity checked_transform(const std::array<double, 16>& world_from_asset) {
  const std::optional<scene::Similarity> checked = scene::similarity_of(world_from_asset);
  if (!checked)
    throw input_error("",
                      "world_from_asset must be rigid with one positive scale (1e-3 to 1e3). So it is a "
                      "rotation times a number, a shift of up to 1e9 m, and 0 0 0 1 in the last row");
  return *checked;
}

std::optional<ScatterProfile> checked_profile(const std::optional<ScatterProfile>& profile) {
  return profile ? std::optional(gaussians::checked_profile(*profile)) : std::nullopt;
}

std::optional<float> float_of(std::optional<double> value) {
  return value ? std::optional(static_cast<float>(*value)) : std::nullopt;
}

void check_mix(std::optional<double> mix) {
  if (mix) require(*mix >= 0 && *mix <= 1, "mix", "0 to 1", *mix);
}

void check_tint(const std::array<double, 3>& tint) {
  for (const double value : tint) require(value >= 0 && value <= 100, "tint", "0 to 100", value);
}

void check_light(const Light& light) {
  if (light.type > LightType::point)
    throw input_error("", "light.type is no known kind: {}", static_cast<int>(light.type));
  for (const double value : light.colour)
    require(value >= 0 && value <= 1e9, "light.colour", "0 to 1e9", value);
  require_finite(light.position_m, "light.position_m");
  require_finite(light.direction, "light.direction");
  require(light.range_m >= 0 && light.range_m <= 1e9, "light.range_m", "0 to 1e9", light.range_m);
  require(light.radius >= 0 && light.radius <= 1e6, "light.radius", "0 to 1e6", light.radius);

  if (light.type != LightType::point) {
    const auto& [x, y, z] = light.direction;
    require(std::hypot(x, y, z) > 1e-12, "light.direction", "longer than 0", std::hypot(x, y, z));
  }
  if (light.type != LightType::spot) return;
  const double outer = light.outer_cone_deg, inner = light.inner_cone_deg;
  // A right angle that was rounded to a float is a little more.
  require(outer > 0 && outer <= 90.001, "light.outer_cone_deg", "over 0, at most 90", outer);
  require(inner >= 0 && inner < outer, "light.inner_cone_deg", "0 to below light.outer_cone_deg", inner);
}

void check_environment(const SceneEnvironment& e) {
  if (!e.file.empty() && e.rgb)
    throw input_error("", "environment.file and environment.rgb exclude each other");
  if (!e.file.empty()) return;
  if (!e.rgb) throw input_error("", "environment.rgb must not be null where environment.file is empty");
  environment::check_size("environment", e.width, e.height, e.rgb->size());
  if (!std::all_of(e.rgb->begin(), e.rgb->end(), [](float value) { return std::isfinite(value); }))
    throw input_error("", "environment.rgb has a value that is not finite");
}

}  // namespace

Scene::Scene() : state_(std::make_unique<State>()) {}
Scene::Scene(const Scene& other) : state_(std::make_unique<State>(*other.state_)) {}
Scene::Scene(Scene&& other) noexcept : state_(std::exchange(other.state_, std::make_unique<State>())) {}
Scene& Scene::operator=(const Scene& other) {
  if (this != &other) state_ = std::make_unique<State>(*other.state_);
  return *this;
}
Scene& Scene::operator=(Scene&& other) noexcept {
  std::swap(state_, other.state_);
  return *this;
}
Scene::~Scene() = default;

Scene::Scene(const Asset& asset) : Scene() {
  const InstanceId id = add({.asset = asset});
  // As the file has them: its loader has checked them.
  const std::vector<Light> lights = asset.lights();
  for (std::size_t i = 0; i < lights.size(); ++i)
    state_->lights.push_back({.id = LightId{state_->next_id++},
                              .light = {.light = lights[i]},
                              .carrier = State::Carrier{.instance = id, .number = i}});
  state_->light_changes = next_change();
}

std::string Scene::name() const {
  if (!state_->name.empty()) return state_->name;
  if (state_->instances.size() == 1) return state_->instances.front().instance.asset.name();
  return fmt::format("scene of {} instances", state_->instances.size());
}

InstanceId Scene::add(const Instance& instance) {
  if (!Asset::State::of(instance.asset)) throw input_error("", "an instance has no asset: it was moved away");
  check_mix(instance.mix);
  check_tint(instance.tint);
  State::Entry entry{.id = InstanceId{state_->next_id},
                     .instance = instance,
                     .placed = {.asset = {},
                                .world_from_asset = checked_transform(instance.world_from_asset),
                                .posed = api::posed_asset(*Asset::State::of(instance.asset), instance.pose),
                                .visible = instance.visible,
                                .profile = checked_profile(instance.profile),
                                .mix = float_of(instance.mix),
                                .tint = glm::vec3(api::vector_of(instance.tint))},
                     .changes = {.pose = next_change(), .material = next_change(), .rig = next_change()}};

  ++state_->next_id;
  state_->instances.push_back(std::move(entry));
  return state_->instances.back().id;
}

void Scene::remove(InstanceId id) {
  const auto removed = find(state_->instances, id, "instance");
  for (State::PlacedLight& placed : state_->lights)
    if (placed.carrier && placed.carrier->instance == id) {
      placed.light.light = api::light_now(*state_, placed);
      placed.carrier.reset();
    }
  state_->instances.erase(removed);
  if (std::erase_if(state_->lights, [&](const State::PlacedLight& l) { return l.light.rig == id; }) > 0)
    state_->light_changes = next_change();
}

std::vector<InstanceId> Scene::instances() const {
  std::vector<InstanceId> ids;
  for (const State::Entry& entry : state_->instances) ids.push_back(entry.id);
  return ids;
}

const Instance& Scene::instance(InstanceId id) const {
  return find(state_->instances, id, "instance")->instance;
}

void Scene::set_transform(InstanceId id, const std::array<double, 16>& world_from_asset) {
  State::Entry& entry = *find(state_->instances, id, "instance");
  entry.placed.world_from_asset = checked_transform(world_from_asset);
  entry.instance.world_from_asset = world_from_asset;
  entry.changes.pose = next_change();
  // The lights of its rig move with it.
  if (std::any_of(state_->lights.begin(), state_->lights.end(),
                  [&](const State::PlacedLight& light) { return light.light.rig == id; }))
    state_->light_changes = entry.changes.pose;
}

void Scene::set_visible(InstanceId id, bool visible) {
  State::Entry& entry = *find(state_->instances, id, "instance");
  entry.instance.visible = entry.placed.visible = visible;
  entry.changes.pose = next_change();
}

void Scene::set_profile(InstanceId id, const std::optional<ScatterProfile>& profile) {
  State::Entry& entry = *find(state_->instances, id, "instance");
  entry.placed.profile = checked_profile(profile);
  entry.instance.profile = profile;
  entry.changes.material = next_change();
}

void Scene::set_mix(InstanceId id, std::optional<double> mix) {
  State::Entry& entry = *find(state_->instances, id, "instance");
  check_mix(mix);
  entry.instance.mix = mix;
  entry.placed.mix = float_of(mix);
  entry.changes.material = next_change();
}

void Scene::set_tint(InstanceId id, const std::array<double, 3>& tint) {
  State::Entry& entry = *find(state_->instances, id, "instance");
  check_tint(tint);
  entry.instance.tint = tint;
  entry.placed.tint = glm::vec3(api::vector_of(tint));
  entry.changes.material = next_change();
}

void Scene::set_pose(InstanceId id, const std::optional<RigPose>& pose) {
  State::Entry& entry = *find(state_->instances, id, "instance");
  entry.placed.posed = api::posed_asset(*Asset::State::of(entry.instance.asset), pose);
  entry.instance.pose = pose;
  entry.changes.rig = next_change();
  if (std::any_of(state_->lights.begin(), state_->lights.end(), [&](const State::PlacedLight& light) {
        return light.carrier && light.carrier->instance == id;
      }))
    state_->light_changes = entry.changes.rig;
}

void Scene::pose(InstanceId id, const std::string& clip, double seconds) {
  set_pose(id, RigPose{.clip = ClipTime{.clip = clip, .seconds = seconds}});
}

LightId Scene::add_light(const SceneLight& light) {
  check_light(light.light);
  if (light.rig) find(state_->instances, *light.rig, "instance");
  state_->lights.push_back({.id = LightId{state_->next_id++}, .light = light});
  state_->light_changes = next_change();
  return state_->lights.back().id;
}

void Scene::remove_light(LightId id) {
  state_->lights.erase(find(state_->lights, id, "light"));
  state_->light_changes = next_change();
}

std::vector<LightId> Scene::lights() const {
  std::vector<LightId> ids;
  for (const State::PlacedLight& placed : state_->lights) ids.push_back(placed.id);
  return ids;
}

const SceneLight& Scene::light(LightId id) const { return find(state_->lights, id, "light")->light; }

void Scene::set_light(LightId id, const SceneLight& light) {
  State::PlacedLight& placed = *find(state_->lights, id, "light");
  check_light(light.light);
  if (light.rig) find(state_->instances, *light.rig, "instance");
  placed.light = light;
  placed.carrier.reset();
  state_->light_changes = next_change();
}

void Scene::set_environment(const std::optional<SceneEnvironment>& environment) {
  if (environment) check_environment(*environment);
  state_->environment = environment;
  state_->environment_changes = next_change();
}

const std::optional<SceneEnvironment>& Scene::environment() const { return state_->environment; }

InstanceChanges Scene::changes(InstanceId id) const {
  return find(state_->instances, id, "instance")->changes;
}
std::uint64_t Scene::light_changes() const { return state_->light_changes; }
std::uint64_t Scene::environment_changes() const { return state_->environment_changes; }

namespace api {

const scene::AssetData& only_asset(const Scene& scene) {
  DERMIS_ASSERT_EQ(scene.state().instances.size(), std::size_t{1});
  return *Asset::State::of(scene.state().instances.front().instance.asset);
}

Light light_now(const Scene::State& scene, const Scene::State::PlacedLight& placed) {
  Light light = placed.light.light;
  if (!placed.carrier) return light;
  const auto& instance = *find(scene.instances, placed.carrier->instance, "instance");
  if (!instance.placed.posed) return light;

  scene::Light moved;
  scene::stand_at(instance.placed.posed->rig.lights.at(placed.carrier->number), moved);
  light.position_m = array_of(moved.position_m);
  light.direction = array_of(moved.direction);
  return light;
}

Light light_of(const scene::Light& light) {
  constexpr double degrees_per_radian = 180 / std::numbers::pi;
  return {.name = light.name,
          .type = light.type,
          .colour = array_of(light.colour),
          .position_m = array_of(light.position_m),
          .direction = array_of(light.direction),
          .range_m = light.range_m,
          .inner_cone_deg = light.inner_cone_rad * degrees_per_radian,
          .outer_cone_deg = std::min(light.outer_cone_rad * degrees_per_radian, 90.0),
          .radius = light.radius};
}

scene::Light placed_light(const Light& light, const scene::Similarity& world_from_rig) {
  constexpr double radians_per_degree = std::numbers::pi / 180;
  glm::dvec3 direction = vector_of(light.direction);
  // A direction of unit length stays as it is, to the bit.
  if (const double length = glm::length(direction); std::abs(length - 1) > 1e-6) direction /= length;

  // A rig grows with its head, and what arrives from its lamps stays.
  const bool near = light.type != LightType::directional;
  const float scale = near ? world_from_rig.scale : 1;
  return {.name = light.name,
          .type = light.type,
          .colour = glm::vec3(vector_of(light.colour)) * scale * scale,
          .position_m = world_from_rig.position(glm::vec3(vector_of(light.position_m))),
          .direction = world_from_rig.direction(glm::vec3(direction)),
          .range_m = static_cast<float>(light.range_m) * scale,
          .inner_cone_rad = static_cast<float>(light.inner_cone_deg * radians_per_degree),
          .outer_cone_rad = static_cast<float>(light.outer_cone_deg * radians_per_degree),
          .radius = static_cast<float>(light.radius) * scale};
}

setup::PlacedScene placed_scene(const Scene& scene) {
  const Scene::State& state = scene.state();
  setup::PlacedScene placed{.name = scene.name(), .instances = {}, .lights = {}};
  for (const Scene::State::Entry& from : state.instances) {
    setup::PlacedInstance& to = placed.instances.emplace_back(from.placed);
    to.asset = Asset::State::of(from.instance.asset);
    to.posed_change = from.changes.rig;
  }

  for (const Scene::State::PlacedLight& light : state.lights) {
    scene::Similarity rig;
    if (light.light.rig) rig = find(state.instances, *light.light.rig, "instance")->placed.world_from_asset;
    placed.lights.push_back(placed_light(light_now(state, light), rig));
  }
  return placed;
}

}  // namespace api
}  // namespace dermis
