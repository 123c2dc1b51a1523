// SPDX-License-Identifier: MIT
// What a uri of a glTF file stands for: embedded bytes or a file beside the scene.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dermis::scene::gltf {

/// The bytes of a "data:...;base64,..." uri; none if it is not a data uri. InputError (where) if it is not
/// well-formed base64.
std::optional<std::vector<std::byte>> data_uri(std::string_view uri, const std::string& where);

/// The file that a relative uri names: percent-decoded, or as it stands if only that exists. InputError
/// (where): a scheme (http:, C:), an absolute path, an empty name.
std::filesystem::path uri_path(const std::filesystem::path& folder, const std::string& uri,
                               const std::string& where);

}  // namespace dermis::scene::gltf
