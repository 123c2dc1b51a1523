// SPDX-License-Identifier: MIT
#include "viewer/model/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "base/core/error.h"
#include "dermis/cancelled.h"

namespace dermis::viewer {
namespace {

// Starts a program whose output goes to a file. Returns its number, or 0.
pid_t start(std::vector<std::string> words, const std::string& output) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, words.front().c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed ? 0 : child;
}

}  // namespace

bool run_program(const std::vector<std::string>& words, const std::string& said,
                 const std::atomic<bool>* stop, std::chrono::milliseconds every) {
  const pid_t child = start(words, said);
  if (child == 0) throw input_error(words.front(), "cannot be started");
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (stop && *stop) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      throw Cancelled(words.front() + " was stopped");
    }
    std::this_thread::sleep_for(every);
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void start_program(const std::vector<std::string>& words) { start(words, "/dev/null"); }

std::string dermis_program() {
  std::error_code error;
  return (std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "dermis").string();
}

std::string make_temporary_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "dermis-view-XXXXXX").string();
  if (!mkdtemp(name.data())) throw InputError(name, "no folder can be made there");
  return name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

std::string last_line(const std::string& file) {
  std::ifstream in(file);
  std::string line, last;
  while (std::getline(in, line))
    if (!line.empty()) last = line;
  return last.empty() ? "it said nothing" : last;
}

}  // namespace dermis::viewer
