// SPDX-License-Identifier: MIT
#include "viewer/model/painter.h"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <utility>

#include "dermis/cancelled.h"
#include "dermis/error.h"
#include "viewer/model/easel.h"

namespace dermis::viewer {

Painter::Painter(Options options) : options_(std::move(options)), thread_([this] { run(); }) {}

Painter::~Painter() {
  stop(-1);
  if (thread_.joinable()) thread_.join();
}

bool Painter::stop(double seconds) {
  std::unique_lock lock(mutex_);
  stop_ = true;
  cancel_ = true;
  wake_.notify_all();
  const auto has_ended = [this] { return has_ended_; };
  if (seconds < 0) {
    ended_.wait(lock, has_ended);
    return true;
  }
  return ended_.wait_for(lock, std::chrono::duration<double>(seconds), has_ended);
}

void Painter::wish(Wish wish) {
  const std::lock_guard lock(mutex_);
  if (!wish.is_b && may_cancel_) cancel_ = true;
  (wish.is_b ? wish_b_ : wish_) = std::move(wish);
  wake_.notify_all();
}

void Painter::drop() {
  const std::lock_guard lock(mutex_);
  wish_.reset();
  if (may_cancel_) cancel_ = true;
}

void Painter::save(SaveWish wish) {
  const std::lock_guard lock(mutex_);
  saves_.push_back(std::move(wish));
  wake_.notify_all();
}

void Painter::use_shaders(std::shared_ptr<const ShaderSet> shaders) {
  const std::lock_guard lock(mutex_);
  shaders_ = std::move(shaders);
}

PainterNews Painter::take_news() {
  const std::lock_guard lock(mutex_);
  return std::exchange(news_, {});
}

bool Painter::is_busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || wish_ || wish_b_ || !saves_.empty();
}

std::string Painter::doing() const {
  const std::lock_guard lock(mutex_);
  return doing_;
}

std::vector<std::string> Painter::validation_messages() const {
  const std::lock_guard lock(mutex_);
  return validation_;
}

std::string Painter::device_name() const {
  const std::lock_guard lock(mutex_);
  return device_name_;
}

void Painter::tell(const std::function<void(PainterNews&)>& change) {
  {
    const std::lock_guard lock(mutex_);
    change(news_);
  }
  if (options_.on_news) options_.on_news();
}

Hooks Painter::hooks() {
  const auto take_progress = [this](const WorkProgress& work) {
    {
      const std::lock_guard lock(mutex_);
      doing_ = fmt::format("{}: {:.0f} %", work.what, 100 * work.share);
    }
    if (options_.on_news) options_.on_news();
    return true;
  };
  const auto take_line = [this](LogLevel, const std::string& line) {
    tell([&](PainterNews& news) { news.notes.push_back(line); });
  };

  return {.log = take_line, .progress = take_progress, .stop = &cancel_};
}

// Waits for it. None: the thread is to end.
std::optional<Painter::Job> Painter::next_job() {
  std::unique_lock lock(mutex_);
  working_ = false;
  wake_.wait(lock, [this] { return stop_ || wish_ || wish_b_ || !saves_.empty(); });
  if (stop_) return {};
  working_ = true;

  Job job;
  if (!saves_.empty()) {
    job.to_save = std::move(saves_.front());
    saves_.erase(saves_.begin());
  } else {
    job.wish = std::exchange(wish_ ? wish_ : wish_b_, {});
  }
  job.shaders = std::exchange(shaders_, {});

  may_cancel_ = job.wish && !job.wish->moving;
  cancel_ = stop_.load();
  return job;
}

void Painter::run() {
  take_priority(options_.priority);
  {
    Easel easel({.device = options_.device, .validate = options_.validate, .hooks = hooks()},
                options_.before_drawing);
    while (std::optional<Job> job = next_job()) {
      if (job->shaders) easel.use_shaders(std::move(job->shaders));
      serve(easel, *job);
    }
    // The renderer ends here, before anybody is told.
  }

  const std::lock_guard lock(mutex_);
  has_ended_ = true;
  ended_.notify_all();
}

// A lost device is opened once more; what fails then is told.
void Painter::serve(Easel& easel, const Job& job) {
  const std::optional<Wish>& wish = job.wish;
  const auto one = [&] {
    if (job.to_save) {
      easel.save(*job.to_save);
      tell([&](PainterNews& news) { news.saved.push_back(job.to_save->file.string()); });
      return;
    }
    auto painted = std::make_shared<const Painted>(easel.draw(*wish));
    tell([&](PainterNews& news) { (wish->is_b ? news.painted_b : news.painted) = std::move(painted); });
  };

  std::string error;
  try {
    try {
      one();
    } catch (const DeviceError&) {
      easel.renew();
      one();
      tell([&](PainterNews& news) { news.renewed = true; });
    }
  } catch (const Cancelled&) {
    // B is drawn when A has been.
    const std::lock_guard lock(mutex_);
    if (wish && wish->is_b && !wish_b_) wish_b_ = wish;
  } catch (const InternalError& mistake) {
    easel.renew();
    error = mistake.what();
  } catch (const std::bad_alloc&) {
    easel.renew();
    error = "too little memory";
  } catch (const std::exception& failure) { error = failure.what(); }

  {
    const std::lock_guard lock(mutex_);
    doing_.clear();
    device_name_ = easel.device_name();
    validation_ = easel.validation_messages();
    working_ = false;
  }
  tell([&](PainterNews& news) {
    if (!error.empty()) news.errors.push_back(error);
  });
}

}  // namespace dermis::viewer
