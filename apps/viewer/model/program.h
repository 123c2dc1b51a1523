// SPDX-License-Identifier: MIT
/// Programs that run beside the viewer: other commands of dermis, the shader compiler, a browser.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace dermis::viewer {

/// Runs a program until it ends, and looks after it every so often. Its output goes to the file `said`.
/// Returns whether its exit status was 0. Throws InputError: it cannot be started; Cancelled: `stop` was set
/// (may be null), and the program was told to end.
bool run_program(const std::vector<std::string>& words, const std::string& said,
                 const std::atomic<bool>* stop, std::chrono::milliseconds every);

/// Starts a program that nobody waits for.
void start_program(const std::vector<std::string>& words);

/// Returns the program `dermis` of this build.
std::string dermis_program();

/// Makes an empty folder of this process. Throws InputError.
std::string make_temporary_folder();

/// Such a folder, removed with all that is in it when this ends.
class TemporaryFolder {
 public:
  TemporaryFolder() : path_(make_temporary_folder()) {}
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Returns the last line of a file that is not empty.
std::string last_line(const std::string& file);

}  // namespace dermis::viewer
