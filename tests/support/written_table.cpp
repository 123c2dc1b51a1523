// SPDX-License-Identifier: MIT
#include "support/written_table.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "support/files.h"

namespace dermis::tests {

void expect_table(const std::filesystem::path& document, const std::string& title, const std::string& command,
                  const std::string& table) {
  const std::filesystem::path path = std::filesystem::path(DERMIS_SOURCE_DIR) / document;
  const std::string begin = "<!-- " + title + ": written by DERMIS_UPDATE=1 " + command + " -->\n";
  std::string text = read_text(path);
  const std::size_t line = text.find(begin);
  ASSERT_NE(line, std::string::npos) << path << " has lost its line " << begin;
  const std::size_t from = line + begin.size(), to = text.find("<!-- end -->", from);
  ASSERT_NE(to, std::string::npos) << path;

  if (std::getenv("DERMIS_UPDATE") != nullptr)
    write_text(path, text.replace(from, to - from, table));
  else
    EXPECT_EQ(text.substr(from, to - from), table);
}

}  // namespace dermis::tests
