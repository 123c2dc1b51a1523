// SPDX-License-Identifier: MIT
#include "tissue/profile/shape_laws.h"

#include <algorithm>
#include <cmath>

#include "tissue/optics/radiative.h"

namespace dermis::profile {
namespace {

// Range of the walks.
constexpr double least_albedo = 0.2, most_albedo = 0.9985, least_eta = 1.3, most_eta = 1.5;

/// A medium in the numbers that the laws are written in.
struct Reduced {
  double free_mm;  // 1 / sigma_t'
  double x;        // sqrt(1 - alpha'), the amplitude of absorption
  double e;        // index over that of skin
  double albedo;
};

Reduced reduced(const optics::Medium& medium) {
  const double albedo = std::clamp(medium.reduced_albedo(), least_albedo, most_albedo);
  return {.free_mm = medium.mean_free_path().mm,
          .x = std::sqrt(1 - albedo),
          .e = std::clamp(medium.eta, least_eta, most_eta) - 1.4,
          .albedo = albedo};
}

double exit_grazing(const Reduced& m) { return 1 + m.x * (0.1939 - 0.1063 * m.x) * (1 - 1.6424 * m.e); }
double exit_normal(const Reduced& m) { return 1 - m.x * (0.1801 - 0.0993 * m.x) * (1 - 1.7175 * m.e); }

/// Attenuation deep in the medium, per mean free path: the root k of 1 = alpha/(2k) ln((1+k)/(1-k)), [C60]
/// ch. 1 sec. 11. Diffusion has sqrt(3 (1 - alpha)), which is 8 % more at alpha = 0.8.
double attenuation(double albedo) {
  double low = 1e-9, high = 1 - 1e-12;
  for (int i = 0; i < 60; ++i) {
    const double k = 0.5 * (low + high);
    (albedo / (2 * k) * std::log((1 + k) / (1 - k)) < 1 ? low : high) = k;
  }
  return 0.5 * (low + high);
}

/// Returns the share of diffuse light that entered which a half-space returns. A beam along the normal
/// returns less by the radiance that leaves along it: reciprocity, [C60] ch. 4.
double half_space_total(const Reduced& m) {
  const optics::Layers layers{
      {.sigma_a_per_mm = 1 - m.albedo, .sigma_s_reduced_per_mm = m.albedo, .eta = 1.4 + m.e}};
  return optics::adding_doubling(layers).reflectance / exit_normal(m);
}

/// Front and back of a slab, as parts of the light that entered.
struct SlabLight {
  double front, back;
};

/// Two fluxes [K48] between mirrors that send the part `mirror` back. The half-space's total gives the
/// reflectance of the core, its attenuation the depth. Near a face the fluxes are not yet diffuse: `beyond`
/// mean free paths are added, and what has scattered little is corrected by an exponential.
class SlabLaw {
 public:
  explicit SlabLaw(const Reduced& m)
      : m_(m),
        total_(half_space_total(m)),
        attenuation_(attenuation(m.albedo)),
        mirror_(0.1292 + 0.3855 * m.e) {}

  double total() const { return total_; }

  SlabLight at(double thickness_mm) const {
    const double d = thickness_mm / m_.free_mm;
    const double beyond = (0.2471 + 0.7485 * m_.e) * (1 - std::exp(-2.0009 * d));
    const double depth = std::min(attenuation_ * (d + beyond), 60.0);

    // Without boundaries: [K48] eq. 1
    const double endless = total_ / (1 - mirror_ + mirror_ * total_);
    const double a = 0.5 * (1 / endless + endless), b = 0.5 * (1 / endless - endless);
    const double sum = a * std::sinh(depth) + b * std::cosh(depth);
    const double r = std::sinh(depth) / sum, t = b / sum;

    // Between the mirrors
    const double out = (1 - mirror_) / ((1 - mirror_ * r) * (1 - mirror_ * r) - mirror_ * mirror_ * t * t);
    const double near = std::exp(-0.8578 * d);
    return {.front = out * (r * (1 - mirror_ * r) + mirror_ * t * t) + near * (-0.0113 - 0.0209 * m_.e),
            .back = out * t + near * (0.0921 + 0.4281 * m_.e)};
  }

