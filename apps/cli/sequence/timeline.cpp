// SPDX-License-Identifier: MIT
#include "cli/sequence/timeline.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "base/core/error.h"
#include "base/settings/fields.h"
#include "cli/settings_options.h"

namespace dermis::cli::sequence {
namespace {

constexpr double most_fps = 1000, most_s = 1e6;
constexpr std::size_t most_frames = 1'000'000;
constexpr const char* group = "Sequence";

// As many numbers with commas between them as there is room for.
bool parse_numbers(std::string_view text, std::size_t count, std::array<double, 2>& numbers) {
  const char *at = text.data(), *const end = at + text.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return false;
    const auto number = std::from_chars(at, end, numbers[i]);
    if (number.ec != std::errc()) return false;
    at = number.ptr;
  }
  return at == end;
}

// FROM..TO, each of `count` numbers. A single place is a motion that stands still if `may_stand`.
bool parse_range(const std::string& text, std::size_t count, bool may_stand, Motion& motion) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return may_stand && parse_numbers(text, count, motion.from);
  const std::string_view all = text;
  return parse_numbers(all.substr(0, dots), count, motion.from) &&
         parse_numbers(all.substr(dots + 2), count, motion.to);
}

// The help of the setting that a motion changes.
std::string help_of_setting(std::string_view path) {
  std::string help;
  const RenderSettings settings;
  for_each_setting(settings, [&](const std::string& name, const About& about, const auto&, std::string_view) {
    if (name == path) help = help_of(about);
  });
  return help;
}

void set_kind(Motion& motion, Motion::Kind kind) {
  if (motion.kind != Motion::Kind::none)
    throw input_error("", "--orbit, --dolly and --light-orbit each move something; give one range of them");
  motion.kind = kind;
}

}  // namespace

std::size_t Timeline::frames() const {
  // The rounding of a product must not add a frame.
  const double count = std::ceil((to_s - from_s) * fps - 1e-6);
  return static_cast<std::size_t>(std::max(count, 1.0));
}

double Timeline::seconds(std::size_t frame) const { return from_s + static_cast<double>(frame) / fps; }

double Timeline::share(std::size_t frame) const { return static_cast<double>(frame) / fps / (to_s - from_s); }

void check(const Timeline& t) {
  if (!(t.fps > 0 && t.fps <= most_fps))
    throw input_error("--fps", "must be above 0 and at most {:g} frames per second, got {:g}", most_fps,
                      t.fps);
  for (const auto& [name, seconds] : {std::pair("--from", t.from_s), std::pair("--to", t.to_s)})
    if (!(seconds >= 0 && seconds <= most_s))
      throw input_error(name, "must be 0 to {:g} s, got {:g}", most_s, seconds);
  if (!(t.to_s > t.from_s))
    throw input_error("--to", "must be after the begin of the sequence, {:g} s, got {:g}", t.from_s, t.to_s);
  if ((t.to_s - t.from_s) * t.fps > most_frames)
    throw input_error("--to", "{:g} s at {:g} frames per second are more than {} frames", t.to_s - t.from_s,
                      t.fps, most_frames);
}

RenderSettings Motion::at(RenderSettings s, double share) const {
  const auto value = [&](std::size_t i) { return from[i] + (to[i] - from[i]) * share; };
  switch (kind) {
    case Kind::none: break;
    case Kind::orbit:
      s.camera.orbit_deg = {value(0), value(1)};
      // The orbit 0,0 is the camera of the file, where that has one: the picture would jump.
      if (s.camera.orbit_deg == std::array<double, 2>{0, 0}) s.camera.orbit_deg[0] = 360;
      break;
    case Kind::dolly: s.camera.distance = value(0); break;
    case Kind::light_orbit:
      s.lighting.placed_lights.push_back({.azimuth_deg = value(0), .elevation_deg = value(1)});
      break;
  }
  return s;
}

void check(const Motion& motion, const RenderSettings& settings) {
  for (const double share : {0.0, 1.0}) check_ranges(motion.at(settings, share));

  const CameraSettings& camera = settings.camera;
  if (motion.kind == Motion::Kind::orbit && (!camera.name.empty() || camera.distance))
    throw input_error("--orbit", "turns the framing camera, which {} replaces",
                      camera.name.empty() ? "--distance" : "--camera");
}

void add_motion_options(CLI::App& command, RenderSettings& settings, Motion& motion) {
  const auto orbit = [&settings, &motion](const std::string& text) {
    Motion read;
    if (!parse_range(text, 2, true, read))
      throw CLI::ValidationError("--orbit", "expected AZ,EL or AZ,EL..AZ,EL in degrees, got '" + text + "'");
    settings.camera.orbit_deg = read.from;
    if (text.find("..") == std::string::npos) return;
    set_kind(motion, Motion::Kind::orbit);
    motion.from = read.from, motion.to = read.to;
  };
  command
      .add_option_function<std::string>("--orbit", orbit,
                                        help_of_setting("camera.orbit_deg") + "; from one place to another")
      ->type_name("AZ,EL[..AZ,EL]")
      ->group(group);

  const auto dolly = [&motion](const std::string& text) {
    set_kind(motion, Motion::Kind::dolly);
    if (!parse_range(text, 1, false, motion))
      throw CLI::ValidationError("--dolly", "expected D..D in radii, got '" + text + "'");
  };
  command
      .add_option_function<std::string>("--dolly", dolly,
                                        "move the camera: distance from the eye to the middle head, in radii")
      ->type_name("D..D")
      ->group(group);

  const auto light_orbit = [&command, &settings, &motion](const std::string& text) {
    set_kind(motion, Motion::Kind::light_orbit);
    if (!parse_range(text, 2, false, motion))
      throw CLI::ValidationError("--light-orbit", "expected AZ,EL..AZ,EL in degrees, got '" + text + "'");
    // As --light: it replaces the rig of a file of settings.
    if (command.get_option("--lights")->count() == 0) settings.lighting.rig_lights.reset();
  };
  command
      .add_option_function<std::string>("--light-orbit", light_orbit,
                                        "move a lamp as those of --light around the head, beside these")
      ->type_name("AZ,EL..AZ,EL")
      ->group(group);
}

std::string text_of(const Motion& m) {
  return fmt::format("{} {} {} {} {}", static_cast<int>(m.kind), m.from[0], m.from[1], m.to[0], m.to[1]);
}

}  // namespace dermis::cli::sequence
