// SPDX-License-Identifier: MIT
// A and B: what B is, when it is drawn, how far the two are apart.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "viewer/app_state.h"

namespace dermis::viewer {

// The picture that A is compared with. Pictures of before a change say nothing of it.
bool App::is_b_current() const {
  return shown_b_ && shown_ && shown_b_->picture.width == shown_->picture.width &&
         shown_b_->picture.height == shown_->picture.height && shown_b_->revision == shown_->revision;
}

void App::show_b(std::shared_ptr<const Painted> painted) {
  const Picture& picture = painted->picture;
  presenter_.set_picture(PictureSlot::b, picture.width, picture.height, picture.display_rgba);
  tell(fmt::format("picture B {} {}x{}", painted->revision, picture.width, picture.height));
  shown_b_ = std::move(painted);
}

void App::take_truth() {
  if (!truth_) return;
  if (const std::string error = truth_->take_error(); !error.empty()) say(error, true);
  std::shared_ptr<const TruthStep> step = truth_->take();
  if (!step || !view_.compare.truth) return;
  truth_text_ = fmt::format("{} samples per pixel, noise {:.1f} %", step->reference.samples,
                            step->reference.noise_percent);
  tell("truth " + truth_text_);
  truth_step_ = step;
  show_b(std::make_shared<const Painted>(
      Painted{.picture = step->reference.picture, .revision = step->revision, .is_b = true}));
  frames_left_ = std::max(frames_left_, 1);
}

void App::take_comparison() {
  std::optional<Outcome<Comparison>> outcome = comparer_.take();
  if (!outcome) return;
  if (!outcome->error.empty()) say(outcome->error, true);
  if (!outcome->result) return;
  comparison_ = std::move(outcome->result);
  if (!comparison_->map_rgba.empty())
    presenter_.set_picture(PictureSlot::map, comparison_->width, comparison_->height, comparison_->map_rgba);
  for (const RegionFigures& region : comparison_->regions)
    tell(fmt::format("compared {}: FLIP {:.5f}, PSNR {:.2f} dB, rel. MSE {:.3e}", region.name, region.flip,
                     region.psnr_db, region.rel_mse));
  frames_left_ = std::max(frames_left_, 1);
}

void App::compare_now() {
  const CompareMode mode = view_.compare.mode;
  if (!view_.compare.is_on() || !is_b_current() || comparer_.is_running() || shown_->moving) return;
  if (compared_a_ == shown_.get() && compared_b_ == shown_b_.get() && compared_mode_ == mode) return;
  compared_a_ = shown_.get();
  compared_b_ = shown_b_.get();
  compared_mode_ = mode;
  const std::vector<PictureRegion> regions =
      view_.compare.truth && truth_step_ ? truth_step_->regions : std::vector<PictureRegion>{};
  comparer_.start([a = shown_, b = shown_b_, regions, mode](const Hooks&) {
    return compare(a->picture, b->picture, regions, mode);
  });
}

// B is drawn, or computed, when A rests.
void App::wish_b() {
  const CompareState& state = view_.compare;
  if (truth_ && !(state.is_on() && state.truth)) {
    truth_->end();
    b_wish_ = {};
  }
  if (!state.is_on() || !shown_ || shown_->moving || shown_->revision != history_->revision()) return;

  const bool is_other_b = !state.truth && state.kept_serial != kept_serial_;
  if (b_wish_ == changed_ && !is_other_b) return;
  b_wish_ = changed_;
  RenderSettings settings = window_settings();
  if (!settings.output.exposure_ev) settings.output.exposure_ev = shown_->picture.statistics.exposure_ev;
  if (state.truth) {
    if (!truth_) truth_.emplace(Window::wake);
    truth_step_.reset();
    truth_text_ = "no samples yet";
    truth_->want(now().scene, settings, changed_.revision);
    return;
  }
  kept_serial_ = state.kept_serial;
  RenderSettings of_b = state.kept->settings;
  of_b.camera = settings.camera;
  of_b.output.width = settings.output.width;
  of_b.output.height = settings.output.height;
  painters_.wish({.scene = state.kept->scene, .settings = of_b, .revision = changed_.revision, .is_b = true});
}

void App::blink() {
  const double phase = std::floor(ImGui::GetTime() / blink_s);
  if (blinks() && phase != blinked_) frames_left_ = std::max(frames_left_, 1);
  blinked_ = phase;
}

}  // namespace dermis::viewer
