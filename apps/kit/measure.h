// SPDX-License-Identifier: MIT
// A run of the kit: the programs that it starts, and what they found, as JSON.
#pragma once

#include <atomic>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kit/child.h"
#include "kit/heads.h"
#include "kit/plan.h"

namespace dermis::kit {

using Json = nlohmann::ordered_json;

struct Task {
  std::filesystem::path kit;      ///< where it was unpacked
  std::filesystem::path scratch;  ///< an empty folder
  Extent extent = Extent::full;
  std::set<std::string> only;  ///< of `parts`; empty: all
  const std::atomic<bool>* stop = nullptr;
};

/// The device that dermis would take, first. Throws DeviceError of one line if there is none that it can use:
/// no driver (with the Vulkan loader's message), or the features that each lacks.
Json find_devices(const Task& task);

class Measurement {
 public:
  Measurement(const Task& task, Json devices);

  /// Runs the parts; each adds its results to the record. Ends early, with `complete` false, when stopped.
  void run();

  /// The whole record: device, machine, results; `failed` lists what did not hold, one line each.
  const Json& record() const { return record_; }
  bool complete() const { return record_.at("complete"); }
  std::size_t failures() const { return record_.at("failed").size(); }

  /// PNGs for the page, with what they show: they live in the scratch folder.
  struct Shot {
    std::string what;
    std::filesystem::path file;
  };
  const std::vector<Shot>& shots() const { return shots_; }

 private:
  Json switches();
  Json equality();
  Json invariants();
  Json frames();
  Json bench();
  Json sessions();
  Json crowds();
  Json memory();

  bool stopped() const { return *task_.stop; }
  /// Runs a program of the kit and notes it: command, seconds, peak memory of the process, why it failed.
  Json start(const std::string& what, std::vector<std::string> words, Ended& ended, double most_seconds);
  /// `dermis render`; the statistics of a run that succeeded are under "statistics".
  Json render(const std::string& what, std::vector<std::string> words, const std::filesystem::path& picture,
              Ended& ended);
  void fail(const std::string& what, const std::string& why);
  std::string place(const std::string& name) const { return (task_.scratch / name).string(); }

  Task task_;
  Heads heads_;
  std::vector<std::string> techniques_;
  bool validated_ = false;
  Json record_;
  std::vector<Shot> shots_;
};

}  // namespace dermis::kit
