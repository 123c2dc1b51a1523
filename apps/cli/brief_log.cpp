// SPDX-License-Identifier: MIT
#include "cli/brief_log.h"

#include <cstdio>
#include <utility>

#include "base/core/log.h"
#include "cli/progress.h"
#include "cli/settings_options.h"

namespace dermis::cli {

bool& verbose() {
  static bool value = false;
  return value;
}

BriefLog::BriefLog(const CLI::App& app)
    : app_(&app),
      scope_(Hooks{.log = [this](LogLevel level, const std::string& line) { take(level, line); }}) {}

void BriefLog::take(LogLevel level, const std::string& line) {
  const std::string text =
      fmt::format("dermis: {}{}\n", level == LogLevel::warning ? "warning: " : "", with_options(line, *app_));
  if (said_one_ && !verbose()) {
    held_.push_back(text);
    return;
  }
  said_one_ = true;
  show_line("");  // a progress may be under way
  std::fputs(text.c_str(), stderr);
}

void BriefLog::finish() {
  if (held_.size() == 1) std::fputs(held_.front().c_str(), stderr);
  if (held_.size() > 1)
    std::fprintf(stderr, "dermis: %zu more warnings or notes; --verbose shows them\n", held_.size());
  held_.clear();
}

}  // namespace dermis::cli
