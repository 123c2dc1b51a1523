// SPDX-License-Identifier: MIT
/// `dermis profile`: from what skin is to a profile that a renderer takes.
#pragma once

#include <CLI/CLI.hpp>

namespace dermis::cli {

void add_profile_command(CLI::App& app, int& exit_status);

}  // namespace dermis::cli
