// SPDX-License-Identifier: MIT
// Variable projection [GP73]: for given variances the best weights follow from linear least squares, so that
// only the variances need a search.
#pragma once

#include <Eigen/Dense>
#include <span>
#include <string>
#include <vector>

#include "tissue/gaussians/fit.h"
#include "tissue/profile/radial.h"

namespace dermis::gaussians {

/// A profile as rows of a least-squares problem: sqrt(quadrature weight) times R(x), x = r or k, scaled so
/// that the rows have the norm 1.
class Target {
 public:
  /// Throws InputError (place `where`, such as a channel) if the profile is 0 everywhere, or so wide or
  /// narrow that its norm overflows or vanishes.
  Target(const profile::RadialProfile& profile, std::string where, Measure measure = Measure::plane);

  const std::string& where() const { return where_; }
  Eigen::Index rows() const { return value_.size(); }
  const Eigen::VectorXd& value() const { return value_; }
  /// Fills the column of G(v, .) on the rows, and its derivative by log v.
  void column(double variance_mm2, Eigen::Ref<Eigen::VectorXd> basis,
              Eigen::Ref<Eigen::VectorXd> slope) const;

 private:
  std::string where_;
  bool spectral_ = false;  // x is k and the rows hold R^
  bool energy_ = false;    // x is r and the rows hold what leaves within it
  Eigen::VectorXd x2_;     // x^2
  Eigen::VectorXd row_weight_;
  Eigen::VectorXd value_;
};

/// The result of projection at one set of variances.
struct Projected {
  double residual2 = 0;     // sum over the channels of the squared relative error
  Eigen::MatrixXd weights;  // terms x channels
  std::vector<double> channel_residual2;
  Eigen::MatrixXd normal;  // J^T J; with J^T r the system of a Gauss-Newton step, J as in [K75]
  Eigen::VectorXd gradient;
};

/// Returns the best weights for the given log-variances >= 0, and the slopes for the next
/// step of the search.
Projected project(std::span<const Target> channels, const Eigen::VectorXd& log_variance);

/// Returns the w >= 0 that minimises |A w - b| [LH74]. A has few columns and full column rank, or nearly so.
Eigen::VectorXd solve_non_negative(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace dermis::gaussians
