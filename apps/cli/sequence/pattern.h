// SPDX-License-Identifier: MIT
/// Names of numbered pictures, "out/frame-%04d.png".
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace dermis::cli::sequence {

class FramePattern {
 public:
  /// %d stands for the number of the frame, %04d for one of at least four digits, %% for a percent sign.
  /// Throws InputError: no number or several, a number in the name of a folder, anything else behind a
  /// percent sign, an ending that is not .png or .exr.
  explicit FramePattern(const std::string& text);

  std::filesystem::path path(std::size_t frame) const;
  /// Returns whether some frame has this name.
  bool matches(const std::filesystem::path& file) const;
  const std::string& text() const { return text_; }

 private:
  std::string text_;            ///< as given
  std::string before_, after_;  ///< the number
  int digits_ = 1;              ///< at least so many
};

}  // namespace dermis::cli::sequence
