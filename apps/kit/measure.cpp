// SPDX-License-Identifier: MIT
#include "kit/measure.h"

#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/sysinfo.h>
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

#include "base/core/error.h"
#include "cli/progress.h"
#include "cli/version.h"
#include "dermis/renderer.h"
#include "kit/results.h"
#include "render/techniques/technique.h"

namespace dermis::kit {
namespace {

namespace fs = std::filesystem;

constexpr double most_seconds_of_a_picture = 900;
constexpr double most_seconds_of_a_benchmark = 12 * 3600;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(": ") + 2, line.size()));
  return "unknown";
}

Json machine() {
  utsname system{};
  ::uname(&system);
  struct sysinfo memory {};
  ::sysinfo(&memory);
  return {{"processor", processor()},
          {"cores", std::thread::hardware_concurrency()},
          {"memory_bytes", std::uint64_t{memory.totalram} * memory.mem_unit},
          {"system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
          {"c_library", ::gnu_get_libc_version()}};
}

bool has_light_maps(const std::string& technique) {
  return techniques::find_technique(technique).has_light_maps;
}

// Returns the loader's message about drivers that it could not open: "ERROR: ...", one line each, the first
// of them.
std::string loader_error(const std::string& said) {
  std::size_t from = said.find("ERROR");
  if (from == std::string::npos) return "";
  std::string line = said.substr(from, said.find('\n', from) - from);
  const std::size_t text = line.find(": ");
  line = text == std::string::npos ? line : line.substr(text + 2);
  return line.substr(line.find_first_not_of(' '));
}

}  // namespace

Json find_devices(const Task& task) {
  const Ended ended = kit::run({.words = {"bin/dermis", "info", "--json"},
                                .folder = task.kit,
                                .variables = {{"VK_LOADER_DEBUG", "error"}},
                                .most_seconds = 120},
                               *task.stop);
  const Json said = Json::parse(ended.out, nullptr, false);
  if (said.is_discarded() || !said.contains("devices"))
    throw device_error("the devices cannot be listed: {}", ended.why());

  const Json& devices = said.at("devices");
  if (devices.empty()) {
    const std::string why = loader_error(ended.err);
    throw device_error(
        "no Vulkan driver can be opened{}{}; the kit brings the loader, the machine its driver. "
        "VK_DRIVER_FILES names a driver's manifest that stands elsewhere",
        why.empty() ? "" : ": ", why);
  }
  if (devices.front().value("usable", false)) return devices;

  std::string reasons;
  for (const Json& device : devices)
    for (const Json& missing : device.at("missing"))
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "" : "; ", device.value("name", "?"),
                             missing.get<std::string>());
  throw device_error("no device that can be used: {}", reasons);
}

Measurement::Measurement(const Task& task, Json devices)
    : task_(task), heads_(find_heads(task.kit)), techniques_(technique_names()) {
  const Json& device = devices.front();
  record_ = {{"what", "tools/gpu_kit.sh: everything that can be measured where nothing is installed"},
             {"extent", name_of(task.extent)},
             {"complete", false},
             {"dermis", DERMIS_VERSION},
             {"commit", cli::commit()},
             {"device", device.at("name")},
             {"driver", device.at("driver")},
             {"api", device.at("api")},
             {"type", device.at("type")},
             {"device_memory_bytes", device.at("memory_bytes")},
             {"machine", machine()},
             {"heads", heads_.all()},
             {"failed", Json::array()},
             {"devices", std::move(devices)}};
}

void Measurement::fail(const std::string& what, const std::string& why) {
  record_["failed"].push_back(what + ": " + why);
  cli::show_line("");
  fmt::print("  FAILED  {}: {}\n", what, why);
  std::fflush(stdout);
}

