// SPDX-License-Identifier: MIT
#include "gpu/device.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>

#include "base/core/assert.h"
#include "base/core/error.h"
#include "base/core/log.h"
#include "gpu/choose.h"
#include "gpu/instance.h"
#include "gpu/loader.h"
#include "gpu/memory.h"

namespace dermis::gpu {
namespace {

const char* text_of(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED: return "initialization failed";
    case VK_ERROR_DEVICE_LOST: return "the device was lost (a driver reset, or a shader ran too long)";
    case VK_ERROR_MEMORY_MAP_FAILED: return "memory could not be mapped";
    case VK_ERROR_LAYER_NOT_PRESENT: return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT: return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "incompatible driver";
    case VK_ERROR_TOO_MANY_OBJECTS: return "too many objects";
    case VK_ERROR_FORMAT_NOT_SUPPORTED: return "format not supported";
    case VK_ERROR_FRAGMENTED_POOL: return "fragmented pool";
    case VK_TIMEOUT: return "timed out";
    case VK_NOT_READY: return "not ready";
    default: return "failed";
  }
}

void check_host(const vulkan::Host& host) {
  const auto need = [](bool given, const char* member) {
    if (!given) throw input_error("vulkan::Host", "{} must not be null", member);
  };
  need(host.get_instance_proc_addr != nullptr, "get_instance_proc_addr");
  need(host.instance != VK_NULL_HANDLE, "instance");
  need(host.physical_device != VK_NULL_HANDLE, "physical_device");
  need(host.device != VK_NULL_HANDLE, "device");
  need(host.queue != VK_NULL_HANDLE, "queue");
  if (!host.memory.allocate != !host.memory.free)
    throw input_error("vulkan::Host", "memory needs both of its callbacks, or none");
}

}  // namespace

void check(VkResult result, std::string_view what) {
  if (result != VK_SUCCESS)
    throw device_error("{}: {} (VkResult {})", what, text_of(result), static_cast<int>(result));
}

struct Device::State {
  bool of_host = false;
  std::unique_ptr<Instance> instance;  ///< ours; null for a host's device
  std::mutex* queue_mutex = nullptr;   ///< of the host; null: nobody else submits
  vulkan::MemoryCallbacks memory_of_host;
  InstanceTable instance_table{};
  DeviceTable vk{};
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  std::uint32_t queue_family = 0;
  VkPhysicalDeviceProperties properties{};
  DeviceInfo summary;
  DeviceLimits limits;
  std::unique_ptr<MemoryPool> memory;
  VkCommandPool pool = VK_NULL_HANDLE;
  VkSemaphore timeline = VK_NULL_HANDLE;
  std::uint64_t submitted = 0;  ///< serial of the last submission
  DeviceCounters counters;
  std::uint32_t recording = 0;  ///< command buffers begun and neither submitted nor discarded

  std::uint64_t host_recorded = 0, host_finished = 0;  ///< frames of the host

  struct Retired {
    std::uint64_t serial, host_frame;  ///< freed when both have completed
    std::function<void()> free;
  };
  std::vector<Retired> retired;
  std::vector<std::pair<std::uint64_t, VkCommandBuffer>> in_flight;
  std::vector<VkCommandBuffer> spare;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();
  void create_device(const Candidate& candidate);
  void set_up(const Candidate& candidate, bool anisotropy);
  void find_limits(const Candidate& candidate, bool anisotropy);
  std::uint64_t completed() const;
  void recycle_commands();
  void free_completed(std::uint64_t serial, std::uint64_t host_frame);
  /// Returns the serial at which all work recorded so far is done.
  std::uint64_t recorded() const { return submitted + recording; }
};

Device::State::~State() {
  if (device == VK_NULL_HANDLE) return;
  if (timeline != VK_NULL_HANDLE) {
    VkSemaphoreWaitInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
    info.semaphoreCount = 1;
    info.pSemaphores = &timeline;
    info.pValues = &submitted;
    // Fails at once on a lost device, where nothing is in use any more.
    vk.vkWaitSemaphores(device, &info, std::numeric_limits<std::uint64_t>::max());
  }
  constexpr std::uint64_t all = std::numeric_limits<std::uint64_t>::max();
  free_completed(all, all);
  memory.reset();
  vk.vkDestroyCommandPool(device, pool, nullptr);
  vk.vkDestroySemaphore(device, timeline, nullptr);
  if (!of_host) vk.vkDestroyDevice(device, nullptr);
}

