// SPDX-License-Identifier: MIT
// Errors of memory name the file over which it ran out.
#pragma once

#include <new>
#include <string>

#include "base/core/error.h"
#include "dermis/scene.h"

namespace dermis::api {

/// Runs `work` for a scene. Trouble with the device, and memory that ends, become a DeviceError that names
/// the scene's file.
template <class Work>
auto naming_the_scene(const Scene& scene, const Work& work) {
  try {
    return work();
  } catch (const DeviceError& error) {
    const std::string text = error.what(), name = scene.name() + ": ";
    throw DeviceError(text.starts_with(name) ? text : name + text);
  } catch (const std::bad_alloc&) {
    throw device_error(
        "{}: too little memory; try smaller maps, a smaller texture_budget_mb or a smaller picture",
        scene.name());
  }
}

}  // namespace dermis::api
