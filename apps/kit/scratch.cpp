// SPDX-License-Identifier: MIT
#include "kit/scratch.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>

#include "base/core/error.h"

namespace dermis::kit {
namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = ".kit-";
constexpr const char* lock_name = "lock";

int open_lock(const fs::path& folder, int flags) {
  const int file = ::open((folder / lock_name).c_str(), O_RDWR | O_CLOEXEC | flags, 0644);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

void remove_left(const fs::path& results) {
  std::error_code ignored;
  for (fs::directory_iterator entry(results, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    if (!entry->path().filename().string().starts_with(prefix)) continue;
    const int lock = open_lock(entry->path(), 0);
    if (lock < 0) continue;
    std::error_code failed;
    fs::remove_all(entry->path(), failed);
    ::close(lock);
  }
}

}  // namespace

Scratch::Scratch(const fs::path& results) {
  std::error_code error;
  fs::create_directories(results, error);
  if (error) throw input_error(results.string(), "cannot be made: {}", error.message());
  remove_left(results);

  const fs::space_info room = fs::space(results, error);
  const double free_mb = 1e-6 * static_cast<double>(room.available);
  if (!error && free_mb < least_free_mb)
    throw input_error(results.string(), "{:.0f} MB are free there, {:.0f} are needed", free_mb,
                      least_free_mb);

  std::string name = (results / (std::string(prefix) + "XXXXXX")).string();
  if (::mkdtemp(name.data()) == nullptr)
    throw input_error(results.string(), "cannot be written to: {}", std::strerror(errno));
  path_ = name;
  lock_ = open_lock(path_, O_CREAT);
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace dermis::kit