void Measurement::run() {
  const auto start = std::chrono::steady_clock::now();
  const std::string probe = place("probe.png");
  kit::Command command{.words = {"bin/dermis", "render", heads_.light(), "--validate", "-o", probe},
                       .folder = task_.kit,
                       .variables = {{"XDG_CACHE_HOME", place("cache")}},
                       .most_seconds = most_seconds_of_a_picture};
  for (const char* word : {"--size", "32x20", "--map-size", "32", "--shadow-size", "32"})
    command.words.emplace_back(word);
  const Ended ended = kit::run(command, *task_.stop);
  validated_ = ended.err.find("validation needs the layer") == std::string::npos;
  record_["validated"] = validated_;
  fmt::print("{}, {}; {} the validation layer\n", record_.value("device", ""), record_.value("driver", ""),
             validated_ ? "under" : "without");
  for (const Json& device : record_["devices"])
    for (const Json& missing : device.value("missing", Json::array()))
      fmt::print("note: {}: {}\n", device.value("name", "?"), missing.get<std::string>());
  std::fflush(stdout);

  using Part = Json (Measurement::*)();
  constexpr Part functions[] = {&Measurement::switches, &Measurement::equality, &Measurement::invariants,
                                &Measurement::frames,   &Measurement::bench,    &Measurement::sessions,
                                &Measurement::crowds,   &Measurement::memory};
  static_assert(std::size(functions) == std::size(parts));

  for (std::size_t i = 0; i < std::size(parts) && !stopped(); ++i) {
    if (!task_.only.empty() && !task_.only.contains(parts[i])) continue;
    const auto part_start = std::chrono::steady_clock::now();
    const std::size_t failures_before = failures();
    record_[parts[i]] = (this->*functions[i])();
    cli::show_line("");
    fmt::print("{:<10} {:>7.1f} s  {}\n", parts[i], seconds_since(part_start),
               failures() == failures_before ? "holds" : "FAILED");
    std::fflush(stdout);
  }
  record_["seconds"] = seconds_since(start);
  record_["complete"] = !stopped();
}

Json Measurement::start(const std::string& what, std::vector<std::string> words, Ended& ended,
                        double most_seconds) {
  cli::show_line(what);
  kit::Command command{.words = std::move(words), .folder = task_.kit, .most_seconds = most_seconds};
  command.variables = {{"XDG_CACHE_HOME", place("cache")},
                       {"TMPDIR", task_.scratch.string()},
                       {"DERMIS_SOURCE", task_.kit.string()},
                       {"DERMIS_ASSET_CACHE", (task_.kit / "assets").string()}};
  ended = kit::run(command, *task_.stop);

  // Where it was written says nothing to a reader.
  for (std::string& word : command.words)
    if (word.starts_with(task_.scratch.string())) word = "OUT" + word.substr(task_.scratch.string().size());
  Json note = {{"command", quoted(command.words)},
               {"seconds", ended.seconds},
               {"process_peak_mb", ended.peak_mb},
               {"ok", ended.ok()}};
  if (!ended.ok()) note["why"] = ended.why();
  return note;
}

Json Measurement::render(const std::string& what, std::vector<std::string> words, const fs::path& picture,
                         Ended& ended) {
  words.insert(words.begin(), {"bin/dermis", "render"});
  const std::string statistics = place("statistics.json");
  words.insert(words.end(), {"-o", picture.string(), "--stats", statistics});
  fs::remove(statistics);

  Json note = start(what, std::move(words), ended, most_seconds_of_a_picture);
  if (!ended.ok()) return note;
  note["statistics"] = read_json(statistics);
  return note;
}

Json Measurement::switches() {
  Json all = Json::array();
  const std::vector<std::string> subjects =
      task_.extent == Extent::full ? heads_.all() : std::vector{heads_.light()};
  for (const std::string& head : subjects)
    for (const std::string& technique : techniques_)
      for (const Switch& change : kit::switches(task_.extent)) {
        if (stopped()) return all;
        if (task_.extent != Extent::full && is_of_light_maps(change.path) && !has_light_maps(technique))
          continue;
        // The built-in head is the same in every picture, and takes seconds to make.
        if (head == Heads::built_in && subjects.size() > 1 && !change.path.empty()) continue;

        const std::string file = place("switch.json");
        const Json settings = settings_with(technique, change);
        std::ofstream(file) << settings.dump();
        std::vector<std::string> words{head, "--settings", file};
        if (validated_) words.emplace_back("--validate");

        const std::string what = fmt::format("{}, {}, {} {}", head, technique, change.path, change.text);
        Ended ended;
        Json note = {{"scene", head},
                     {"technique", technique},
                     {"setting", change.path},
                     {"value", change.value()},
                     {"offered", true}};
        note.update(render(what, words, place("switch.png"), ended));
        note["settings"] = settings;
        // A technique that does not have a setting says so.
        if (ended.err.find("is not known to this technique") != std::string::npos) note["offered"] = false;
        if (!ended.ok() && note["offered"] && !ended.stopped) fail(what, ended.why());
        drop_repeated_statistics(note);
        all.push_back(std::move(note));
      }
  return all;
}

