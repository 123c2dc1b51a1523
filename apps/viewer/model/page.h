// SPDX-License-Identifier: MIT
/// Pages that other commands of dermis write about what is looked at, opened in the browser.
#pragma once

#include <string>
#include <vector>

#include "dermis/hooks.h"
#include "viewer/model/skin_maker.h"

namespace dermis::viewer {

/// A page: a title, and the command that writes it to --html, without that.
struct Page {
  const char* title;
  std::vector<std::string> words;
};

/// Returns the pages of a scene: techniques against the truth, and the paper's test.
/// `scene_words`: of one scene (viewer/model/saving.h).
std::vector<Page> pages_of(const std::vector<std::string>& scene_words,
                           const std::vector<std::string>& options, const std::string& device);

/// Runs the `dermis` beside this program with these words and `--html FILE`, and waits for it; a hook ends
/// it. Returns the file. Throws InputError with what the command said last; Cancelled.
std::string write_page(const Page& page, const Hooks& hooks);

/// Writes R(r) of a skin and of its fit, as `dermis profile --plot` does. Returns the file. Throws
/// InputError.
std::string write_profile_page(const MadeSkin& skin, const Hooks& hooks);

/// Shows a file in the browser; nothing where there is none.
void open_page(const std::string& file);

}  // namespace dermis::viewer
