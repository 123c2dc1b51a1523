// SPDX-License-Identifier: MIT
#include "render/passes/light_map/transmission.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/core/assert.h"
#include "tissue/optics/media.h"
#include "tissue/profile/shape_laws.h"

namespace dermis::passes {

static_assert(gaussians::max_terms == MOST_TERMS);

std::vector<std::size_t> transmission_groups(std::size_t terms, std::size_t first_mapped) {
  std::vector<std::size_t> first;
  if (first_mapped > 0) first.push_back(0);
  const std::size_t mapped = terms - first_mapped,
                    groups = first_mapped == 0
                                 ? std::min<std::size_t>(terms, TRANSMISSION_GROUPS)
                                 : std::min<std::size_t>((mapped + 1) / 2, TRANSMISSION_GROUPS - 1);
  for (std::size_t g = 0, at = first_mapped; g < groups; ++g) {
    first.push_back(at);
    at += (terms - at + groups - g - 1) / (groups - g);  // an equal share of the rest, rounded up
  }
  return first;
}

std::vector<std::size_t> mapped_groups(std::size_t terms, std::size_t first_mapped) {
  std::vector<std::size_t> first = transmission_groups(terms, first_mapped);
  if (first_mapped > 0) first.erase(first.begin());
  for (std::size_t& term : first) term -= first_mapped;
  return first;
}

double gains_end_mm(const ScatterProfile& profile) {
  return std::sqrt(2 * std::log(1000.0) * profile.max_variance_mm2());
}

std::vector<gaussians::Rgb> slab_gains(const ScatterProfile& profile,
                                       std::span<const double> thicknesses_mm) {
  std::vector<gaussians::Rgb> gains(thicknesses_mm.size(), gaussians::Rgb{1, 1, 1});
  if (!profile.shape || !profile.medium) return gains;
  constexpr double most = 12;

  const optics::RgbMedium medium = optics::rgb_medium(*profile.medium);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<double> backs = profile::slab_backs(medium[c], thicknesses_mm);
    for (std::size_t i = 0; i < gains.size(); ++i) {
      const double d = thicknesses_mm[i];
      double gaussian = 0;
      for (const Gaussian& term : profile.terms)
        gaussian += term.weight[c] * std::exp(-d * d / (2 * term.variance_mm2));
      const double front = std::max(profile::slab_front(*profile.shape, c, d), 0.1);
      gains[i][c] = std::clamp(backs[i] / std::max(gaussian * front, 1e-9), 0.0, most);
    }
  }
  return gains;
}

namespace {

// Returns those of the terms from `begin` on. first: the first term of each group, counted from there.
io::TransmissionIo constants_of(const ScatterProfile& profile, double mm_per_unit, std::size_t begin,
                                std::vector<std::size_t> first) {
  const std::span<const Gaussian> all = std::span(profile.terms).subspan(begin);
  const std::size_t terms = all.size();
  DERMIS_ASSERT_LE(terms, std::size_t{MOST_TERMS});
  io::TransmissionIo out{};
  for (std::size_t i = 0; i < terms; ++i) {
    out.two_sigma_m[i] = static_cast<float>(2 * std::sqrt(all[i].variance_mm2) / mm_per_unit);
    out.falloff_per_m2[i] = static_cast<float>(mm_per_unit * mm_per_unit / (2 * all[i].variance_mm2));
  }

  const double end_mm = std::max(gains_end_mm(profile), 1e-6);
  out.gains_end_per_m = static_cast<float>(mm_per_unit / end_mm);
  std::array<double, TRANSMISSION_GAINS> thicknesses_mm{};
  for (std::size_t i = 0; i < thicknesses_mm.size(); ++i) {
    const double root = static_cast<double>(i) / (TRANSMISSION_GAINS - 1);
    thicknesses_mm[i] = end_mm * root * root;
  }
  const std::vector<gaussians::Rgb> gains = slab_gains(profile, thicknesses_mm);
  for (std::size_t i = 0; i < gains.size(); ++i) out.gain[i] = {gains[i][0], gains[i][1], gains[i][2]};

  first.push_back(terms);
  for (int c = 0; c < 3; ++c) {
    const auto weight = [&](std::size_t i) { return all[i].weight[static_cast<std::size_t>(c)]; };
    const auto share = [&](std::size_t g, std::size_t i) -> float& {
      return out.share[g * MOST_TERMS + i][c];
    };

    // Shares of the T_i in the mean of the last group that had weight.
    std::vector<double> before(terms, 0.0);
    for (std::size_t g = 0; g + 1 < first.size(); ++g) {
      double sum = 0;
      for (std::size_t i = first[g]; i < first[g + 1]; ++i) {
        sum += weight(i);
        out.group[i] = static_cast<std::uint32_t>(g);
      }
      out.group_weight[g][c] = static_cast<float>(sum);
      if (!(sum > 0)) continue;

      std::vector<double> mean(terms, 0.0);
      for (std::size_t i = first[g]; i < first[g + 1]; ++i) mean[i] = weight(i) / sum;
      for (std::size_t i = 0; i < terms; ++i) share(g, i) = static_cast<float>(mean[i] - before[i]);
      before = mean;
    }
  }

  return out;
}

}  // namespace

io::TransmissionIo transmission_io(const ScatterProfile& profile, double mm_per_unit,
                                   std::size_t first_mapped) {
  return constants_of(profile, mm_per_unit, 0, transmission_groups(profile.terms.size(), first_mapped));
}

io::TransmissionIo mapped_transmission_io(const ScatterProfile& profile, double mm_per_unit,
                                          std::size_t first_mapped) {
  return constants_of(profile, mm_per_unit, first_mapped, mapped_groups(profile.terms.size(), first_mapped));
}

ThroughBindings::ThroughBindings(gpu::PipelineLibrary& library, const std::vector<ThroughMesh>& meshes,
                                 bool at_pixel) {
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    meshes_.push_back(meshes[i].mesh);
    const auto same = std::find_if(
        meshes.begin(), meshes.begin() + static_cast<std::ptrdiff_t>(i), [&](const ThroughMesh& m) {
          return m.profile == meshes[i].profile && m.mm_per_unit == meshes[i].mm_per_unit &&
                 m.first_mapped == meshes[i].first_mapped;
        });
    const auto first = static_cast<std::size_t>(same - meshes.begin());
    if (first < i) {
      number_.push_back(number_[first]);
      continue;
    }
    number_.push_back(constants_.size());
    const auto constants = at_pixel ? transmission_io : mapped_transmission_io;
    const io::TransmissionIo io = constants(meshes[i].profile, meshes[i].mm_per_unit, meshes[i].first_mapped);
    constants_.push_back(gpu::make_buffer(library.device(), "transmission", std::span(&io, 1),
                                          VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
  }
}

std::size_t ThroughBindings::entry_of(std::uint32_t mesh) const {
  const auto found = std::find(meshes_.begin(), meshes_.end(), mesh);
  DERMIS_ASSERT_EQ(found != meshes_.end(), true);
  return static_cast<std::size_t>(found - meshes_.begin());
}

void ThroughBindings::offer(Bindings& bindings, const frame::Resources& resources, frame::TextureId entering,
                            frame::TextureId shadow, std::size_t entry) const {
  // A binding that is never read must be bound, too.
  const gpu::SampledBinding maps = resources.nearest(entering.valid() ? entering : shadow);
  bindings.add("entering_maps", maps).add("Transmission", constants_[number_[entry]]);
}

}  // namespace dermis::passes
