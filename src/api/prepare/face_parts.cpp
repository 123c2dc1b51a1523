// SPDX-License-Identifier: MIT
#include "api/prepare/face_parts.h"

#include <vector>

#include "api/vectors.h"
#include "dermis/landmarks.h"

namespace dermis::api {
namespace {

std::uint32_t label_of(regions::NamedPart part, bool left) {
  const std::uint32_t side = left ? 1 : 0;
  switch (part) {
    case regions::NamedPart::eye: return LABEL_PART_RIGHT_EYE + side;
    case regions::NamedPart::brow: return LABEL_PART_RIGHT_BROW + side;
    case regions::NamedPart::mouth: return LABEL_PART_MOUTH;
    case regions::NamedPart::hair: return LABEL_PART_HAIR;
    case regions::NamedPart::lashes: return LABEL_PART_LASHES;
    case regions::NamedPart::none: break;
  }
  return LABEL_PART_OTHER;
}

}  // namespace

FaceParts::FaceParts(const std::optional<Asset>& asset) {
  const auto marks = asset ? Landmarks::of(*asset) : std::nullopt;
  if (!marks) return;
  Scene at_rest;
  std::vector<glm::dvec3> points_m;
  for (const auto& point_m : marks->positions_m(at_rest, at_rest.add({.asset = *asset})))
    points_m.push_back(vector_of(point_m));
  places_.emplace(points_m);
}

io::LabelVertexIo FaceParts::of_skin(const glm::dvec3& position_m) const {
  const regions::FacePlace at =
      places_ ? places_->at(position_m) : regions::FacePlace{.left = static_cast<float>(position_m.x)};
  return {.part = {-1, -1},
          .left = at.left,
          .face = {at.lips, at.above_parting, at.behind_lips, at.below_jaw},
          .kind = 0};
}

io::LabelVertexIo FaceParts::of_surface(const scene::AssetData& scene, const scene::Primitive& primitive,
                                        const glm::dvec3& position_m) const {
  io::LabelVertexIo vertex = of_skin(position_m);
  const scene::Material& material = scene.materials[static_cast<std::size_t>(primitive.material)];
  // A primitive may be named after the whole head: the material counts before it, but for hair, which is
  // brows and lashes, too.
  regions::NamedPart part = regions::named_part(material.name);
  const regions::NamedPart own = regions::named_part(primitive.name);
  if (part == regions::NamedPart::none || part == regions::NamedPart::hair)
    part = own == regions::NamedPart::none ? part : own;
  vertex.kind = material.skin ? LABEL_PART_FACE : label_of(part, vertex.left >= 0);
  return vertex;
}

}  // namespace dermis::api
