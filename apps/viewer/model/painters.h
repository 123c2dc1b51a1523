// SPDX-License-Identifier: MIT
/// Threads that draw the window's pictures. Where a picture takes seconds, one that was begun cannot be
/// ended. So there pictures that follow the hand have a thread and a device of their own, before those at
/// rest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/model/painter.h"

namespace dermis::viewer {

class Painters {
 public:
  /// `apart`: two devices rather than one.
  Painters(Painter::Options options, bool apart);

  void wish(Wish wish);
  void save(SaveWish wish) { rest_.save(std::move(wish)); }
  void use_shaders(const std::shared_ptr<const ShaderSet>& shaders);
  PainterNews take_news();

  bool is_busy() const { return rest_.is_busy() || follows_hand(); }
  /// Returns whether a picture that follows the hand is being drawn on a device of its own.
  bool follows_hand() const { return quick_ && quick_->is_busy(); }
  std::string doing() const;
  std::vector<std::string> validation_messages() const;

  /// Ends the threads if that takes no longer than so many seconds. Returns whether they have ended.
  bool stop(double seconds);

 private:
  Painter rest_;
  std::optional<Painter> quick_;
};

}  // namespace dermis::viewer
