// SPDX-License-Identifier: MIT
#include "gpu/memory.h"

#include <random>

#include "fixture.h"
#include "gpu/raw.h"
#include "support/log_lines.h"

namespace dermis::gpu {
namespace {

using Memory = GpuTest;
constexpr std::uint64_t mib = 1 << 20;

TEST_F(Memory, SmallResourcesShareABlockAndNeverOverlap) {
  std::mt19937 random(7);
  std::vector<RawBuffer> live;

  const auto check_apart = [&] {
    std::map<std::pair<VkDeviceMemory, std::uint64_t>, std::uint64_t> ranges;
    for (const RawBuffer& buffer : live)
      ranges[{buffer.allocation->memory, buffer.allocation->offset}] = buffer.allocation->bytes;
    ASSERT_EQ(ranges.size(), live.size());
    for (auto range = ranges.begin(); range != ranges.end(); ++range) {
      const auto next = std::next(range);
      if (next == ranges.end() || next->first.first != range->first.first) continue;
      ASSERT_LE(range->first.second + range->second, next->first.second);
    }
  };

  for (int step = 0; step < 600; ++step) {
    if (live.empty() || random() % 5 < 3) {
      live.push_back(create_raw_buffer(device(), "piece", {.bytes = 1 + random() % (300 << 10)}));
    } else {
      const std::size_t victim = random() % live.size();
      destroy_raw_buffer(device(), live[victim]);
      live.erase(live.begin() + static_cast<std::ptrdiff_t>(victim));
    }
    if (step % 50 == 0) check_apart();
  }

  check_apart();
  EXPECT_LE(device().memory().reserved_bytes(), 2 * MemoryPool::block_bytes);
  for (const RawBuffer& buffer : live) destroy_raw_buffer(device(), buffer);

  // All pieces merged again: a buffer of almost half a block fits into the one block that is kept.
  EXPECT_EQ(device().buffer_bytes(), 0u);
  const std::uint64_t kept = device().memory().reserved_bytes();
  EXPECT_LE(kept, MemoryPool::block_bytes);
  const Buffer one(device(), "one", {.bytes = 30 * mib}), two(device(), "two", {.bytes = 30 * mib});
  EXPECT_EQ(device().memory().reserved_bytes(), kept);
}

TEST_F(Memory, LargeResourcesComeAndGoAlone) {
  const std::uint64_t before = device().memory().reserved_bytes();
  {
    const Buffer large(device(), "large", {.bytes = 48 * mib});
    EXPECT_GE(device().memory().reserved_bytes(), before + 48 * mib);
    EXPECT_LT(device().memory().reserved_bytes(), before + 64 * mib);
  }
  EXPECT_EQ(device().memory().reserved_bytes(), before);
  EXPECT_GE(device().peak_bytes(), 48 * mib);
}

TEST_F(Memory, ImagesAndBuffersAreCountedApart) {
  const Buffer buffer(device(), "buffer", {.bytes = mib});
  EXPECT_EQ(device().image_bytes(), 0u);
  const std::uint64_t buffers = device().buffer_bytes();
  EXPECT_GE(buffers, mib);
  {
    const Texture texture(device(), "texture",
                          {.width = 512,
                           .height = 512,
                           .format = VK_FORMAT_R8G8B8A8_UNORM,
                           .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
    EXPECT_GE(device().image_bytes(), mib);
    EXPECT_EQ(device().buffer_bytes(), buffers);
  }
  EXPECT_EQ(device().image_bytes(), 0u);
  EXPECT_GE(device().peak_bytes(), 2 * mib);
}

TEST_F(Memory, MovedResourcesAreFreedOnce) {
  Buffer a(device(), "a", {.bytes = 1024});
  Buffer b = std::move(a);
  EXPECT_FALSE(a);  // NOLINT(bugprone-use-after-move): that is what is tested
  b = Buffer(device(), "b", {.bytes = 2048});
  EXPECT_EQ(b.name(), "b");
  EXPECT_EQ(b.desc().bytes, 2048u);
  Texture t(device(), "t",
            {.width = 4, .height = 4, .format = VK_FORMAT_R8_UNORM, .usage = VK_IMAGE_USAGE_SAMPLED_BIT});
  Texture u = std::move(t);
  EXPECT_FALSE(t);  // NOLINT(bugprone-use-after-move)
  u = {};
  b = {};
  EXPECT_EQ(device().image_bytes() + device().buffer_bytes(), 0u);
}

TEST_F(Memory, StagingLeavesNothingBehind) {
  const std::vector<std::byte> bytes(3 * mib, std::byte{5});
  const Buffer buffer(device(), "buffer", {.bytes = bytes.size()});
  const std::uint64_t held = device().buffer_bytes();
  upload(device(), buffer, bytes);
  EXPECT_EQ(read_back(device(), buffer), bytes);
  EXPECT_EQ(device().buffer_bytes(), held);
}

/// Buffers in a pool of their own, whose heaps are pretended to be small.
class SmallHeap : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    if (IsSkipped()) return;
    VkPhysicalDeviceMemoryProperties properties = device().memory().properties();
    for (std::uint32_t i = 0; i < properties.memoryHeapCount; ++i) properties.memoryHeaps[i].size = 32 * mib;
    pool_ =
        std::make_unique<MemoryPool>(device().vk(), device().handle(), properties, std::uint64_t{1} << 30);
  }
  void TearDown() override {
    while (!held_.empty()) let_go();
    pool_.reset();
    GpuTest::TearDown();
  }
  /// What the pool said if it refused.
  std::string take(std::uint64_t bytes) {
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    check(device().vk().vkCreateBuffer(device().handle(), &info, nullptr, &buffer), "vkCreateBuffer");
    try {
      held_.push_back({buffer, pool_->allocate_buffer("bite", buffer, BufferPlace::device)});
      return "";
    } catch (const DeviceError& error) {
      device().vk().vkDestroyBuffer(device().handle(), buffer, nullptr);
      return error.what();
    }
  }
  void let_go() {
    device().vk().vkDestroyBuffer(device().handle(), held_.back().handle, nullptr);
    pool_->free(held_.back().allocation);
    held_.pop_back();
  }
  std::unique_ptr<MemoryPool> pool_;
  std::vector<RawBuffer> held_;
};

// Destructors free memory: a mistake there must not end the program.
TEST_F(SmallHeap, WhatIsFreedTwiceIsAWarning) {
  ASSERT_EQ(take(mib), "");
  MemoryPool::Allocation* const allocation = held_.back().allocation;
  let_go();
  tests::LogLines said;
  pool_->free(allocation);
  pool_->free(nullptr);
  ASSERT_EQ(said.warnings.size(), 2u);
  EXPECT_EQ(said.warnings[0].find("internal error: "), 0u) << said.warnings[0];

  ASSERT_EQ(take(mib), "");
  const VkBuffer left = held_.back().handle;
  held_.clear();
  pool_.reset();
  EXPECT_EQ(said.warnings.size(), 3u) << "something was never freed";
  device().vk().vkDestroyBuffer(device().handle(), left, nullptr);
}

TEST_F(SmallHeap, IsFilledToTheBrimAndThenSaysSo) {
  std::string said;
  while (said.empty()) said = take(mib);
  EXPECT_GE(held_.size(), 30u);
  EXPECT_LE(held_.size(), 32u);
  EXPECT_EQ(
      said.find(
          "no device memory for 'bite': needed 1.0 MiB; the heap has 32.0 MiB, of which this program holds "),
      0u)
      << said;
  EXPECT_NE(said.find("Try smaller maps"), std::string::npos);
  let_go();
  EXPECT_EQ(take(mib), "");
}

TEST_F(SmallHeap, EmptyBlocksGiveWay) {
  EXPECT_EQ(take(mib), "");
  let_go();
  EXPECT_GT(pool_->reserved_bytes(), 0u);  // kept for the next small one
  EXPECT_EQ(take(30 * mib), "");
  EXPECT_NE(take(30 * mib), "");
  EXPECT_NE(take(std::uint64_t{40} * mib), "");
}

}  // namespace
}  // namespace dermis::gpu
