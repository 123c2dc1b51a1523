// SPDX-License-Identifier: MIT
#include "tools/dataset/shard_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>
#include <utility>
#include <vector>

#include "base/core/error.h"
#include "base/core/log.h"
#include "dermis/dataset.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto forgotten_after = 1h;  // of a file of another machine, whose locks may not be seen here
constexpr auto patience = 2s;  // for what another worker writes beside a file that it has just published

[[noreturn]] void try_again(const fs::path& path, const char* what, int error) {
  throw TryAgain(fmt::format("{}: {}: {}", path.string(), what, std::strerror(error)));
}

// In names of files.
std::string host() {
  std::string text = host_name();
  for (char& c : text)
    if (c == '/' || c == '.') c = '-';
  return text.empty() ? "unknown" : text;
}

bool is_at(const fs::path& path, int file) {
  struct stat opened {
  }, named{};
  return ::fstat(file, &opened) == 0 && ::stat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

void write_all(int file, const fs::path& path, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) try_again(path, "cannot be written", written < 0 ? errno : ENOSPC);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

// Opens a temporary file under its lock, empty. Returns its descriptor.
int open_locked(const fs::path& temporary, const fs::path& path) {
  while (true) {
    const int file = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) try_again(path, "cannot be written", errno);
    // A file system without locks does without: then others wait for the hour.
    while (::flock(file, LOCK_EX) != 0 && errno == EINTR) continue;
    // Another worker that looks for files of dead ones may have taken this one between open and lock.
    if (is_at(temporary, file)) return file;
    ::close(file);
  }
}

/// A small file beside, gone unless it has got its name.
class Beside {
 public:
  Beside(const fs::path& path, std::string_view text)
      : path_(path), temporary_(temporary_of(path)), file_(open_locked(temporary_, path)) {
    try {
      write_all(file_, path, std::as_bytes(std::span(text.data(), text.size())));
      if (::fsync(file_) != 0 && errno != EINVAL) try_again(path, "cannot be written", errno);
    } catch (...) {
      remove();
      throw;
    }
  }
  ~Beside() { remove(); }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  void take_name() {
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) try_again(path_, "cannot be written", errno);
  }

 private:
  void remove() {
    if (is_at(temporary_, file_)) ::unlink(temporary_.c_str());
    ::close(file_);
  }

  fs::path path_, temporary_;
  int file_;
};

// Gives a file its name unless there is one of that name. Returns 0, or an errno.
int named_once(const fs::path& from, const fs::path& to) {
  if (::link(from.c_str(), to.c_str()) == 0) {
    ::unlink(from.c_str());
    return 0;
  }
  const int refused = errno;
  if (refused == EEXIST || refused == ENOSPC || refused == EDQUOT || refused == EIO) return refused;

  // File systems without hard links. Without either call a second worker may replace the file by equal bytes.
  note("{}: link() is refused here ({}); the shard is renamed into place", to.string(),
       std::strerror(refused));
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno == EEXIST) return EEXIST;
  struct stat there {};
  if (::stat(to.c_str(), &there) == 0) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

}  // namespace

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

fs::path temporary_of(const fs::path& path) {
  static std::atomic<unsigned> number{0};  // workers may be threads of one process
  const unsigned n = number++;
  return fs::path(
      fmt::format("{}.{}.{}{}", path.string(), host(), ::getpid(), n == 0 ? "" : fmt::format("-{}", n)));
}

std::vector<fs::path> held_temporaries(const fs::path& path, bool removes) {
  std::vector<fs::path> held;
  const std::string prefix = path.filename().string() + ".", here = "." + host() + ".";
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix) ||
        std::count(name.begin() + static_cast<std::ptrdiff_t>(prefix.size()), name.end(), '.') != 1)
      continue;
    const int file = ::open(entry.path().c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) continue;  // it has just been published or removed

    const bool is_free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(entry.path(), ignored);
    const bool is_dead = is_free && (name.find(here) != std::string::npos || age > forgotten_after);
    if (is_dead && removes) ::unlink(entry.path().c_str());
    if (!is_dead) held.push_back(entry.path());
    ::close(file);
  }
  return held;
}

ShardFile::ShardFile(const fs::path& path)
    : path_(path), temporary_(temporary_of(path)), file_(open_locked(temporary_, path)) {}

ShardFile::~ShardFile() {
  if (is_at(temporary_, file_)) ::unlink(temporary_.c_str());
  ::close(file_);
}

void ShardFile::write(std::span<const std::byte> bytes) {
  write_all(file_, path_, bytes);
  hash_.add(bytes);
  bytes_ += bytes.size();
}

std::string ShardFile::finish() {
  if (::fsync(file_) != 0 && errno != EINVAL) try_again(path_, "cannot be written", errno);
  return digest_ = hash_.digest();
}

ShardFile::Published ShardFile::publish(const fs::path& beside, std::string_view text) {
  Beside small(beside, text);  // first: then a full disk leaves nothing
  const int error = named_once(temporary_, path_);
  if (error == 0) {
    small.take_name();
    return Published::by_us;
  }
  if (error != EEXIST) try_again(path_, "cannot be published", error);

  // Another worker was first. Its small file is there, or comes; or it has died between the two.
  std::error_code ignored;
  for (auto waited = 0ms; waited < patience; waited += 50ms) {
    if (fs::exists(beside, ignored)) return Published::was_there;
    if (hash_of_file(path_).sha256 == digest_) break;
    std::this_thread::sleep_for(50ms);
  }
  if (fs::exists(beside, ignored)) return Published::was_there;
  if (hash_of_file(path_).sha256 != digest_ && ::rename(temporary_.c_str(), path_.c_str()) != 0)
    try_again(path_, "cannot be published", errno);
  small.take_name();
  return Published::by_us;
}

}  // namespace dermis::dataset
