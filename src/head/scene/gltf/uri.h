// SPDX-License-Identifier: MIT
// Resolves uris of a glTF file: embedded bytes or a file beside the scene.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dermis::scene::gltf {

/// Returns the bytes of a "data:...;base64,..." uri; nothing if it is not a data uri. Throws InputError
/// (place `where`) if it is not well-formed base64.
std::optional<std::vector<std::byte>> data_uri(std::string_view uri, const std::string& where);

/// Returns the file that a relative uri names: percent-decoded, or unchanged, or with slashes for
/// backslashes, if only that exists. Throws InputError (place `where`) for a scheme (http:, C:), an absolute
/// path, an empty name.
std::filesystem::path uri_path(const std::filesystem::path& folder, const std::string& uri,
                               const std::string& where);

}  // namespace dermis::scene::gltf
