// SPDX-License-Identifier: MIT
/// One piece of work beside the window: started, watched, ended by a flag.
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "dermis/cancelled.h"
#include "dermis/hooks.h"
#include "viewer/model/priority.h"

namespace dermis::viewer {

/// End of a piece of work.
template <class Result>
struct Outcome {
  std::optional<Result> result{};    ///< none: it failed, or was ended
  std::string error{};               ///< empty: it was ended, or there is a result
  std::vector<std::string> notes{};  ///< messages of the library
};

template <class Result>
class Background {
 public:
  /// `on_news`: called by any thread when the work is further, or has ended.
  explicit Background(std::function<void()> on_news) : on_news_(std::move(on_news)) {}
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;
  ~Background() {
    end();
    if (thread_.joinable()) thread_.join();
  }

  /// Begins work; what was under way is ended first, and waited for.
  void start(std::function<Result(const Hooks&)> work, Priority priority = Priority::background) {
    end();
    if (thread_.joinable()) thread_.join();
    state_ = std::make_shared<State>();
    thread_ = std::thread([state = state_, work = std::move(work), on_news = on_news_, priority] {
      take_priority(priority);
      run(*state, work, on_news);
      if (on_news) on_news();
    });
  }

  /// Tells the work to end.
  void end() {
    if (state_) state_->stop = true;
  }

  bool is_running() const { return state_ && !state_->done; }

  /// "reading maps: 40 %"; empty where nothing is known.
  std::string doing() const {
    if (!state_) return {};
    const std::lock_guard lock(state_->mutex);
    return state_->doing;
  }

  /// Returns how the work ended, once.
  std::optional<Outcome<Result>> take() {
    if (!state_ || !state_->done) return {};
    if (thread_.joinable()) thread_.join();
    return std::move(std::exchange(state_, {})->outcome);
  }

 private:
  struct State {
    std::atomic<bool> stop = false, done = false;
    mutable std::mutex mutex;
    std::string doing;
    Outcome<Result> outcome;
  };

  static void run(State& state, const std::function<Result(const Hooks&)>& work,
                  const std::function<void()>& on_news) {
    const Hooks hooks{.log =
                          [&](LogLevel, const std::string& line) {
                            const std::lock_guard lock(state.mutex);
                            state.outcome.notes.push_back(line);
                          },
                      .progress =
                          [&](const WorkProgress& progress) {
                            {
                              const std::lock_guard lock(state.mutex);
                              state.doing = fmt::format("{}: {:.0f} %", progress.what, 100 * progress.share);
                            }
                            if (on_news) on_news();
                            return !state.stop;
                          },
                      .stop = &state.stop};
    try {
      state.outcome.result = work(hooks);
    } catch (const Cancelled&) {
    } catch (const std::exception& error) { state.outcome.error = error.what(); }
    state.done = true;
  }

  std::function<void()> on_news_;
  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace dermis::viewer
