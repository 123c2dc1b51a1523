// SPDX-License-Identifier: MIT
#include "tools/dataset/studio.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "api/prepare/label_forms.h"
#include "base/core/error.h"

namespace dermis::dataset {
namespace {

constexpr std::size_t most_heads = 4;  // in memory, each with its maps
// Digits of cameras: what functions of different machines round differently lies below.
constexpr double camera_steps = 1e9;

/// Turns about a point: yaw to the head's left, pitch down, roll to its left shoulder; column-major.
std::array<double, 16> turned_about(const std::array<double, 3>& centre_m,
                                    const std::array<double, 3>& turn_deg) {
  std::array<double, 3> c{}, s{};
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = std::cos(turn_deg[i] * 3.14159265358979323846 / 180);
    s[i] = std::sin(turn_deg[i] * 3.14159265358979323846 / 180);
  }
  const auto [cy, cp, cr] = c;
  const auto [sy, sp, sr] = s;
  // Roll about z, then pitch about x, then yaw about y.
  const std::array<double, 9> r{cy * cr + sy * sp * sr,
                                -cy * sr + sy * sp * cr,
                                sy * cp,  //
                                cp * sr,
                                cp * cr,
                                -sp,  //
                                -sy * cr + cy * sp * sr,
                                sy * sr + cy * sp * cr,
                                cy * cp};
  std::array<double, 16> m{};
  for (std::size_t row = 0; row < 3; ++row) {
    double moved = 0;
    for (std::size_t column = 0; column < 3; ++column) {
      m[4 * column + row] = r[3 * row + column];
      moved += r[3 * row + column] * centre_m[column];
    }
    m[12 + row] = centre_m[row] - moved;
  }
  m[15] = 1;
  return m;
}

}  // namespace

void round_numbers(Json& json, double steps) {
  if (json.is_number_float()) {
    const double rounded = std::round(json.get<double>() * steps) / steps;
    json = rounded == 0 ? 0.0 : rounded;
  }
  if (json.is_structured())
    for (Json& value : json) round_numbers(value, steps);
}

Studio::Studio(std::shared_ptr<const Recipe::State> recipe, std::string device, const Hooks& hooks)
    : recipe_(std::move(recipe)), device_(std::move(device)), hooks_(hooks) {
  reopen();
}

void Studio::reopen() {
  session_.reset();
  renderer_.reset();
  renderer_.emplace(Renderer::Options{.device = device_, .hooks = hooks_});
  Outputs wanted = Outputs{Output::display} | recipe_->labels;
  if (recipe_->landmarks) wanted = wanted | Outputs{Output::depth};  // says which of them are seen
  session_.emplace(*renderer_, Session::Options{.wanted = wanted});
}

Studio::Kept& Studio::head_of_sample(const Json& identity) {
  const std::string asset = identity["asset"], key = asset + '\0' + identity["options"].dump();
  const auto found = std::ranges::find(heads_, key, &Kept::key);
  if (found != heads_.end()) {
    std::rotate(heads_.begin(), found, found + 1);
    return heads_.front();
  }
  const bool built_in = asset.starts_with("built-in");
  const Asset loaded =
      Asset::load(built_in ? asset : recipe_->file(asset), options_of(*recipe_, identity["options"]), hooks_);
  ++heads_loaded_;
  if (heads_.size() == most_heads) heads_.pop_back();
  heads_.push_front({key, Scene(loaded), loaded.bounds().centre_m, {}});
  if (recipe_->landmarks) heads_.front().landmarks = Landmarks::of(loaded);
  return heads_.front();
}

Ordered Studio::begin(std::uint64_t sample) {
  const Place place = recipe_->place_of(sample);
  try {
    return ordered(place);
  } catch (const InputError& error) {
    throw input_error("recipe '" + recipe_->name + "'", "sample {} (identities[{}], {}): {}", sample,
                      place.entry, recipe_->entries[place.entry].asset, error.what());
  }
}

Ordered Studio::ordered(const Place& place) {
  Ordered out{.place = place, .json = recipe_->parameters(place)};
  const Json& identity = out.json["identity"];
  const RenderSettings settings = settings_of(*recipe_, out.json["settings"]);
  const HeadPlace stands = head_of(out.json["head"]);

  Kept& head = head_of_sample(identity);
  if (recipe_->landmarks && !head.landmarks)
    throw input_error("", "has no landmarks: no NAME.landmarks.json lies beside it");
  const InstanceId id = head.scene.instances().front();
  head.scene.set_pose(id, pose_of(identity["morphs"], out.json["pose"]));
  head.scene.set_transform(id, turned_about(head.centre_m, stands.turn_deg));
  head.scene.set_tint(id, stands.tint);
  head.scene.set_mix(id, stands.mix);

  out.ticket = session_->draw(head.scene, settings);
  const ResolvedCamera camera = resolved_camera(head.scene, settings);
  out.json["camera"] = api::camera_json(camera);
  round_numbers(out.json["camera"], camera_steps);
  if (recipe_->landmarks) out.posed = {head.scene, *head.landmarks, camera};
  if (!class_) {
    const Statistics statistics = session_->statistics(out.ticket);
    class_ = DeviceClass{statistics.device, statistics.driver, statistics.api};
  }
  return out;
}

Drawn Studio::finish(Ordered&& ordered) {
  Drawn drawn{ordered.place, std::move(ordered.json), session_->results(ordered.ticket), {}};
  if (const auto& posed = ordered.posed)
    drawn.landmarks = posed->landmarks.in_picture(posed->scene, posed->scene.instances().front(),
                                                  posed->camera, drawn.results.depth_m);
  return drawn;
}

DeviceClass Studio::device_class() {
  if (!class_) finish(begin(0));
  return *class_;
}

}  // namespace dermis::dataset
