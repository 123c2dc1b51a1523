// SPDX-License-Identifier: MIT
// Lists of the runs of the kit.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace dermis::kit {

/// Extent of a run.
enum class Extent {
  full,   ///< all of a record of docs/results; an hour of a GPU, days of a software driver
  quick,  ///< each kind of measurement at a size that a software driver manages in minutes
  smoke   ///< whether everything starts; its figures say nothing
};
const char* name_of(Extent extent);

/// The parts of a run, in order.
inline constexpr const char* parts[] = {"switches", "equality", "invariants", "frame",
                                        "bench",    "sessions", "crowd",      "memory"};

/// One setting away from its default. Each is drawn under the validation layer, with every technique.
struct Switch {
  std::string path;  ///< "quality.mask"; empty: nothing is changed
  std::string text;  ///< the value as JSON
  nlohmann::ordered_json value() const;
};
/// Returns every other value of each setting that is a choice, and a value for each that is a number or a
/// text, in the order of the settings. A smoke run has two of them.
std::vector<Switch> switches(Extent extent);

/// Whether a technique without light maps has no use for the setting. A full run switches it there, too: it
/// must not harm.
bool is_of_light_maps(const std::string& path);

/// Settings that stay as they are: where the picture goes, and how large it is.
bool is_fixed(const std::string& path);

/// Returns the settings of a small picture with one switch, as `dermis render --settings` reads them.
nlohmann::ordered_json settings_with(const std::string& technique, const Switch& change);

/// A statement that must hold on any device, and the tests that prove it: filters of kit_checks.
struct Invariant {
  std::string name, filter;
  bool quick = false;  ///< is part of a quick run
};
/// Returns those of the extent.
std::vector<Invariant> invariants(Extent extent);

}  // namespace dermis::kit
