// SPDX-License-Identifier: MIT
// Tables of the documents that are written from the code.
#pragma once

#include <filesystem>
#include <string>

namespace dermis::tests {

/// Expects `table` in the document, below root, between the line "<!-- `title`: written by DERMIS_UPDATE=1
/// `command` -->" and "<!-- end -->". With DERMIS_UPDATE=1 in the environment, writes it there.
void expect_table(const std::filesystem::path& document, const std::string& title, const std::string& command,
                  const std::string& table);

}  // namespace dermis::tests
