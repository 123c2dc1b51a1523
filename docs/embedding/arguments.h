// SPDX-License-Identifier: MIT
/// The command line of the sample. Nothing here concerns dermis.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace host {

struct Arguments {
  std::string picture, linear;
  int frames = 60;
  bool validate = false;
};

/// Returns nothing if they make no sense.
std::optional<Arguments> read_arguments(std::span<char*> words);

}  // namespace host
