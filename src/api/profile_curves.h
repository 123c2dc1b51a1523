// SPDX-License-Identifier: MIT
/// The curves behind a profile of the public interface.
#pragma once

#include <array>
#include <string>

#include "dermis/profile.h"
#include "tissue/optics/media.h"
#include "tissue/profile/model.h"
#include "tissue/profile/radial.h"

namespace dermis {

struct ModelCurves {
  explicit ModelCurves(std::array<profile::ProfilePtr, 3> of) : profiles(std::move(of)) {}
  std::array<profile::ProfilePtr, 3> profiles;
};

namespace api {

/// Fits the profiles. `medium` is the modelled medium; if it is null, `eta` is the index of the surface.
ScatterProfile fitted_profile(const std::string& name, const profile::ModelledProfiles& made,
                              const optics::RgbMedium* medium, double eta, const ProfileOptions& options);

/// Likewise, of a medium, by the model that the options name.
ScatterProfile profile_of_medium(const std::string& name, const optics::RgbMedium& medium,
                                 const ProfileOptions& options);

}  // namespace api
}  // namespace dermis
