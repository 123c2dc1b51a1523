// SPDX-License-Identifier: MIT
/// Scenes for what techniques cannot do, each for one thing, generated: --scene test:NAME.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dermis/hooks.h"
#include "dermis/scene.h"

namespace dermis::cli::test_scenes {

struct TestScene {
  std::string_view name;   ///< that follows "test:"
  std::string_view shows;  ///< one line: what it is, and what fails there
  bool built_in_head;      ///< takes the seconds of the built-in head; the others milliseconds
};

/// All of them, in the order of a table.
std::vector<TestScene> all();

inline constexpr std::string_view prefix = "test:";
inline bool is_test_scene(std::string_view name) { return name.starts_with(prefix); }

/// Makes the scene of a name with its prefix. Where its size in the picture matters, the first camera of the
/// scene is made for a picture of so many pixels' height. Throws InputError for an unknown name; lists the
/// known ones.
Scene make(std::string_view prefixed_name, int picture_height, const Hooks& hooks = {});

}  // namespace dermis::cli::test_scenes
