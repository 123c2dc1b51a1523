// SPDX-License-Identifier: MIT
// From what was read to the Scene: which materials are used and which of them are skin, their pictures,
// lights and cameras in the world.
#pragma once

#include "scene/gltf/place.h"

namespace dermis::scene::gltf {

/// The materials that shown primitives use, renumbered in the file's order; primitives without one share
/// glTF's default material, the last. Map references still point into Document::images. `numbers.skin` stays
/// empty.
std::vector<MaterialSource> used_materials(const Document& document, MaterialNumbers& numbers);

/// Decides which materials are skin: `skin_material` if not empty, else extras.dermis, else the name contains
/// "skin", else the only one; and gives skin its default index of refraction. Warns if nothing is.
/// What is blended is drawn as a surface even if it is skin by these rules, with a warning that names it.
/// InputError: no material is called skin_material.
void choose_skin(const Document& document, const std::string& skin_material,
                 std::vector<MaterialSource>& materials);

struct ImageLimits {
  int max_side = 16384;            ///< pixels; a larger picture is refused
  std::uint64_t budget_bytes = 0;  ///< of map_bytes() over all maps
};

/// What a map takes in memory and on any device: its pixels, 4 bytes each, and its levels on the device, 4/3
/// times 4 bytes per pixel; 8 for colours, which some devices keep as half floats.
std::uint64_t map_bytes(int width, int height, bool colour);

/// Decodes the pictures that the materials use and points the maps at Scene::images. All headers are read
/// before the first picture is decoded; as long as all maps together are over the budget, the largest is
/// halved, while it is read: colours in linear light, other maps as plain data, by the average of areas. One
/// note says which. A picture that is used as colour and as data counts twice, and is kept twice if it is
/// halved. InputError names the picture, also where memory ends.
void decode_images(const Document& document, Bytes& bytes, const ImageLimits& limits, Scene& scene);

void place_lights_and_cameras(const Document& document, double unit_scale, Scene& scene);

}  // namespace dermis::scene::gltf
