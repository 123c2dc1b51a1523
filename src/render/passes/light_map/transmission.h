// SPDX-License-Identifier: MIT
/// Transmitted light, as it joins the light that spreads over the surface.
///
/// A slab of thickness d, lit on its far side with B(y), shows sum_i w_i exp(-d^2 / 2 v_i) (G(v_i) * B). So
/// every term of the profile has light of its own, T_i = exp(-d^2 / 2 v_i) B summed over the lights.
///
/// The convolution is a chain, narrow to wide, so T_i needs no blur of its own. The excess of T_i over
/// T_(i-1) joins the chain before the step to term i. Terms form at most three groups. The light of a group
/// is the mean of its terms', by their weights: sum_i w_i T_i is exact for any groups, only widths are
/// shared. The first group joins in the irradiance map itself, so three groups need two more maps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/resources.h"
#include "render/passes/bindings.h"
#include "render/shared/terms_io.h"
#include "tissue/gaussians/sum.h"

namespace dermis::passes {

/// Returns the first term of each group: 0, then those that begin the second and the third. k terms (1..8)
/// make min(k, 3) groups; the narrow ones take more terms, because wide Gaussians carry nearly all of the
/// light and are blurred most. first_mapped: terms before it, which are lit at the pixel, are the first
/// group. Those that maps hold are one group, or two if they are more than two.
std::vector<std::size_t> transmission_groups(std::size_t terms, std::size_t first_mapped = 0);
/// Returns those of the terms that maps hold, counted from the first of these.
std::vector<std::size_t> mapped_groups(std::size_t terms, std::size_t first_mapped);

/// Returns the thickness of the last gain: the widest Gaussian holds less than a thousandth of its light
/// there.
double gains_end_mm(const ScatterProfile& profile);
/// Returns, for each thickness, the light through a slab of the profile's medium (profile::slab_backs()) over
/// that of the Gaussians, at most 12. It is also divided by the light that the slab's front returns, because
/// shading multiplies all light by that. 1 of a profile without ShapeLaws.
std::vector<gaussians::Rgb> slab_gains(const ScatterProfile& profile, std::span<const double> thicknesses_mm);

/// Returns the constants of a profile. share[group * MOST_TERMS + i] is the part of T_i that joins at that
/// group; summed over groups and weighted as in the final sum, each T_i counts w_i. A channel without weight
/// in a group joins at the next. mm_per_unit, first_mapped: as ThroughMesh.
io::TransmissionIo transmission_io(const ScatterProfile& profile, double mm_per_unit,
                                   std::size_t first_mapped = 0);
/// Returns those of the terms that maps hold: arrays begin with the first of these, and gains stay those of
/// the whole profile.
io::TransmissionIo mapped_transmission_io(const ScatterProfile& profile, double mm_per_unit,
                                          std::size_t first_mapped);

/// A skin mesh whose light also comes through the body.
struct ThroughMesh {
  std::uint32_t mesh = 0;          ///< among the skin meshes of the plan
  ScatterProfile profile;          ///< in mm of the asset
  double mm_per_unit = 1000;       ///< mm of the asset per metre of the world
  std::uint32_t first_mapped = 0;  ///< terms before it are lit at the pixel
  std::uint32_t mapped_terms() const {
    return static_cast<std::uint32_t>(profile.terms.size()) - first_mapped;
  }
};

/// Bindings of transmission.glsl beside the lighting: entering light, in the maps of the lights, and the
/// constants of a profile.
class ThroughBindings {
 public:
  ThroughBindings() = default;
  /// The constants are those of the terms that maps hold, or, `at_pixel`, those of all.
  ThroughBindings(gpu::PipelineLibrary& library, const std::vector<ThroughMesh>& meshes,
                  bool at_pixel = false);
  /// Returns the number of a skin mesh of the plan among `meshes`, which hold it.
  std::size_t entry_of(std::uint32_t mesh) const;
  /// Offers the bindings. `entering` is not valid if nothing is stored (`entering_stored` is then false);
  /// `shadow` is of the same lights.
  void offer(Bindings& bindings, const frame::Resources& resources, frame::TextureId entering,
             frame::TextureId shadow, std::size_t entry) const;

 private:
  std::vector<gpu::Buffer> constants_;  // TransmissionIo, one for equal profiles
  std::vector<std::size_t> number_;     // of those, by entry
  std::vector<std::uint32_t> meshes_;   // by entry
};

}  // namespace dermis::passes
