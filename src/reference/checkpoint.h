// SPDX-License-Identifier: MIT
// What has been gathered, in a file, so that a run that was stopped can go on as if it had not been.
#pragma once

#include <cstdint>
#include <filesystem>

#include "reference/film.h"
#include "reference/settings.h"

namespace dermis::reference {

/// A number that changes with whatever the samples depend on: triangles, materials, maps, lights, camera,
/// model, coefficients, seed.
std::uint64_t fingerprint(const scene::Scene& scene, const Job& job, std::uint64_t seed);

/// Atomically.
void save_checkpoint(const std::filesystem::path& path, const Film& film, std::uint64_t fingerprint);

/// False if there is no such file. InputError: it is damaged, of another version, or of another picture.
bool load_checkpoint(const std::filesystem::path& path, Film& film, std::uint64_t fingerprint);

}  // namespace dermis::reference