Json Measurement::equality() {
  Json all = Json::array();
  std::vector<std::string> subjects{heads_.light()};
  if (task_.extent == Extent::full) subjects = heads_.all();
  if (task_.extent == Extent::quick && heads_.main() != heads_.light()) subjects.push_back(heads_.main());
  const std::vector<std::string> size =
      task_.extent == Extent::full    ? std::vector<std::string>{"--size", "960x600", "--map-size", "1024"}
      : task_.extent == Extent::quick ? std::vector<std::string>{"--size", "480x300", "--map-size", "512"}
                                      : std::vector<std::string>{"--size", "96x60", "--map-size", "64"};

  for (const std::string& head : subjects)
    for (const std::string& technique : techniques_) {
      if (task_.extent == Extent::smoke && technique != techniques_.front()) continue;
      const std::string what = fmt::format("{}, {}, two runs", head, technique);
      const fs::path pictures[2] = {place("first.exr"), place("second.exr")};
      Json notes[2];
      Ended ended[2];
      for (std::size_t i = 0; i < 2; ++i) {
        if (stopped()) return all;
        std::vector<std::string> words{head, "--technique", technique, "--shadow-size", size[3]};
        words.insert(words.end(), size.begin(), size.end());
        fs::remove(pictures[i]);
        notes[i] = render(what, words, pictures[i], ended[i]);
      }

      const bool both = ended[0].ok() && ended[1].ok();
      const bool equal = both && same_bytes(pictures[0], pictures[1]);
      const bool counted = both && notes[0]["statistics"]["texels"] == notes[1]["statistics"]["texels"];
      if (!both)
        fail(what, ended[0].ok() ? ended[1].why() : ended[0].why());
      else if (!equal || !counted)
        fail(what, equal ? "counts differ" : "pictures differ");
      Json note = {{"scene", head},
                   {"technique", technique},
                   {"equal", equal},
                   {"counts_equal", counted},
                   {"command", notes[0]["command"]}};
      if (both) {
        note["bytes"] = fs::file_size(pictures[0]);
        note["texels"] = notes[0]["statistics"]["texels"];
      }
      all.push_back(std::move(note));
    }
  return all;
}

Json Measurement::invariants() {
  Json all = Json::array();
  for (const Invariant& invariant : kit::invariants(task_.extent)) {
    if (stopped()) break;
    const std::string file = place("checks.json");
    fs::remove(file);
    Ended ended;
    Json note = {{"name", invariant.name}, {"result", nullptr}};
    note.update(start(invariant.name,
                      {"bin/kit_checks", "--gtest_filter=" + invariant.filter, "--gtest_brief=1",
                       "--gtest_output=json:" + file},
                      ended, 3600));
    if (ended.stopped) break;
    add_cases(note, read_json(file));
    note["result"] = result_of(note, ended);
    if (note["result"] == "failed") fail(invariant.name, why_not(note, ended));
    all.push_back(std::move(note));
  }
  return all;
}

Json Measurement::frames() {
  Json all = Json::array();
  const bool full = task_.extent == Extent::full, smoke = task_.extent == Extent::smoke;
  std::vector<std::vector<std::string>> variants{{}, {"--optimise", "none"}, {"--technique", "lambert"}};
  if (smoke) variants.resize(1);

  for (const std::vector<std::string>& variant : variants) {
    if (stopped()) break;
    std::vector<std::string> words{heads_.main(),
                                   "--size",
                                   full    ? "1280x720"
                                   : smoke ? "96x60"
                                           : "640x360",
                                   "--map-size",
                                   full    ? "1024"
                                   : smoke ? "64"
                                           : "512",
                                   "--frames",
                                   full    ? "9"
                                   : smoke ? "1"
                                           : "3"};
    words.insert(words.end(), variant.begin(), variant.end());
    const fs::path picture = place(fmt::format("frame-{}.png", all.size()));
    const std::string what = quoted(words);
    Ended ended;
    all.push_back(render(what, words, picture, ended));
    if (ended.ok())
      shots_.push_back({what, picture});
    else if (!ended.stopped)
      fail("frame " + what, ended.why());
  }
  return all;
}