void Device::State::create_device(const Candidate& candidate) {
  RequiredFeatures required;
  required.features.features.samplerAnisotropy = candidate.anisotropy;
  const float priority = 1;
  VkDeviceQueueCreateInfo queue_info{};
  queue_info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue_info.queueFamilyIndex = candidate.queue_family;
  queue_info.queueCount = 1;
  queue_info.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &required.features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue_info;
  info.enabledExtensionCount = static_cast<std::uint32_t>(RequiredFeatures::extensions().size());
  info.ppEnabledExtensionNames = RequiredFeatures::extensions().data();
  check(instance_table.create_device(candidate.handle, &info, nullptr, &device), "vkCreateDevice");
}

void Device::State::find_limits(const Candidate& candidate, bool anisotropy) {
  VkPhysicalDeviceMaintenance4Properties maintenance4{};
  maintenance4.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_4_PROPERTIES;
  VkPhysicalDeviceProperties2 all{};
  all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  all.pNext = &maintenance4;
  instance_table.get_properties2(physical, &all);
  properties = all.properties;

  const VkPhysicalDeviceLimits& has = properties.limits;
  limits.max_image_side = has.maxImageDimension2D;
  limits.max_array_layers = has.maxImageArrayLayers;
  limits.max_buffer_bytes = maintenance4.maxBufferSize;
  limits.max_storage_buffer_bytes = has.maxStorageBufferRange;
  limits.max_texel_buffer_texels = has.maxTexelBufferElements;
  std::ranges::copy(has.maxComputeWorkGroupCount, limits.max_workgroups.begin());
  limits.max_workgroup_threads = has.maxComputeWorkGroupInvocations;
  limits.max_anisotropy = anisotropy ? has.maxSamplerAnisotropy : 1;
  limits.max_push_bytes = has.maxPushConstantsSize;
  limits.max_clip_distances = has.maxClipDistances;

  limits.timestamp_period_ns = has.timestampPeriod;
  limits.timestamps = candidate.timestamp_bits > 0;
  limits.timestamp_mask = limits.timestamps ? ~std::uint64_t{0} >> (64 - candidate.timestamp_bits) : 0;
  limits.software = candidate.type == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

void Device::State::set_up(const Candidate& candidate, bool anisotropy) {
  physical = candidate.handle;
  summary = candidate.summary;
  vk = load_device_table(instance_table.get_device_proc_addr, device);
  find_limits(candidate, anisotropy);

  VkPhysicalDeviceMaintenance3Properties maintenance3{};
  maintenance3.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
  VkPhysicalDeviceProperties2 all{};
  all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
  all.pNext = &maintenance3;
  instance_table.get_properties2(physical, &all);
  VkPhysicalDeviceMemoryProperties heaps{};
  instance_table.get_memory_properties(physical, &heaps);
  memory =
      std::make_unique<MemoryPool>(vk, device, heaps, maintenance3.maxMemoryAllocationSize, memory_of_host);

  VkCommandPoolCreateInfo pool_info{};
  pool_info.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT | VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool_info.queueFamilyIndex = queue_family;
  check(vk.vkCreateCommandPool(device, &pool_info, nullptr, &pool), "vkCreateCommandPool");
  VkSemaphoreTypeCreateInfo type{};
  type.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO;
  type.semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE;
  VkSemaphoreCreateInfo semaphore{};
  semaphore.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO;
  semaphore.pNext = &type;
  check(vk.vkCreateSemaphore(device, &semaphore, nullptr, &timeline), "vkCreateSemaphore");
}

std::uint64_t Device::State::completed() const {
  std::uint64_t value = 0;
  check(vk.vkGetSemaphoreCounterValue(device, timeline, &value), "vkGetSemaphoreCounterValue");
  return value;
}

void Device::State::recycle_commands() {
  const std::uint64_t done = completed();
  std::erase_if(in_flight, [&](const auto& entry) {
    if (entry.first > done) return false;
    spare.push_back(entry.second);
    return true;
  });
  free_completed(done, host_finished);
}

void Device::State::free_completed(std::uint64_t serial, std::uint64_t host_frame) {
  // Freeing one object may retire another, so the list is moved out first.
  std::vector<Retired> due;
  std::erase_if(retired, [&](Retired& entry) {
    if (entry.serial > serial || entry.host_frame > host_frame) return false;
    due.push_back(std::move(entry));
    return true;
  });
  for (const Retired& entry : due) entry.free();
}

Device::Device(const Options& options) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.instance = std::make_unique<Instance>(options.validate);
  s.instance_table = s.instance->table();
  std::vector<Candidate> candidates;
  for (VkPhysicalDevice device : s.instance->physical_devices())
    candidates.push_back(examine(s.instance_table, device));
  sort_best_first(candidates);
  const Candidate& chosen = choose(candidates, options.select);
  s.queue_family = chosen.queue_family;
  s.create_device(chosen);
  s.set_up(chosen, chosen.anisotropy);
  s.vk.vkGetDeviceQueue(s.device, s.queue_family, 0, &s.queue);
}

