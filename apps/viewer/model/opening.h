// SPDX-License-Identifier: MIT
/// Files that come into the window: heads and scenes, surroundings, profiles, settings.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "viewer/model/document.h"

namespace dermis::viewer {

/// Changes by a file, once it has been read.
struct OpenedFile {
  std::string what;                     ///< names the change, for undo
  std::function<void(Document&)> into;  ///< puts it into the document as it is by then
};

/// Reads and checks a file: .glb, .gltf, a scene file, .hdr, .exr, a profile, settings. Takes seconds.
/// `document`: as it is now. Throws InputError: no such file, none of these kinds (lists them), what the
/// readers of each say; Cancelled.
OpenedFile read_file_for(const Document& document, const std::filesystem::path& path, const Hooks& hooks);

/// Puts a profile on all skin of the scene, in place of the one that the settings name.
void set_profile(Document& document, const ScatterProfile& profile);

/// Takes such a profile away again.
void clear_profile(Document& document);

}  // namespace dermis::viewer
