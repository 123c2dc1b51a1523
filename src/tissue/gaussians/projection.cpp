// SPDX-License-Identifier: MIT
#include "tissue/gaussians/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/core/error.h"
#include "tissue/optics/quadrature.h"

namespace dermis::gaussians {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

namespace {

using profile::RadialProfile;

/// Gathers the rows of a target.
struct Rows {
  std::vector<double> x, weight, value;  // weight: square root of the quadrature weight
  void add(double at, double of, double is) {
    x.push_back(at);
    weight.push_back(of);
    value.push_back(of * is);
  }
};

/// Makes rows by the trapezoid rule in log x. Integrands vanish at both ends, and a Gaussian is bounded for
/// arg x| < pi/4, so the error falls like e^{-2 pi (pi/4) / step}, about e^{-5/step}.
Rows smooth_rows(const RadialProfile& profile, bool spectral) {
  constexpr double step = 0.1;
  const double beam_mm2 = profile.has_pole() ? core_variance_mm2(profile) : 0;

  // Range of r, or of k, outside which the integrand is negligible.
  double low = 1e-6 * profile.inner_mm(), high = 45 * profile.outer_mm();
  if (spectral) {
    low = 1e-6 / profile.outer_mm();
    high = profile.has_pole() ? 6.5 / std::sqrt(beam_mm2) : 45 / profile.inner_mm();
  }
  Rows rows;
  for (double i = 0; i <= std::ceil(std::log(high / low) / step); ++i) {
    const double x = low * std::exp(step * i);
    // Int r f^2 dr = Int r^2 f^2 d(log r), so a row weighs r sqrt(step). By Parseval Int r f^2 dr = Int k
    // f^^2 dk / (4 pi^2), which divides the weight by 2 pi. A beam of variance v multiplies R^ and S^ by
    // e^{-v k^2/2}.
    const double weight = x * std::sqrt(step) / (spectral ? 2 * pi : 1) * std::exp(-beam_mm2 * x * x / 2);
    rows.add(x, weight, spectral ? profile.hankel(x) : profile.at(x));
  }
  return rows;
}

constexpr int cell_nodes = 4;

/// Returns the Lagrange polynomial n of the nodes at x: 1 at node n, 0 at the others.
double lagrange(const std::array<double, cell_nodes>& node, int n, double x) {
  double product = 1;
  for (int m = 0; m < cell_nodes; ++m)
    if (m != n) product *= (x - node[m]) / (node[n] - node[m]);
  return product;
}

/// Adds the rows of the cell low..high, over which Gaussians are nearly cubic. They hold the cubic nearest to
/// R, weighted by r, so that Int r R S dr and Int r S^2 dr are right however R varies inside. Returns Int r
/// (R - cubic)^2 dr, which no sum of Gaussians can reduce.
double add_cell(Rows& rows, const RadialProfile& profile, double low, double high) {
  // Four Gauss nodes integrate r l_m l_n (degree 7) exactly, so Lagrange polynomials of the nodes are
  // orthogonal under r dr, with the squared norm weight_n r_n. Three nodes per piece integrate r R l_n
  // exactly for linear R.
  static const std::vector<optics::Node> cell_rule = optics::gauss_legendre(cell_nodes, 0, 1),
                                         piece_rule = optics::gauss_legendre(3, 0, 1);
  std::array<double, cell_nodes> node{}, moment{};
  for (int n = 0; n < cell_nodes; ++n) node[n] = low + (high - low) * cell_rule[n].x;

  double square = 0;  // Int r R^2 dr
  const auto add_piece = [&](double from, double to) {
    for (const optics::Node& at : piece_rule) {
      const double r = from + (to - from) * at.x, value = profile.at(r), weight = (to - from) * at.weight * r;
      square += weight * value * value;
      for (int n = 0; n < cell_nodes; ++n) moment[n] += weight * value * lagrange(node, n, r);
    }
  };

  // Splits the cell at the profile's break points.
  const std::span<const double> breaks = profile.break_points_mm();
  double from = low;
  for (auto next = std::upper_bound(breaks.begin(), breaks.end(), low); next != breaks.end() && *next < high;
       ++next) {
    add_piece(from, *next);
    from = *next;
  }
  add_piece(from, high);

  // Coefficients of the cubic are moment_n / norm_n^2. Subtracts its square from that of R.
  for (int n = 0; n < cell_nodes; ++n) {
    const double weight = (high - low) * cell_rule[n].weight * node[n];
    rows.add(node[n], std::sqrt(weight), moment[n] / weight);
    square -= moment[n] * moment[n] / weight;
  }

  return std::max(square, 0.0);
}

/// Makes the rows of a profile with break points, cell by cell, and one row for what lies between its rows.
Rows broken_rows(const RadialProfile& profile) {
  const double end = profile.break_points_mm().back();
  Rows rows;

  double low = 1e-5 * profile.inner_mm();
  double rest = add_cell(rows, profile, 0, low);
  while (low < 10 * end) {
    // A cell ends where the profile does, because R may jump there.
    const double grown = low * std::exp(0.2), high = low < end && grown > end ? end : grown;
    rest += add_cell(rows, profile, low, high);
    low = high;
  }
  rows.x.push_back(0);
  rows.weight.push_back(0);
  rows.value.push_back(std::sqrt(rest));
  return rows;
}

/// Rows evenly in log r, from where hardly any light leaves nearer to where hardly any leaves farther.
Rows energy_rows(const RadialProfile& profile) {
  constexpr double step = 0.1, share = 5e-4;
  const double low = profile.quantile(share), high = profile.quantile(1 - share);
  Rows rows;
  if (!(low > 0)) return rows;
  for (double i = 0; i <= std::ceil(std::log(high / low) / step); ++i) {
    const double r = low * std::exp(step * i);
    rows.add(r, std::sqrt(step), profile.within(r));
  }
  return rows;
}

Rows rows_of(const RadialProfile& profile, bool spectral, Measure measure) {
  if (measure == Measure::energy) return energy_rows(profile);
  return spectral || profile.break_points_mm().empty() ? smooth_rows(profile, spectral)
                                                       : broken_rows(profile);
}

}  // namespace

Target::Target(const RadialProfile& profile, std::string where, Measure measure)
    : where_(std::move(where)),
      spectral_(measure == Measure::plane && (profile.hankel_is_exact() || profile.has_pole())),
      energy_(measure == Measure::energy) {
  if (!(profile.total() > 0))
    throw input_error(where_, "the profile reflects nothing: there is no sum of Gaussians to fit");

  const Rows rows = rows_of(profile, spectral_, measure);
  const auto vector = [](const std::vector<double>& from) {
    return Eigen::Map<const VectorXd>(from.data(), static_cast<Index>(from.size()));
  };

  x2_ = vector(rows.x).array().square();
  row_weight_ = vector(rows.weight);
  value_ = vector(rows.value);

  const double norm = value_.norm();
  if (!(norm > 0) || !std::isfinite(norm))
    throw input_error(where_, "the profile cannot be fitted: its norm is {}", norm);
  value_ /= norm;
  row_weight_ /= norm;
}

// Finer detail than this is not visible on skin. Needed for dark skin, where much light leaves within
// micrometres.
constexpr double finest_mm = 0.01;

double core_variance_mm2(const profile::RadialProfile& profile) {
  const double core_mm = std::max(profile.quantile(0.05), std::min(finest_mm, profile.quantile(0.5)));
  if (!(core_mm > 0))
    throw input_error(profile.name(), "the profile reflects nothing: there is no sum of Gaussians to fit");
  return core_mm * core_mm;
}

void Target::column(double variance_mm2, Eigen::Ref<VectorXd> basis, Eigen::Ref<VectorXd> slope) const {
  const double v = variance_mm2;
  if (energy_) {  // E = 1 - e^{-r^2/(2v)}
    const Eigen::ArrayXd t = x2_.array() / (2 * v);
    basis = (row_weight_.array() * (1 - (-t).exp())).matrix();
    slope = (row_weight_.array() * (-t).exp() * -t).matrix();
  } else if (spectral_) {  // G^ = e^{-v k^2/2}
    const Eigen::ArrayXd t = x2_.array() * (v / 2);
    basis = (row_weight_.array() * (-t).exp()).matrix();
    slope = (-basis.array() * t).matrix();
  } else {  // G = e^{-r^2/(2v)} / (2 pi v)
    const Eigen::ArrayXd t = x2_.array() / (2 * v);
    basis = (row_weight_.array() * (-t).exp() / (2 * pi * v)).matrix();
    slope = (basis.array() * (t - 1)).matrix();
  }
}

VectorXd solve_non_negative(const MatrixXd& a, const VectorXd& b) {
  const Index n = a.cols();
  std::vector<bool> used(static_cast<std::size_t>(n), true);
  VectorXd w = VectorXd::Zero(n);

  const auto solve_used = [&] {
    std::vector<Index> columns;
    for (Index j = 0; j < n; ++j)
      if (used[j]) columns.push_back(j);
    VectorXd s = VectorXd::Zero(n);
    if (columns.empty()) return s;
    const MatrixXd part = a(Eigen::all, columns);
    const VectorXd solution = part.colPivHouseholderQr().solve(b);
    for (std::size_t i = 0; i < columns.size(); ++i) s[columns[i]] = solution[static_cast<Index>(i)];
    return s;
  };

  w = solve_used();
  if (w.minCoeff() >= 0) return w;  // nearly always

  // [LH74] ch. 23, active set: adds the column whose gradient is largest, then removes those that would turn
  // negative.
  used.assign(used.size(), false);
  w.setZero();
  for (Index outer = 0; outer < 3 * n; ++outer) {
    const VectorXd gain = a.transpose() * (b - a * w);
    Index best = -1;
    for (Index j = 0; j < n; ++j)
      if (!used[j] && gain[j] > 1e-14 && (best < 0 || gain[j] > gain[best])) best = j;
    if (best < 0) break;
    used[best] = true;

    for (Index inner = 0; inner <= n; ++inner) {
      // Moves towards the solution of the used columns, up to where the first weight becomes 0.
      const VectorXd s = solve_used();
      double part = 1;
      for (Index j = 0; j < n; ++j)
        if (used[j] && s[j] <= 0) part = std::min(part, w[j] / (w[j] - s[j]));
      if (part >= 1) {
        w = s;
        break;
      }
      w += part * (s - w);
      for (Index j = 0; j < n; ++j)
        if (used[j] && w[j] <= 1e-15) {
          used[j] = false;
          w[j] = 0;
        }
    }
  }

  return w.cwiseMax(0);
}

Projected project(std::span<const Target> channels, const VectorXd& log_variance) {
  const Index n = log_variance.size();
  Projected out;
  out.weights = MatrixXd::Zero(n, static_cast<Index>(channels.size()));
  out.normal = MatrixXd::Zero(n, n);
  out.gradient = VectorXd::Zero(n);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const Target& target = channels[c];
    MatrixXd basis(target.rows(), n), slope(target.rows(), n);
    for (Index j = 0; j < n; ++j) target.column(std::exp(log_variance[j]), basis.col(j), slope.col(j));

    // Weights from the factor R alone, n x n, which has the least-squares solution of the whole basis.
    const Eigen::HouseholderQR<MatrixXd> qr(basis);
    const MatrixXd r = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();
    const VectorXd rotated = qr.householderQ().transpose() * target.value();
    const VectorXd w = solve_non_negative(r, rotated.head(n));

    const VectorXd residual = target.value() - basis * w;
    out.weights.col(static_cast<Index>(c)) = w;
    out.channel_residual2.push_back(residual.squaredNorm());
    out.residual2 += residual.squaredNorm();

    // Jacobian of the residual, [K75]: dr/dp_j = -(1 - Q Q^T) dPhi_j w_j, where Q spans the columns in use.
    std::vector<Index> used;
    for (Index j = 0; j < n; ++j)
      if (w[j] != 0) used.push_back(j);
    if (used.empty()) continue;

    const MatrixXd part = basis(Eigen::all, used);
    const Eigen::HouseholderQR<MatrixXd> part_qr(part);
    const MatrixXd q =
        part_qr.householderQ() * MatrixXd::Identity(target.rows(), static_cast<Index>(used.size()));
    MatrixXd jacobian = -slope * w.asDiagonal();
    jacobian -= q * (q.transpose() * jacobian).eval();
    out.normal += jacobian.transpose() * jacobian;
    out.gradient += jacobian.transpose() * residual;
  }

  return out;
}

}  // namespace dermis::gaussians
