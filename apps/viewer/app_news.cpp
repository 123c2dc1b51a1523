// SPDX-License-Identifier: MIT
// News from the threads beside the window.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "viewer/app_state.h"
#include "viewer/model/label_views.h"
#include "viewer/model/page.h"

namespace dermis::viewer {

void App::take_first() {
  std::optional<Outcome<Scene>> outcome = first_.take();
  if (!outcome) return;
  if (!outcome->error.empty()) throw InputError("", outcome->error);
  if (!outcome->result) return;
  auto opened = std::make_shared<Opened>();
  opened->words = options_.words;
  opened->options = options_.scene_options;
  opened->scene = *outcome->result;
  history_.emplace(
      Document{.opened = opened, .scene = opened->scene, .settings = options_.settings, .skin = {}});
  window_.set_title("dermis: " + opened->scene.name());
  frames_left_ = 3;
  tell("opened " + opened->scene.name());
}

void App::take_opened() {
  std::optional<Outcome<OpenedFile>> outcome = opener_.take();
  if (!outcome) return;
  view_.notes.insert(view_.notes.end(), outcome->notes.begin(), outcome->notes.end());
  if (!outcome->error.empty()) say(outcome->error, true);
  frames_left_ = 3;
  if (!outcome->result) return;

  Document next = now();
  outcome->result->into(next);
  history_->take(std::move(next), outcome->result->what);
  window_.set_title("dermis: " + now().scene.name());
  say(outcome->result->what);
}

// A skin that was edited is computed beside the window, and comes into the document when it is there.
void App::take_skin() {
  const SkinSource& source = now().skin;
  if (source.serial != wanted_skin_) {
    wanted_skin_ = source.serial;
    if (source.kind == SkinKind::scene)
      skin_.reset();
    else
      skin_maker_.want(source);
  }

  std::optional<MadeSkin> made = skin_maker_.take();
  if (const std::string error = skin_maker_.take_error(); !error.empty()) say(error, true);
  if (!made || now().skin.kind == SkinKind::scene) return;
  tell(fmt::format("skin {} in {:.0f} ms, {}", made->model, made->ms, made->is_quick ? "quick" : "final"));
  skin_ = std::move(made);
  Document next = now();
  set_profile(next, skin_->profile);
  history_->amend(std::move(next));
  frames_left_ = std::max(frames_left_, 2);
}

void App::show(std::shared_ptr<const Painted> painted) {
  const Picture& picture = painted->picture;
  const std::vector<std::uint8_t> labels = label_picture(*painted, view_.show);
  presenter_.set_picture(PictureSlot::a, picture.width, picture.height,
                         labels.empty() ? picture.display_rgba : labels);
  tell(fmt::format("picture {} {}x{} 1/{} {:.1f} ms {}", painted->revision, picture.width, picture.height,
                   painted->divisor, painted->ms, painted->moving ? "moving" : "at rest"));
  view_.frame_ms.push_back(static_cast<float>(painted->ms));
  if (view_.frame_ms.size() > 120) view_.frame_ms.erase(view_.frame_ms.begin());
  if (!painted->moving) exposure_ev_ = picture.statistics.exposure_ev;
  // The error of before is over.
  if (view_.is_error && painted->revision != (shown_ ? shown_->revision : 0)) view_.message.clear();
  shown_ = std::move(painted);
  has_picture_news_ = true;
}

void App::take_painted() {
  PainterNews news = painters_.take_news();
  // A picture of before a change, and a small one that comes after the sharp one, are late.
  const bool is_late = news.painted && shown_ &&
                       (news.painted->serial < shown_->serial ||
                        (news.painted->serial == shown_->serial && news.painted->moving && !shown_->moving));
  if (news.painted && !is_late) show(std::move(news.painted));
  if (news.painted_b) show_b(std::move(news.painted_b));
  for (const std::string& file : news.saved) say("saved " + file);
  if (news.renewed) say("the device was lost; another one draws");
  for (const std::string& error : news.errors) say(error, true);
  view_.notes.insert(view_.notes.end(), news.notes.begin(), news.notes.end());
  if (view_.notes.size() > 100) view_.notes.erase(view_.notes.begin(), view_.notes.end() - 100);
  frames_left_ = std::max(frames_left_, 1);
}

void App::take_page() {
  std::optional<Outcome<std::string>> outcome = pager_.take();
  if (!outcome) return;
  if (!outcome->error.empty()) say(outcome->error, true);
  if (!outcome->result) return;
  say("wrote " + *outcome->result);
  open_page(*outcome->result);
}

void App::take_recorded() {
  std::optional<Outcome<std::string>> outcome = recorder_.take();
  if (!outcome) return;
  view_.records = false;
  frames_left_ = std::max(frames_left_, 2);
  if (!outcome->error.empty())
    say(outcome->error, true);
  else
    say(outcome->result ? "recorded " + *outcome->result : "recording was stopped");
}

// A picture of the new ones is drawn; of faulty ones there is none, and the old picture stays.
void App::take_shaders() {
  std::optional<LiveShaders::News> news = live_shaders_->take();
  if (!news) return;
  tell(news->errors.empty() ? fmt::format("shaders: {} other than built", news->shaders->size())
                            : "shader error: " + news->errors.substr(0, news->errors.find('\n')));
  view_.shader_errors = std::move(news->errors);
  if (view_.shader_errors.empty()) {
    painters_.use_shaders(news->shaders);
    ++shaders_taken_;
  }
  frames_left_ = std::max(frames_left_, 2);
}

void App::take_news() {
  take_first();
  if (history_) take_opened();
  if (history_) take_skin();
  take_page();
  take_recorded();
  if (live_shaders_) take_shaders();
  take_truth();
  take_comparison();
  take_painted();
}

}  // namespace dermis::viewer
