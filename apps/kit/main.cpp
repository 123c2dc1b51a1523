// SPDX-License-Identifier: MIT
// kit: measures everything on the machine it was unpacked on, and writes one JSON and one page. run_kit
// starts it with the libraries that it needs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/known_names.h"
#include "cli/help.h"
#include "cli/progress.h"
#include "kit/measure.h"
#include "kit/page.h"
#include "kit/place.h"
#include "kit/results.h"
#include "kit/scratch.h"

namespace dermis::kit {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  bool quick = false, smoke = false;
  std::string out = "kit-results";
  std::vector<std::string> only;
};

void check_part(const std::string& name) {
  if (std::ranges::find(parts, name) == std::end(parts))
    throw CLI::ValidationError("--only", fmt::format("'{}' is no part; {}", name, listed_names(name, parts)));
}

void add_arguments(CLI::App& app, Arguments& a) {
  app.add_flag("--quick", a.quick,
               "each kind of measurement in a small size: a quarter of an hour of a software "
               "driver, a few minutes of a GPU");
  app.add_flag("--smoke", a.smoke, "only whether everything starts; its figures say nothing");
  app.add_option("--out", a.out, "folder for the results; made if it is not there");
  app.add_option("--only", a.only, "some parts alone")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("PART,PART,..")
      ->default_str(fmt::format("{}", fmt::join(parts, ",")))
      ->each(check_part);
  app.footer(
      "Writes kit-DEVICE.json and kit-DEVICE.html. Ctrl-C ends with what there is; a second one writes\n"
      "nothing. Exit status: 0 everything holds; 1 something does not, or it was stopped; 2 the command "
      "line\n"
      "cannot be parsed. `run_kit dermis ...` is the packed program itself.");
}

int measure(const Arguments& a, const std::string& command, const fs::path& kit) {
  const std::atomic<bool>& stop = cli::catch_interrupts();
  Task task{.kit = kit,
            .scratch = {},
            .extent = a.quick   ? Extent::quick
                      : a.smoke ? Extent::smoke
                                : Extent::full,
            .only = {a.only.begin(), a.only.end()},
            .stop = &stop};
  Json devices = find_devices(task);

  const fs::path results = fs::absolute(a.out);
  const Scratch scratch(results);
  task.scratch = scratch.path();
  const fs::path name = results / ("kit-" + file_part(devices.front().at("name")));
  const std::string json = name.string() + ".json", html = name.string() + ".html";
  check_writable(json);
  check_writable(html);

  Measurement measurement(task, std::move(devices));
  measurement.run();

  // The command line stands before the results.
  Json record;
  for (const auto& [key, value] : measurement.record().items()) {
    record[key] = value;
    if (key == "what") record["command"] = command;
  }
  const std::string text = record.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  const std::string document = page(record, measurement.shots());
  write_file(html, document);
  write_file(json, text);
  fmt::print("{}\n{}\n", json, html);

  if (!measurement.complete()) {
    fmt::print(stderr, "run_kit: stopped; what is written holds the parts until then\n");
    return 1;
  }
  if (measurement.failures() == 0) return 0;
  fmt::print(stderr, "run_kit: {} did not hold; the page lists them first\n", measurement.failures());
  return 1;
}

int main(int argc, char** argv) {
  CLI::App app{"Measures dermis on this machine: what holds, what it costs"};
  app.name("run_kit");
  app.formatter(std::make_shared<cli::HelpFormatter>());
  app.option_defaults()->always_capture_default();
  Arguments arguments;
  add_arguments(app, arguments);
  try {
    app.parse(argc, argv);
    if (arguments.quick && arguments.smoke) throw CLI::ValidationError("--smoke", "is not for --quick");
  } catch (const CLI::ParseError& error) { return app.exit(error) == 0 ? 0 : 2; }

  try {
    char bin[PATH_MAX];
    if (!find_program_folder(bin))
      throw input_error("", "cannot find the folder it was unpacked in; start it by its path");
    std::vector<std::string> words(argv, argv + argc);
    words[0] = "./run_kit";
    return measure(arguments, quoted(words), fs::path(bin).parent_path());
  } catch (const std::exception& error) {
    cli::show_line("");
    fmt::print(stderr, "run_kit: {}\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace dermis::kit

int main(int argc, char** argv) { return dermis::kit::main(argc, argv); }
