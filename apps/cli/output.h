// SPDX-License-Identifier: MIT
/// Where a command's text goes.
#pragma once

#include <string>

namespace dermis::cli {

/// Throws InputError if standard output did not take all that was printed: a full disk behind a pipe.
void finish_output();

/// Text to a file, atomically, or to standard output if path is "-". InputError if it does not get there
/// whole: a full disk behind a pipe is a failure, too.
void write_text(const std::string& path, const std::string& text);

}  // namespace dermis::cli
