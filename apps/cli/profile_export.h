// SPDX-License-Identifier: MIT
/// Exports of `dermis profile` for other renderers: the parameters of their systems, and kernels.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/profile_report.h"
#include "cli/profile_source.h"

namespace dermis::cli {

struct ExportOptions {
  std::string name;         ///< of a system or of a kernel; empty: nothing is exported
  std::string folder;       ///< for a kernel's files; empty: JSON is printed
  std::optional<int> taps;  ///< of a kernel
  bool is_kernel() const;
};

/// Returns the names of systems and kernels.
std::vector<std::string_view> export_names();

/// Checks options before the long work. Throws InputError: an unknown name (lists them), an option that does
/// not go with it, a folder that cannot be written.
void check_export(const ExportOptions& options);

/// Writes the files of a kernel into the folder, each as a whole, if there is one. Returns what is printed.
std::string exported(const Source& source, const Fitted& fitted, const ExportOptions& options);

}  // namespace dermis::cli
