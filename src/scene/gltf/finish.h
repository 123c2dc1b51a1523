// SPDX-License-Identifier: MIT
// From what was read to the Scene: which materials are used and which of them are skin, their pictures,
// lights and cameras in the world.
#pragma once

#include "scene/gltf/place.h"

namespace dermis::scene::gltf {

/// The materials that primitives use, renumbered; primitives without one share glTF's default material.
/// Map references still point into Document::images.
std::vector<MaterialSource> used_materials(const Document& document, std::vector<Primitive>& primitives);

/// Decides which materials are skin: `skin_material` if not empty, else extras.dermis, else the name contains
/// "skin", else the only one; and gives skin its default index of refraction. Warns if nothing is.
/// InputError: no material is called skin_material.
void choose_skin(const Document& document, const std::string& skin_material,
                 std::vector<MaterialSource>& materials);

/// Decodes the pictures that the materials use, each once, and points the maps at Scene::images. InputError
/// names the picture.
void decode_images(const Document& document, Bytes& bytes, int max_map_side, Scene& scene);

void place_lights_and_cameras(const Document& document, double unit_scale, Scene& scene);

}  // namespace dermis::scene::gltf
