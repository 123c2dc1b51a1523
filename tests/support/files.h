// SPDX-License-Identifier: MIT
// A folder that goes away, and files as text.
#pragma once

#include <filesystem>
#include <string>

namespace dermis::tests {

/// A fresh folder, removed with all that is in it at the end.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A folder of this run of the program, removed when it ends: programs that run side by side do not meet.
const std::filesystem::path& program_folder();

/// Empty if there is no such file.
std::string read_text(const std::filesystem::path& path);

/// Throws std::runtime_error if it cannot be written.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace dermis::tests
