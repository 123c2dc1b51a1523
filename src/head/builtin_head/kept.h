// SPDX-License-Identifier: MIT
// Keeps the net and the maps of the head, all that takes long, in the cache of files (base/core/cache.h).
#pragma once

#include <filesystem>
#include <optional>

#include "head/builtin_head/complexion.h"
#include "head/builtin_head/maps.h"

namespace dermis::builtin_head {

struct Baked {
  Net net;
  Maps maps;
};

/// Returns a hash of the sources of this folder and of the spectral model, part of each key: other code has
/// other files.
const char* code_hash();

/// Returns the file of a head: tone, size of its maps and the hash of the code are its name. Empty if
/// `folder` is.
std::filesystem::path kept_file(const std::filesystem::path& folder, Tone tone, int map_size);

/// Returns what keep() was given; nothing if there is no such file, or it is damaged, or of another size or
/// code.
std::optional<Baked> kept(const std::filesystem::path& file, int map_size);

/// Writes the file. A failure costs only time: a warning tells.
void keep(const std::filesystem::path& file, const Baked& baked);

}  // namespace dermis::builtin_head
