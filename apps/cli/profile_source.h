// SPDX-License-Identifier: MIT
/// The start of `dermis profile`: one of several descriptions of skin, as three profiles.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "dermis/profile.h"
#include "tissue/optics/skin.h"
#include "tissue/profile/model.h"

namespace dermis::cli {

/// The options of the command that name a source and a model, as given.
struct SourceOptions {
  std::string preset, coefficients, layers, burley, csv, colour, import;
  std::string head;                          ///< glTF, whose colour map has the pigments
  std::vector<std::string> skin_material;    ///< of the head
  std::string melanin_map, haemoglobin_map;  ///< pictures to write of the head's pigments
  /// Members that were given: melanin makes it a source, the rest refine.
  SpectralSkin skin;
  std::set<std::string> given;  ///< names of those members
  ProfileOptions profile;
  std::filesystem::path cache;  ///< of Monte-Carlo
};

/// Of SourceOptions::import.
inline constexpr const char* import_help =
    "another system's values: \"unity reflectance=R,G,B scattering_distance=R,G,B\", unreal, cycles, "
    "openpbr, gltf";

/// Three profiles and what is known about them.
struct Source {
  std::string name;
  std::string model;  ///< for people
  std::string note;   ///< why that model, and what it leaves out; lines, empty if there is nothing to say
  std::array<profile::ProfilePtr, 3> profiles;
  optics::RgbMedium medium;          ///< the medium itself, or the homogeneous one that is equivalent
  bool equivalent = false;           ///< medium is a summary: equal total and half frequency
  std::optional<SpectralSkin> skin;  ///< of spectral skin and of colours
};

/// Exactly one source must be set: CLI::ParseError (exit status 2) if none or several are; InputError if what
/// it says is wrong.
Source open_source(const SourceOptions& options);

}  // namespace dermis::cli
