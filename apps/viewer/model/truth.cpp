// SPDX-License-Identifier: MIT
#include "viewer/model/truth.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "base/core/error.h"

namespace dermis::viewer {
namespace {

std::filesystem::path make_folder() {
  std::string name = (std::filesystem::temp_directory_path() / "dermis-view-XXXXXX").string();
  if (!mkdtemp(name.data())) throw InputError(name, "no folder for the ground truth can be made there");
  return name;
}

// One processor stays for the pictures.
int free_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

// Goes on until there are so many samples: a hook then ends the work, and what there is lies in the
// checkpoint. `halt` ends it at once.
ReferencePicture refined(const Scene& scene, const RenderSettings& settings,
                         const std::filesystem::path& checkpoint, int samples, std::atomic<bool>& halt) {
  ReferenceSettings reference;
  reference.samples = 1'000'000;
  reference.threads = free_threads();
  reference.checkpoint = checkpoint;
  reference.resume = true;
  reference.after_sample = [&](const ReferenceProgress& progress) {
    if (progress.samples >= samples) halt = true;
  };
  // The note would be that there is no checkpoint yet.
  const Hooks hooks{.log = [](LogLevel, const std::string&) {}, .progress = {}, .stop = &halt};
  return render_reference(scene, settings, reference, hooks);
}

}  // namespace

int truth_divisor(int width, int height) {
  int by = 1;
  while ((width / by) * (height / by) > most_truth_pixels) ++by;
  return by;
}

RenderSettings truth_settings(const RenderSettings& settings) {
  RenderSettings same = settings;
  const int by = truth_divisor(settings.output.width, settings.output.height);
  same.output.width = std::max(settings.output.width / by, 1);
  same.output.height = std::max(settings.output.height / by, 1);
  same.output.bloom = 0;
  return same;
}

Truth::Truth(std::function<void()> on_news, int most_samples)
    : on_news_(on_news), most_samples_(most_samples), folder_(make_folder()), work_(std::move(on_news)) {}

Truth::~Truth() {
  end();
  while (work_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void Truth::end() {
  work_.end();
  mailbox_->halt = true;
}

void Truth::want(const Scene& scene, const RenderSettings& settings, std::uint64_t revision) {
  end();
  mailbox_ = std::make_shared<Mailbox>();
  const auto work = [=, mailbox = mailbox_, on_news = on_news_, most = most_samples_,
                     checkpoint = folder_ / fmt::format("truth-{}", revision)](const Hooks& hooks) {
    const std::vector<PictureRegion> regions = picture_regions(scene, settings, hooks);
    for (int samples = 1; samples <= most && !*hooks.stop; samples *= 2) {
      mailbox->halt = false;
      if (*hooks.stop) break;
      auto step = std::make_shared<TruthStep>(
          TruthStep{refined(scene, settings, checkpoint, samples, mailbox->halt), regions, revision});
      {
        const std::lock_guard lock(mailbox->mutex);
        mailbox->step = std::move(step);
      }
      if (on_news) on_news();
    }
    std::error_code ignored;
    std::filesystem::remove(checkpoint, ignored);
    return true;
  };
  work_.start(work);
}

std::shared_ptr<const TruthStep> Truth::take() {
  const std::lock_guard lock(mailbox_->mutex);
  return std::exchange(mailbox_->step, {});
}

std::string Truth::take_error() {
  std::optional<Outcome<bool>> outcome = work_.take();
  return outcome ? outcome->error : std::string();
}

}  // namespace dermis::viewer
