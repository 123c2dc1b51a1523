// SPDX-License-Identifier: MIT
#include <new>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "environment/environment.h"
#include "image/codec.h"

namespace dermis::environment {
namespace {

image::ImageF load_radiance(const std::filesystem::path& path) {
  try {
    return image::load_image_f(path, {}, most_pixels);
  } catch (const std::bad_alloc&) { throw input_error(path.string(), "needs more memory than there is"); }
}

}  // namespace

Environment load(const std::filesystem::path& path) {
  return checked({.name = path.filename().string(), .radiance = load_radiance(path)}, path.string());
}

Environment from_name_or_file(const std::string& name) {
  if (name == "studio") return studio();
  std::error_code error;
  if (!std::filesystem::exists(name, error))
    throw input_error(name, "no such environment: neither a file (.hdr, .exr) nor the built-in 'studio'{}",
                      did_you_mean(name, {"studio"}));
  return load(name);
}

}  // namespace dermis::environment
