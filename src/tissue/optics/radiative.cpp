// SPDX-License-Identifier: MIT
#include "tissue/optics/radiative.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/core/error.h"
#include "tissue/optics/fresnel.h"
#include "tissue/optics/quadrature.h"

namespace dermis::optics {
namespace {

/// Returns the Gauss-Radau rule on [low, 1] with a node at 1, so that the perpendicular beam is one of the
/// directions.
template <int n>
std::array<Node, n> radau_to_one(double low) {
  std::array<Node, n> rule;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(2 * std::numbers::pi * i / (2 * n - 1)), p0 = 1, p1 = x;
    for (int step = 0; step < 60; ++step) {  // roots of P_{n-1} + P_n; -1 is one of them
      p0 = 1;
      p1 = x;
      for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
      }

      if (i == 0) break;
      const double change = (1 - x) / n * (p0 + p1) / (p0 - p1);
      x -= change;
      if (std::abs(change) < 1e-15) break;
    }

    const double weight = i == 0 ? 2.0 / (n * n) : (1 - x) / (n * n * p0 * p0);
    rule[i] = {1 - (1 - low) * (x + 1) / 2, weight * (1 - low) / 2};  // mirrored: -1 becomes 1
  }
  return rule;
}

/// The method with 2 half_count directions.
template <int half_count>
struct AddingDoubling {
  static constexpr int directions = 2 * half_count;
  using Matrix = Eigen::Matrix<double, directions, directions>;
  using Vector = Eigen::Matrix<double, directions, 1>;

  /// Directions inside a medium: those past the critical angle, then those that can leave. The last is
  /// perpendicular.
  struct Directions {
    Vector mu, weight, surface;  // surface: internal reflectance
  };

  static Directions directions_of(double eta) {
    Directions d;
    const double critical =
        eta > 1 ? std::sqrt(1 - 1 / (eta * eta)) : 0.3;  // without a critical angle any split works
    const auto inner = gauss_legendre(half_count, 0, critical);
    const auto outer = radau_to_one<half_count>(critical);
    for (int i = 0; i < half_count; ++i) {
      d.mu[i] = inner[i].x;
      d.weight[i] = inner[i].weight;
      d.mu[directions - 1 - i] = outer[i].x;
      d.weight[directions - 1 - i] = outer[i].weight;
    }
    for (int i = 0; i < directions; ++i) d.surface[i] = eta == 1 ? 0 : fresnel(d.mu[i], eta);
    return d;
  }

  /// The effect of a slab on intensities: out = R in (same side), out = T in (other side). A slab is
  /// homogeneous, so that both sides are alike.
  struct SlabMatrices {
    Matrix reflect, transmit;
  };

  /// Returns a slab so thin that the mean of its two faces stands for its inside ([PGW93] "diamond"): second
  /// order in `depth`.
  static SlabMatrices thin_slab(const Directions& d, double albedo, double depth) {
    const Vector scale = (depth / 2) * d.mu.cwiseInverse();
    const Matrix gain = scale * (albedo / 2) * d.weight.transpose();
    const Matrix loss = Matrix(scale.asDiagonal()) - gain;
    const Matrix inverse = (Matrix::Identity() + loss).inverse();

    // At a face lit with 1: T = forward + back R, R = back (1 + T). Insert T and solve for R.
    const Matrix forward = inverse * (Matrix::Identity() - loss), back = inverse * gain;
    SlabMatrices slab;
    slab.reflect =
        (Matrix::Identity() - back * back).partialPivLu().solve(back * (Matrix::Identity() + forward));
    slab.transmit = forward + back * slab.reflect;
    return slab;
  }

  // [PGW93], adding for two equal slabs: light bounces between them, (1 - R R)^-1.
  static void double_slab(SlabMatrices& slab) {
    const Matrix bounce =
        (Matrix::Identity() - slab.reflect * slab.reflect).partialPivLu().solve(slab.transmit);
    slab.reflect += slab.transmit * slab.reflect * bounce;
    slab.transmit = (slab.transmit * bounce).eval();
  }

