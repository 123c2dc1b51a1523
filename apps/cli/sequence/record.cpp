// SPDX-License-Identifier: MIT
#include "cli/sequence/record.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hash.h"

namespace dermis::cli::sequence {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 27;  // a million lines have half of it
constexpr const char* title = "dermis sequence 1";

// "NAME.PID.NUMBER.part", as write_file() calls what it has not finished.
struct Unfinished {
  std::string name;
  pid_t process = 0;
};
// Takes the number behind the last dot off the text; none if there is none of one to nine digits.
std::optional<int> take_number(std::string_view& text) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const std::string_view digits = text.substr(dot + 1);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (digits.empty() || digits.size() > 9 || !std::all_of(digits.begin(), digits.end(), is_digit))
    return std::nullopt;

  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  text.remove_suffix(digits.size() + 1);
  return number;
}

std::optional<Unfinished> unfinished(std::string_view file) {
  constexpr std::string_view ending = ".part";
  if (!file.ends_with(ending)) return std::nullopt;
  file.remove_suffix(ending.size());
  if (!take_number(file)) return std::nullopt;
  const std::optional<int> process = take_number(file);
  if (!process || file.empty()) return std::nullopt;
  return Unfinished{std::string(file), *process};
}

bool is_gone(pid_t process) { return ::kill(process, 0) != 0 && errno == ESRCH; }

}  // namespace

Record::Record(fs::path path, std::uint64_t fingerprint)
    : path_(std::move(path)), header_(fmt::format("{}\n{:016x}\n", title, fingerprint)) {}

Record::~Record() {
  if (file_ >= 0) ::close(file_);
}

void Record::load() {
  std::error_code error;
  if (!fs::exists(path_, error)) return;
  const std::vector<std::byte> bytes = read_file(path_, most_bytes);
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());

  if (!text.starts_with(std::string(title) + "\n"))
    throw input_error(path_.string(), "is not what a stopped `dermis sequence` leaves");
  if (!text.starts_with(header_))
    throw input_error(
        path_.string(),
        "belongs to another sequence: scene, settings, times, motion or program differ; without "
        "--resume it is replaced");

  std::istringstream lines(text.substr(header_.size()));
  std::getline(lines, device_);
  for (std::string one; std::getline(lines, one);) {
    std::size_t frame = 0;
    Written written;
    std::istringstream words(one);
    // The last line may be cut off: what does not give the same line again does not count.
    if (words >> frame >> written.bytes >> std::hex >> written.hash && line(frame, written) == one + "\n")
      frames_[frame] = written;
  }
}

bool Record::has(std::size_t frame, const fs::path& picture) const {
  const auto found = frames_.find(frame);
  std::error_code error;
  if (found == frames_.end() || fs::file_size(picture, error) != found->second.bytes || error) return false;
  return written(picture) == found->second;
}

void Record::open(const std::string& device) {
  if (!device_.empty() && device_ != device)
    throw input_error(path_.string(),
                      "was begun on {}, and this is {}, whose pictures may differ; without --resume it is "
                      "replaced",
                      device_, device);
  std::string text = header_ + device + "\n";
  for (const auto& [frame, written] : frames_) text += line(frame, written);
  write_file(path_, text);

  file_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (file_ < 0) throw input_error(path_.string(), "cannot be written: {}", std::strerror(errno));
}

void Record::add(std::size_t frame, const fs::path& picture) {
  const std::string text = line(frame, written(picture));
  const std::lock_guard lock(mutex_);
  errno = 0;
  if (::write(file_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
    throw input_error(path_.string(), "cannot be written: {}", std::strerror(errno == 0 ? ENOSPC : errno));
}

void Record::remove() {
  std::error_code ignored;  // most runs with nothing to do never had one
  fs::remove(path_, ignored);
}

Record::Written Record::written(const fs::path& picture) {
  const std::vector<std::byte> bytes = read_file(picture);
  Hash hash;
  hash.bytes(bytes.data(), bytes.size());
  return {.bytes = bytes.size(), .hash = hash.value()};
}

std::string Record::line(std::size_t frame, const Written& written) {
  return fmt::format("{} {} {:016x}\n", frame, written.bytes, written.hash);
}

void remove_unfinished(const fs::path& folder, const std::function<bool(const std::string&)>& is_ours) {
  std::error_code error;
  for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    const std::optional<Unfinished> found = unfinished(name);
    std::error_code ignored;
    if (found && is_gone(found->process) && is_ours(found->name)) fs::remove(at->path(), ignored);
  }
}

}  // namespace dermis::cli::sequence
