// SPDX-License-Identifier: MIT
// The last steps of every source of scenes: a file or the arrays of a host.
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/core/error.h"
#include "base/core/one_line.h"
#include "base/core/warnings.h"
#include "head/scene/asset_data.h"

namespace dermis::scene {

/// Makes missing normals, and tangents where the source's cannot be used. `has_tangents`: per primitive,
/// usable_tangents() of head/scene/surface/local_mesh.h. Materials and their maps are final.
void complete_surfaces(const std::vector<bool>& has_tangents, AssetData& scene);

/// Returns whether complete_surfaces() leaves a primitive of this material the tangents of its source.
bool keeps_tangents(const Material& material, bool has_tangents);

/// Throws InputError if more nodes have skin with texture coordinates than can be lit separately.
void check_skin_nodes(const std::string& file, std::size_t count);

/// Warns if the skin is not as high as a head.
void warn_of_size(const std::string& file, const AssetData& scene);

/// Returns what load() returns. Groups its warnings, and keeps each error one line, whatever text of the file
/// it quotes; what takes more memory than there is becomes an InputError.
template <class Load>
auto with_errors_of_import(const std::string& file, const Load& load) {
  const auto too_large = [&] { return input_error(file, "needs more memory than there is"); };
  const WarningGroup group;
  try {
    return with_one_line_errors(load);
  } catch (const std::bad_alloc&) { throw too_large(); } catch (const std::length_error&) {
    throw too_large();
  }
}

}  // namespace dermis::scene
