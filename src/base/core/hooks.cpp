// SPDX-License-Identifier: MIT
#include "base/core/hooks.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <set>
#include <utility>

#include "base/core/log.h"

namespace dermis {

struct CallContext::Call {
  /// Shared by enclosing calls.
  struct Shared {
    std::mutex mutex;              ///< keeps two threads out of the hooks
    std::set<std::string> warned;  ///< of what warn_once() has warned
  };

  Hooks hooks;
  std::shared_ptr<Shared> shared = std::make_shared<Shared>();
  std::atomic<bool> cancelled{false};  ///< set when `progress` has returned false

  bool stopped() const {
    return cancelled.load(std::memory_order_relaxed) ||
           (hooks.stop != nullptr && hooks.stop->load(std::memory_order_relaxed));
  }
};

namespace {

using Lock = std::lock_guard<std::mutex>;

thread_local CallContext current;

std::shared_ptr<CallContext::Call> call_within(const std::shared_ptr<CallContext::Call>& outer,
                                               const Hooks& hooks) {
  auto call = std::make_shared<CallContext::Call>();
  call->hooks = hooks;
  if (outer == nullptr) return call;

  call->shared = outer->shared;
  if (!hooks.log) call->hooks.log = outer->hooks.log;
  if (!hooks.progress) call->hooks.progress = outer->hooks.progress;
  if (hooks.stop == nullptr) call->hooks.stop = outer->hooks.stop;
  return call;
}

}  // namespace

CallContext current_context() { return current; }

bool is_cancelled(const CallContext& context) { return context.call != nullptr && context.call->stopped(); }

void stop_if_cancelled(const CallContext& context) {
  if (!is_cancelled(context)) return;
  throw Cancelled(context.steps == nullptr ? "stopped" : "stopped: " + context.steps->what());
}

HookScope::HookScope(const Hooks& hooks)
    : HookScope(CallContext{call_within(current.call, hooks), nullptr}) {}
HookScope::HookScope(CallContext context) : before_(std::exchange(current, std::move(context))) {}
HookScope::~HookScope() { current = std::move(before_); }

void log_line(LogLevel level, const std::string& line) {
  const std::shared_ptr<CallContext::Call> call = current.call;
  if (call == nullptr || !call->hooks.log) {
    std::fputs(fmt::format("dermis: {}{}\n", level == LogLevel::warning ? "warning: " : "", line).c_str(),
               stderr);
    return;
  }
  const Lock lock(call->shared->mutex);
  const HookScope outside{CallContext{}};  // a hook may call the library: that call is its own
  try {
    call->hooks.log(level, line);
  } catch (...) {
    // The line is lost, the work is not: warnings are also given while an object is destroyed.
  }
}

void warn_once(const std::string& kind, const std::string& line) {
  if (const std::shared_ptr<CallContext::Call> call = current.call) {
    const Lock lock(call->shared->mutex);
    if (!call->shared->warned.insert(kind).second) return;
  }
  log_line(LogLevel::warning, line);
}

Steps::Steps(std::string what, std::size_t count, std::size_t of_outer)
    : what_(std::move(what)), count_(std::max<std::size_t>(count, 1)), outer_(current) {
  stop_if_cancelled(current);
  if (outer_.steps != nullptr) {
    const Lock lock(outer_.call->shared->mutex);
    const Steps& outer = *outer_.steps;
    what_ = outer.what_;
    const double step = outer.width_ / static_cast<double>(outer.count_);
    const std::size_t first = std::min(outer.done_, outer.count_ - 1);
    from_ = outer.from_ + step * static_cast<double>(first);
    width_ = step * static_cast<double>(std::min(of_outer, outer.count_ - first));
  }
  if (current.call != nullptr) current.steps = this;
}

Steps::~Steps() {
  if (outer_.call != nullptr) current.steps = outer_.steps;
}

void Steps::done(std::size_t steps) {
  const std::shared_ptr<CallContext::Call>& call = outer_.call;
  if (call == nullptr) return;

  const Lock lock(call->shared->mutex);
  done_ += std::min(steps, count_ - done_);
  const double share = from_ + width_ * static_cast<double>(done_) / static_cast<double>(count_);

  // Steps of the outer work may run at the same time: what is reported never falls.
  Steps* outermost = this;
  while (outermost->outer_.steps != nullptr) outermost = outermost->outer_.steps;
  outermost->reported_ = std::max(outermost->reported_, share);

  if (call->hooks.progress) {
    const HookScope outside{CallContext{}};  // a hook may call the library: that call is its own
    if (!call->hooks.progress({.what = what_, .share = outermost->reported_})) call->cancelled = true;
  }
  stop_if_cancelled({call, this});
}

}  // namespace dermis
