// SPDX-License-Identifier: MIT
// Draws samples: assets, scene, session.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dermis/camera.h"
#include "dermis/landmarks.h"
#include "dermis/session.h"
#include "tools/dataset/lock.h"
#include "tools/dataset/recipe.h"

namespace dermis::dataset {

/// Rounds all numbers to multiples of 1 / steps.
void round_numbers(Json& json, double steps);

/// A sample on its way.
struct Ordered {
  Place place;
  Json json;  ///< the parameters, then the camera
  Ticket ticket{};
  /// For its landmarks, which wait for the depths; none: they are not wanted.
  struct Posed {
    Scene scene;
    Landmarks landmarks;
    ResolvedCamera camera;
  };
  std::optional<Posed> posed;
};

/// A drawn sample.
struct Drawn {
  Place place;
  Json json;
  Results results;
  std::vector<Landmark> landmarks;  ///< empty: not wanted
};

/// One thread at a time may use it.
class Studio {
 public:
  /// Throws DeviceError: no such device.
  Studio(std::shared_ptr<const Recipe::State> recipe, std::string device, const Hooks& hooks);

  /// Begins to draw, and returns while the device works: results() of the sample before may be asked for
  /// until then. Throws InputError that names recipe, sample, identity and parameter; DeviceError.
  Ordered begin(std::uint64_t sample);
  Drawn finish(Ordered&& ordered);
  /// Opens the device anew after it was lost. Assets stay.
  void reopen();

  /// The scene of the sample that was begun last.
  const Scene& scene() const { return heads_.front().scene; }

  /// So far; one that was kept is not loaded again.
  std::uint64_t heads_loaded() const { return heads_loaded_; }

  /// Of the device that draws. Draws sample 0 if none was drawn.
  DeviceClass device_class();

 private:
  struct Kept {
    std::string key;
    Scene scene;
    std::array<double, 3> centre_m{};
    std::optional<Landmarks> landmarks;
  };
  Kept& head_of_sample(const Json& identity);
  Ordered ordered(const Place& place);

  std::shared_ptr<const Recipe::State> recipe_;
  std::string device_;
  Hooks hooks_;
  std::deque<Kept> heads_;  ///< the one used last is in front
  std::uint64_t heads_loaded_ = 0;
  std::optional<Renderer> renderer_;
  std::optional<Session> session_;
  std::optional<DeviceClass> class_;
};

}  // namespace dermis::dataset
