// SPDX-License-Identifier: MIT
// Vulkan without global functions: a library that defined vkCreateInstance and its like, or linked the
// loader, would get in the way of an engine that brings its own. Each device has a table of the functions we
// call.
#pragma once

#ifndef VK_NO_PROTOTYPES
#define VK_NO_PROTOTYPES
#endif
#include <vulkan/vulkan.h>

// A function that a table lacks is added here.
#define DERMIS_DEVICE_FUNCTIONS(X)  \
  X(vkAllocateCommandBuffers)       \
  X(vkAllocateMemory)               \
  X(vkBeginCommandBuffer)           \
  X(vkBindBufferMemory)             \
  X(vkBindImageMemory)              \
  X(vkCmdBeginRendering)            \
  X(vkCmdBindIndexBuffer)           \
  X(vkCmdBindPipeline)              \
  X(vkCmdClearColorImage)           \
  X(vkCmdClearDepthStencilImage)    \
  X(vkCmdCopyBuffer)                \
  X(vkCmdCopyBufferToImage)         \
  X(vkCmdCopyImageToBuffer)         \
  X(vkCmdDispatch)                  \
  X(vkCmdDispatchIndirect)          \
  X(vkCmdDraw)                      \
  X(vkCmdDrawIndexed)               \
  X(vkCmdDrawIndirect)              \
  X(vkCmdEndRendering)              \
  X(vkCmdFillBuffer)                \
  X(vkCmdPipelineBarrier2)          \
  X(vkCmdPushConstants)             \
  X(vkCmdPushDescriptorSetKHR)      \
  X(vkCmdResetQueryPool)            \
  X(vkCmdSetCullMode)               \
  X(vkCmdSetScissor)                \
  X(vkCmdSetViewport)               \
  X(vkCmdUpdateBuffer)              \
  X(vkCmdWriteTimestamp2)           \
  X(vkCreateBuffer)                 \
  X(vkCreateBufferView)             \
  X(vkCreateCommandPool)            \
  X(vkCreateComputePipelines)       \
  X(vkCreateDescriptorSetLayout)    \
  X(vkCreateFence)                  \
  X(vkCreateGraphicsPipelines)      \
  X(vkCreateImage)                  \
  X(vkCreateImageView)              \
  X(vkCreatePipelineCache)          \
  X(vkCreatePipelineLayout)         \
  X(vkCreateQueryPool)              \
  X(vkCreateSampler)                \
  X(vkCreateSemaphore)              \
  X(vkCreateShaderModule)           \
  X(vkDestroyBuffer)                \
  X(vkDestroyCommandPool)           \
  X(vkDestroyDescriptorSetLayout)   \
  X(vkDestroyDevice)                \
  X(vkDestroyFence)                 \
  X(vkDestroyImage)                 \
  X(vkDestroyBufferView)            \
  X(vkDestroyImageView)             \
  X(vkDestroyPipeline)              \
  X(vkDestroyPipelineCache)         \
  X(vkDestroyPipelineLayout)        \
  X(vkDestroyQueryPool)             \
  X(vkDestroySampler)               \
  X(vkDestroySemaphore)             \
  X(vkDestroyShaderModule)          \
  X(vkDeviceWaitIdle)               \
  X(vkEndCommandBuffer)             \
  X(vkFreeMemory)                   \
  X(vkGetBufferMemoryRequirements2) \
  X(vkGetDeviceQueue)               \
  X(vkGetImageMemoryRequirements2)  \
  X(vkGetPipelineCacheData)         \
  X(vkGetQueryPoolResults)          \
  X(vkGetSemaphoreCounterValue)     \
  X(vkMapMemory)                    \
  X(vkQueueSubmit)                  \
  X(vkQueueSubmit2)                 \
  X(vkResetCommandBuffer)           \
  X(vkResetFences)                  \
  X(vkWaitForFences)                \
  X(vkWaitSemaphores)

namespace dermis::gpu {

struct DeviceTable {
#define DERMIS_MEMBER(name) PFN_##name name = nullptr;
  DERMIS_DEVICE_FUNCTIONS(DERMIS_MEMBER)
#undef DERMIS_MEMBER
};

}  // namespace dermis::gpu
