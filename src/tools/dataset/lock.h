// SPDX-License-Identifier: MIT
// recipe.lock.json: a recipe with all that its samples depend on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/dataset/inputs.h"
#include "tools/dataset/recipe.h"

namespace dermis::dataset {

/// Devices of one class draw the same bits.
struct DeviceClass {
  std::string name, driver, api;
  bool operator==(const DeviceClass&) const = default;
  std::string text() const { return name + " (" + driver + ")"; }
};

struct Lock {
  std::shared_ptr<const Recipe::State> recipe;  ///< with all licences
  std::string inputs_sha256;                    ///< of all files
  std::vector<Input> inputs;
  DeviceClass device;  ///< that prepared it
  /// Typology angle of the skin of each entry, degrees; none: not measured, or its options differ by person.
  std::vector<std::optional<double>> ita_deg;
  bool one_device = false;
};

std::filesystem::path lock_file(const std::filesystem::path& folder);

Json json_of(const DeviceClass& device);
DeviceClass device_of(const json::Value& object);
Json json_of(const Licence& licence);

/// One hash of all files.
std::string hash_of_inputs(const std::vector<Input>& inputs);

std::string text_of(const Lock& lock, const std::filesystem::path& folder);
/// Throws InputError: the folder is not prepared, or by another version of dermis; the lock was edited.
Lock load_lock(const std::filesystem::path& folder);
/// Throws InputError: a file has changed since.
void check_inputs(const Lock& lock);

}  // namespace dermis::dataset
