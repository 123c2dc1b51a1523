// SPDX-License-Identifier: MIT
/// Draws the pictures of the window: a renderer with a session for pictures that change, one for pictures at
/// rest, and a frame whose passes are timed. Of one thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/model/pace.h"
#include "viewer/model/painter.h"

namespace dermis::viewer {

class Easel {
 public:
  Easel(Renderer::Options options, std::function<void()> before_drawing)
      : options_(std::move(options)), before_drawing_(std::move(before_drawing)) {}

  /// Draws as Session and Renderer do, and throws as they do.
  Painted draw(const Wish& wish);
  /// Draws and writes as `dermis render` does.
  void save(const SaveWish& wish);

  /// Draws with these in the place of dermis's own.
  void use_shaders(std::shared_ptr<const ShaderSet> shaders);

  /// Lets go of the device; the next picture opens it again.
  void renew();

  std::string device_name() const { return device_name_; }
  std::vector<std::string> validation_messages() const;

 private:
  Renderer& renderer();
  Session& session(bool moving, bool labels);
  PreparedFrame& prepared(const Scene& scene, RenderSettings settings);
  Painted draw_prepared(const Wish& wish);
  Painted draw_in_session(const Wish& wish);
  std::optional<LightMap> light_map(const Wish& wish, const RenderSettings& drawn);

  Renderer::Options options_;
  std::function<void()> before_drawing_;
  std::shared_ptr<const ShaderSet> shaders_ = std::make_shared<const ShaderSet>();
  // Each may use the one before it.
  std::optional<Renderer> renderer_;
  std::optional<Session> moving_, resting_;
  bool resting_has_labels_ = false;
  std::optional<PreparedFrame> prepared_;
  Pace pace_;
  std::string device_name_;
  std::vector<std::string> said_;  ///< by the validation layer of renderers that are gone
};

}  // namespace dermis::viewer