  static SlabMatrices make_slab(const Directions& d, const Layer& layer) {
    const Medium medium = layer.medium();
    const double albedo = medium.reduced_albedo();
    constexpr double thin = 1e-3;

    if (std::isfinite(layer.thickness_mm)) {
      const double depth = layer.thickness_mm * medium.sigma_t_reduced_per_mm();
      const int doublings = std::max(0, static_cast<int>(std::ceil(std::log2(depth / thin))));
      SlabMatrices slab = thin_slab(d, albedo, std::ldexp(depth, -doublings));
      for (int i = 0; i < doublings; ++i) double_slab(slab);
      return slab;
    }
    // A half-space: doubles until nothing passes.
    SlabMatrices slab = thin_slab(d, albedo, thin);
    for (int i = 0; i < 50 && slab.transmit.cwiseAbs().maxCoeff() > 1e-9; ++i) double_slab(slab);
    return slab;
  }

  /// Returns the reflectance of each upper layer on each half-space below it, row by row.
  static std::vector<double> two_layers(const std::vector<Layer>& above, const std::vector<Layer>& below) {
    const Directions d = directions_of(above.front().eta);
    const auto slabs_of = [&](const std::vector<Layer>& layers) {
      std::vector<SlabMatrices> slabs;
      for (const Layer& layer : layers) slabs.push_back(make_slab(d, layer));
      return slabs;
    };
    const std::vector<SlabMatrices> upper = slabs_of(above), lower = slabs_of(below);

    const double enters = 1 / (d.mu[directions - 1] * d.weight[directions - 1]);  // unit flux
    const Vector leaves = d.mu.cwiseProduct(d.weight).cwiseProduct(Vector::Ones() - d.surface);
    std::vector<double> totals;
    for (const SlabMatrices& slab : upper) {
      for (const SlabMatrices& half_space : lower) {
        const Matrix bounce =
            (Matrix::Identity() - slab.reflect * half_space.reflect).partialPivLu().solve(slab.transmit);
        const Matrix both = slab.reflect + slab.transmit * half_space.reflect * bounce;
        const Vector down = (Matrix::Identity() - d.surface.asDiagonal() * both)
                                .partialPivLu()
                                .solve(Vector::Unit(directions - 1) * enters);
        totals.push_back(leaves.dot(both * down));
      }
    }
    return totals;
  }

  static Totals solve(const Layers& layers, const std::string& where) {
    check(layers, where);
    for (const Layer& layer : layers)
      if (layer.eta != layers[0].eta)
        throw input_error(where, "adding-doubling wants one index for all layers, got {} and {}",
                          layers[0].eta, layer.eta);
    const Directions d = directions_of(layers[0].eta);

    // Adds slabs from the bottom up. `below` reflects what comes down; `through` maps what arrives at the
    // current top to what arrives at the last face.
    Matrix below = d.surface.asDiagonal(), through = Matrix::Identity();
    for (std::size_t i = layers.size(); i-- > 0;) {
      const SlabMatrices slab = make_slab(d, layers[i]);
      // Light that arrives at `below`, per unit on top of the slab.
      const Matrix bounce = (Matrix::Identity() - slab.reflect * below).partialPivLu().solve(slab.transmit);
      through = (through * bounce).eval();
      below = (slab.reflect + slab.transmit * below * bounce).eval();
    }

    // Light just below the surface: what entered plus what the surface reflects back.
    Vector entered = Vector::Zero();
    entered[directions - 1] = 1 / (d.mu[directions - 1] * d.weight[directions - 1]);  // unit flux
    const Vector down = (Matrix::Identity() - d.surface.asDiagonal() * below).partialPivLu().solve(entered);
    const Vector leaves = d.mu.cwiseProduct(d.weight).cwiseProduct(Vector::Ones() - d.surface);
    return {leaves.dot(below * down), leaves.dot(through * down)};
  }
};

}  // namespace

Totals adding_doubling(const Layers& layers, const std::string& where) {
  return AddingDoubling<8>::solve(layers, where);
}
Totals adding_doubling_coarse(const Layers& layers, const std::string& where) {
  return AddingDoubling<4>::solve(layers, where);
}

std::vector<double> two_layers_coarse(const std::vector<Layer>& above, const std::vector<Layer>& below) {
  return AddingDoubling<4>::two_layers(above, below);
}

}  // namespace dermis::optics
