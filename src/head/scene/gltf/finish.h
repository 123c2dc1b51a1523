// SPDX-License-Identifier: MIT
// Completes the AssetData: materials in use, their pictures, lights and cameras in the world.
#pragma once

#include "head/scene/gltf/place.h"

namespace dermis::scene::gltf {

/// Returns the materials that shown primitives use, renumbered in the file's order; primitives without one
/// share glTF's default material, the last. Map references still point into Document::images. `numbers.skin`
/// stays empty.
std::vector<MaterialSource> used_materials(const Document& document, MaterialNumbers& numbers);

/// Returns the other materials of the file; `numbers` are those of used_materials().
UnusedMaterials unused_materials(const Document& document, const MaterialNumbers& numbers);

struct ImageLimits {
  int max_side = 16384;            ///< pixels; larger pictures are rejected
  std::uint64_t budget_bytes = 0;  ///< of map_bytes() over all maps, head/scene/import/texture_budget.h
};

/// Decodes the pictures that the materials use and points the maps at AssetData::images. Reads all headers
/// before it decodes the first picture. While all maps together exceed the budget, the largest is downsampled
/// by 2: colours in linear light, other maps as plain data, by area averages. One note lists them. A picture
/// used as colour and as data counts twice, and is kept twice if it is downsampled. Throws InputError (names
/// the picture), also if memory runs out.
void decode_images(const Document& document, Bytes& bytes, const ImageLimits& limits, AssetData& scene);

/// Makes maps of roughness of those of glossiness: per material a factor on the map's alpha, none where the
/// map is one of roughness.
void turn_glossiness(const std::vector<std::optional<float>>& factors, AssetData& scene);

/// Multiplies the transmission of materials by the mean of their maps. Warns of maps that are not even.
void average_transmission(const std::string& file, AssetData& scene);

/// The nodes at which cameras and lights of a scene stand, in their order.
struct ViewNodes {
  std::vector<int> cameras, lights;
};

/// Adds those of the shown nodes to the scene.
ViewNodes place_lights_and_cameras(const Document& document, double unit_scale, AssetData& scene);

}  // namespace dermis::scene::gltf
