// SPDX-License-Identifier: MIT
#include "base/core/warnings.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

namespace dermis {
namespace {

constexpr std::size_t shown_names = 3;

struct Kind {
  std::string kind, first_line;
  std::vector<std::string> names;     // the first three, each once
  std::size_t count = 0, others = 0;  // all warnings, and those with further names
};

thread_local int groups = 0;
thread_local std::vector<Kind> gathered;

std::string line_of(const Kind& k) {
  if (k.count == 1) return k.first_line;
  std::string names;
  for (const std::string& name : k.names) names += (names.empty() ? "'" : ", '") + name + "'";
  if (k.others > 0) names += fmt::format(" and {} more", k.others);
  return fmt::format("{}: {} of them: {}", k.kind, k.count, names);
}

}  // namespace

WarningGroup::WarningGroup() : exceptions_(std::uncaught_exceptions()) { ++groups; }

WarningGroup::~WarningGroup() {
  if (--groups > 0) return;
  const std::vector<Kind> kinds = std::exchange(gathered, {});
  if (std::uncaught_exceptions() > exceptions_) return;
  for (const Kind& k : kinds) log_line(LogLevel::warning, line_of(k));
}

void warn_of(const std::string& kind, const std::string& name, const std::string& line) {
  if (groups == 0) return log_line(LogLevel::warning, line);
  for (Kind& k : gathered) {
    if (k.kind != kind) continue;
    ++k.count;
    if (std::find(k.names.begin(), k.names.end(), name) != k.names.end()) return;
    if (k.names.size() < shown_names)
      k.names.push_back(name);
    else
      ++k.others;
    return;
  }
  gathered.push_back({kind, line, {name}, 1});
}

}  // namespace dermis
