// SPDX-License-Identifier: MIT
// The library behaves as a guest of the program that it is part of: it speaks where it is told to, ends when
// it is told to, and several renderers do not affect each other.
#include <gtest/gtest.h>

#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "dermis/error.h"
#include "dermis/renderer.h"
#include "gpu/support/host.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "head/scene/import/shapes.h"
#include "support/files.h"
#include "support/thrown.h"
#include "support/variable.h"

namespace dermis::tests {
namespace {

RenderSettings lit_by_a_studio() {
  RenderSettings s = small_settings("texture-space", 48, 64);
  s.lighting.environment = "studio";
  return s;
}

// The pictures of one renderer in one thread, and what it said.
struct Program {
  std::vector<std::vector<float>> pictures;
  std::vector<std::string> lines;

  void draw(const Scene& scene, int frames) {
    Renderer own({.hooks = hooks()});
    draw_with(own, scene, frames);
  }
  void draw_on(const vulkan::Host& host, const Scene& scene, int frames) {
    Renderer own(host, hooks());
    draw_with(own, scene, frames);
  }

 private:
  Hooks hooks() {
    return {.log = [this](LogLevel, const std::string& line) { lines.push_back(line); }};
  }
  void draw_with(Renderer& own, const Scene& scene, int frames) {
    RenderSettings s = lit_by_a_studio();
    PreparedFrame frame = own.prepare(scene, s);
    for (int i = 0; i < frames; ++i) {
      s.camera.orbit_deg = {10.0 * i, 0};
      frame.set(s);
      frame.draw();
      pictures.push_back(frame.picture().linear_rgba);
    }
  }
};

// Both bake what the skin sees of the studio, and write it and their pipelines to one folder. `./run tsan`
// runs it under the thread sanitizer.
TEST(TwoRenderers, DrawInTwoThreadsWithOneSceneAndOneCache) {
  constexpr int frames = 50;
  const TempFolder folder;
  const Variable cache("XDG_CACHE_HOME", folder.path().string());
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  Program first, second, alone;
  {
    const std::jthread a([&] { first.draw(scene, frames); });
    const std::jthread b([&] { second.draw(scene, frames); });
  }
  alone.draw(scene, frames);
  ASSERT_EQ(alone.pictures.size(), static_cast<std::size_t>(frames));
  EXPECT_TRUE(first.pictures == alone.pictures);
  EXPECT_TRUE(second.pictures == alone.pictures);
  EXPECT_TRUE(alone.lines.empty()) << "a damaged file? " << alone.lines.front();
}

// One device of a host, one queue, which both submit to, and one cache of pipelines.
TEST(TwoRenderers, DrawInTwoThreadsOnOneDeviceOfAHost) {
  constexpr int frames = 50;
  const TempFolder folder;
  const Variable cache("XDG_CACHE_HOME", folder.path().string());
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  Host host;
  std::mutex queue;
  vulkan::Host shared = host.vulkan();
  shared.queue_mutex = &queue;
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  ASSERT_EQ(host.vk().vkCreatePipelineCache(shared.device, &info, nullptr, &shared.pipeline_cache),
            VK_SUCCESS);

  Program first, second, alone;
  {
    const std::jthread a([&] { first.draw_on(shared, scene, frames); });
    const std::jthread b([&] { second.draw_on(shared, scene, frames); });
  }
  host.vk().vkDestroyPipelineCache(shared.device, shared.pipeline_cache, nullptr);
  alone.draw(scene, frames);
  EXPECT_TRUE(first.pictures == alone.pictures);
  EXPECT_TRUE(second.pictures == alone.pictures);
  EXPECT_EQ(host.messages(), std::vector<std::string>{});
}

TEST(Cache, APictureNeedsNone) {
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  const TempFolder folder;
  const auto picture_with = [&](const std::string& cache_home, std::vector<std::string>& lines) {
    const Variable home("HOME", ""), cache("XDG_CACHE_HOME", cache_home);
    Renderer own({.hooks = {.log = [&](LogLevel, const std::string& line) { lines.push_back(line); }}});
    return own.render(scene, lit_by_a_studio()).linear_rgba;
  };

  std::vector<std::string> lines, none, of_read_only;
  const std::vector<float> kept = picture_with(folder.path().string(), lines);
  EXPECT_TRUE(picture_with("", none) == kept) << "no folder for a cache";
  EXPECT_TRUE(none.empty()) << none.front();

  // Not even root creates a folder there.
  EXPECT_TRUE(picture_with("/proc/dermis", of_read_only) == kept) << "a folder that cannot be written";
  ASSERT_FALSE(of_read_only.empty());
  EXPECT_NE(of_read_only.front().find("not kept for the next run"), std::string::npos)
      << of_read_only.front();
}

TEST(Progress, OfAFirstFrameIsToldAndCanEndIt) {
  const Variable no_home("HOME", ""), no_cache("XDG_CACHE_HOME", "");
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  std::vector<std::string> works;
  std::string refused;
  Renderer own({.hooks = {.progress = [&](const WorkProgress& work) {
                  if (works.empty() || works.back() != work.what) works.push_back(work.what);
                  return work.what != refused;
                }}});

  const Picture whole = own.render(scene, lit_by_a_studio());
  EXPECT_EQ(works, (std::vector<std::string>{"preparing the environment", "making pipelines",
                                             "bringing the scene to the device",
                                             "occlusion of the surroundings", "making gutters"}));

  for (const std::string& work : std::vector<std::string>(works)) {
    // Another renderer, so that nothing is there yet.
    Renderer fresh({.hooks = {.progress = [&](const WorkProgress& w) { return w.what != work; }}});
    EXPECT_EQ(thrown<Cancelled>([&] { fresh.render(scene, lit_by_a_studio()); }), "stopped: " + work);
  }

  // A frame that was ended while it was prepared is prepared anew.
  PreparedFrame frame = own.prepare(scene, small_settings("texture-space", 32, 64));
  refused = "making pipelines";
  EXPECT_THROW(frame.set(lit_by_a_studio()), Cancelled);
  EXPECT_THROW(frame.draw(), Cancelled);
  refused.clear();
  frame.set(lit_by_a_studio());
  EXPECT_TRUE(frame.picture().linear_rgba == whole.linear_rgba);
}

TEST(Loading, IsToldAndCanBeEnded) {
  std::vector<std::string> works;
  double last = 0;
  const Scene head = Scene::built_in({.progress = [&](const WorkProgress& work) {
    if (works.empty() || works.back() != work.what) {
      works.push_back(work.what);
      last = 0;
    }
    EXPECT_GE(work.share, last);
    last = work.share;
    return true;
  }});
  EXPECT_EQ(works, (std::vector<std::string>{"making the built-in head", "measuring the unwrap"}));
  EXPECT_EQ(last, 1);

  for (const std::string& refused : works)
    EXPECT_EQ(thrown<Cancelled>([&] {
                Scene::built_in({.progress = [&](const WorkProgress& work) { return work.what != refused; }});
              }),
              "stopped: " + refused);
}

// The hook stands for a mistake of ours in the middle of the work.
TEST(AMistakeOfOurs, LeavesARendererThatCanOnlyBeDestroyed) {
  const Scene scene = wrap(scene::sphere(0.0713, 6));
  bool broken = false;
  Renderer own({.hooks = {.progress = [&](const WorkProgress&) -> bool {
                  if (broken) throw InternalError("internal error: 2 + 2 == 5: 4 vs 5");
                  return true;
                }}});
  PreparedFrame frame = own.prepare(scene, small_settings("texture-space", 32, 64));
  frame.draw();

  broken = true;
  RenderSettings s = small_settings("lambert", 40, 64);
  EXPECT_EQ(thrown<InternalError>([&] { frame.set(s); }), "internal error: 2 + 2 == 5: 4 vs 5");
  broken = false;
  for (const auto& call :
       std::vector<std::function<void()>>{[&] { frame.set(s); }, [&] { frame.draw(); },
                                          [&] { frame.picture(); }, [&] { own.render(scene, s); }})
    EXPECT_NE(thrown<InternalError>(call).find("may only be destroyed"), std::string::npos);

  // Others are not concerned.
  EXPECT_GT(renderer().render(scene, s).statistics.skin_pixels, 0u);
}

}  // namespace
}  // namespace dermis::tests