Json Measurement::bench() {
  const std::string file = place("bench.json");
  std::vector<std::string> words{"bin/dermis", "bench"};
  if (heads_.main() != Heads::built_in) words.push_back(heads_.main());
  if (task_.extent == Extent::quick)
    words.insert(words.end(), {"--quick", "--distances", "2.5,50", "--rounds", "2"});
  if (task_.extent == Extent::smoke)
    words.insert(words.end(), {"--size", "64x40", "--map-size", "64", "--shadow-size", "64", "--heads", "1",
                               "--distances", "2.5", "--rounds", "1", "--picture-samples", "1"});
  words.insert(words.end(), {"--json", file});

  Ended ended;
  Json note = start("the paper's test", words, ended, most_seconds_of_a_benchmark);
  if (!ended.ok() && !ended.stopped) fail("bench", ended.why());
  // One that was stopped has written the cells that are complete.
  note["run"] = read_json(file);
  for (const Json& cell : note["run"].value("cells", Json::array()))
    if (const std::uint64_t reads = unshaded_reads(cell); reads > 0)
      fail("bench", fmt::format("{} heads at {} radii read {} texels that were never lit",
                                cell.value("heads", 0), cell.value("distance", 0.0), reads));
  return note;
}

Json Measurement::sessions() {
  const std::string file = place("sessions.json");
  std::vector<std::string> words{"bin/sessions_bench", file, heads_.main(), "300"};
  if (task_.extent == Extent::quick) words = {words[0], file, heads_.main(), "8", "1", "4"};
  if (task_.extent == Extent::smoke) words = {words[0], file, heads_.light(), "4", "1"};
  Ended ended;
  Json note = start("sessions", words, ended, most_seconds_of_a_benchmark);
  note["runs"] = read_json(file);
  if (!ended.ok() && !ended.stopped)
    fail("sessions", note["runs"].empty() ? ended.why() : "a steady frame asks something of the device");
  return note;
}

Json Measurement::crowds() {
  struct Crowd {
    std::size_t heads;
    const char *size, *map;
  };
  std::vector<Crowd> sizes{{16, "1920x1200", "1024"}, {64, "1920x1200", "1024"}, {256, "1920x1200", "512"}};
  if (task_.extent == Extent::quick) sizes = {{16, "480x300", "256"}, {64, "480x300", "256"}};
  if (task_.extent == Extent::smoke) sizes = {{3, "96x60", "64"}};
  std::vector<std::string> faces = heads_.people;
  if (faces.empty()) faces = {heads_.light()};

  Json all = Json::array();
  for (const Crowd& crowd : sizes) {
    if (stopped()) break;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < crowd.heads; ++i) words.push_back(faces[i % faces.size()]);
    words.insert(words.end(),
                 {"--layout", "grid", "--size", crowd.size, "--map-size", crowd.map, "--shadow-size",
                  crowd.map, "--lights", "2", "--frames", task_.extent == Extent::full ? "9" : "1"});
    const std::string what = fmt::format("{} heads of {} assets", crowd.heads, faces.size());
    const fs::path picture = place(fmt::format("crowd-{}.png", crowd.heads));
    Ended ended;
    Json note = {{"heads", crowd.heads}, {"assets", faces.size()}};
    note.update(render(what, words, picture, ended));
    if (ended.ok())
      shots_.push_back({what, picture});
    else if (!ended.stopped)
      fail(what, ended.why());
    all.push_back(std::move(note));
  }
  return all;
}

Json Measurement::memory() {
  struct Case {
    const char *heads, *map;
  };
  std::vector<Case> cases{{"1", "512"},  {"1", "1024"},  {"1", "2048"}, {"1", "4096"},
                          {"4", "2048"}, {"16", "2048"}, {"64", "1024"}};
  if (task_.extent == Extent::quick) cases = {{"1", "512"}, {"1", "1024"}, {"4", "512"}, {"16", "512"}};
  if (task_.extent == Extent::smoke) cases = {{"1", "64"}};

  Json all = Json::array();
  for (const auto& [heads, map] : cases) {
    if (stopped()) break;
    const std::vector<std::string> words{heads_.main(),
                                         "--heads",
                                         heads,
                                         "--distance",
                                         "10",
                                         "--size",
                                         task_.extent == Extent::full ? "1920x1200" : "480x300",
                                         "--map-size",
                                         map,
                                         "--shadow-size",
                                         map};
    Ended ended;
    Json note =
        render(fmt::format("memory of {} heads, maps of {}", heads, map), words, place("memory.png"), ended);
    if (!ended.ok() && !ended.stopped) fail("memory " + quoted(words), ended.why());
    note["heads"] = std::stoi(heads);
    note["map_size"] = std::stoi(map);
    drop_repeated_statistics(note);
    all.push_back(std::move(note));
  }
  return all;
}

}  // namespace dermis::kit
