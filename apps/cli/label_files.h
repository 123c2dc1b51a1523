// SPDX-License-Identifier: MIT
/// `dermis render --labels`: what each pixel shows, beside its picture.
#pragma once

#include <string>
#include <vector>

#include "dermis/outputs.h"
#include "dermis/renderer.h"

namespace dermis::cli {

/// The labels that `--labels` names.
struct WantedLabels {
  Outputs outputs;         ///< in files
  bool landmarks = false;  ///< in the sheet; of "all" where there are some
  bool all = false;
};

/// Returns the labels that a list such as "depth,landmarks" or "all" names. Throws InputError: an unknown
/// name; one that no file of this ending holds.
WantedLabels labels_of(const std::string& list, const std::string& ending);

/// A file that is not written yet.
struct PendingFile {
  std::string path;
  std::vector<std::byte> bytes;
};

/// Returns the file that says what the labels mean, beside a picture: "face.json" of "face.png".
std::string label_sheet(const std::string& picture);

/// Draws the labels of a picture and returns their files, the sheet last: beside a PNG one for each label,
/// else the picture itself with the labels as layers. Throws InputError: settings.output.show is not the
/// picture; a number that a PNG does not hold; landmarks that are asked for by name, and none of the heads
/// has them.
std::vector<PendingFile> label_files(Renderer& renderer, const Scene& scene, const RenderSettings& settings,
                                     const Picture& picture, const WantedLabels& labels,
                                     const std::string& path);

}  // namespace dermis::cli
