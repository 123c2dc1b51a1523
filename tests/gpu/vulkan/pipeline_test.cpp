// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "base/core/file.h"
#include "fixture.h"
#include "gpu/pipeline_cache.h"
#include "support/log_lines.h"
#include "support/thrown.h"

namespace dermis::gpu {
namespace {

using Pipelines = GpuTest;

struct FillPush {
  float weights[3];
  std::uint32_t count;
};

TEST_F(Pipelines, ComputeWritesWhatTheShaderSays) {
  std::vector<float> from(3 * 100);
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<float>(i);
  const Buffer in = make_buffer<float>(device(), "in", from, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const Buffer out(device(), "out",
                   {.bytes = 100 * sizeof(float), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  const Pipeline& fill = library().compute("fill.comp");
  device().run([&](VkCommandBuffer commands) {
    Cmd cmd(device(), commands);
    cmd.bind(fill, std::array<Binding, 2>{BufferBinding{&in}, BufferBinding{&out}});
    cmd.push(fill, FillPush{{1, 10, 100}, 100});
    cmd.dispatch_over(fill, 100, 1);
  });
  const auto values = values_of<float>(out);
  for (std::size_t i = 0; i < 100; ++i)
    ASSERT_FLOAT_EQ(values[i], from[3 * i] + 10 * from[3 * i + 1] + 100 * from[3 * i + 2]) << "element " << i;
}

TEST_F(Pipelines, TexelsAreTheBytesOfABuffer) {
  // Patterns that a float would not keep everywhere: quiet and signalling NaN, denormal numbers.
  std::vector<std::uint32_t> words(5 * 4);
  for (std::uint32_t i = 0; i < words.size(); ++i) words[i] = i;
  words[1] = 0x7fc00001, words[6] = 0x7fa00001, words[11] = 0xffffffff, words[16] = 0x80000001;
  const Buffer from = make_buffer<std::uint32_t>(device(), "from", words, texels_of_shaders);
  const Buffer to(device(), "to",
                  {.bytes = 6 * 4 * sizeof(std::uint32_t), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  const Pipeline& texels = library().compute("texels.comp");
  ASSERT_EQ(texels.interface.bindings[0].kind, BindingKind::texel_buffer);
  device().run([&](VkCommandBuffer commands) {
    Cmd cmd(device(), commands);
    cmd.bind(texels, std::array<Binding, 2>{BufferBinding{&from}, BufferBinding{&to}});
    cmd.dispatch_over(texels, 8, 1);
  });

  const auto values = values_of<std::uint32_t>(to);
  for (std::size_t i = 0; i < words.size(); ++i)
    EXPECT_EQ(values[(4 - i / 4) * 4 + i % 4], words[i]) << "word " << i;
  EXPECT_EQ(values.back(), 5u);
}

TEST_F(Pipelines, ReflectionFindsBindingsPushAndWorkgroup) {
  const ShaderInterface found = reflect(test_vulkan::find_shader("fill.comp"), "fill.comp");
  ASSERT_EQ(found.bindings.size(), 2u);
  EXPECT_EQ(found.bindings[0].binding, 0u);
  EXPECT_EQ(found.bindings[0].kind, BindingKind::storage_buffer);
  EXPECT_EQ(found.bindings[0].name, "from");
  EXPECT_EQ(found.bindings[1].binding, 3u);
  EXPECT_EQ(found.push_bytes, 16u);
  EXPECT_EQ(found.workgroup, (std::array<std::uint32_t, 3>{64, 1, 1}));

  const ShaderInterface grid = reflect(test_vulkan::find_shader("grid.comp"), "grid.comp");
  using Constant = std::pair<std::string, std::uint32_t>;
  EXPECT_EQ(grid.constants,
            (std::vector<Constant>{{"doubled", 1}, {"group_x", 4}, {"offset", 7}, {"unused", 9}}));
  EXPECT_EQ(grid.workgroup, (std::array<std::uint32_t, 3>{8, 2, 1}));
  EXPECT_EQ(grid.workgroup_constants,
            (std::array<std::uint32_t, 3>{4, ShaderInterface::fixed, ShaderInterface::fixed}));

  const ShaderInterface store = reflect(test_vulkan::find_shader("store.comp"), "store.comp");
  ASSERT_EQ(store.bindings.size(), 2u);
  EXPECT_EQ(store.bindings[0].kind, BindingKind::storage_image);
  EXPECT_EQ(store.bindings[1].kind, BindingKind::uniform_buffer);
  EXPECT_EQ(reflect(test_vulkan::find_shader("shadow.comp"), "shadow.comp").bindings[0].kind,
            BindingKind::sampled_image);
  EXPECT_EQ(reflect(test_vulkan::find_shader("shadow.comp"), "shadow.comp").push_bytes, 12u);
}

TEST_F(Pipelines, ConstantsByNameSetWorkgroupBoolAndFloat) {
  struct Case {
    Constants constants;
    std::uint32_t group_x;
    float expected;
  };

  const Case cases[] = {
      {{}, 8, 8.5f},
      {{{"group_x", 16}}, 16, 16.5f},
      {{{"group_x", 4}, {"doubled", 1}, {"offset", bits(0.25f)}, {"unused", bits(-1)}}, 4, 8.25f}};

  for (const Case& c : cases) {
    const Pipeline& pipeline = library().compute("grid.comp", c.constants);
    EXPECT_EQ(pipeline.interface.workgroup[0], c.group_x);
    const Buffer out(device(), "out",
                     {.bytes = 64 * sizeof(float), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
    device().run([&](VkCommandBuffer commands) {
      Cmd cmd(device(), commands);
      cmd.bind(pipeline, std::array<Binding, 1>{BufferBinding{&out}});
      cmd.dispatch_over(pipeline, 32, 2);
    });
    EXPECT_EQ(values_of<float>(out), std::vector<float>(64, c.expected)) << pipeline.name;
  }
}

TEST_F(Pipelines, AreMadeOnceAndKeepTheirPlace) {
  const Pipeline* first = &library().compute("grid.comp", {{"group_x", 16}});
  EXPECT_NE(first, &library().compute("grid.comp"));
  EXPECT_EQ(first, &library().compute("grid.comp", {{"group_x", 16}}));
  EXPECT_GT(library().creation_ms(), 0);
  const VkSampler sampler = library().sampler({.filter = Filter::nearest});
  EXPECT_EQ(sampler, library().sampler({.filter = Filter::nearest}));
  EXPECT_NE(sampler,
            library().sampler({.filter = Filter::linear, .u = Address::repeat, .max_anisotropy = 8}));
}

TEST_F(Pipelines, ThatDifferInWhatTheyCullAreCompiledOnce) {
  GraphicsDesc desc{.vertex = "triangle.vert",
                    .fragment = "triangle.frag",
                    .colour_formats = {VK_FORMAT_R8G8B8A8_UNORM},
                    .cull = Cull::back};
  const std::uint64_t before = device().counters().pipelines;
  const Pipeline& back = library().graphics(desc);
  desc.cull = Cull::none;
  const Pipeline& none = library().graphics(desc);
  desc.cull = Cull::front;
  const Pipeline& front = library().graphics(desc);
  EXPECT_EQ(device().counters().pipelines - before, 1u);
  EXPECT_EQ(back.handle, none.handle);
  EXPECT_EQ(front.handle, none.handle);
  EXPECT_NE(back.cull_mode, none.cull_mode);
  EXPECT_NE(back.cull_mode, front.cull_mode);
}

TEST_F(Pipelines, TooLargeWorkgroupIsARefusal) {
  try {
    library().compute("grid.comp", {{"group_x", 1u << 20}});
    FAIL();
  } catch (const DeviceError& error) {
    EXPECT_NE(std::string(error.what()).find("needs workgroups of 1048576x2x1"), std::string::npos)
        << error.what();
  }
}

TEST_F(Pipelines, IndirectDispatchTakesItsSizeFromABuffer) {
  const std::uint32_t arguments[] = {99, 2, 2, 1};
  const Buffer in =
      make_buffer<std::uint32_t>(device(), "arguments", arguments, VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
  const Buffer out(device(), "out",
                   {.bytes = 64 * sizeof(float), .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  const Pipeline& grid = library().compute("grid.comp");
  device().run([&](VkCommandBuffer commands) {
    Cmd cmd(device(), commands);
    cmd.bind(grid, std::array<Binding, 1>{BufferBinding{&out}});
    cmd.dispatch_indirect(in, 4);
  });
  EXPECT_EQ(values_of<float>(out), std::vector<float>(64, 8.5f));
}

TEST_F(Pipelines, OurMistakesAreThrownWithBothValues) {
  const auto expect_in = [](const std::string& part, const auto& work) {
    const std::string error = tests::thrown<InternalError>(work);
    EXPECT_NE(error.find(part), std::string::npos) << error;
  };
  const auto expect_recording = [&](const std::string& part, const auto& record) {
    expect_in(part, [&] {
      device().run([&](VkCommandBuffer commands) {
        Cmd cmd(device(), commands);
        record(cmd);
      });
    });
  };

  expect_in("declared: doubled, group_x, offset, unused", [&] {
    library().compute("grid.comp", {{"group_y", 1}});
  });
  expect_in("missing.comp", [&] { library().compute("missing.comp"); });
  expect_in("junk: is not SPIR-V", [] { reflect(std::array<std::uint32_t, 6>{1, 2, 3, 4, 5, 6}, "junk"); });

  const Pipeline& grid = library().compute("grid.comp");
  expect_recording("0 given, 1 declared", [&](Cmd& cmd) { cmd.bind(grid, {}); });
  expect_recording("binding 0 'to'",
                   [&](Cmd& cmd) { cmd.bind(grid, std::array<Binding, 1>{SampledBinding{}}); });
  const Pipeline& texels = library().compute("texels.comp");
  const Buffer plain(device(), "plain", {.bytes = 64, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT});
  expect_recording("texel_view", [&](Cmd& cmd) {
    cmd.bind(texels, std::array<Binding, 2>{BufferBinding{&plain}, BufferBinding{&plain}});
  });
  expect_recording("4 given, 0 declared", [&](Cmd& cmd) { cmd.push(grid, 1.0f); });
}

/// A cache file in a folder of its own, with the warnings that were given.
class PipelineCache : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    folder_ = std::filesystem::path(testing::TempDir()) /
              fmt::format("dermis_cache_{}", ::testing::UnitTest::GetInstance()->random_seed());
    folder_ /= testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    file_ = folder_ / "deep" / "pipelines.bin";
  }
  void TearDown() override {
    std::filesystem::remove_all(folder_);
    GpuTest::TearDown();
  }
  void build_and_save() {
    PipelineLibrary cached(device(), test_vulkan::find_shader, file_);
    cached.compute("grid.comp");
    cached.save_cache();
  }
  std::filesystem::path folder_, file_;
  tests::LogLines said_;
};

TEST_F(PipelineCache, SurvivesEveryKindOfDamage) {
  if (IsSkipped()) return;
  build_and_save();

  const std::vector<std::byte> good = read_file(file_);
  const std::vector<std::byte> blob = load_pipeline_cache(file_, device().properties());
  constexpr std::size_t header = 48, seal = 26;
  ASSERT_EQ(header + blob.size() + seal, good.size());
  ASSERT_FALSE(blob.empty());

  const auto damaged = [&](auto&& change) {
    std::vector<std::byte> bytes = good;
    change(bytes);
    std::ofstream(file_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    EXPECT_TRUE(load_pipeline_cache(file_, device().properties()).empty());
    build_and_save();
    EXPECT_FALSE(load_pipeline_cache(file_, device().properties()).empty());
  };

  for (const std::size_t at : {std::size_t{0}, std::size_t{9}, std::size_t{30}, std::size_t{45}, header,
                               good.size() - seal - 1, good.size() - 1})
    damaged([&](std::vector<std::byte>& bytes) { bytes[at] ^= std::byte{0x40}; });
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, header - 1, header, good.size() - 1})
    damaged([&](std::vector<std::byte>& bytes) { bytes.resize(size); });
  damaged([&](std::vector<std::byte>& bytes) { bytes.resize(good.size() + 100); });

  std::filesystem::remove(file_);
  build_and_save();
  EXPECT_FALSE(load_pipeline_cache(file_, device().properties()).empty());
  EXPECT_EQ(said_.warnings, std::vector<std::string>{});
}

TEST_F(PipelineCache, IgnoresAnotherDriversFile) {
  if (IsSkipped()) return;
  build_and_save();
  VkPhysicalDeviceProperties other = device().properties();
  ++other.driverVersion;
  EXPECT_TRUE(load_pipeline_cache(file_, other).empty());
  other = device().properties();
  other.pipelineCacheUUID[3] ^= 1;
  EXPECT_TRUE(load_pipeline_cache(file_, other).empty());
}

TEST_F(PipelineCache, ThatCannotBeWrittenIsAWarning) {
  if (IsSkipped()) return;
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "deep") << "a file where the folder should be";
  build_and_save();
  ASSERT_EQ(said_.warnings.size(), 1u);
  EXPECT_NE(said_.warnings[0].find("pipelines.bin"), std::string::npos);
}

}  // namespace
}  // namespace dermis::gpu
