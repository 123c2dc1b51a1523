// SPDX-License-Identifier: MIT
#include "base/core/cache.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/log.h"

namespace dermis::cache {
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t default_limit_mb = 1000;
constexpr std::array<std::string_view, 4> prefixes{"occlusion", "monte-carlo", "pipelines", "built-in"};
constexpr std::string_view unfinished = "unfinished", part_ending = ".part";
// Another process may still be writing a younger file.
constexpr std::chrono::hours part_lifetime{1};

constexpr std::string_view seal_word = "checksum ";
constexpr std::size_t seal_bytes = seal_word.size() + 16 + 1;

std::string seal_of(std::span<const std::byte> bytes) {
  return fmt::format("{}{:016x}\n", seal_word, checksum(bytes));
}

struct Entry {
  fs::path path;
  std::string_view kind;
  std::uint64_t bytes = 0;
  fs::file_time_type used{};
};

/// Returns the kind of a file name; empty if it is not ours.
std::string_view kind_of(const std::string& name) {
  for (const std::string_view prefix : prefixes) {
    if (!name.starts_with(prefix)) continue;
    const std::string_view rest = std::string_view(name).substr(prefix.size());
    if (!rest.starts_with('-') && !rest.starts_with('.')) continue;
    return name.ends_with(part_ending) ? unfinished : prefix;
  }
  return {};
}

// Lists the files of the cache. Skips those that another process removes meanwhile.
std::vector<Entry> entries_of(const fs::path& folder) {
  std::vector<Entry> entries;
  std::error_code error;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const std::string_view kind = kind_of(i->path().filename().string());
    std::error_code gone;
    if (kind.empty() || !i->is_regular_file(gone)) continue;

    Entry entry{.path = i->path(), .kind = kind};
    entry.bytes = i->file_size(gone);
    if (!gone) entry.used = i->last_write_time(gone);
    if (!gone) entries.push_back(std::move(entry));
  }
  return entries;
}

std::vector<Usage> sum_of(const std::vector<Entry>& entries) {
  std::vector<Usage> sums;
  for (const std::string_view kind : prefixes) sums.push_back({.kind = std::string(kind)});
  sums.push_back({.kind = std::string(unfinished)});
  for (const Entry& entry : entries)
    for (Usage& sum : sums)
      if (sum.kind == entry.kind) {
        ++sum.files;
        sum.bytes += entry.bytes;
      }
  return sums;
}

/// Makes room for `coming` bytes under the name of `file`, whose old content will be replaced.
void evict(const fs::path& file, std::uint64_t coming, std::uint64_t limit) {
  std::vector<Entry> entries = entries_of(file.parent_path());
  const auto now = fs::file_time_type::clock::now();
  std::error_code ignored;
  std::erase_if(entries, [&](const Entry& entry) {
    if (entry.kind == unfinished && now - entry.used > part_lifetime) fs::remove(entry.path, ignored);
    return entry.kind == unfinished || entry.path == file;
  });

  std::uint64_t held = coming;
  for (const Entry& entry : entries) held += entry.bytes;
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return a.used != b.used ? a.used < b.used : a.path < b.path;
  });
  for (const Entry& entry : entries) {
    if (held <= limit) return;
    if (fs::remove(entry.path, ignored)) held -= entry.bytes;
  }
}

}  // namespace

fs::path default_folder() {
  const auto from = [](const char* variable) -> fs::path {
    const char* value = std::getenv(variable);
    return value && *value ? value : "";
  };
  if (const fs::path cache = from("XDG_CACHE_HOME"); !cache.empty()) return cache / "dermis";
  if (const fs::path home = from("HOME"); !home.empty()) return home / ".cache" / "dermis";
  return {};
}

std::uint64_t limit_bytes() {
  std::uint64_t mb = default_limit_mb;
  if (const char* value = std::getenv("DERMIS_CACHE_LIMIT"); value && *value) {
    std::uint64_t wanted = 0;
    const char* const end = value + std::strlen(value);
    const auto read = std::from_chars(value, end, wanted);
    if (read.ec == std::errc() && read.ptr == end && wanted <= std::uint64_t{1} << 40)
      mb = wanted;
    else
      warn("DERMIS_CACHE_LIMIT is not a number of whole megabytes; the limit is {}", default_limit_mb);
  }
  return mb * 1'000'000;
}

std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint64_t>(b)) * 0x100000001B3u;
  return hash;
}

std::optional<std::vector<std::byte>> read(const fs::path& file, std::uint64_t most_bytes) {
  std::error_code error;
  if (file.empty() || !fs::is_regular_file(file, error)) return std::nullopt;
  std::vector<std::byte> bytes;
  try {
    bytes = read_file(file, most_bytes + seal_bytes, true);
  } catch (const InputError&) { return std::nullopt; }

  const std::size_t body = bytes.size() < seal_bytes ? 0 : bytes.size() - seal_bytes;
  const std::string seal = seal_of(std::span(bytes).first(body));
  if (bytes.size() < seal_bytes || std::memcmp(bytes.data() + body, seal.data(), seal_bytes) != 0) {
    note("{}: damaged, or of another version; it is made again", file.string());
    return std::nullopt;
  }
  bytes.resize(body);
  // Marks the file as used now; if that fails, its age counts from when it was written.
  fs::last_write_time(file, fs::file_time_type::clock::now(), error);
  return bytes;
}

bool write(const fs::path& file, std::vector<std::byte> bytes, std::uint64_t limit) {
  if (file.empty()) return false;
  const std::string seal = seal_of(bytes);
  const auto sealing = std::as_bytes(std::span(seal));
  bytes.insert(bytes.end(), sealing.begin(), sealing.end());
  if (bytes.size() > limit) return false;

  std::error_code ignored;  // if the folder cannot be created, the write reports it
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  evict(file, bytes.size(), limit);
  try {
    write_file(file, bytes);
    return true;
  } catch (const InputError& error) {
    constexpr const char* kind = "not kept for the next run";
    warn_once(kind, fmt::format("{}: {}", kind, error.what()));
    return false;
  }
}

std::vector<Usage> usage(const fs::path& folder) { return sum_of(entries_of(folder)); }

std::vector<Usage> clear(const fs::path& folder) {
  std::vector<Entry> entries = entries_of(folder);
  std::erase_if(entries, [](const Entry& entry) {
    std::error_code failed;
    return !fs::remove(entry.path, failed);
  });
  return sum_of(entries);
}

}  // namespace dermis::cache
