// SPDX-License-Identifier: MIT
/// Vulkan as the window needs it: results that are checked, handles that are destroyed.
#pragma once

#include <vulkan/vulkan.h>

#include <utility>

namespace dermis::viewer {

/// The surface of the window is gone, or does not take pictures any more: make the presenter anew.
struct SurfaceLost {};

/// Throws DeviceError that names the call, or SurfaceLost.
void check(VkResult result, const char* call);

/// Owns a handle of a device: destroys it with the function it was given.
template <class Handle>
class Owned {
 public:
  using Destroy = void(VKAPI_PTR*)(VkDevice, Handle, const VkAllocationCallbacks*);
  Owned() = default;
  Owned(VkDevice device, Handle handle, Destroy destroy)
      : device_(device), handle_(handle), destroy_(destroy) {}
  Owned(Owned&& other) noexcept { *this = std::move(other); }
  Owned& operator=(Owned&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    std::swap(destroy_, other.destroy_);
    return *this;
  }
  ~Owned() {
    if (handle_) destroy_(device_, handle_, nullptr);
  }
  Handle get() const { return handle_; }

 private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
  Destroy destroy_ = nullptr;
};

}  // namespace dermis::viewer
