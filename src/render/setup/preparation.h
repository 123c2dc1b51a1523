// SPDX-License-Identifier: MIT
/// Rays and files behind an interface, so that a program that draws from arrays links no library for them.
/// dermis::dermis implements it (src/api/prepare/preparation.cpp), dermis::draw does not.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dermis/asset.h"
#include "environment/environment.h"
#include "environment/occlusion.h"
#include "head/scene/asset_data.h"
#include "head/scene/surface/curvature.h"
#include "head/scene/surface/unwrap.h"
#include "render/passes/pixels/labels/labels_io.h"

namespace dermis::setup {

/// For labels, at the vertices of an asset.
struct LabelVertices {
  std::vector<std::vector<io::LabelVertexIo>> skin;      ///< of each skin mesh
  std::vector<std::vector<io::LabelVertexIo>> surfaces;  ///< of each primitive; empty where it is skin
};

/// Each throws as the function that it stands for.
struct Preparation {
  environment::Environment (*environment)(const std::string& name_or_file);
  environment::Occlusion (*occlusion)(const scene::AssetData&, const scene::SkinMesh&,
                                      const environment::OcclusionSettings&);
  std::vector<scene::VertexShape> (*body_shape)(const scene::AssetData&, const scene::SkinMesh&);
  /// `asset`: whose landmarks divide the face; none: it is not divided.
  LabelVertices (*label_vertices)(const scene::AssetData&, std::span<const scene::SkinMesh>,
                                  const std::optional<Asset>& asset);
  void (*repaint)(scene::AssetData&, const SceneOptions&);  ///< other melanin and haemoglobin
};

/// Throws InputError where the program does not link dermis::dermis; `wanted` names what needs it.
const Preparation& preparation(std::string_view wanted);

}  // namespace dermis::setup
