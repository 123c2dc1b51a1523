// SPDX-License-Identifier: MIT
/// The report of `dermis profile`: its fit, as a table for people, as JSON, and as a picture.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/profile_plot.h"
#include "cli/profile_source.h"
#include "tissue/gaussians/fit.h"

namespace dermis::cli {

/// A fit in either form, ready to be printed.
struct Fitted {
  ScatterProfile shared;                          ///< terms empty if per channel
  std::array<gaussians::ChannelFit, 3> channels;  ///< terms empty if shared
  gaussians::Rgb error_percent{};
  /// light that the model gives back, which may be more than entered
  gaussians::Rgb model_total{};
  gaussians::Rgb total{};                                           ///< the same, at most 1
  gaussians::Rgb mean_free_path_mm{}, diffuse_mean_free_path_mm{};  ///< infinite where nothing absorbs
};

/// terms: 1 to 8. InputError names the channel that no sum of Gaussians fits.
Fitted fit(const Source& source, int terms, bool shared, ProfileFit measure = ProfileFit::plane);

/// Terms of channel c (0..2) with weights that sum to 1.
std::vector<gaussians::Term> normalised(const Fitted& fitted, int c);

/// Lines for a person, notes first.
std::string table(const Source& source, const Fitted& fitted);
/// Returns the distance of each sum from the fit, a row per sum.
std::string differences(const PlottedSum& fit, const std::vector<PlottedSum>& others);
/// The profile file; with variances_mm2 [k][3] if they are per channel, where a channel with fewer terms is
/// filled with terms of weight 0.
std::string profile_json(const Source& source, const Fitted& fitted);

/// The profile in the parameters of another system (tissue/gaussians/exchange.h), with what gets lost.
std::string exported(const Source& source, const Fitted& fitted, const std::string& system);

/// The fit as curves: its label is the number of terms that it has.
PlottedSum plotted(const Fitted& fitted);
/// A published sum or a profile file as curves. InputError as from_name_or_file().
PlottedSum plotted(const std::string& name_or_path);

}  // namespace dermis::cli
