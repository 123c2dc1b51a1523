// SPDX-License-Identifier: MIT
// What the targets share: refusals that are told from findings, and files that live in memory.
#pragma once

#include <filesystem>
#include <string_view>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "targets.h"

namespace dermis::fuzz {

/// Throws InternalError unless the message is one line a person can read: not empty, at most 4,000 bytes, no
/// control characters.
void check_message(std::string_view message);

/// Runs `body`. False after an InputError, whose message is checked; every other exception passes.
template <class Body>
bool accepts(const Body& body) {
  try {
    body();
    return true;
  } catch (const InputError& error) {
    check_message(error.what());
    return false;
  }
}

std::string_view as_text(Bytes bytes);

/// A folder of this process, removed at its end; empty but for what a target puts there, so that files which
/// an input names cannot be found.
const std::filesystem::path& scratch_folder();

/// Replaces that file. Throws std::runtime_error if it cannot be written.
std::filesystem::path put_file(const std::filesystem::path& name, Bytes bytes);

}  // namespace dermis::fuzz
