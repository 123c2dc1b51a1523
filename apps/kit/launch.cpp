// SPDX-License-Identifier: MIT
// run_kit: starts a program of the kit with the libraries that the kit brings. Needs the C library alone, and
// so uses nothing of the C++ library, which would ask for a newer one.
//
// Some libraries are also needed by Vulkan drivers, and a process has each once: an older one of the kit
// would keep a newer driver from loading. So the system's are used wherever the program starts with them.
#include <dlfcn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include "kit/place.h"

namespace {

// A program that starts without one of these has found the system's, and it is new enough. Below lib/.
constexpr const char* shared_with_drivers[] = {"libstdc++", "libgcc", "libz"};
constexpr int shared_count = 3;

// Of NVIDIA's driver, which a machine without a desktop may lack; in lib/desktop. Without libEGL it opens,
// and then offers no Vulkan.
constexpr const char* of_a_desktop[] = {"libX11.so.6", "libXext.so.6", "libEGL.so.1"};

// Where containers put NVIDIA's driver.
constexpr const char* nvidia_folder = "/usr/local/nvidia/lib64";
constexpr const char* nvidia_manifests[] = {"/usr/local/nvidia/share/vulkan/icd.d/nvidia_icd.json",
                                            "/usr/local/nvidia/vulkan/icd.d"};
constexpr const char* usual_manifests[] = {"/etc/vulkan/icd.d/nvidia_icd.json",
                                           "/usr/share/vulkan/icd.d/nvidia_icd.json"};

/// A text of fixed room; what does not fit is cut, and is_cut() says so.
class Text {
 public:
  Text& add(const char* more) {
    const std::size_t length = std::strlen(more);
    cut_ = cut_ || length_ + length >= sizeof text_;
    if (cut_) return *this;
    std::memcpy(text_ + length_, more, length + 1);
    length_ += length;
    return *this;
  }
  const char* get() const { return text_; }
  bool is_cut() const { return cut_; }

 private:
  char text_[8 * PATH_MAX] = "";
  std::size_t length_ = 0;
  bool cut_ = false;
};

bool is_there(const char* path) {
  struct stat found;
  return ::stat(path, &found) == 0;
}

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

int fail(const char* what, const char* why) {
  std::fprintf(stderr, "run_kit: %s%s\n", what, why);
  return 1;
}

/// Folders that are searched for libraries, in this order: the kit's own, those that `used` names, and what
/// the caller has set.
Text folders(const char* kit, const bool* used, const char* more = "") {
  Text list;
  list.add(kit).add("/lib");
  for (int i = 0; i < shared_count; ++i)
    if (used[i]) list.add(":").add(kit).add("/lib/").add(shared_with_drivers[i]);
  list.add(more);
  if (is_set("LD_LIBRARY_PATH")) list.add(":").add(std::getenv("LD_LIBRARY_PATH"));
  return list;
}

/// Whether the program starts with these folders; `said` is the first line that it or the dynamic linker
/// says.
bool starts(const char* program, const Text& libraries, char (&said)[512]) {
  int ends[2];
  if (::pipe(ends) != 0) return false;
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    ::setenv("LD_LIBRARY_PATH", libraries.get(), 1);
    ::execl(program, program, "--version", static_cast<char*>(nullptr));
    std::fprintf(stderr, "%s: %s\n", program, std::strerror(errno));
    ::_exit(127);
  }
  ::close(ends[1]);

  std::size_t length = 0;
  char rest[512];
  for (ssize_t count = 1; count > 0;) {
    const bool full = length + 1 >= sizeof said;
    count = ::read(ends[0], full ? rest : said + length, full ? sizeof rest : sizeof said - 1 - length);
    if (!full && count > 0) length += static_cast<std::size_t>(count);
  }
  ::close(ends[0]);
  said[length] = '\0';
  said[std::strcspn(said, "\n")] = '\0';

  int status = 0;
  return child > 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Sets LD_LIBRARY_PATH. False if the program does not start even with all that the kit has.
bool find_libraries(const char* kit, const char* program, char (&said)[512]) {
  bool used[shared_count] = {true, true, true};
  if (!starts(program, folders(kit, used), said)) return false;

  char ignored[512];
  for (bool& one : used) {
    one = false;
    one = !starts(program, folders(kit, used), ignored);
  }

  Text more;
  for (const char* library : of_a_desktop)
    if (::dlopen(library, RTLD_LAZY | RTLD_LOCAL) == nullptr) {
      more.add(":").add(kit).add("/lib/desktop");
      break;
    }
  if (is_there(nvidia_folder)) more.add(":").add(nvidia_folder);
  const Text all = folders(kit, used, more.get());
  std::snprintf(said, sizeof said, "LD_LIBRARY_PATH is too long");
  return !all.is_cut() && ::setenv("LD_LIBRARY_PATH", all.get(), 1) == 0;
}

/// Tells the loader of the kit's validation layer, and of drivers that stand where it does not look.
/// Variables that the caller has set stay.
void find_layers_and_drivers(const char* kit) {
  Text layers;
  layers.add(kit).add("/share/vulkan/explicit_layer.d");
  if (is_there(layers.get()) && !is_set("VK_LAYER_PATH") && !is_set("VK_ADD_LAYER_PATH"))
    ::setenv("VK_ADD_LAYER_PATH", layers.get(), 1);

  for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES"})
    if (is_set(variable)) return;
  // A driver that is named twice is two devices.
  for (const char* manifest : usual_manifests)
    if (is_there(manifest)) return;
  for (const char* manifest : nvidia_manifests)
    if (is_there(manifest)) {
      ::setenv("VK_ADD_DRIVER_FILES", manifest, 1);
      return;
    }
  // The driver's library may be there without a manifest. If it is not, the loader passes over this one.
  Text manifest;
  manifest.add(kit).add("/share/vulkan/icd.d/nvidia.json");
  ::setenv("VK_ADD_DRIVER_FILES", manifest.get(), 1);
}

}  // namespace

int main(int argc, char** argv) {
  char kit[PATH_MAX];
  if (!dermis::kit::find_program_folder(kit))
    return fail("cannot find the folder it was unpacked in; start it by its path", "");

  // These part a list of folders, or begin a name that the dynamic linker replaces.
  if (std::strpbrk(kit, ":;$") != nullptr) return fail(kit, ": may not lie in a folder with ':', ';' or '$'");

  Text dermis, measure;
  dermis.add(kit).add("/bin/dermis");
  measure.add(kit).add("/bin/kit");
  char said[512] = "";
  if (!find_libraries(kit, dermis.get(), said)) return fail("the packed program does not start: ", said);
  find_layers_and_drivers(kit);

  // `run_kit dermis render ...` is the program itself.
  const bool is_program = argc > 1 && std::strcmp(argv[1], "dermis") == 0;
  char** words = is_program ? argv + 1 : argv;
  ::execv((is_program ? dermis : measure).get(), words);
  return fail("cannot start ", (is_program ? dermis : measure).get());
}
