// SPDX-License-Identifier: MIT
// Stores samples in a file, so that a stopped run can continue as if it had not stopped.
#pragma once

#include <cstdint>
#include <filesystem>

#include "truth/reference/film.h"
#include "truth/reference/settings.h"

namespace dermis::reference {

/// Returns a number that changes with all that the samples depend on: triangles, materials, maps, lights,
/// camera, model, coefficients, seed.
std::uint64_t fingerprint(const scene::AssetData& scene, const Job& job, std::uint64_t seed);

/// Writes the file atomically.
void save_checkpoint(const std::filesystem::path& path, const Film& film, std::uint64_t fingerprint);

/// Returns false if there is no such file. Throws InputError if it is damaged, of another version, or of
/// another picture.
bool load_checkpoint(const std::filesystem::path& path, Film& film, std::uint64_t fingerprint);

}  // namespace dermis::reference
