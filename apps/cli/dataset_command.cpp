// SPDX-License-Identifier: MIT
// `dermis dataset`: labelled pictures by the shard.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "base/core/error.h"
#include "base/core/known_names.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/help.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "dermis/dataset.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

constexpr int temporary_failure = 75;  // EX_TEMPFAIL: the same command may succeed later

struct DatasetArguments {
  std::string action, path;
  std::string output, shards, device = "best";
  bool one_device = false;
  double redraw = 1e-3;
  std::uint64_t samples = 64;
  int threads = 0;
  dataset::SlurmOptions slurm;
};

dataset::Options options_of(const DatasetArguments& a) {
  return {.device = a.device, .threads = a.threads, .hooks = terminal_hooks()};
}

int prepare(const DatasetArguments& a) {
  const fs::path folder = a.output.empty() ? fs::path(a.path).replace_extension() : fs::path(a.output);
  dataset::prepare(a.path, folder, a.one_device, options_of(a));
  show_line("");
  const dataset::Recipe recipe = dataset::recipe_of(folder);
  fmt::print("{}: {} samples of {} identities in {} shards\n", folder.string(), recipe.samples(),
             recipe.identities(), recipe.shards());
  return 0;
}

int write(const DatasetArguments& a) {
  const std::vector<std::uint64_t> shards =
      a.shards.empty() ? std::vector<std::uint64_t>{} : dataset::ranges_of(a.shards);
  const dataset::Written written = dataset::write(a.path, shards, options_of(a));
  show_line("");
  fmt::print("{} shards drawn, {} samples; {} were there, {} are drawn by other workers\n", written.shards,
             written.samples, written.there, written.elsewhere);
  return 0;
}

int missing(const DatasetArguments& a) {
  const std::string text = dataset::ranges_text(dataset::missing(a.path));
  if (!text.empty()) fmt::print("{}\n", text);
  return 0;
}

int verify(const DatasetArguments& a) {
  const dataset::Verified found = dataset::verify(a.path, a.redraw, options_of(a));
  show_line("");
  for (const std::string& warning : found.warnings) fmt::print("warning: {}\n", warning);
  for (const std::string& fault : found.faults) fmt::print("fault: {}\n", fault);
  fmt::print("{} shards, {} samples, {} drawn again, {} faults\n", found.shards, found.samples, found.redrawn,
             found.faults.size());
  if (!found.parameters_sha256.empty())
    fmt::print("parameters {}\npictures   {}\n", found.parameters_sha256, found.pictures_sha256);
  return found.faults.empty() ? 0 : 1;
}

int slurm(const DatasetArguments& a) {
  dataset::SlurmOptions options = a.slurm;
  options.device = a.device;
  if (options.program.empty()) options.program = cli::quoted(fs::read_symlink("/proc/self/exe").string());
  write_text(a.output.empty() ? "-" : a.output, dataset::slurm_script(a.path, options));
  return 0;
}

int write_page(const DatasetArguments& a, const char* name, const std::string& text) {
  const std::string file = a.output.empty() ? (fs::path(a.path) / name).string() : a.output;
  write_text(file, text);
  if (file != "-") fmt::print("page: {}\n", fs::absolute(file).string());
  return 0;
}

int sheet(const DatasetArguments& a) {
  return write_page(a, "sheet.html", dataset::sheet(a.path, a.samples));
}

int datasheet(const DatasetArguments& a) { return write_page(a, "datasheet.md", dataset::datasheet(a.path)); }

int coco(const DatasetArguments& a) {
  write_text(a.output.empty() ? "-" : a.output, dataset::coco(a.path));
  return 0;
}

int bench(const DatasetArguments& a) {
  const dataset::Benchmark b = dataset::bench(a.path, a.samples, options_of(a));
  show_line("");
  const double count = static_cast<double>(b.samples);
  const auto ms = [count](double seconds) { return 1000 * seconds / count; };
  fmt::print("{} samples: {:.2f} per second; a bare session {:.2f}; share {:.2f}\n", b.samples,
             count / b.total_s, count / b.bare_s, b.bare_s / b.total_s);
  fmt::print("per sample, ms: setting {:.1f}, drawing {:.1f}, waiting for encoders {:.1f}, writing {:.1f}\n",
             ms(b.setting_s), ms(b.drawing_s), ms(b.waiting_s), ms(b.writing_s));
  fmt::print("encoding beside them {:.1f} ms; {:.1f} kB; heads loaded meanwhile: {}\n", ms(b.encoding_s),
             static_cast<double>(b.bytes) / count / 1000, b.heads);
  return 0;
}

