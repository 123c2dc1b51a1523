// SPDX-License-Identifier: MIT
#include "tissue/profile/single_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tissue/optics/fresnel.h"
#include "tissue/optics/quadrature.h"

namespace dermis::profile {
namespace {

using std::numbers::pi;

/// Returns 1 + g^2 + 2 g mu, written so that nothing cancels for g near -1. Light that came down leaves
/// upwards at cosine mu, so cos(theta) = -mu.
double turn_of(double g, double mu) { return (1 + g) * (1 + g) - 2 * g * (1 - mu); }

/// Adds to every ring what a scattering at depth t, optical depth tau, sends there, times `weight`: 2 pi Int
/// p_HG(mu) e^{-tau/mu} (1 - F(mu)) dmu over the directions mu = t / sqrt(t^2 + r^2) of the ring.
void add_depth(std::vector<double>& rings, const std::vector<double>& edges_mm, const PhotonLayer& layer,
               double t, double tau, double weight) {
  static const std::vector<optics::Node> rule = optics::gauss_legendre(6, 0, 1);
  const double critical = layer.eta > 1 ? std::sqrt(1 - 1 / (layer.eta * layer.eta)) : 0;
  double high = 1;

  for (std::size_t i = 0; i < rings.size(); ++i) {
    const double low = std::max(t / std::hypot(t, edges_mm[i + 1]), critical);
    if (low >= high) break;  // past the escape cone
    const auto leaves = [&](double mu) { return std::exp(-tau / mu) * (1 - optics::fresnel(mu, layer.eta)); };

    double sum = 0;
    if (i == 0 && layer.g < -0.5) {
      // A backward lobe may lie here entirely. It is flat in s = turn^{-1/2}:
      //   p_HG dmu = (1 - g^2) / (4 pi |g|) ds
      const double lowest = 1 / std::sqrt(turn_of(layer.g, low)), highest = 1 / (1 + layer.g);
      for (const optics::Node& node : rule) {
        const double s = lowest + (highest - lowest) * node.x;
        const double mu = 1 - (1 / (s * s) - (1 + layer.g) * (1 + layer.g)) / (-2 * layer.g);
        sum += node.weight * (highest - lowest) * (1 - layer.g) * (1 + layer.g) / (4 * pi * -layer.g) *
               leaves(mu);
      }
    } else {
      for (const optics::Node& node : rule) {
        // node.x^2, because 1 - F starts like a square root at the critical angle.
        const double mu = low + (high - low) * node.x * node.x, turn = turn_of(layer.g, mu);
        const double phase = (1 - layer.g) * (1 + layer.g) / (4 * pi * turn * std::sqrt(turn));
        sum += node.weight * (high - low) * 2 * node.x * phase * leaves(mu);
      }
    }

    rings[i] += weight * 2 * pi * sum;
    high = low;
  }
}

}  // namespace

bool single_is_exact(const std::vector<PhotonLayer>& layers, ScatterScene::Light light) {
  return light == ScatterScene::Light::perpendicular &&
         std::all_of(layers.begin(), layers.end(),
                     [&](const PhotonLayer& layer) { return layer.eta == layers[0].eta; });
}

std::vector<double> single_rings(const std::vector<PhotonLayer>& layers,
                                 const std::vector<double>& edges_mm) {
  // Integrates sigma_s e^{-tau(t)} over the depths t of all layers, in log t.
  std::vector<double> rings(edges_mm.size() - 1, 0.0);
  double tau_above = 0;
  for (const PhotonLayer& layer : layers) {
    const double sigma_s = layer.albedo * layer.sigma_t_per_mm;
    const double bottom = std::min(layer.bottom_mm, layer.top_mm + 40 / layer.sigma_t_per_mm);
    const double start = std::max(layer.top_mm, 1e-7 / layer.sigma_t_per_mm);
    if (bottom > start) {
      for (const optics::Node& node : optics::gauss_legendre(160, std::log(start), std::log(bottom))) {
        const double t = std::exp(node.x), tau = tau_above + (t - layer.top_mm) * layer.sigma_t_per_mm;
        add_depth(rings, edges_mm, layer, t, tau, sigma_s * std::exp(-tau) * t * node.weight);
      }
    }
    tau_above += (layer.bottom_mm - layer.top_mm) * layer.sigma_t_per_mm;
    if (tau_above > 40) break;
  }
  return rings;
}

}  // namespace dermis::profile
