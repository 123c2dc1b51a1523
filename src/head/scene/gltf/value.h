// SPDX-License-Identifier: MIT
// glTF is read through json::Value, which checks types, ranges and references
// before anything is used, and names file and place in every error.
//
// Why not tinygltf: it skips optional members of a wrong type, reads files and decodes Draco before anything
// is validated, and refuses meshopt fallback buffers. The checks would all have to be written around it
// anyway; on the plain JSON they are the reader.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/json/document.h"
#include "base/json/value.h"

namespace dermis::scene::gltf {

using json::max_count;
using json::Value;

/// The JSON of a file, within the limits for a scene. Warns of a byte-order mark, and of null and empty
/// members, which it leaves out. InputError: not JSON, no object.
json::Document parse(std::string_view text, const std::string& file);

/// The extension of this object by that name, if it is an object; else warns.
std::optional<Value> extension(const Value& value, const char* name);

}  // namespace dermis::scene::gltf
