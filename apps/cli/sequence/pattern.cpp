// SPDX-License-Identifier: MIT
#include "cli/sequence/pattern.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/core/error.h"
#include "base/core/file.h"

namespace dermis::cli::sequence {
namespace {

constexpr const char* example = "out/frame-%04d.png";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

FramePattern::FramePattern(const std::string& text) : text_(text) {
  const std::string ending = ending_of(text);
  if (ending != ".png" && ending != ".exr")
    throw input_error(
        text, "pictures are written as .png or .exr, videos as .mp4, .webm or .webp, not as '{}'", ending);

  bool found = false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::string& part = found ? after_ : before_;
    if (text[at] != '%') {
      part += text[at];
      continue;
    }
    if (text.compare(at, 2, "%%") == 0) {
      part += text[++at];
      continue;
    }

    // %d or %0Nd, one digit N.
    const bool padded = text.compare(at + 1, 1, "0") == 0 && at + 2 < text.size() && is_digit(text[at + 2]);
    const std::size_t end = at + (padded ? 3 : 1);
    if (end >= text.size() || text[end] != 'd')
      throw input_error(text, "after % there must be d, 0 and a digit and d, or another %, as in {}",
                        example);
    if (found) throw input_error(text, "holds the number of the frame twice; once is enough: {}", example);
    if (padded) digits_ = std::max(1, text[at + 2] - '0');
    found = true;
    at = end;
  }

  if (!found) throw input_error(text, "does not say where the number of the frame stands: {}", example);
  if (after_.find('/') != std::string::npos)
    throw input_error(text, "has the number in the name of a folder, and it belongs to the file: {}",
                      example);
}

std::filesystem::path FramePattern::path(std::size_t frame) const {
  return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

bool FramePattern::matches(const std::filesystem::path& file) const {
  const std::string name = file.filename().string();
  const std::string before = std::filesystem::path(before_).filename().string();
  if (name.size() <= before.size() + after_.size() || !name.starts_with(before) || !name.ends_with(after_))
    return false;
  const std::string number = name.substr(before.size(), name.size() - before.size() - after_.size());
  return number.size() <= 9 && std::all_of(number.begin(), number.end(), is_digit) &&
         same_file(path(std::stoul(number)), file);
}

}  // namespace dermis::cli::sequence
