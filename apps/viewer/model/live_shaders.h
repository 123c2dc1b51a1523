// SPDX-License-Identifier: MIT
/// Shaders that are compiled anew when their files change, for developers: edit a file, see it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "viewer/model/program.h"

namespace dermis::viewer {

/// SPIR-V in the place of what the program was built with, by name ("blur.comp").
using ShaderSet = std::map<std::string, std::vector<std::uint32_t>, std::less<>>;

/// The shaders in a folder, as the build compiles them.
class ShaderFolder {
 public:
  using Time = std::filesystem::file_time_type;

  /// `folder`: what #include is relative to, as src/ is. `compiler`: glslc. A file newer than `built` counts
  /// as changed.
  ShaderFolder(std::filesystem::path folder, std::string compiler, Time built);

  /// Compiles what has changed since the last call, with all that includes it. Returns whether something has.
  /// Throws Cancelled: `stop` was set.
  bool refresh(const std::atomic<bool>& stop);

  /// The last set that was without errors; what is as it was built is not in it.
  std::shared_ptr<const ShaderSet> shaders() const { return shaders_; }
  /// Messages of the compiler, or differences of an interface; empty: nothing is wrong.
  std::string errors() const;

 private:
  std::vector<std::filesystem::path> changed_files();
  bool depends_on(const std::filesystem::path& file, const std::vector<std::filesystem::path>& changed) const;
  void compile(const std::filesystem::path& file, const std::string& name,
               const std::vector<std::string>& defines, const std::atomic<bool>& stop);

  std::filesystem::path folder_;
  std::string compiler_;
  TemporaryFolder output_;  ///< of what the compiler writes
  Time built_;
  std::map<std::filesystem::path, Time> times_;
  std::map<std::string, std::string> errors_;  ///< by shader
  ShaderSet compiled_;
  std::shared_ptr<const ShaderSet> shaders_ = std::make_shared<const ShaderSet>();
};

/// Watches a folder on a thread of its own.
class LiveShaders {
 public:
  struct News {
    std::shared_ptr<const ShaderSet> shaders;
    std::string errors;
  };

  /// `on_news`: called by that thread when there is something to take.
  LiveShaders(std::filesystem::path folder, std::string compiler, std::function<void()> on_news);
  ~LiveShaders();
  LiveShaders(const LiveShaders&) = delete;
  LiveShaders& operator=(const LiveShaders&) = delete;

  /// Returns what has changed since the last call.
  std::optional<News> take();

 private:
  void run(ShaderFolder& folder);

  ShaderFolder folder_;
  std::function<void()> on_news_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<News> news_;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace dermis::viewer
