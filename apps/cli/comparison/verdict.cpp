// SPDX-License-Identifier: MIT
// A table in words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cli/comparison/table.h"

namespace dermis::cli::comparison {
namespace {

/// Errors that differ by less cannot be told apart: FLIP and the noise of a reference move as much.
constexpr double as_near = 1.25;

struct Entry {
  std::string technique;
  Figures figures;
};

// Further rows of a technique (one Gaussian, single optimisations) are no choices of their own.
std::vector<Entry> entries_of(const Case& one) {
  std::vector<Entry> entries;
  for (const ComparedTechnique& t : one.found.techniques)
    if (t.name == t.statistics.technique) entries.push_back({t.name, figures_of(t)});
  return entries;
}

const Entry& nearest_of(const std::vector<Entry>& entries) {
  return *std::min_element(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.figures.rel_mse < b.figures.rel_mse;
  });
}

/// Returns the fastest of those that are as near as the nearest.
const Entry& choice_of(const std::vector<Entry>& entries) {
  const double least = nearest_of(entries).figures.rel_mse;
  const Entry* choice = nullptr;
  for (const Entry& e : entries)
    if (e.figures.rel_mse <= as_near * least && (!choice || e.figures.ms < choice->figures.ms)) choice = &e;
  return *choice;
}

/// Another one is at most as slow and at most as far, and one of both is less.
bool is_beaten(const Entry& e, const std::vector<Entry>& entries) {
  return std::any_of(entries.begin(), entries.end(), [&](const Entry& other) {
    const Figures &a = other.figures, &b = e.figures;
    return a.ms <= b.ms && a.rel_mse <= b.rel_mse && (a.ms < b.ms || a.rel_mse < b.rel_mse);
  });
}

std::string error_ratio(const Entry& e, const Entry& to) {
  return fmt::format("{:.2g} times its error", std::sqrt(e.figures.rel_mse / to.figures.rel_mse));
}

std::string sentence_of(const Case& one, const std::vector<Entry>& entries) {
  const Entry &nearest = nearest_of(entries), &choice = choice_of(entries);
  std::string text = fmt::format("{}: {} is nearest (relMSE {:.2g}, {:.0f} ms)", one.name, nearest.technique,
                                 nearest.figures.rel_mse, nearest.figures.ms);
  if (&choice != &nearest)
    text += fmt::format("; {} is as near within {:.0f} %, and takes {:.2f} of its time", choice.technique,
                        100 * (as_near - 1), choice.figures.ms / nearest.figures.ms);

  std::vector<std::string> faster;
  for (const Entry& e : entries)
    if (&e != &choice && e.figures.ms < choice.figures.ms && !is_beaten(e, entries))
      faster.push_back(fmt::format("{} takes {:.2f} of the time of {} and has {}", e.technique,
                                   e.figures.ms / choice.figures.ms, choice.technique,
                                   error_ratio(e, choice)));
  return text + (faster.empty() ? "; nothing is faster without being beaten" : "; ") +
         fmt::format("{}", fmt::join(faster, ", ")) + ".";
}

}  // namespace

double less_noise(const RegionError& error) {
  if (!error.rel_mse_unbiased) return error.rel_mse;
  // An error below the noise of the reference is not known any better than so.
  return std::max(*error.rel_mse_unbiased, (error.rel_mse - *error.rel_mse_unbiased) / 100);
}

Figures figures_of(const ComparedTechnique& technique) {
  Figures f;
  f.ms = technique.ms();
  f.taps_per_pixel = taps_per_pixel(technique.statistics);
  f.device_mb =
      static_cast<double>(technique.statistics.image_bytes + technique.statistics.buffer_bytes) / 1e6;
  const std::optional<RegionError>& skin = technique.errors.front();
  if (!skin) return f;
  f.flip = skin->flip;
  f.larger = less_noise(*skin);
  f.rel_mse = technique.at_size ? less_noise(*technique.at_size) : f.larger;
  return f;
}

std::vector<std::string> verdict(const Table& table) {
  std::vector<std::string> sentences, names;
  std::map<std::string, std::vector<std::string>> chosen, beaten;
  std::size_t counted = 0;
  for (const Case& one : table.cases) {
    const std::vector<Entry> entries = entries_of(one);
    if (entries.size() < 2) continue;
    ++counted;
    sentences.push_back(sentence_of(one, entries));
    chosen[choice_of(entries).technique].push_back(one.name);
    for (const Entry& e : entries) {
      if (std::find(names.begin(), names.end(), e.technique) == names.end()) names.push_back(e.technique);
      if (is_beaten(e, entries)) beaten[e.technique].push_back(one.name);
    }
  }

  for (const std::string& name : names) {
    const std::vector<std::string>&right = chosen[name], &lost = beaten[name];
    std::string text = name + (right.empty() ? " is the right choice in no case"
                                             : fmt::format(" is the right choice in {} of {} cases ({})",
                                                           right.size(), counted, fmt::join(right, "; ")));
    text += lost.empty() ? "; nothing is both faster and nearer in any case."
                         : fmt::format("; something is both faster and nearer in {} ({}).", lost.size(),
                                       fmt::join(lost, "; "));
    sentences.push_back(std::move(text));
  }
  return sentences;
}

}  // namespace dermis::cli::comparison