/// An action, what it works on, and the options that it takes.
struct Action {
  const char* name;
  int (*run)(const DatasetArguments&);
  std::vector<std::string> options;
};

const std::vector<Action>& actions() {
  static const std::vector<Action> all{
      {"prepare", prepare, {"--output", "--one-device", "--device"}},
      {"write", write, {"--shard", "--device", "--threads"}},
      {"missing", missing, {}},
      {"verify", verify, {"--redraw", "--device"}},
      {"slurm", slurm, {"--output", "--program", "--partition", "--minutes", "--tasks", "--device"}},
      {"sheet", sheet, {"--output", "--samples"}},
      {"datasheet", datasheet, {"--output"}},
      {"coco", coco, {"--output"}},
      {"bench", bench, {"--samples", "--device", "--threads"}}};
  return all;
}

std::vector<std::string> action_names() {
  std::vector<std::string> names;
  for (const Action& action : actions()) names.emplace_back(action.name);
  return names;
}

const Action& action_of(const CLI::App& command, const DatasetArguments& a) {
  for (const Action& action : actions()) {
    if (a.action != action.name) continue;
    for (const CLI::Option* option : command.get_options()) {
      if (option->get_positional() || option->count() == 0) continue;
      const std::string name = "--" + option->get_lnames().front();
      if (std::ranges::find(action.options, name) == action.options.end())
        throw input_error(name, "`dermis dataset {}` does not take it", a.action);
    }
    return action;
  }
  throw input_error("dataset", "{}", unknown_name(a.action, action_names()));
}

int run(const CLI::App& command, const DatasetArguments& a) {
  const Action& action = action_of(command, a);
  catch_interrupts();
  try {
    return action.run(a);
  } catch (const dataset::TryAgain& error) {
    show_line("");
    fmt::print(stderr, "dermis: {}; try again\n", error.what());
    return temporary_failure;
  }
}

void add_options(CLI::App& command, DatasetArguments& a) {
  command
      .add_option(
          "ACTION", a.action,
          "prepare a recipe; write shards; list those missing; verify; a job script for slurm; a contact "
          "sheet; a datasheet; boxes as coco; bench")
      ->type_name("prepare|write|missing|verify|slurm|sheet|datasheet|coco|bench")
      ->required();
  command
      .add_option("PATH", a.path,
                  "a recipe (prepare, bench), else the folder of a data set, python/datasets.md")
      ->type_name("FILE|FOLDER")
      ->required();
  command
      .add_option(
          "-o,--output", a.output,
          "folder of the data set (prepare; default: the recipe's name), page (sheet, datasheet; default: "
          "sheet.html, datasheet.md in the folder), file (slurm, coco; default: standard output)")
      ->type_name("FILE|FOLDER")
      ->default_str("");
  command.add_option("--shard", a.shards, "write: these shards, 0-3,7, also those that other workers draw")
      ->type_name("RANGES")
      ->default_str("");
  command.add_flag("--one-device", a.one_device,
                   "prepare: devices of another name or driver are refused; else verify warns of them");
  command.add_option("--redraw", a.redraw, "verify: share of the samples that is drawn again, 0 to 1");
  add_count(command, "--samples", a.samples, "sheet, bench: how many samples", "1 to 2^64 - 1");
  command.add_option("--threads", a.threads,
                     "write, bench: threads that encode pictures, 0 to 4096; 0: one for each core");
  add_device_option(command, a.device);
}

void add_slurm_options(CLI::App& command, dataset::SlurmOptions& s) {
  constexpr const char* group = "Slurm";
  s.program.clear();
  command.add_option("--program", s.program, "command of a worker (default: this program)")
      ->type_name("COMMAND")
      ->default_str("")
      ->group(group);
  command.add_option("--partition", s.partition, "partition (default: the cluster's)")
      ->type_name("NAME")
      ->default_str("")
      ->group(group);
  command
      .add_option("--minutes", s.minutes, "limit of a task; a minute before, the worker ends and is requeued")
      ->group(group);
  add_count(command, "--tasks", s.most_tasks, "tasks of the array, at most; more shards share them",
            "1 to 1000000")
      ->group(group);
}

}  // namespace

void add_dataset_command(CLI::App& app, int& exit_status) {
  CLI::App* command = app.add_subcommand(
      "dataset",
      "draw labelled pictures from a recipe, by the shard, on one machine or a cluster, and check them");
  auto arguments = std::make_shared<DatasetArguments>();
  add_options(*command, *arguments);
  add_slurm_options(*command, arguments->slurm);
  command->callback([command, arguments, &exit_status] { exit_status = run(*command, *arguments); });
}

}  // namespace dermis::cli
