// SPDX-License-Identifier: MIT
// The end of the program when something goes wrong.
#pragma once

#include <CLI/CLI.hpp>

namespace dermis::cli {

/// Prints the exception that is being handled, in one line on standard error, with the options of the command
/// that ran. Returns the exit status: 0 for --help and --version, 2 for a command line that cannot be parsed,
/// 70 for a mistake of dermis (EX_SOFTWARE of sysexits.h), 1 for everything else. Call it in a handler.
int report_failure(const CLI::App& app);

}  // namespace dermis::cli