Device::Device(const vulkan::Host& host) : state_(std::make_unique<State>()) {
  check_host(host);
  State& s = *state_;
  s.of_host = true;
  s.queue_mutex = host.queue_mutex;
  s.memory_of_host = host.memory;
  s.instance_table = load_instance_table(host.get_instance_proc_addr, host.instance);
  const Candidate candidate = examine(s.instance_table, host.physical_device, host.queue_family);
  if (!candidate.summary.missing.empty())
    throw device_error("{} cannot be used: {}", candidate.summary.name,
                       fmt::join(candidate.summary.missing, "; "));
  s.device = host.device;
  s.queue = host.queue;
  s.queue_family = host.queue_family;
  s.set_up(candidate, host.sampler_anisotropy && candidate.anisotropy);
  if (s.vk.vkCmdPushDescriptorSetKHR == nullptr)
    throw device_error("the host's device was made without {} (see RequiredFeatures)",
                       RequiredFeatures::extensions()[0]);
}

Device::~Device() = default;

VkDevice Device::handle() const { return state_->device; }
const DeviceTable& Device::vk() const { return state_->vk; }
const DeviceInfo& Device::summary() const { return state_->summary; }
const DeviceLimits& Device::limits() const { return state_->limits; }
const VkPhysicalDeviceProperties& Device::properties() const { return state_->properties; }
MemoryPool& Device::memory() { return *state_->memory; }
std::uint64_t Device::image_bytes() const { return state_->memory->image_bytes(); }
std::uint64_t Device::buffer_bytes() const { return state_->memory->buffer_bytes(); }
std::uint64_t Device::peak_bytes() const { return state_->memory->peak_bytes(); }

bool Device::format_supports(VkFormat format, VkFormatFeatureFlags features) const {
  VkFormatProperties2 properties{};
  properties.sType = VK_STRUCTURE_TYPE_FORMAT_PROPERTIES_2;
  state_->instance_table.get_format_properties2(state_->physical, format, &properties);
  return (properties.formatProperties.optimalTilingFeatures & features) == features;
}

std::optional<VkImageFormatProperties> Device::image_format_properties(VkFormat format,
                                                                       VkImageUsageFlags usage) const {
  VkImageFormatProperties properties{};
  const VkResult result = state_->instance_table.get_image_format_properties(
      state_->physical, format, VK_IMAGE_TYPE_2D, VK_IMAGE_TILING_OPTIMAL, usage, 0, &properties);
  if (result == VK_ERROR_FORMAT_NOT_SUPPORTED) return std::nullopt;
  check(result, "vkGetPhysicalDeviceImageFormatProperties");
  return properties;
}

