// SPDX-License-Identifier: MIT
#include "viewer/model/easel.h"

#include <chrono>
#include <utility>

#include "api/shader_scope.h"
#include "dermis/error.h"
#include "viewer/model/camera_moves.h"
#include "viewer/model/memory.h"

namespace dermis::viewer {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// A session has all that any camera may need, so pictures follow at once. A prepared frame has the needs of
// one view: for a picture at rest, which costs less after a change of the profile. It also times passes,
// chooses an exposure and shows maps; labels are the session's.
bool needs_prepared(const Wish& wish) {
  if (wish.settings.output.show != "picture") return true;
  if (wish.moving) return false;
  return wish.timed || !wish.labels || !wish.settings.output.exposure_ev;
}

}  // namespace

Renderer& Easel::renderer() {
  if (renderer_) return *renderer_;
  const api::ShaderScope scope([shaders = shaders_](std::string_view name) {
    const auto found = shaders->find(name);
    return found == shaders->end() ? std::span<const std::uint32_t>() : std::span(found->second);
  });
  return renderer_.emplace(options_);
}

Session& Easel::session(bool moving, bool labels) {
  if (moving) {
    if (!moving_) moving_.emplace(renderer(), Session::Options{.frames_in_flight = 1});
    return *moving_;
  }
  if (resting_ && resting_has_labels_ != labels) resting_.reset();
  resting_has_labels_ = labels;
  if (!resting_)
    resting_.emplace(renderer(), Session::Options{.frames_in_flight = 1,
                                                  .statistics = true,
                                                  .wanted = labels ? Outputs::all() : Outputs::picture()});
  return *resting_;
}

Painted Easel::draw(const Wish& wish) {
  const auto start = std::chrono::steady_clock::now();
  if (before_drawing_) before_drawing_();
  Painted painted = needs_prepared(wish) ? draw_prepared(wish) : draw_in_session(wish);
  painted.revision = wish.revision;
  painted.serial = wish.serial;
  painted.moving = wish.moving;
  painted.is_b = wish.is_b;
  painted.ms = ms_since(start);
  device_name_ = painted.picture.statistics.device;
  return painted;
}

Painted Easel::draw_in_session(const Wish& wish) {
  RenderSettings settings = wish.moving ? pace_.settings(wish.settings) : wish.settings;
  if (!settings.output.exposure_ev) settings.output.exposure_ev = wish.exposure_ev;

  Session& session = this->session(wish.moving, wish.labels && !wish.moving);
  const auto start = std::chrono::steady_clock::now();
  const Ticket ticket = session.draw(wish.scene, settings);
  Painted painted{.picture = session.picture(ticket)};
  if (wish.labels && !wish.moving) {
    painted.labels = session.results(ticket);
    painted.camera = drawn_camera(wish.scene, settings);
    if (wish.light) painted.light = light_map(wish, settings);
  }

  if (wish.moving) {
    painted.divisor = pace_.divisor();
    pace_.drew(ms_since(start));
  }
  return painted;
}

PreparedFrame& Easel::prepared(const Scene& scene, RenderSettings settings) {
  settings.output.frames = 1;
  if (!prepared_) return prepared_.emplace(renderer().prepare(scene, settings));
  prepared_->set(scene, settings);
  return *prepared_;
}

// None: the technique has no such map, or its nearest head does not read it.
std::optional<LightMap> Easel::light_map(const Wish& wish, const RenderSettings& drawn) {
  RenderSettings settings = drawn;
  settings.output.show = "irradiance";
  try {
    Picture map = prepared(wish.scene, settings).picture();
    return LightMap{
        .side = map.width, .rgba = std::move(map.linear_rgba), .exposure_ev = map.statistics.exposure_ev};
  } catch (const InputError&) { return {}; }
}

Painted Easel::draw_prepared(const Wish& wish) {
  RenderSettings settings = wish.moving ? pace_.settings(wish.settings) : wish.settings;
  if (wish.moving && !settings.output.exposure_ev) settings.output.exposure_ev = wish.exposure_ev;
  PreparedFrame& frame = prepared(wish.scene, settings);
  if (wish.timed) frame.draw();
  Painted painted{.picture = frame.picture()};
  if (wish.moving) painted.divisor = pace_.divisor();
  return painted;
}

void Easel::save(const SaveWish& wish) {
  if (before_drawing_) before_drawing_();
  RenderSettings settings = wish.settings;
  settings.output.frames = 1;
  renderer().render(wish.scene, settings).save(wish.file);
}

// A pipeline is kept as long as its renderer, so there is another one.
void Easel::use_shaders(std::shared_ptr<const ShaderSet> shaders) {
  renew();
  shaders_ = std::move(shaders);
}

void Easel::renew() {
  if (renderer_) {
    const std::vector<std::string> messages = renderer_->validation_messages();
    said_.insert(said_.end(), messages.begin(), messages.end());
  }
  prepared_.reset();
  moving_.reset();
  resting_.reset();
  renderer_.reset();
  return_free_memory();
}

std::vector<std::string> Easel::validation_messages() const {
  std::vector<std::string> all = said_;
  if (renderer_) {
    const std::vector<std::string> messages = renderer_->validation_messages();
    all.insert(all.end(), messages.begin(), messages.end());
  }
  return all;
}

}  // namespace dermis::viewer
