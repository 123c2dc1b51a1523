// SPDX-License-Identifier: MIT
/// Surroundings on the device, and what a frame needs of them.
#pragma once

#include <filesystem>
#include <string>

#include "dermis/renderer.h"
#include "environment/environment.h"
#include "gpu/resources.h"
#include "shared/scene_io.h"

namespace dermis::api {

struct Surroundings {
  std::string name;                         ///< RenderSettings::environment
  std::filesystem::file_time_type written;  ///< of the file when it was read
  environment::Irradiance irradiance;
  gpu::Texture map;  ///< RGBA16F, prefiltered
};

/// InputError: see environment::from_name_or_file.
Surroundings surroundings_of(gpu::Device& device, const std::string& name);

/// Is it still what this name means? A file may have changed.
bool is_current(const Surroundings& surroundings, const std::string& name);

void fill_surroundings(io::FrameIo& frame, const Surroundings& surroundings, const RenderSettings& settings);

}  // namespace dermis::api