VkCommandBuffer Device::begin() {
  State& s = *state_;
  s.recycle_commands();

  VkCommandBuffer commands = VK_NULL_HANDLE;
  if (s.spare.empty()) {
    VkCommandBufferAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
    info.commandPool = s.pool;
    info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    info.commandBufferCount = 1;
    check(s.vk.vkAllocateCommandBuffers(s.device, &info, &commands), "vkAllocateCommandBuffers");
  } else {
    commands = s.spare.back();
    s.spare.pop_back();
  }

  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(s.vk.vkBeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");

  ++s.recording;
  return commands;
}

void Device::discard(VkCommandBuffer commands) {
  State& s = *state_;
  DERMIS_ASSERT_LT(0u, s.recording);
  --s.recording;
  s.vk.vkResetCommandBuffer(commands, 0);
  s.spare.push_back(commands);
  for (State::Retired& entry : s.retired) entry.serial = std::min(entry.serial, s.recorded());
}

std::uint64_t Device::submit(VkCommandBuffer commands) {
  State& s = *state_;
  DERMIS_ASSERT_LT(0u, s.recording);
  check(s.vk.vkEndCommandBuffer(commands), "vkEndCommandBuffer");

  VkCommandBufferSubmitInfo command_info{};
  command_info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO;
  command_info.commandBuffer = commands;
  VkSemaphoreSubmitInfo signal{};

  signal.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO;
  signal.semaphore = s.timeline;
  signal.value = s.submitted + 1;
  signal.stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;

  VkSubmitInfo2 info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2;
  info.commandBufferInfoCount = 1;
  info.pCommandBufferInfos = &command_info;
  info.signalSemaphoreInfoCount = 1;
  info.pSignalSemaphoreInfos = &signal;
  {
    std::unique_lock<std::mutex> lock;
    if (s.queue_mutex) lock = std::unique_lock(*s.queue_mutex);
    check(s.vk.vkQueueSubmit2(s.queue, 1, &info, VK_NULL_HANDLE), "vkQueueSubmit2");
  }

  --s.recording;
  ++s.counters.submissions;
  s.in_flight.emplace_back(++s.submitted, commands);
  return s.submitted;
}

void Device::wait(std::uint64_t serial) {
  State& s = *state_;
  DERMIS_ASSERT_LE(serial, s.submitted);
  if (!has_completed(serial)) {
    ++s.counters.waits;
    if (serial == s.submitted) ++s.counters.idle_waits;
  }

  VkSemaphoreWaitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO;
  info.semaphoreCount = 1;
  info.pSemaphores = &s.timeline;
  info.pValues = &serial;
  check(s.vk.vkWaitSemaphores(s.device, &info, std::numeric_limits<std::uint64_t>::max()),
        "vkWaitSemaphores");
  s.recycle_commands();
}

bool Device::has_completed(std::uint64_t serial) const {
  std::uint64_t now = 0;
  const State& s = *state_;
  return s.vk.vkGetSemaphoreCounterValue(s.device, s.timeline, &now) == VK_SUCCESS && now >= serial;
}

DeviceCounters& Device::counters() {
  state_->counters.allocations = state_->memory->allocations();
  return state_->counters;
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) {
  VkCommandBuffer commands = begin();
  try {
    record(commands);
  } catch (...) {
    discard(commands);
    throw;
  }
  wait(submit(commands));
}

void Device::begin_host_frame(std::uint64_t recorded, std::uint64_t finished) {
  State& s = *state_;
  s.host_recorded = std::max(s.host_recorded, recorded);
  s.host_finished = std::max(s.host_finished, finished);
  s.free_completed(s.completed(), s.host_finished);
}

void Device::retire(std::function<void()> free) {
  State& s = *state_;
  std::uint64_t now = 0;
  const bool known = s.vk.vkGetSemaphoreCounterValue(s.device, s.timeline, &now) == VK_SUCCESS;
  if (known && now >= s.recorded() && s.host_finished >= s.host_recorded) return free();
  s.retired.push_back({s.recorded(), s.host_recorded, std::move(free)});
}

const std::vector<std::string>& Device::validation_messages() const {
  static const std::vector<std::string> none;
  return state_->instance ? state_->instance->messages() : none;
}

void Device::set_name(VkObjectType type, std::uint64_t handle, const std::string& name) const {
  if (state_->instance_table.set_object_name == nullptr) return;
  VkDebugUtilsObjectNameInfoEXT info{};
  info.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT;
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = name.c_str();
  state_->instance_table.set_object_name(state_->device, &info);
}

void Device::begin_label(VkCommandBuffer commands, const std::string& name) const {
  if (state_->instance_table.begin_label == nullptr) return;
  VkDebugUtilsLabelEXT label{};
  label.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT;
  label.pLabelName = name.c_str();
  state_->instance_table.begin_label(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const {
  if (state_->instance_table.end_label != nullptr) state_->instance_table.end_label(commands);
}

std::vector<DeviceInfo> list_devices() {
  std::vector<Candidate> candidates;
  try {
    const Instance instance(false);
    for (VkPhysicalDevice device : instance.physical_devices())
      candidates.push_back(examine(instance.table(), device));
  } catch (const DeviceError&) { return {}; }
  sort_best_first(candidates);
  std::vector<DeviceInfo> summaries;
  for (const Candidate& candidate : candidates) summaries.push_back(candidate.summary);
  return summaries;
}

}  // namespace dermis::gpu
