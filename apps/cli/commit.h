// SPDX-License-Identifier: MIT
#pragma once

namespace dermis::cli {

/// The commit that the program was built from, as `git describe --always --dirty` names it; "unknown" outside
/// of a repository.
const char* commit();

}  // namespace dermis::cli
