// SPDX-License-Identifier: MIT
#include "cli/profile_export.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/known_names.h"
#include "image/codec.h"
#include "tissue/gaussians/exchange.h"
#include "tissue/gaussians/kernel_export.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

// With variances of their own per channel, each term has the weight of one.
ScatterProfile sum_for_kernels(const Source& source, const Fitted& fitted) {
  std::map<double, gaussians::Rgb> weights;
  for (int c = 0; c < 3; ++c)
    for (const gaussians::Term& term : normalised(fitted, c))
      weights[term.variance_mm2][static_cast<std::size_t>(c)] += term.weight;

  ScatterProfile sum;
  sum.name = source.name;
  for (const auto& [variance_mm2, weight] : weights)
    if (weight != gaussians::Rgb{}) sum.terms.push_back({variance_mm2, weight});
  return sum;
}

std::string write_kernel(const gaussians::ExportedKernel& kernel, const ExportOptions& options) {
  fs::create_directory(options.folder);
  std::string written;
  const auto path_of = [&](const std::string& ending) {
    const fs::path path = fs::path(options.folder) / (options.name + ending);
    written += path.string() + "\n";
    return path;
  };
  write_file(path_of(".json"), kernel.json);
  write_file(path_of(".h"), kernel.c);
  write_file(path_of(".glsl"), kernel.glsl);
  for (const gaussians::KernelPicture& picture : kernel.pictures)
    image::save_exr(path_of("-" + picture.name + ".exr"), {.width = picture.width,
                                                           .height = picture.height,
                                                           .channels = picture.channels,
                                                           .values = picture.values});
  return written;
}

}  // namespace

std::vector<std::string_view> export_names() {
  std::vector<std::string_view> names = gaussians::exchange_names();
  const auto kernels = gaussians::kernel_names();
  names.insert(names.end(), kernels.begin(), kernels.end());
  return names;
}

bool ExportOptions::is_kernel() const {
  const auto kernels = gaussians::kernel_names();
  return std::find(kernels.begin(), kernels.end(), name) != kernels.end();
}

void check_export(const ExportOptions& options) {
  if (options.is_kernel()) {
    gaussians::check_kernel_taps(options.name, options.taps);
    if (options.folder.empty()) return;
    fs::path folder(options.folder);
    if (!folder.has_filename()) folder = folder.parent_path();
    std::error_code ignored;
    if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
      throw input_error(options.folder, "is a file; --export-to needs a folder");
    check_writable(fs::is_directory(folder, ignored) ? folder / (options.name + ".json") : folder);
    return;
  }

  const std::vector<std::string_view> known = export_names();
  if (!options.name.empty() && std::find(known.begin(), known.end(), options.name) == known.end())
    throw input_error("--export", "{}", unknown_name(options.name, known));
  if (!options.folder.empty() || options.taps)
    throw input_error("--export-to and --export-taps", "go with a kernel alone: --export {}",
                      fmt::join(gaussians::kernel_names(), ", "));
}

std::string exported(const Source& source, const Fitted& fitted, const ExportOptions& options) {
  if (!options.is_kernel()) return exported(source, fitted, options.name);
  const gaussians::ExportedKernel kernel =
      gaussians::export_kernel(options.name, sum_for_kernels(source, fitted), options.taps);
  return options.folder.empty() ? kernel.json : write_kernel(kernel, options);
}

}  // namespace dermis::cli
