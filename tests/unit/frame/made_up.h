// SPDX-License-Identifier: MIT
// Passes that exist only to be declared: a plan is made from a list of what they touch.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "frame/plan.h"

namespace dermis::frame::test {

struct Nothing {};  // of a frame: these passes record nothing
using Plan = FramePlan<Nothing>;

struct Touch {
  Access access{};
  std::variant<TextureId, BufferId> what;
};

struct MadeUp {
  struct Settings {
    PassKind kind = PassKind::compute;
    std::vector<Touch> touches;
    Runs runs = Runs::every_frame;
  } settings;
  struct In {
  } in;
  struct Out {};

  Out declare(Declare& d) const;
  void record(gpu::Cmd&, const Resources&, const Nothing&) const {}
};

inline void add(Plan& plan, const std::string& name, PassKind kind, std::vector<Touch> touches,
                Runs runs = Runs::every_frame) {
  plan.add<MadeUp>(name, {}, {kind, std::move(touches), runs});
}

inline constexpr gpu::TextureDesc small_map{.width = 8, .height = 8, .format = VK_FORMAT_R16G16B16A16_SFLOAT};
inline constexpr gpu::TextureDesc small_depth{.width = 8, .height = 8, .format = VK_FORMAT_D32_SFLOAT};
inline constexpr gpu::BufferDesc small_buffer{.bytes = 64};

}  // namespace dermis::frame::test
