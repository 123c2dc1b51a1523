// SPDX-License-Identifier: MIT
/// Profiles while a slider moves: a quick model first, the one that is right when there is time.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/model/background.h"
#include "viewer/model/skin_source.h"

namespace dermis::viewer {

/// R(r) of a profile and of its fit, per channel, for a plot.
struct SkinCurves {
  std::vector<double> r_mm;
  std::vector<std::array<double, 3>> model, standard_error, fit;  ///< per mm^2; no model: empty
};

struct MadeSkin {
  ScatterProfile profile;
  SkinCurves curves;
  std::string model;                    ///< for people
  std::string note;                     ///< why this model, and what it leaves out
  bool is_quick = false;                ///< a better one follows
  double ms = 0;                        ///< that it took
  std::optional<cli::Source> source{};  ///< of what can be exported; none: Gaussians alone
};

/// Computes a skin. `quick`: in a few hundredths of a second, by diffusion theory whatever the coefficients,
/// and without the curve of a model that has layers. Throws InputError: what the source says is wrong;
/// Cancelled.
MadeSkin make_skin(const SkinSource& source, bool quick, const Hooks& hooks);

/// Returns whether the quick model is not the one that the source asks for, or has no curve of it.
bool needs_better(const SkinSource& source);

/// Returns R(r) of a profile alone.
SkinCurves curves_of(const ScatterProfile& profile);

/// Returns the skin in the parameters of another system, with what gets lost. Throws InputError.
std::string exported_skin(const MadeSkin& skin, const std::string& system);

/// Returns its profile and the fit as an SVG. Throws InputError: Gaussians alone.
std::string plotted_skin(const MadeSkin& skin);

/// Computes the newest wish in the background.
class SkinMaker {
 public:
  explicit SkinMaker(std::function<void()> on_news) : work_(std::move(on_news)) {}

  /// Asks for this skin. A better model that is under way for another one is ended, a quick one is not: what
  /// it finds is shown while the next one is computed.
  void want(const SkinSource& source);
  /// Goes on. Returns what there is since the last call.
  std::optional<MadeSkin> take();
  /// Returns an error since the last call; empty: none.
  std::string take_error() { return std::exchange(error_, {}); }

  bool is_running() const { return work_.is_running() || next_; }
  std::string doing() const { return work_.doing(); }
  void end() { next_.reset(), work_.end(); }

 private:
  struct Wish {
    SkinSource source;
    bool quick = true;
  };
  void start();

  std::optional<Wish> next_;
  Wish under_way_;
  std::string error_;
  Background<MadeSkin> work_;
};

}  // namespace dermis::viewer
