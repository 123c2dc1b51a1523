// SPDX-License-Identifier: MIT
/// Ground truth beside the window: `dermis reference` of the scene that is looked at, on the processors that
/// pictures leave free, refined while one looks.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "dermis/reference.h"
#include "viewer/model/background.h"

namespace dermis::viewer {

/// Progress of the truth.
struct TruthStep {
  ReferencePicture reference;
  std::vector<PictureRegion> regions;  ///< "skin" first
  std::uint64_t revision = 0;          ///< of the document
};

/// At most so many pixels, so that the truth comes while one looks.
inline constexpr int most_truth_pixels = 160'000;
/// Returns by what the sides of a picture are divided for its truth.
int truth_divisor(int width, int height);
/// Returns the settings that both pictures are drawn with: of that size, and without bloom, which the truth
/// has not.
RenderSettings truth_settings(const RenderSettings& settings);

class Truth {
 public:
  /// `most_samples` per pixel: then it rests.
  explicit Truth(std::function<void()> on_news, int most_samples = 4096);
  ~Truth();

  /// Begins anew with this scene. `settings`: truth_settings(), with an exposure.
  void want(const Scene& scene, const RenderSettings& settings, std::uint64_t revision);
  void end();

  /// Returns the newest step since the last call, or null.
  std::shared_ptr<const TruthStep> take();
  /// Returns why it ended, once; empty: it did not fail.
  std::string take_error();
  bool is_running() const { return work_.is_running(); }

 private:
  struct Mailbox {
    std::mutex mutex;
    std::shared_ptr<const TruthStep> step;
    std::atomic<bool> halt = false;  ///< ends the samples that are under way
  };
  std::function<void()> on_news_;
  int most_samples_;
  std::filesystem::path folder_;                                    ///< for what it goes on from
  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();  ///< of the work under way
  Background<bool> work_;
};

}  // namespace dermis::viewer
