// SPDX-License-Identifier: MIT
#include "base/core/file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/core/error.h"

namespace dermis {
namespace fs = std::filesystem;

namespace {

struct Close {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// Returns whether the path is a device or a pipe. These are written directly: a rename would replace them
/// (as root, it would remove /dev/null).
bool is_stream(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

constexpr int most_links = 40;  // as many as Linux follows
// Of the 255 bytes that names have: leaves room for what file_beside() adds.
constexpr std::size_t longest_stem = 224;

/// Throws InputError on failure; a partly written file stays.
void write_bytes(const fs::path& to, std::span<const std::byte> bytes, const fs::path& named) {
  File file(std::fopen(to.c_str(), "wb"));
  if (!file) throw input_error(named.string(), "cannot be written: {}", std::strerror(errno));
  // A full disk may show when the buffer is flushed, and on a network when the file is closed.
  const bool written =
      bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  if (!written || std::fflush(file.get()) != 0 || std::fclose(file.release()) != 0)
    throw input_error(named.string(), "cannot be written: {}", std::strerror(errno));
}

}  // namespace

std::vector<std::byte> read_file(const fs::path& path, std::uint64_t limit_bytes, bool allow_empty) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw input_error(path.string(), "no such file");
  if (fs::is_directory(status)) throw input_error(path.string(), "is a directory, expected a file");
  if (!fs::is_regular_file(status)) throw input_error(path.string(), "is not a regular file");
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw input_error(path.string(), "cannot be opened: {}", std::strerror(errno));
  // Asks the open file, because another file may have taken its name meanwhile.
  struct stat opened {};
  if (::fstat(::fileno(file.get()), &opened) != 0)
    throw input_error(path.string(), "cannot be read: {}", std::strerror(errno));
  const auto size = static_cast<std::uint64_t>(opened.st_size);
  if (size > limit_bytes)
    throw input_error(path.string(), "has {} bytes, the limit is {}", size, limit_bytes);
  if (size == 0 && !allow_empty) throw input_error(path.string(), "is empty");

  std::vector<std::byte> bytes(size);
  if (size != 0 && std::fread(bytes.data(), 1, size, file.get()) != size)
    throw input_error(path.string(), "cannot be read to its end");
  return bytes;
}

void check_writable(const fs::path& path) {
  if (path.empty() || !path.has_filename())
    throw input_error(path.string(), "is not the name of a file to write");
  std::error_code error;
  if (fs::is_directory(path, error))
    throw input_error(path.string(), "is a directory, expected the name of a file to write");
  if (is_stream(path)) {
    if (::access(path.c_str(), W_OK) != 0)
      throw input_error(path.string(), "cannot be written: {}", std::strerror(errno));
    return;
  }
  const fs::path to = followed_links(path), folder = to.has_parent_path() ? to.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    throw input_error(path.string(), "folder '{}' does not exist", folder.string());
  if (::access(folder.c_str(), W_OK) != 0)
    throw input_error(path.string(), "folder '{}' cannot be written", folder.string());
}

fs::path followed_links(const fs::path& path) {
  fs::path at = path;
  std::error_code error;
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(at, error)); ++i)
    at = at.parent_path() / fs::read_symlink(at);  // an absolute one replaces the folder
  if (fs::is_symlink(fs::symlink_status(at, error)))
    throw input_error(path.string(), "cannot be written: {}", std::strerror(ELOOP));
  return at;
}

std::string file_stem(const fs::path& path) { return path.filename().string().substr(0, longest_stem); }

fs::path file_beside(const fs::path& path, std::string_view ending) {
  return path.parent_path() / (file_stem(path) + std::string(ending));
}

fs::path unfinished_path(const fs::path& path, unsigned number) {
  return file_beside(path, fmt::format(".{}.{}.part", ::getpid(), number));
}

std::string ending_of(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
  check_writable(path);
  if (is_stream(path)) return write_bytes(path, bytes, path);

  static std::atomic<unsigned> number{0};
  std::error_code ignored;
  const fs::path to = followed_links(path), part = unfinished_path(to, number++);

  try {
    write_bytes(part, bytes, path);
  } catch (...) {
    fs::remove(part, ignored);
    throw;
  }

  std::error_code error;
  fs::rename(part, to, error);
  if (error) {
    fs::remove(part, ignored);
    throw input_error(path.string(), "cannot be written: {}", error.message());
  }
}

void write_file(const fs::path& path, std::string_view text) {
  write_file(path, std::as_bytes(std::span(text.data(), text.size())));
}

bool same_file(const fs::path& a, const fs::path& b) {
  const auto full = [](const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)); };
  return full(a) == full(b);
}

}  // namespace dermis
