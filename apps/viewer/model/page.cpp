// SPDX-License-Identifier: MIT
#include "viewer/model/page.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "core/error.h"
#include "dermis/cancelled.h"

namespace dermis::viewer {
namespace {

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Starts a program whose output goes to a file. Returns its number, or 0.
pid_t start(std::vector<std::string> words, const std::string& output) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, words.front().c_str(), &actions, nullptr, pointers_to(words).data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed ? 0 : child;
}

std::string last_line(const std::string& file) {
  std::ifstream in(file);
  std::string line, last;
  while (std::getline(in, line))
    if (!line.empty()) last = line;
  return last.empty() ? "it said nothing" : last;
}

std::string make_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "dermis-page-XXXXXX").string();
  if (!mkdtemp(name.data())) throw InputError(name, "no folder for the page can be made there");
  return name;
}

}  // namespace

std::vector<Page> pages_of(const std::vector<std::string>& scene_words,
                           const std::vector<std::string>& options, const std::string& device) {
  const std::string scene = scene_words.empty() ? "built-in" : scene_words.front();
  std::vector<std::string> compare{"compare", "--scene", scene, "--techniques", "all", "--device", device};
  // What compare calls otherwise, or decides itself, is left out.
  for (std::size_t i = 0; i + 1 < options.size(); ++i)
    for (const char* same : {"--eye", "--target", "--fov", "--map-size", "--shadow-size", "--environment"})
      if (options[i] == same) {
        compare.push_back(options[i]);
        compare.push_back(options[i + 1]);
      }
  compare.insert(compare.end(), {"--size", "320x360", "--noise", "5"});
  std::vector<std::string> bench{"bench", scene, "--quick", "--device", device};
  return {{"Techniques against the truth", compare}, {"The paper's test, quick", bench}};
}

std::string write_page(const Page& page, const Hooks& hooks) {
  const std::string folder = make_folder(), file = folder + "/page.html", said = folder + "/said.txt";
  std::error_code error;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  std::vector<std::string> words{(here / "dermis").string()};
  words.insert(words.end(), page.words.begin(), page.words.end());
  words.insert(words.end(), {"--html", file});

  const pid_t child = start(words, said);
  if (child == 0) throw input_error(words.front(), "cannot be started");
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (hooks.stop && *hooks.stop) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      std::filesystem::remove_all(folder, error);
      throw Cancelled("the page was stopped");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw InputError("", last_line(said));
  return file;
}

void open_page(const std::string& file) { start({"xdg-open", file}, "/dev/null"); }

}  // namespace dermis::viewer
