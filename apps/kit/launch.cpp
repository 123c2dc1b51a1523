// SPDX-License-Identifier: MIT
// run_kit: starts a program of the kit with the libraries that the kit brings. Needs the C library alone.
//
// Some libraries are also needed by Vulkan drivers, and a process has each once: an older one of the kit would
// keep a newer driver from loading. So the system's are used wherever the program starts with them.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "kit/place.h"

namespace {

struct Fallback {
  const char* folder;  // below lib/
  const char* library;
};

// A program that starts without one of these has found the system's, and it is new enough.
constexpr Fallback needed_by_us[] = {
    {"libstdc++", "libstdc++.so.6"}, {"libgcc", "libgcc_s.so.1"}, {"libz", "libz.so.1"}};
// NVIDIA's driver needs these, which a machine without a desktop may lack.
constexpr Fallback needed_by_drivers[] = {{"x11", "libX11.so.6"}, {"x11", "libXext.so.6"}};

// Where containers put NVIDIA's driver.
constexpr const char* nvidia_folder = "/usr/local/nvidia/lib64";
constexpr const char* nvidia_manifests[] = {"/usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json",
                                            "/usr/local/nvidia/vulkan/icd.d/nvidia_icd.json",
                                            "/usr/local/nvidia/vulkan/icd.d"};

bool is_there(const std::string& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0;
}

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

int fail(const std::string& line) {
  std::fprintf(stderr, "run_kit: %s\n", line.c_str());
  return 1;
}

/// Returns a list of folders that is searched in this order, what the caller has set last.
std::string joined(const std::vector<std::string>& folders, const char* variable) {
  std::string list;
  for (const std::string& folder : folders) list += (list.empty() ? "" : ":") + folder;
  if (is_set(variable)) list += (list.empty() ? "" : ":") + std::string(std::getenv(variable));
  return list;
}

/// Whether the program starts with these folders; otherwise `said` is what the dynamic linker says, one line.
bool starts(const std::string& program, const std::string& folders, std::string& said) {
  int ends[2];
  if (::pipe(ends) != 0) return false;
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::setenv("LD_LIBRARY_PATH", folders.c_str(), 1);
    ::execl(program.c_str(), program.c_str(), "--version", static_cast<char*>(nullptr));
    std::perror(program.c_str());
    ::_exit(127);
  }
  ::close(ends[1]);

  std::string text;
  char part[512];
  for (ssize_t count; (count = ::read(ends[0], part, sizeof part)) > 0;)
    text.append(part, static_cast<std::size_t>(count));
  ::close(ends[0]);
  said = text.substr(0, text.find('\n'));

  int status = 0;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Folders of libraries for the program: the kit's own, and those of the fallbacks that this system needs.
/// Empty if the program does not start with any of them.
std::string library_folders(const std::string& kit, const std::string& program, std::string& said) {
  constexpr std::size_t count = std::size(needed_by_us);
  bool used[count];
  for (bool& one : used) one = true;
  const auto folders = [&] {
    std::vector<std::string> list{kit + "/lib"};
    for (std::size_t i = 0; i < count; ++i)
      if (used[i]) list.push_back(kit + "/lib/" + needed_by_us[i].folder);
    return list;
  };
  if (!starts(program, joined(folders(), "LD_LIBRARY_PATH"), said)) return {};

  std::string ignored;
  for (bool& one : used) {
    one = false;
    one = !starts(program, joined(folders(), "LD_LIBRARY_PATH"), ignored);
  }

  std::vector<std::string> list = folders();
  for (const Fallback& fallback : needed_by_drivers) {
    const std::string folder = kit + "/lib/" + fallback.folder;
    if (list.back() != folder && ::dlopen(fallback.library, RTLD_LAZY | RTLD_LOCAL) == nullptr)
      list.push_back(folder);
  }
  std::string all = joined(list, "LD_LIBRARY_PATH");
  if (is_there(nvidia_folder)) all += std::string(":") + nvidia_folder;
  return all;
}

/// Tells the loader of the kit's validation layer, and of drivers that stand where it does not look. What the
/// caller has set stays.
void find_layers_and_drivers(const std::string& kit) {
  const std::string layers = kit + "/share/vulkan/explicit_layer.d";
  if (is_there(layers) && !is_set("VK_LAYER_PATH") && !is_set("VK_ADD_LAYER_PATH"))
    ::setenv("VK_ADD_LAYER_PATH", layers.c_str(), 1);

  for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"})
    if (is_set(variable)) return;
  for (const char* manifest : nvidia_manifests)
    if (is_there(manifest)) {
      ::setenv("VK_ADD_DRIVER_FILES", manifest, 1);
      return;
    }
  // The driver's library without a manifest; if it is not there either, the loader passes over this.
  if (!is_there("/etc/vulkan/icd.d/nvidia_icd.json") && !is_there("/usr/share/vulkan/icd.d/nvidia_icd.json"))
    ::setenv("VK_ADD_DRIVER_FILES", (kit + "/share/vulkan/icd.d/nvidia.json").c_str(), 1);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string kit = dermis::kit::program_folder();
  if (kit.empty()) return fail("cannot find the folder it was unpacked in; start it by its path");

  // The first word may name another program of the kit: `run_kit dermis render ...`.
  int first = 1;
  std::string name = "kit";
  if (argc > 1 && std::string(argv[1]) == "dermis") {
    name = argv[1];
    first = 2;
  }
  const std::string program = kit + "/bin/" + name;

  std::string said;
  const std::string folders = library_folders(kit, kit + "/bin/dermis", said);
  if (folders.empty()) return fail("the packed program does not start: " + said);
  ::setenv("LD_LIBRARY_PATH", folders.c_str(), 1);
  find_layers_and_drivers(kit);

  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (int i = first; i < argc; ++i) words.push_back(argv[i]);
  words.push_back(nullptr);
  ::execv(program.c_str(), words.data());
  std::perror(("run_kit: " + program).c_str());
  return 1;
}
