// SPDX-License-Identifier: MIT
#include "dermis/landmarks.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <utility>

#include "api/asset_state.h"
#include "api/scene_state.h"
#include "api/vectors.h"
#include "base/core/error.h"
#include "head/builtin_head/face_points.h"
#include "head/landmarks/known.h"
#include "head/landmarks/places.h"
#include "head/scene/placement.h"
#include "head/scene/rig/rig.h"

namespace dermis {

struct Landmarks::State {
  std::shared_ptr<const scene::AssetData> asset;
  std::array<LandmarkPlace, count> places;
  landmarks::KeptPlaces kept;
};

namespace {

std::shared_ptr<const Landmarks::State> made_state(const Asset& asset, const landmarks::Sidecar& sidecar) {
  const auto data = Asset::State::of(asset);
  return std::make_shared<const Landmarks::State>(
      Landmarks::State{data, sidecar.places, landmarks::kept_places(sidecar, *data)});
}

std::filesystem::path sidecar_of(const std::filesystem::path& file) {
  return std::filesystem::path(file).replace_extension(".landmarks.json");
}

/// By how much the depth changes to the next pixel: of opposite neighbours the nearer one counts, so that an
/// edge beside the point is none.
class DepthPicture {
 public:
  DepthPicture(std::span<const float> depth_m, int width, int height)
      : depth_m_(depth_m), width_(width), height_(height) {}

  bool shows(double x, double y, double depth_m) const {
    // Also keeps numbers within integers, and those that are none out.
    if (!(x > -1 && x < width_ && y > -1 && y < height_)) return false;
    const int left = static_cast<int>(std::floor(x)), up = static_cast<int>(std::floor(y));
    for (const int j : {up, up + 1})
      for (const int i : {left, left + 1})
        if (fits(i, j, depth_m)) return true;
    return false;
  }

 private:
  double at(int i, int j) const {
    if (i < 0 || i >= width_ || j < 0 || j >= height_) return std::numeric_limits<double>::infinity();
    return depth_m_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(i)];
  }
  bool fits(int i, int j, double depth_m) const {
    const double slope_m = std::max(change_m(i, j, 1, 0), change_m(i, j, 0, 1));
    return std::abs(at(i, j) - depth_m) <= std::max(1e-3, slope_m);
  }
  double change_m(int i, int j, int across, int down) const {
    const double here = at(i, j);
    const double change =
        std::min(std::abs(at(i - across, j - down) - here), std::abs(at(i + across, j + down) - here));
    return std::isfinite(change) ? change : 0;
  }

  std::span<const float> depth_m_;
  int width_ = 0, height_ = 0;
};

Landmark projected(const ResolvedCamera& camera, const std::array<double, 3>& x_m) {
  std::array<double, 3> c = camera.t_m;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < 3; ++k) c[row] += camera.r[3 * row + k] * x_m[k];
  Landmark found{.position_m = x_m, .depth_m = c[2]};
  if (c[2] < camera.near_m) {
    found.x = found.y = std::numeric_limits<double>::quiet_NaN();
    return found;
  }
  const double z = camera.orthographic ? 1 : c[2];
  found.x = camera.k[0] * c[0] / z + camera.k[2];
  found.y = camera.k[4] * c[1] / z + camera.k[5];
  return found;
}

}  // namespace

std::optional<Landmarks> Landmarks::of(const Asset& asset) {
  const auto& source = Asset::State::source_of(asset);
  const auto data = Asset::State::of(asset);
  if (source && source->file.empty())
    return Landmarks(made_state(asset, {.places = builtin_head::landmark_places(*data)}));
  if (source && std::filesystem::exists(sidecar_of(source->file)))
    return load(asset, sidecar_of(source->file));
  if (const auto known = landmarks::known_landmarks(*data)) return Landmarks(made_state(asset, *known));
  return std::nullopt;
}

Landmarks Landmarks::load(const Asset& asset, const std::filesystem::path& file) {
  const json::Document document = json::load(file, landmarks::most_bytes, landmarks::sidecar_limits);
  const landmarks::Sidecar sidecar = landmarks::read_sidecar(document.root());
  if (const std::string why = landmarks::misfit(sidecar, *Asset::State::of(asset)); !why.empty())
    throw input_error(file.string(), "{}", why);
  return Landmarks(made_state(asset, sidecar));
}

std::span<const LandmarkPlace, Landmarks::count> Landmarks::places() const { return state_->places; }

std::vector<std::array<double, 3>> Landmarks::positions_m(const Scene& scene, InstanceId id) const {
  const auto& instances = scene.state().instances;
  const auto instance = std::ranges::find(instances, id, &Scene::State::Entry::id);
  if (instance == instances.end())
    throw input_error("", "no instance {} in this scene", static_cast<std::uint32_t>(id));
  if (Asset::State::of(instance->instance.asset) != state_->asset)
    throw input_error("", "instance {} is of another asset than these landmarks of {}",
                      static_cast<std::uint32_t>(id), state_->asset->name);

  const auto in_asset_m = [&](const landmarks::KeptVertex& kept) {
    return instance->placed.posed ? scene::posed_position_m(*state_->asset, instance->placed.posed->rig,
                                                            kept.primitive, kept.vertex)
                                  : glm::dvec3(scene::world_position_m(
                                        state_->asset->primitives[kept.primitive], 0, kept.vertex));
  };
  const std::array<double, 16>& m = instance->instance.world_from_asset;
  std::vector<std::array<double, 3>> positions_m;
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 p_m(0);
    for (std::size_t k = 0; k < 3; ++k)
      if (state_->places[i].weights[k] != 0)
        p_m += state_->places[i].weights[k] * in_asset_m(state_->kept[i][k]);
    std::array<double, 3>& world_m = positions_m.emplace_back();
    for (std::size_t k = 0; k < 3; ++k)
      world_m[k] = m[k] * p_m.x + m[4 + k] * p_m.y + m[8 + k] * p_m.z + m[12 + k];
  }
  return positions_m;
}

std::vector<Landmark> Landmarks::in_picture(const Scene& scene, InstanceId id, const ResolvedCamera& camera,
                                            std::span<const float> depth_m) const {
  const auto pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  if (depth_m.size() != pixels)
    throw input_error("", "depth_m has {} pixels, and the camera's picture {} x {}", depth_m.size(),
                      camera.width, camera.height);
  const DepthPicture picture(depth_m, camera.width, camera.height);
  std::vector<Landmark> found;
  for (const std::array<double, 3>& position_m : positions_m(scene, id)) {
    found.push_back(projected(camera, position_m));
    Landmark& mark = found.back();
    mark.seen = scene.instance(id).visible && picture.shows(mark.x, mark.y, mark.depth_m);
  }
  return found;
}

}  // namespace dermis
