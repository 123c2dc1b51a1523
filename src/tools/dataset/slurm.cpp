// SPDX-License-Identifier: MIT
// The job script of a Slurm array.
#include <algorithm>
#include <cctype>

#include "base/core/error.h"
#include "tools/dataset/lock.h"
#include "tools/dataset/manifest.h"

namespace dermis::dataset {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view job =
#include "tools/dataset/slurm_job.inc"
    ;

void replace(std::string& text, std::string_view name, std::string_view value) {
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + value.size()))
    text.replace(at, name.size(), value);
}

std::string in_quotes(std::string_view word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

void check_word(const char* what, const std::string& text, std::string_view not_these) {
  const bool is_bad = std::ranges::any_of(text, [&](unsigned char c) {
    return std::iscntrl(c) != 0 || not_these.find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (is_bad) throw input_error("", "{} '{}' has a character that a job script cannot hold", what, text);
}

std::string word_of(std::string name) {
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  return name.empty() ? "dermis" : name;
}

}  // namespace

std::string slurm_script(const fs::path& folder, const SlurmOptions& options) {
  const Recipe recipe = recipe_of(load_lock(folder));
  const std::string whole = fs::weakly_canonical(fs::absolute(folder)).string();
  check_word("folder", whole, "\"%\\@");
  check_word("partition", options.partition, " \"'\\@");
  check_word("program", options.program, "@");
  check_word("device", options.device, "@");
  if (options.minutes < 2 || options.minutes > 525'600)
    throw input_error("", "the limit of a task must be 2 to 525600 minutes, got {}", options.minutes);
  if (options.most_tasks < 1 || options.most_tasks > 1'000'000)
    throw input_error("", "an array has 1 to 1000000 tasks, got {}", options.most_tasks);

  const std::uint64_t shards = recipe.shards(), run = (shards + options.most_tasks - 1) / options.most_tasks;
  std::string text(job);
  replace(text, "@JOB@", word_of(recipe.name()));
  replace(text, "@LAST@", std::to_string((shards + run - 1) / run - 1));
  replace(text, "@MINUTES@", std::to_string(options.minutes));
  replace(text, "@PARTITION@\n", options.partition.empty() ? "" : "#SBATCH -p " + options.partition + "\n");
  replace(text, "@SHARDS@", std::to_string(shards));
  replace(text, "@RUN@", std::to_string(run));
  replace(text, "@DEVICE@", in_quotes(options.device));
  replace(text, "@PROGRAM@", options.program);
  replace(text, "@QUOTED_FOLDER@", in_quotes(whole));
  replace(text, "@FOLDER@", whole);
  return text;
}

}  // namespace dermis::dataset
