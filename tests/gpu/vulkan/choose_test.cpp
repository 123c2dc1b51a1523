// SPDX-License-Identifier: MIT
// Choosing among devices, without any.
#include "gpu/choose.h"

#include <gtest/gtest.h>

#include <functional>

#include "dermis/error.h"

namespace dermis::gpu {
namespace {

/// A device that has everything we ask for and nothing else.
DeviceFacts complete() {
  const RequiredFeatures required;
  DeviceFacts facts;
  facts.api_version = RequiredFeatures::api_version;
  facts.features = required.features.features;
  facts.features11 = required.features11;
  facts.features12 = required.features12;
  facts.features13 = required.features13;
  for (const char* name : RequiredFeatures::extensions()) facts.extensions.emplace_back(name);
  facts.graphics_and_compute_queue = true;
  for (const FormatNeed& need : format_needs()) facts.formats.push_back(need.features);
  facts.colour_samples = facts.depth_samples = VK_SAMPLE_COUNT_1_BIT | VK_SAMPLE_COUNT_4_BIT;
  return facts;
}

TEST(Missing, NothingOnACompleteDevice) { EXPECT_EQ(missing_of(complete()), std::vector<std::string>{}); }

TEST(Missing, OneSentenceForEachThing) {
  struct Case {
    const char* word;
    std::function<void(DeviceFacts&)> take;
  };

  const Case cases[] = {
      {"needs Vulkan 1.3, has 1.2.131",
       [](auto& f) {
         f.api_version = VK_MAKE_API_VERSION(0, 1, 2, 131);
         f.features13 = {};
         f.formats = {};
       }},
      {"shaderClipDistance", [](auto& f) { f.features.shaderClipDistance = VK_FALSE; }},
      {"depthClamp", [](auto& f) { f.features.depthClamp = VK_FALSE; }},
      {"shaderStorageImageExtendedFormats",
       [](auto& f) { f.features.shaderStorageImageExtendedFormats = VK_FALSE; }},
      {"scalarBlockLayout", [](auto& f) { f.features12.scalarBlockLayout = VK_FALSE; }},
      {"timelineSemaphore", [](auto& f) { f.features12.timelineSemaphore = VK_FALSE; }},
      {"separateDepthStencilLayouts", [](auto& f) { f.features12.separateDepthStencilLayouts = VK_FALSE; }},
      {"dynamicRendering", [](auto& f) { f.features13.dynamicRendering = VK_FALSE; }},
      {"synchronization2", [](auto& f) { f.features13.synchronization2 = VK_FALSE; }},
      {"maintenance4", [](auto& f) { f.features13.maintenance4 = VK_FALSE; }},
      {"VK_KHR_push_descriptor", [](auto& f) { f.extensions = {"VK_KHR_swapchain"}; }},
      {"graphics and compute", [](auto& f) { f.graphics_and_compute_queue = false; }},
      {"half-float images", [](auto& f) { f.formats[0] &= ~VK_FORMAT_FEATURE_2_STORAGE_IMAGE_BIT; }},
      {"depth images",
       [](auto& f) { f.formats[1] &= ~VK_FORMAT_FEATURE_2_SAMPLED_IMAGE_DEPTH_COMPARISON_BIT; }},
      {"4 samples", [](auto& f) { f.colour_samples = VK_SAMPLE_COUNT_1_BIT; }},
      {"4 samples", [](auto& f) { f.depth_samples = VK_SAMPLE_COUNT_1_BIT; }},
  };

  for (const Case& c : cases) {
    DeviceFacts facts = complete();
    c.take(facts);
    const auto missing = missing_of(facts);
    ASSERT_EQ(missing.size(), 1u) << c.word;
    EXPECT_NE(missing[0].find(c.word), std::string::npos) << missing[0];
  }
}

Candidate candidate(const char* name, VkPhysicalDeviceType type, std::vector<std::string> missing = {}) {
  Candidate made;
  made.type = type;
  made.summary.name = name;
  made.summary.missing = std::move(missing);
  return made;
}

std::vector<Candidate> shelf() {
  std::vector<Candidate> all{
      candidate("Soft", VK_PHYSICAL_DEVICE_TYPE_CPU),
      candidate("Old Discrete", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU, {"needs A", "needs B"}),
      candidate("Virtual One", VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU),
      candidate("Built In", VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU),
      candidate("Card 4000", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU),
      candidate("Card 5000", VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU)};
  sort_best_first(all);
  return all;
}

std::string refusal(const std::vector<Candidate>& all, const std::string& select) {
  try {
    return "chose " + choose(all, select).summary.name;
  } catch (const DeviceError& error) { return error.what(); }
}

TEST(Choose, BestFirstAndUnusableLast) {
  std::vector<std::string> names;
  for (const Candidate& c : shelf()) names.push_back(c.summary.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Card 4000", "Card 5000", "Built In", "Virtual One", "Soft",
                                             "Old Discrete"}));
}

TEST(Choose, ByBestIndexOrPartOfTheName) {
  const auto all = shelf();
  EXPECT_EQ(choose(all, "best").summary.name, "Card 4000");
  EXPECT_EQ(choose(all, "2").summary.name, "Built In");
  EXPECT_EQ(choose(all, "vIRTUAL").summary.name, "Virtual One");
  EXPECT_EQ(choose(all, "5000").summary.name, "Card 5000");  // no such index, so a part of a name
}

TEST(Choose, RefusalsSayWhatThereIs) {
  const auto all = shelf();
  EXPECT_EQ(refusal(all, "radeon"),
            "no device 'radeon'; there are: 0: Card 4000; 1: Card 5000; 2: Built In; 3: Virtual One; 4: "
            "Soft; 5: Old Discrete");
  EXPECT_EQ(refusal(all, "6"),
            "no device '6'; there are: 0: Card 4000; 1: Card 5000; 2: Built In; 3: Virtual One; 4: Soft; 5: "
            "Old Discrete");
  EXPECT_EQ(refusal(all, "old"), "Old Discrete cannot be used: needs A; needs B");
  EXPECT_EQ(refusal({}, "best"), no_driver_message());
  EXPECT_NE(no_driver_message().find("mesa-vulkan-drivers"), std::string::npos);
}

}  // namespace
}  // namespace dermis::gpu
