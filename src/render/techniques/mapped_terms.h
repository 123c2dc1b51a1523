// SPDX-License-Identifier: MIT
/// Selects the terms of the profile that are blurred for a head: those that its pixels read.
#pragma once

#include <cstdint>
#include <vector>

#include "render/passes/light_map/mapped_terms.h"
#include "render/techniques/technique.h"

namespace dermis::techniques {

/// Returns sigma, in texels at the mean density, of the narrowest term that a map is made for
/// (sides_by_need.h). It is less for a wide term of few pixels.
double held_sigma_texels(const PlannedMesh& part, double sigma_mm, double pixels_per_mm);

/// Returns sigma, in pixels, up to which a term is lit at the pixel: it would blur what the pixel does not
/// show. From there to half as much again it moves to the map, so that nothing pops. The widest stays longer,
/// because beyond it there is no map at all, and no light around edges. Terms narrower than
/// PlannedMesh::wide_mm are on maps of close-ups alone.
double least_sigma_pixels(const PlannedMesh& part, double sigma_mm);

/// Returns the part of the light of narrower terms than PlannedMesh::mapped() that pixels of a head read from
/// the light before any blur. A texel averages light better than the two points at which a coarse pixel is
/// lit.
float entered_share(const PlannedMesh& part, const passes::MapDetail& detail);

/// Returns the first of the terms that a map of T_max texels holds, where pixels are no finer than this. It
/// is the widest if none fits, as a map has at least one term.
std::uint32_t first_mapped(const PlannedMesh& part, const passes::MapDetail& finest);

/// Returns the terms of skin mesh `mesh` of the plan that are read from its light maps, of
/// PlannedMesh::mapped(): all, unless FrameSettings::mixes().
passes::MappedTerms mapped_terms(const FrameSettings& settings, std::uint32_t mesh,
                                 const passes::MapDetail& detail);

/// Returns those of each skin mesh of a model.
std::vector<passes::MappedTerms> mapped_terms_of(const FrameSettings& settings, const Model& model,
                                                 const passes::MapDetail& detail);

/// Returns how many steps of the chain of blurs of a skin mesh, its first, take the light before any blur:
/// those of terms that one kernel holds, at most two. Each takes a map more, so that it is one where all
/// terms are mapped.
std::size_t direct_steps(const FrameSettings& settings, const PlannedMesh& part);

/// Returns how many terms a skin mesh reads from such maps.
int mapped_count(const FrameSettings& settings, std::uint32_t mesh, const passes::MapDetail& detail);

}  // namespace dermis::techniques
