// SPDX-License-Identifier: MIT
#include "viewer/model/page.h"

#include <chrono>
#include <filesystem>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "dermis/cancelled.h"
#include "viewer/model/program.h"

namespace dermis::viewer {

std::vector<Page> pages_of(const std::vector<std::string>& scene_words,
                           const std::vector<std::string>& options, const std::string& device) {
  const std::string scene = scene_words.empty() ? "built-in" : scene_words.front();
  std::vector<std::string> compare{"compare", "--scene", scene, "--techniques", "all", "--device", device};
  // Options that compare calls otherwise, or decides itself, are left out.
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
  const std::string folder = make_temporary_folder(), file = folder + "/page.html",
                    said = folder + "/said.txt";
  std::vector<std::string> words{dermis_program()};
  words.insert(words.end(), page.words.begin(), page.words.end());
  words.insert(words.end(), {"--html", file});

  try {
    if (run_program(words, said, hooks.stop, std::chrono::milliseconds(50))) return file;
  } catch (const Cancelled&) {
    std::error_code error;
    std::filesystem::remove_all(folder, error);
    throw;
  }
  throw InputError("", last_line(said));
}

std::string write_profile_page(const MadeSkin& skin, const Hooks& hooks) {
  const HookScope scope(hooks);
  std::string file = make_temporary_folder() + "/profile.svg";
  write_file(file, plotted_skin(skin));
  return file;
}

void open_page(const std::string& file) { start_program({"xdg-open", file}); }

}  // namespace dermis::viewer
