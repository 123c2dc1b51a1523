// SPDX-License-Identifier: MIT
/// Parts of a face at the vertices of an asset: what the label `part` is made of.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "dermis/asset.h"
#include "head/scene/asset_data.h"
#include "render/passes/pixels/labels/labels_io.h"
#include "truth/regions/face_parts.h"

namespace dermis::api {

class FaceParts {
 public:
  /// Takes the asset's landmarks at rest, if it has them. Throws InputError as Landmarks::of() does.
  explicit FaceParts(const std::optional<Asset>& asset);

  /// Returns what is known of a vertex of skin without rays.
  io::LabelVertexIo of_skin(const glm::dvec3& position_m) const;
  /// Returns the part of a vertex of what is drawn as no skin.
  io::LabelVertexIo of_surface(const scene::AssetData& scene, const scene::Primitive& primitive,
                               const glm::dvec3& position_m) const;

 private:
  std::optional<regions::FacePlaces> places_;
};

}  // namespace dermis::api
