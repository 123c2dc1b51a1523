// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace dermis::cli {

/// The commit that the program was built from, as `git describe --always --dirty` names it; "unknown" outside
/// of a repository.
const char* commit();

/// Returns what --version prints, a few lines: "dermis 0.2.0 (commit)", then what it was built with.
std::string version_text();

}  // namespace dermis::cli
