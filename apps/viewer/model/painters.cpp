// SPDX-License-Identifier: MIT
#include "viewer/model/painters.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

namespace dermis::viewer {
namespace {

Painter::Options with(Painter::Options options, Priority priority) {
  options.priority = priority;
  return options;
}

void append(std::vector<std::string>& to, std::vector<std::string> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Painters::Painters(Painter::Options options, bool apart)
    : rest_(with(options, apart ? Priority::background : Priority::hand)) {
  if (apart) quick_.emplace(with(std::move(options), Priority::hand));
}

void Painters::wish(Wish wish) {
  if (!quick_ || !wish.moving) {
    rest_.wish(std::move(wish));
    return;
  }
  rest_.drop();
  quick_->wish(std::move(wish));
}

void Painters::use_shaders(const std::shared_ptr<const ShaderSet>& shaders) {
  rest_.use_shaders(shaders);
  if (quick_) quick_->use_shaders(shaders);
}

PainterNews Painters::take_news() {
  PainterNews news = rest_.take_news();
  if (!quick_) return news;

  PainterNews more = quick_->take_news();
  if (more.painted && (!news.painted || more.painted->serial > news.painted->serial))
    news.painted = std::move(more.painted);
  append(news.errors, std::move(more.errors));
  append(news.notes, std::move(more.notes));
  news.renewed = news.renewed || more.renewed;
  return news;
}

std::string Painters::doing() const {
  const std::string doing = rest_.doing();
  return doing.empty() && quick_ ? quick_->doing() : doing;
}

std::vector<std::string> Painters::validation_messages() const {
  std::vector<std::string> messages = rest_.validation_messages();
  if (quick_) append(messages, quick_->validation_messages());
  return messages;
}

bool Painters::stop(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  // Both are told before one is waited for.
  rest_.stop(0);
  const bool ended = !quick_ || quick_->stop(seconds);
  const std::chrono::duration<double> left = end - std::chrono::steady_clock::now();
  return rest_.stop(std::max(left.count(), 0.0)) && ended;
}

}  // namespace dermis::viewer
