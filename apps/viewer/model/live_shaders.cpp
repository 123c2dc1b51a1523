// SPDX-License-Identifier: MIT
#include "viewer/model/live_shaders.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <set>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/core/error.h"
#include "base/core/file.h"
#include "dermis/cancelled.h"
#include "gpu/replaced_shader.h"
#include "render/techniques/shaders.h"

namespace dermis::viewer {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto look_every = 400ms;

bool is_shader(const fs::path& file) {
  const fs::path ending = file.extension();
  return ending == ".comp" || ending == ".vert" || ending == ".frag";
}

// Returns the shaders that a file is, by name as the library finds them, each with what it defines: "-DNAME".
// Those of a technique are found by its folder and their file, others by their file.
std::map<std::string, std::vector<std::string>> shaders_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  const bool of_technique = folder.parent_path().filename() == "techniques";
  const std::string before = of_technique ? folder.filename().string() + "/" : "";

  std::map<std::string, std::vector<std::string>> shaders{{before + file.filename().string(), {}}};
  constexpr std::string_view variant = "// Variant ";
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(variant) || colon == std::string::npos) continue;
    std::vector<std::string>& defines = shaders[before + line.substr(variant.size(), colon - variant.size())];
    std::istringstream words(line.substr(colon + 1));
    for (std::string word; words >> word;) defines.push_back("-D" + word);
  }
  return shaders;
}

bool may_matter(const fs::path& file) {
  return is_shader(file) || file.extension() == ".glsl" || file.extension() == ".h";
}

// Returns the files that a file includes in quotes: beside it, or from the folder.
std::vector<fs::path> includes_of(const fs::path& file, const fs::path& folder) {
  std::vector<fs::path> found;
  std::ifstream in(file);
  std::error_code error;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#include \"")) continue;
    const std::string name = line.substr(10, line.find('"', 10) - 10);
    for (const fs::path& base : {file.parent_path(), folder})
      if (const fs::path path = (base / name).lexically_normal(); fs::exists(path, error)) {
        found.push_back(path);
        break;
      }
  }
  return found;
}

std::vector<std::uint32_t> read_words(const fs::path& file) {
  const std::vector<std::byte> bytes = read_file(file);
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

std::string read_text(const fs::path& file) {
  const std::vector<std::byte> bytes = read_file(file);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Without the folder that all names begin with.
std::string shortened(std::string text, const std::string& folder) {
  for (std::size_t at; (at = text.find(folder + "/")) != std::string::npos;)
    text.erase(at, folder.size() + 1);
  return text;
}

fs::file_time_type built_at() {
  std::error_code error;
  return fs::last_write_time("/proc/self/exe", error);
}

}  // namespace

ShaderFolder::ShaderFolder(fs::path folder, std::string compiler, Time built)
    : folder_(std::move(folder)), compiler_(std::move(compiler)), built_(built) {}

std::vector<fs::path> ShaderFolder::changed_files() {
  std::vector<fs::path> changed;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder_, error), end; at != end; at.increment(error)) {
    if (error) break;
    const fs::path& file = at->path();
    if (!may_matter(file)) continue;
    const Time time = fs::last_write_time(file, error);
    if (error) continue;  // an editor puts another in its place
    const auto [known, is_new] = times_.emplace(file, built_);
    if (is_new ? time > built_ : time != known->second) changed.push_back(file);
    known->second = time;
  }
  return changed;
}

bool ShaderFolder::depends_on(const fs::path& file, const std::vector<fs::path>& changed) const {
  std::vector<fs::path> open{file};
  std::set<fs::path> seen;
  while (!open.empty()) {
    const fs::path one = open.back();
    open.pop_back();
    if (!seen.insert(one).second) continue;
    if (std::ranges::find(changed, one) != changed.end()) return true;
    const std::vector<fs::path> more = includes_of(one, folder_);
    open.insert(open.end(), more.begin(), more.end());
  }
  return false;
}

void ShaderFolder::compile(const fs::path& file, const std::string& name,
                           const std::vector<std::string>& defines, const std::atomic<bool>& stop) {
  const std::string code = output_.path() + "/code.spv", said = output_.path() + "/said.txt";
  const std::span<const std::uint32_t> ours = techniques::find_any_shader(name);

  // As cmake/DermisShaders.cmake does.
  std::vector<std::string> command{
      compiler_, "--target-env=vulkan1.3", "-Werror", "-I", folder_.string(), "-o", code, file.string()};
  command.insert(command.end(), defines.begin(), defines.end());
  const bool good = run_program(command, said, &stop, 5ms);
  if (!good) {
    errors_[name] = shortened(read_text(said), folder_.string());
    return;
  }
  std::vector<std::uint32_t> words = read_words(code);
  try {
    gpu::check_replacement(shortened(file.string(), folder_.string()), name, ours, words);
  } catch (const InputError& error) {
    errors_[name] = std::string(error.what()) + "\n";
    return;
  }
  errors_.erase(name);
  if (std::ranges::equal(words, ours))
    compiled_.erase(name);
  else
    compiled_[name] = std::move(words);
}

bool ShaderFolder::refresh(const std::atomic<bool>& stop) {
  const std::vector<fs::path> changed = changed_files();
  if (changed.empty()) return false;

  bool any = false;
  std::set<std::string> there;
  for (const auto& entry : times_) {
    const fs::path& file = entry.first;
    if (!is_shader(file)) continue;
    const bool is_changed = depends_on(file, changed);
    for (const auto& [name, defines] : shaders_of(file)) {
      there.insert(name);
      if (techniques::find_any_shader(name).empty()) continue;
      // A faulty shader may be right now, if it waited for a file that was not there.
      if (!errors_.contains(name) && !is_changed) continue;
      compile(file, name, defines, stop);
      any = true;
    }
  }
  // A variant whose line is gone is as it was built.
  const auto is_gone = [&](const auto& entry) { return !there.contains(entry.first); };
  std::erase_if(errors_, is_gone);
  std::erase_if(compiled_, is_gone);
  // Shaders of one header belong together: none is used while one is wrong.
  if (errors_.empty() && compiled_ != *shaders_) shaders_ = std::make_shared<const ShaderSet>(compiled_);
  return any;
}

std::string ShaderFolder::errors() const {
  std::string all;
  for (const auto& entry : errors_) all += entry.second;
  return all;
}

LiveShaders::LiveShaders(fs::path folder, std::string compiler, std::function<void()> on_news)
    : folder_(std::move(folder), std::move(compiler), built_at()),
      on_news_(std::move(on_news)),
      thread_([this] { run(folder_); }) {}

LiveShaders::~LiveShaders() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    wake_.notify_all();
  }
  thread_.join();
}

void LiveShaders::run(ShaderFolder& folder) {
  while (!stop_) {
    std::optional<News> news;
    try {
      if (folder.refresh(stop_)) news = News{folder.shaders(), folder.errors()};
    } catch (const Cancelled&) { return; } catch (const std::exception& error) {
      news = News{folder.shaders(), error.what()};
    }

    std::unique_lock lock(mutex_);
    if (news) {
      news_ = std::move(news);
      if (on_news_) on_news_();
    }
    wake_.wait_for(lock, look_every, [this] { return stop_.load(); });
  }
}

std::optional<LiveShaders::News> LiveShaders::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

}  // namespace dermis::viewer