 private:
  Reduced m_;
  double total_, attenuation_, mirror_;
};

/// Returns the least thickness whose front lacks no more than `lack` of the half-space's light. It may be
/// short of it by more than the law's own error only once: the front rises with thickness until then.
double front_thickness_mm(const SlabLaw& slab, double free_mm, double lack) {
  double low = 0, high = 1000 * free_mm;
  for (int i = 0; i < 60; ++i) {
    const double d = 0.5 * (low + high);
    (slab.at(d).front / slab.total() < 1 - lack ? low : high) = d;
  }
  return high;
}

void fill_front(ShapeLaws& laws, std::size_t c, const Reduced& m) {
  // The exponential through two points of the slab law.
  const SlabLaw slab(m);
  constexpr double thin = 0.25, thick = 0.05;
  const double d0 = front_thickness_mm(slab, m.free_mm, thin),
               d1 = front_thickness_mm(slab, m.free_mm, thick);
  laws.front_mm[c] = std::max((d1 - d0) / std::log(thin / thick), 1e-6 * m.free_mm);
  laws.front_share[c] = std::min(thin * std::exp(d0 / laws.front_mm[c]), 1.0);
}

void fill_curvature(ShapeLaws& laws, std::size_t c, const Reduced& m) {
  const double l = m.free_mm, x = m.x, e = m.e;
  laws.curvature_mm[c] = l * (3.085 - 4.032 * x + 2.122 * x * x) * (1 + (1.221 - 1.672 * x) * e);
  laws.convex_mm[c] = l * (0.5284 / x - 1.843) * (1 - 0.564 * e);
  laws.concave_mm[c] = l * (0.9235 / std::sqrt(x) + 1.387);
  laws.difference_mm[c] = l * (0.3257 / x - 0.4894);
  laws.difference_mm2[c] = l * l * (1.822 - 1.047 * x);
}

}  // namespace

ShapeLaws shape_laws(const optics::RgbMedium& medium) {
  optics::check(medium, "medium");
  ShapeLaws laws;
  for (std::size_t c = 0; c < 3; ++c) {
    const Reduced m = reduced(medium[c]);
    fill_curvature(laws, c, m);
    fill_front(laws, c, m);
    laws.exit_grazing[c] = exit_grazing(m);
    laws.exit_normal[c] = exit_normal(m);
    laws.exit_offset_mm[c] = m.free_mm / medium[c].eta;  // a mean free path along the refracted ray
  }
  return laws;
}

double curved_total(const ShapeLaws& laws, std::size_t c, double mean_per_mm, double difference_per_mm) {
  const double bend = mean_per_mm > 0 ? laws.convex_mm[c] * mean_per_mm : -laws.concave_mm[c] * mean_per_mm;
  const double below = std::max(1 + bend + laws.difference_mm[c] * difference_per_mm, 0.5);
  const double total = 1 + laws.curvature_mm[c] * mean_per_mm / below +
                       laws.difference_mm2[c] * difference_per_mm * difference_per_mm;
  return std::clamp(total, 0.3, 2.5);
}

double slab_front(const ShapeLaws& laws, std::size_t c, double thickness_mm) {
  return 1 - laws.front_share[c] * std::exp(-thickness_mm / laws.front_mm[c]);
}

std::vector<double> slab_backs(const optics::Medium& medium, std::span<const double> thicknesses_mm) {
  const SlabLaw slab(reduced(medium));
  std::vector<double> backs;
  for (const double thickness_mm : thicknesses_mm) backs.push_back(slab.at(thickness_mm).back / slab.total());
  return backs;
}

}  // namespace dermis::profile
