// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "cli/command.h"
#include "cli/compare_page.h"
#include "core/error.h"
#include "core/file.h"
#include "image/codec.h"

namespace dermis::cli {
namespace {

namespace fs = std::filesystem;

// Two PNG of this many pixels take 2 GB.
constexpr image::DecodeLimits limits{.max_side = 16384, .max_pixels = std::size_t{1} << 26};

struct CompareArguments {
  std::string a, b, json, html, region, view = "filmic";
  std::vector<std::string> variances;
};

image::View view_of(const std::string& name) {
  if (name == "filmic") return image::View::filmic;
  if (name == "srgb") return image::View::srgb;
  if (name == "linear") return image::View::linear;
  throw input_error("--view", "'{}' is not known; known: filmic, srgb, linear", name);
}

/// What can be refused before pictures are read.
void check_outputs(const CompareArguments& arguments) {
  if (arguments.html == "-") throw input_error("--html", "needs a file, not standard output");
  const auto full = [](const std::string& path) { return fs::weakly_canonical(fs::absolute(path)); };
  std::vector<std::string> taken{arguments.a, arguments.b};
  if (!arguments.region.empty()) taken.push_back(arguments.region);
  taken.insert(taken.end(), arguments.variances.begin(), arguments.variances.end());
  for (const std::string& output : {arguments.json, arguments.html}) {
    if (output.empty() || output == "-") continue;
    check_writable(output);
    for (const std::string& other : taken)
      if (full(output) == full(other)) throw input_error(output, "is also another file of this command; outputs need names of their own");
    taken.push_back(output);
  }
}

template <class Image>
void check_size(const Image& a, const std::string& a_name, const Image& b, const std::string& b_name) {
  if (a.width != b.width || a.height != b.height)
    throw input_error(b_name, "is {} x {} pixels, {} is {} x {}; only pictures of one size can be compared", b.width, b.height, a_name,
                      a.width, a.height);
}

image::Region region_for(const CompareArguments& arguments, int width, int height) {
  return arguments.region.empty() ? image::Region() : image::load_region(arguments.region, width, height);
}

void compare_linear(const CompareArguments& arguments, std::span<const std::byte> a_bytes, std::span<const std::byte> b_bytes,
                    Compared& compared) {
  const image::ImageF a = image::decode_image_f(a_bytes, arguments.a, limits), b = image::decode_image_f(b_bytes, arguments.b, limits);
  check_size(a, arguments.a, b, arguments.b);
  compared.region = region_for(arguments, a.width, a.height);
  std::vector<image::ImageF> variances;
  for (const std::string& name : arguments.variances) {
    variances.push_back(image::load_image_f(name, limits));
    check_size(a, arguments.a, variances.back(), name);
    const auto& values = variances.back().values;
    const auto negative = std::find_if(values.begin(), values.end(), [](float value) { return value < 0; });
    if (negative != values.end()) throw input_error(name, "holds {}; variances are 0 or more", *negative);
  }
  const image::View view = view_of(arguments.view);
  compared.view = arguments.view;
  compared.found = image::compare(a, b, view, variances, compared.region);
  compared.shown_a = image::to_display(a, view);
  compared.shown_b = image::to_display(b, view);
}

void compare_display(const CompareArguments& arguments, std::span<const std::byte> a_bytes, std::span<const std::byte> b_bytes,
                     Compared& compared) {
  if (!arguments.variances.empty()) throw input_error("--z", "needs two linear pictures (EXR); {} holds display values", arguments.a);
  compared.shown_a = image::decode_image8(a_bytes, arguments.a, limits);
  compared.shown_b = image::decode_image8(b_bytes, arguments.b, limits);
  check_size(compared.shown_a, arguments.a, compared.shown_b, arguments.b);
  compared.region = region_for(arguments, compared.shown_a.width, compared.shown_a.height);
  compared.found = image::compare(compared.shown_a, compared.shown_b, compared.region);
}

void run(const CompareArguments& arguments) {
  view_of(arguments.view);
  check_outputs(arguments);
  Compared compared{.a = arguments.a, .b = arguments.b, .region_name = arguments.region};
  {
    const std::vector<std::byte> a = read_file(arguments.a), b = read_file(arguments.b);
    const image::PictureKind kind = image::picture_kind(a, arguments.a);
    if (image::picture_kind(b, arguments.b) != kind) {
      const auto name = [](bool linear) { return linear ? "linear light" : "display values"; };
      const bool linear = kind == image::PictureKind::linear;
      throw input_error(arguments.b, "holds {}, {} holds {}; compare two PNG or two EXR pictures", name(!linear), arguments.a,
                        name(linear));
    }
    (kind == image::PictureKind::linear ? compare_linear : compare_display)(arguments, a, b, compared);
  }
  // All there is to say before anything is written.
  const std::string json = compared_json(compared), page = arguments.html.empty() ? "" : compared_page(compared);
  if (!arguments.html.empty()) write_file(arguments.html, page);
  if (!arguments.json.empty()) write_text(arguments.json, json);
  if (arguments.json != "-") write_text("-", compared_text(compared));
}

}  // namespace

void add_compare_command(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("compare", "how far two pictures are apart: FLIP, PSNR, relative error");
  auto arguments = std::make_shared<CompareArguments>();
  command->option_defaults()->always_capture_default();
  command->add_option("A", arguments->a, "the reference: PNG or JPEG, or EXR or HDR")->required();
  command->add_option("B", arguments->b, "what is compared with it: of the same size, and linear if A is")->required();
  command->add_option("--json", arguments->json, "write the figures as JSON, - for standard output");
  command->add_option("--html", arguments->html, "write a page: side by side, slider, map of errors, table; one file");
  command->add_option("--region", arguments->region, "PNG of the same size: only pixels that are not black there count");
  command
      ->add_option("--z", arguments->variances,
                   "EXR: variance of each pixel of A or B (squared standard error); how much of the difference is noise; up to 2 times")
      ->allow_extra_args(false)
      ->expected(1, 2)
      ->default_str("");
  command->add_option("--view", arguments->view, "how EXR is shown for PSNR and the page: filmic, srgb, linear");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace dermis::cli
