// SPDX-License-Identifier: MIT
#include "gpu/timer.h"

#include "base/core/assert.h"
#include "gpu/device.h"

namespace dermis::gpu {

struct Timer::State {
  struct Scope {
    std::string name;
    std::uint32_t first = 0, last = 0;  ///< queries
  };
  Device* device = nullptr;
  VkQueryPool pool = VK_NULL_HANDLE;
  std::uint32_t queries = 0;
  std::uint32_t next = 0;
  std::vector<Scope> scopes;
  std::vector<std::size_t> open;  ///< open scopes, outermost first

  std::uint32_t stamp(VkCommandBuffer commands) {
    DERMIS_ASSERT_LT(next, queries);
    if (pool) device->vk().vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, next);
    return next++;
  }
};

Timer::Timer(Device& device, std::uint32_t max_scopes) : state_(std::make_unique<State>()) {
  state_->device = &device;
  state_->queries = max_scopes * 2;
  if (!device.limits().timestamps || max_scopes == 0) return;
  VkQueryPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = state_->queries;
  check(device.vk().vkCreateQueryPool(device.handle(), &info, nullptr, &state_->pool), "vkCreateQueryPool");
}

Timer::~Timer() {
  if (!state_->pool) return;
  state_->device->retire([device = state_->device, pool = state_->pool] {
    device->vk().vkDestroyQueryPool(device->handle(), pool, nullptr);
  });
}

void Timer::reset(VkCommandBuffer commands) {
  DERMIS_ASSERT(state_->open.empty());
  state_->scopes.clear();
  state_->next = 0;
  if (state_->pool) state_->device->vk().vkCmdResetQueryPool(commands, state_->pool, 0, state_->queries);
}

void Timer::begin(VkCommandBuffer commands, const std::string& name) {
  state_->open.push_back(state_->scopes.size());
  state_->scopes.push_back({name, state_->stamp(commands), 0});
}

void Timer::end(VkCommandBuffer commands) {
  DERMIS_ASSERT(!state_->open.empty());
  state_->scopes[state_->open.back()].last = state_->stamp(commands);
  state_->open.pop_back();
}

std::vector<Timing> Timer::read() const {
  const State& s = *state_;
  DERMIS_ASSERT(s.open.empty());
  std::vector<Timing> timings;
  std::vector<std::uint64_t> ticks(s.next);
  if (s.pool && !ticks.empty()) {
    check(s.device->vk().vkGetQueryPoolResults(s.device->handle(), s.pool, 0, s.next,
                                               ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                               sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT),
          "vkGetQueryPoolResults (read() comes after the work has completed)");
  }
  const double ms_per_tick = s.device->limits().timestamp_period_ns * 1e-6;
  const std::uint64_t mask = s.device->limits().timestamp_mask;  // a counter of fewer bits wraps around
  for (const State::Scope& scope : s.scopes)
    timings.push_back(
        {scope.name, static_cast<double>((ticks[scope.last] - ticks[scope.first]) & mask) * ms_per_tick});
  return timings;
}

}  // namespace dermis::gpu
