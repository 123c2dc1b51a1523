// SPDX-License-Identifier: MIT
/// State of the viewer while it runs, and its loop: news from the threads, a frame of panels, wishes.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app.h"
#include "viewer/model/background.h"
#include "viewer/model/live_shaders.h"
#include "viewer/model/opening.h"
#include "viewer/model/painters.h"
#include "viewer/model/saving.h"
#include "viewer/model/truth.h"
#include "viewer/panels/desk.h"
#include "viewer/panels/layout.h"
#include "viewer/panels/places.h"
#include "viewer/window/presenter.h"

namespace dermis::viewer {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

class App {
 public:
  explicit App(const AppOptions& options);

  int run();

 private:
  void take_news();
  void take_first();
  void take_opened();
  void take_page();
  void take_shaders();
  void take_recorded();
  void start_recording();
  void take_skin();
  void take_truth();
  void take_comparison();
  void show_b(std::shared_ptr<const Painted> painted);
  void wish_b();
  void compare_now();
  bool is_b_current() const;
  bool blinks() const {
    return view_.compare.is_on() && view_.compare.mode == CompareMode::blink && is_b_current();
  }
  void blink();
  void take_painted();
  void show(std::shared_ptr<const Painted> painted);
  void draw_frame();
  void show_frame(bool edits_skin);
  void apply(Desk& desk);
  void serve(const Requests& requests);
  void save(const Requests& requests);
  void save_scene(const SaveNames& names);
  void write_page_number(std::size_t number);
  std::vector<std::string> scene_in_file(const SaveNames& names);
  void save_one(const Requests& requests, const SaveNames& names);
  void open_next();
  void play();
  void wish();
  double timeout() const;
  double seconds_to_frame() const;
  void tell_shown();
  void rest();
  int close();

  const Document& now() const { return history_->now(); }
  RenderSettings shown_settings() const;   // as a file would be drawn
  RenderSettings window_settings() const;  // as the window shows it now
  void say(const std::string& text, bool is_error = false);
  void tell_places();
  void tell(const std::string& line) const {
    if (!options_.scripted) return;
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  }
  double rest_after() const;  ///< seconds from the last change to a picture at rest

  const AppOptions& options_;
  Window window_;
  Presenter presenter_;
  ViewState view_;
  std::optional<History> history_;  // none before the first scene
  HeadSphereCache spheres_;
  std::optional<SavedScene> saved_scene_;

  Background<Scene> first_{Window::wake};
  Background<OpenedFile> opener_{Window::wake};
  std::vector<std::string> to_open_;
  Background<std::string> pager_{Window::wake}, recorder_{Window::wake};
  SkinMaker skin_maker_{Window::wake};
  std::optional<MadeSkin> skin_;
  std::uint64_t wanted_skin_ = 0;
  Painters painters_;
  std::optional<LiveShaders> live_shaders_;
  int shaders_taken_ = 0;
  std::shared_ptr<const Painted> shown_, shown_b_;
  std::optional<Truth> truth_;
  std::shared_ptr<const TruthStep> truth_step_;
  std::string truth_text_ = "no samples yet";
  Background<Comparison> comparer_{Window::wake};
  std::optional<Comparison> comparison_;

  // The last wish, and the time of the last change.
  struct Wished {
    std::uint64_t serial = 0;  // grows with each change of the rest
    std::uint64_t revision = 0;
    int width = 0, height = 0;
    int shaders = 0;     // number of their changes
    bool truth = false;  // B is, so A is drawn as the truth is
    std::string show{};
    bool timed = false, labels = false, light = false;
    bool operator==(const Wished&) const = default;
  };
  Wished changed_, moving_wish_, resting_wish_, b_wish_;
  std::uint64_t kept_serial_ = 0;        // of what was kept as B
  const Painted* compared_a_ = nullptr;  // pictures of the last comparison, by identity
  const Painted* compared_b_ = nullptr;
  CompareMode compared_mode_ = CompareMode::off;
  bool has_picture_news_ = false;                   // no frame has shown it yet
  bool is_put_off_ = false;                         // the last frame was laid out, and not shown
  std::uint64_t told_picture_ = 0, rested_at_ = 0;  // serials
  double exposure_ev_ = 0;                          // of the last picture at rest
  Clock::time_point changed_at_{}, drawn_at_{}, played_at_{}, retry_at_{};
  PictureArea area_{};
  std::vector<Place> told_places_;
  std::uint64_t gesture_ = 1;
  double blinked_ = 0;
  int frames_left_ = 3;  // of the panels: ImGui needs some until all of an event is seen
};

}  // namespace dermis::viewer
