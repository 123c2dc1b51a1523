// SPDX-License-Identifier: MIT
// The hooks of a caller (dermis/hooks.h) while the library works for it. They belong to a thread rather than
// travel through every function, because a warning may arise anywhere; parallel_for() takes them along.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "dermis/hooks.h"

namespace dermis {

class Steps;

/// Task of a thread: a call of the library, and the step of long work within it. Both may be null.
struct CallContext {
  struct Call;
  std::shared_ptr<Call> call;
  Steps* steps = nullptr;
};

/// Returns the context of the current thread, to be handed to the threads that help.
CallContext current_context();

/// Returns whether the caller has ended the work.
bool is_cancelled(const CallContext& context);
/// Throws Cancelled if the caller has ended the work.
void stop_if_cancelled(const CallContext& context);

/// While it exists, the current thread works for the owner of the hooks.
class HookScope {
 public:
  /// Begins a call with these hooks. A member that is empty is that of the enclosing call.
  explicit HookScope(const Hooks& hooks);
  /// Joins the call of another thread, or of none.
  explicit HookScope(CallContext context);
  ~HookScope();
  HookScope(const HookScope&) = delete;
  HookScope& operator=(const HookScope&) = delete;

 private:
  CallContext before_;
};

/// Counts the finished steps of long work, by any thread, and tells the caller how far the work is. A step
/// may count steps of its own: they are shares of that step, or of several, under the name of the outermost
/// work.
///
///   Steps rows("what the skin sees of its surroundings", side);
///   parallel_for(side, [&](std::size_t row) { ...; rows.done(); });
class Steps {
 public:
  /// `of_outer`: how many steps of the enclosing work these are. Throws Cancelled if the caller has ended the
  /// work.
  Steps(std::string what, std::size_t count, std::size_t of_outer = 1);
  ~Steps();
  Steps(const Steps&) = delete;
  Steps& operator=(const Steps&) = delete;

  /// Ends one step, or several. Throws Cancelled if the caller ends the work, and whatever its hook throws.
  void done(std::size_t steps = 1);

  const std::string& what() const { return what_; }

 private:
  std::string what_;
  std::size_t count_, done_ = 0;
  double from_ = 0, width_ = 1;  ///< of the outermost work
  double reported_ = 0;          ///< of the outermost work, kept there
  CallContext outer_;
};

}  // namespace dermis
