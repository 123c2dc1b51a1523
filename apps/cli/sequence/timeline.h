// SPDX-License-Identifier: MIT
/// When the frames of a sequence are, and how camera and lamp move.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstddef>
#include <string>

#include "dermis/settings.h"

namespace dermis::cli::sequence {

/// Frames stand at from_s + n / fps, before to_s: a clip or a full turn that is played again and again shows
/// no frame twice in a row.
struct Timeline {
  double fps = 30;
  double from_s = 0, to_s = 0;

  std::size_t frames() const;               ///< at least 1
  double seconds(std::size_t frame) const;  ///< since the begin of the clip
  /// Of the way from from_s (0) to to_s (1, which no frame is).
  double share(std::size_t frame) const;
};
/// Throws InputError: a rate, a time or a number of frames out of range; the end is not after the begin.
void check(const Timeline& timeline);

/// A motion beside a clip, even from the begin to the end.
struct Motion {
  enum class Kind {
    none,
    orbit,       ///< CameraSettings::orbit_deg
    dolly,       ///< CameraSettings::distance, in the first value
    light_orbit  ///< azimuth and elevation of one more of LightingSettings::placed_lights
  };
  Kind kind = Kind::none;
  std::array<double, 2> from{}, to{};

  /// Returns the settings of the frame at this share of the way: those with which `dermis render` gives the
  /// same picture.
  RenderSettings at(RenderSettings settings, double share) const;
};
/// Throws InputError: begin or end out of range, or a camera is chosen that the motion does not move.
void check(const Motion& motion, const RenderSettings& settings);

/// Adds --orbit (which may also stand still), --dolly and --light-orbit.
void add_motion_options(CLI::App& command, RenderSettings& settings, Motion& motion);

/// Returns the motion as text, for a fingerprint.
std::string text_of(const Motion& motion);

}  // namespace dermis::cli::sequence
