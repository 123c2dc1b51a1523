// SPDX-License-Identifier: MIT
/// How light that comes through the body joins the light that spreads over its surface.
///
/// A slab of thickness d, lit on its far side with B(y), shows sum_i w_i exp(-d^2 / 2 v_i) (G(v_i) * B):
/// every term of the profile has light of its own, T_i = exp(-d^2 / 2 v_i) B summed over the lights. The
/// convolution is a chain, narrow to wide, so T_i need not be blurred by itself: what T_i has over T_(i-1)
/// joins the chain before the step to term i. Terms are taken together in at most three groups: a group's
/// light is the mean of its terms', by their weights, so that sum_i w_i T_i is exact whatever the groups;
/// only widths are shared. The first group joins in the irradiance map itself, so three groups need two more
/// maps.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/resources.h"
#include "gaussians/sum.h"
#include "passes/bindings.h"
#include "shared/transmission_io.h"

namespace dermis::passes {

/// The first term of each group: 0, then those that begin the second and the third. k terms (1..8) make
/// min(k, 3) groups, the narrow ones taking more terms: wide Gaussians carry nearly all of the light and are
/// blurred most.
std::vector<std::size_t> transmission_groups(std::size_t terms);

/// share[group * MOST_TERMS + i]: of T_i in what joins at that group; summed over groups and weighted
/// as the final sum does, each T_i counts w_i. A channel without weight in a group waits for the next.
/// mm_per_unit: of the scene.
io::TransmissionIo transmission_io(const gaussians::SumOfGaussians& profile, double mm_per_unit);

/// What skin_through.glsl binds beside the lighting: what of the light enters, in the lights' maps, and the
/// constants of a profile.
class ThroughBindings {
 public:
  ThroughBindings() = default;
  ThroughBindings(gpu::PipelineLibrary& library, const std::vector<gaussians::SumOfGaussians>& profiles,
                  double mm_per_unit);
  /// entering: not valid where nothing is stored of it, `entering_stored` is false then; shadow: its lights'.
  void offer(Bindings& bindings, const frame::Resources& resources, frame::TextureId entering,
             frame::TextureId shadow, std::size_t profile) const;

 private:
  std::vector<gpu::Buffer> constants_;  // TransmissionIo, one for equal profiles
  std::vector<std::size_t> number_;     // of those, by profile
};

}  // namespace dermis::passes
