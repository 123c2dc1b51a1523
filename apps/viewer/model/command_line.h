// SPDX-License-Identifier: MIT
/// The command line that draws a picture again.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dermis/scene.h"
#include "dermis/settings.h"

namespace dermis::viewer {

/// Returns the options that make these settings of the default ones, a word each: from the rows of the
/// settings, so that a new setting needs nothing here. Settings without an option (camera.matrices) are left
/// out.
std::vector<std::string> option_words(const RenderSettings& settings);
/// Likewise, of how the files of a scene are read.
std::vector<std::string> option_words(const SceneOptions& options);

/// Returns "dermis render SCENE ... -o OUTPUT". `scene_words`: files, not yet quoted; `device`: as --device
/// has it.
std::string render_command(const std::vector<std::string>& scene_words, const RenderSettings& settings,
                           std::string_view device, std::string_view output);

}  // namespace dermis::viewer
