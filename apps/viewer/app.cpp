// SPDX-License-Identifier: MIT
#include "viewer/app_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "dermis/error.h"
#include "render/setup/frame_setup.h"
#include "viewer/model/animation.h"
#include "viewer/model/label_views.h"
#include "viewer/model/memory.h"

namespace dermis::viewer {
namespace {

constexpr double rest_s = 0.25;            // after the last change, a picture at rest
constexpr double held_rest_s = 0.6;        // the same while a button is held: more is likely to come
constexpr double software_frame_s = 0.05;  // panels leave the processors to the picture
constexpr double busy_frame_s = 0.1;       // and more so while one follows the hand
constexpr double play_frame_s = 1.0 / 30;
constexpr double closing_s = 0.8;

// For tests: every Nth picture is drawn by a device that is lost.
std::function<void()> lost_device_hook() {
  const char* text = std::getenv("DERMIS_VIEW_LOSE_DEVICE");
  const int every = text ? std::atoi(text) : 0;
  if (every <= 0) return {};
  return [every, drawn = 0]() mutable {
    if (++drawn % every == 0) throw DeviceError("the device was lost (DERMIS_VIEW_LOSE_DEVICE)");
  };
}

}  // namespace

App::App(const AppOptions& options)
    : options_(options),
      window_("dermis", options.width, options.height),
      presenter_(window_, options.validate),
      painters_({.device = options.device,
                 .validate = options.validate,
                 .on_news = Window::wake,
                 .before_drawing = lost_device_hook()},
                presenter_.is_software()) {
  view_.fixed_size = options.fixed_size;
  if (!options.shader_folder.empty())
    live_shaders_.emplace(options.shader_folder, options.shader_compiler, Window::wake);
  first_.start([&options](const Hooks& hooks) { return options.load(hooks); });
}

double App::rest_after() const { return ImGui::IsAnyMouseDown() ? held_rest_s : rest_s; }

void App::say(const std::string& text, bool is_error) {
  view_.message = text;
  view_.is_error = is_error;
  tell((is_error ? "error: " : "message: ") + text);
}

// Where the widgets are, when that has changed.
void App::tell_places() {
  if (!options_.scripted || places() == told_places_) return;
  told_places_ = places();
  for (const Place& place : told_places_)
    tell(fmt::format("place {}: {} {} {} {}", place.name, place.x, place.y, place.width, place.height));
  tell("places told");
}

// The settings as pictures of this window have them.
RenderSettings App::shown_settings() const {
  RenderSettings settings = now().settings;
  if (!view_.fixed_size && area_.width > 0) {
    settings.output.width = area_.width;
    settings.output.height = area_.height;
  }
  return settings;
}

RenderSettings App::window_settings() const {
  RenderSettings settings = shown_settings();
  settings.output.show = is_label_view(view_.show) ? first_shown : view_.show;
  return view_.compare.is_on() && view_.compare.truth ? truth_settings(settings) : settings;
}

void App::open_next() {
  for (std::string& file : window_.take_dropped()) to_open_.push_back(std::move(file));
  if (!history_ || to_open_.empty() || opener_.is_running()) return;
  const std::string file = to_open_.front();
  to_open_.erase(to_open_.begin());
  tell("opening " + file);
  opener_.start(
      [document = now(), file](const Hooks& hooks) { return read_file_for(document, file, hooks); });
}

void App::play() {
  if (!history_ || !view_.playing) {
    played_at_ = Clock::now();
    return;
  }
  const double seconds = seconds_since(played_at_);
  if (seconds < play_frame_s) return;
  played_at_ = Clock::now();
  Document next = now();
  if (!play_on(next.scene, std::min(seconds, 0.25), view_.loops)) {
    view_.playing = false;
    return;
  }
  constexpr std::uint64_t of_playing = ~std::uint64_t{0};
  history_->take(std::move(next), "play", of_playing);
  frames_left_ = std::max(frames_left_, 1);
}

void App::apply(Desk& desk) {
  if (!desk.next) return;
  try {
    setup::check_settings(desk.next->settings);
    history_->take(std::move(*desk.next), desk.change, gesture_);
  } catch (const InputError& error) { say(error.what(), true); }
  frames_left_ = std::max(frames_left_, 2);
}

void App::draw_frame() {
  if (!presenter_.begin()) return;
  frames_left_ = std::max(frames_left_ - 1, 0);
  drawn_at_ = Clock::now();

  Requests requests;
  const std::uint64_t skin_before = wanted_skin_;
  if (!history_) {
    loading_layout(first_.doing());
  } else {
    const std::string skin_doing = skin_maker_.is_running() ? "computing " + skin_maker_.doing() : "";
    Desk desk{.now = now(),
              .sphere = spheres_.of(now()),
              .shown = shown_.get(),
              .skin = skin_ ? &*skin_ : nullptr,
              .skin_doing = skin_doing,
              .shown_b = is_b_current() ? shown_b_.get() : nullptr,
              .comparison = comparison_ && is_b_current() ? &*comparison_ : nullptr,
              .truth_text = truth_text_,
              .truth_divisor = truth_divisor(area_.width, area_.height),
              .view = view_,
              .requests = requests};
    const std::string doing = opener_.is_running() ? opener_.doing() : painters_.doing();
    area_ = main_layout(desk, *history_, doing, window_.take_keys());
    if (!ImGui::IsAnyItemActive()) ++gesture_;
    apply(desk);
    // Edits are begun before the panels are shown.
    take_skin();
    wish();
  }
  show_frame(wanted_skin_ != skin_before);
  if (history_) serve(requests);
  tell_places();
}

// Shows the panels that were laid out. On a software driver that takes both processors as long as a profile
// does. So after an edit of the skin it is put off once, and the new picture brings the panels with it.
void App::show_frame(bool edits_skin) {
  if (edits_skin && presenter_.is_software() && !has_picture_news_ && !is_put_off_) {
    presenter_.drop();
    is_put_off_ = true;
    frames_left_ = std::max(frames_left_, 1);
    return;
  }

  is_put_off_ = has_picture_news_ = false;
  if (presenter_.end()) {
    tell_shown();
  } else if (!window_.is_minimised()) {
    frames_left_ = std::max(frames_left_, 1);
    retry_at_ = Clock::now() + std::chrono::milliseconds(100);
  }
}

// When a picture has come to the window.
void App::tell_shown() {
  if (!options_.scripted || !shown_ || shown_->serial == told_picture_) return;
  told_picture_ = shown_->serial;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  tell(fmt::format("shown {} at {} ms", shown_->revision,
                   std::chrono::duration_cast<std::chrono::milliseconds>(now).count()));
}

void App::wish() {
  if (!history_ || area_.width <= 0) return;
  const RenderSettings settings = window_settings();
  Wished wanted{.serial = changed_.serial,
                .revision = history_->revision(),
                .width = settings.output.width,
                .height = settings.output.height,
                .shaders = shaders_taken_,
                .truth = view_.compare.is_on() && view_.compare.truth,
                .show = view_.show,
                .timed = view_.timed,
                .labels = view_.loupe || is_label_view(view_.show),
                .light = view_.loupe};
  if (wanted != changed_) {
    ++wanted.serial;
    changed_ = wanted;
    changed_at_ = Clock::now();
  }

  const bool moving = view_.playing || seconds_since(changed_at_) < rest_after();
  Wished& last = moving ? moving_wish_ : resting_wish_;
  if (!moving) wish_b();
  if (last == wanted) return;
  last = wanted;
  painters_.wish({.scene = now().scene,
                  .settings = settings,
                  .revision = wanted.revision,
                  .serial = wanted.serial,
                  .moving = moving,
                  .exposure_ev = exposure_ev_,
                  .timed = wanted.timed,
                  .labels = wanted.labels,
                  .light = wanted.light});
}

// When the panels may be drawn again.
double App::seconds_to_frame() const {
  const double retry = -seconds_since(retry_at_);
  if (!presenter_.is_software() || has_picture_news_) return retry;
  const double every_s = painters_.follows_hand() ? busy_frame_s : software_frame_s;
  return std::max(every_s - seconds_since(drawn_at_), retry);
}

// Returns the seconds in which nothing will happen by itself; negative: for ever.
double App::timeout() const {
  if (frames_left_ > 0) return std::max(seconds_to_frame(), 0.0);
  if (view_.playing) return play_frame_s;
  if (blinks()) return blink_s - std::fmod(ImGui::GetTime(), blink_s) + 0.01;
  if (history_ && area_.width > 0 && resting_wish_ != changed_)
    return std::max(rest_after() - seconds_since(changed_at_), 0.001);
  return -1;
}

// Nothing is to be done until something happens.
void App::rest() {
  if (shown_ && shown_->serial != rested_at_) {
    rested_at_ = shown_->serial;
    return_free_memory();
  }
  tell(fmt::format("idle after {} frames", presenter_.frames()));
}

int App::run() {
  while (!window_.should_close()) {
    take_news();
    open_next();
    play();
    blink();
    wish();  // of what has come, before the panels are drawn: they take as long as a small picture
    if (frames_left_ > 0 && seconds_to_frame() <= 0) draw_frame();
    if (window_.is_minimised()) frames_left_ = 0;
    wish();
    compare_now();

    const double wait_s = timeout();
    if (wait_s < 0 && !painters_.is_busy() && !opener_.is_running() && !skin_maker_.is_running() &&
        !recorder_.is_running())
      rest();
    window_.wait(wait_s < 0 ? -1 : std::max(wait_s, 0.0));
    if (window_.take_touched()) frames_left_ = std::max(frames_left_, 3);
  }
  return close();
}

// Ends what works beside the window. A thread that does not end in time ends with the program. No file that
// it may be writing appears under its name half-written.
int App::close() {
  const Clock::time_point start = Clock::now();
  first_.end();
  opener_.end();
  skin_maker_.end();
  pager_.end();
  recorder_.end();
  if (truth_) truth_->end();
  bool ended = painters_.stop(closing_s);
  const auto is_running = [&] {
    return first_.is_running() || opener_.is_running() || skin_maker_.is_running() ||
           comparer_.is_running() || pager_.is_running() || recorder_.is_running() ||
           (truth_ && truth_->is_running());
  };
  while (is_running() && seconds_since(start) < closing_s) window_.wait(0.01);
  ended = ended && !is_running();

  std::vector<std::string> messages = painters_.validation_messages();
  presenter_.close();
  const std::vector<std::string>& own = presenter_.validation_messages();
  messages.insert(messages.end(), own.begin(), own.end());
  for (const std::string& message : messages)
    std::fprintf(stderr, "dermis: validation: %s\n", message.c_str());
  const int status = messages.empty() ? 0 : 1;
  tell(fmt::format("closed in {:.2f} s", seconds_since(start)));
  if (!ended) {
    std::fflush(nullptr);
    std::_Exit(status);
  }
  return status;
}

int run(const AppOptions& options) {
  App app(options);
  return app.run();
}

}  // namespace dermis::viewer
