// SPDX-License-Identifier: MIT
#include "viewer/model/painter.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <thread>

#include "dermis/error.h"
#include "unit/viewer/documents.h"
#include "viewer/model/painters.h"
#include "viewer/model/shown_maps.h"

namespace dermis::viewer {
namespace {

RenderSettings small() {
  RenderSettings settings;
  settings.output.width = 48;
  settings.output.height = 40;
  settings.quality.map_size = 64;
  settings.quality.shadow_size = 64;
  settings.quality.samples = 1;
  return settings;
}

// Waits until nothing is to be done any more, and returns all that was told.
template <class AnyPainter>
PainterNews settle(AnyPainter& painter) {
  PainterNews all;
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (painter.is_busy() && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_FALSE(painter.is_busy());
  return painter.take_news();
}

TEST(Painter, DrawsWhatTheRendererDraws) {
  const Document document = tests::square_document();
  Painter painter({});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 7});
  const PainterNews news = settle(painter);
  ASSERT_TRUE(news.painted);
  EXPECT_EQ(news.painted->revision, 7u);
  Renderer renderer;
  EXPECT_EQ(news.painted->picture.display_rgba, renderer.render(document.scene, small()).display_rgba);
}

TEST(Painter, PassesOverWishesThatAreOld) {
  const Document document = tests::square_document();
  Painter painter({});
  for (std::uint64_t i = 1; i <= 20; ++i)
    painter.wish({.scene = document.scene, .settings = small(), .revision = i, .moving = true});
  const PainterNews news = settle(painter);
  ASSERT_TRUE(news.painted);
  EXPECT_EQ(news.painted->revision, 20u);
  EXPECT_TRUE(news.painted->moving);
}

TEST(Painter, GivesBothPicturesOfAComparison) {
  Document document = tests::square_document();
  Painter painter({});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1});
  RenderSettings other = small();
  other.output.exposure_ev = 1;
  painter.wish({.scene = document.scene, .settings = other, .revision = 1, .is_b = true});
  const PainterNews news = settle(painter);
  ASSERT_TRUE(news.painted && news.painted_b);
  EXPECT_NE(news.painted->picture.display_rgba, news.painted_b->picture.display_rgba);
}

TEST(Painter, DrawsAllThatStaysWanted) {
  // However many wishes end each other: the last one of A and of B are drawn.
  const Document document = tests::square_document();
  Painter painter({});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1, .is_b = true});
  for (std::uint64_t i = 1; i <= 12; ++i) {
    RenderSettings other = small();
    other.output.width += static_cast<int>(i);
    painter.wish({.scene = document.scene, .settings = other, .revision = i, .moving = i % 3 == 0});
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
  }
  const PainterNews news = settle(painter);
  EXPECT_TRUE(news.errors.empty());
  ASSERT_TRUE(news.painted && news.painted_b);
  EXPECT_EQ(news.painted->revision, 12u);
}

TEST(Painters, WhatFollowsTheHandWaitsForNothing) {
  // The picture at rest cannot be ended, and ends when one that came later is there.
  std::promise<void> is_shown;
  std::atomic<int> begun = 0;
  const Document document = tests::square_document();
  Painters painters({.before_drawing =
                         [&, shown = is_shown.get_future().share()] {
                           if (++begun == 1) shown.wait_for(std::chrono::seconds(60));
                         }},
                    true);
  painters.wish({.scene = document.scene, .settings = small(), .revision = 1, .serial = 1});
  while (begun == 0) std::this_thread::yield();
  painters.wish({.scene = document.scene, .settings = small(), .revision = 2, .serial = 2, .moving = true});

  PainterNews news;
  for (int i = 0; i < 6000 && !news.painted; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    news = painters.take_news();
  }
  ASSERT_TRUE(news.painted);
  EXPECT_EQ(news.painted->serial, 2u);
  EXPECT_TRUE(news.painted->moving);
  is_shown.set_value();
  EXPECT_TRUE(settle(painters).errors.empty());
}

TEST(Painters, OfTwoPicturesTheNewerIsTaken) {
  const Document document = tests::square_document();
  for (const bool apart : {false, true}) {
    Painters painters({}, apart);
    painters.wish({.scene = document.scene, .settings = small(), .serial = 3, .moving = true});
    painters.wish({.scene = document.scene, .settings = small(), .serial = 3});
    const PainterNews news = settle(painters);
    ASSERT_TRUE(news.painted);
    EXPECT_FALSE(news.painted->moving);
    EXPECT_TRUE(painters.stop(60));
  }
}

TEST(Painter, OpensALostDeviceOnceMore) {
  const Document document = tests::square_document();
  int drawn = 0;
  Painter painter({.before_drawing = [&] {
    if (++drawn == 2) throw DeviceError("the device was lost");
  }});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1});
  const PainterNews first = settle(painter);
  painter.wish({.scene = document.scene, .settings = small(), .revision = 2});
  const PainterNews second = settle(painter);
  EXPECT_FALSE(first.renewed);
  EXPECT_TRUE(second.renewed);
  EXPECT_TRUE(second.errors.empty());
  ASSERT_TRUE(first.painted && second.painted);
  EXPECT_EQ(first.painted->picture.display_rgba, second.painted->picture.display_rgba);
}

TEST(Painter, TellsWhatIsLostForGood) {
  const Document document = tests::square_document();
  Painter painter({.before_drawing = [] { throw DeviceError("the device was lost"); }});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1});
  const PainterNews news = settle(painter);
  EXPECT_FALSE(news.painted);
  EXPECT_EQ(news.errors, (std::vector<std::string>{"the device was lost"}));
}

TEST(Painter, TellsWhatIsWrongAndGoesOn) {
  const Document document = tests::square_document();
  Painter painter({});
  RenderSettings wrong = small();
  wrong.lighting.environment = "nowhere.hdr";
  painter.wish({.scene = document.scene, .settings = wrong, .revision = 1});
  EXPECT_EQ(settle(painter).errors.size(), 1u);
  painter.wish({.scene = document.scene, .settings = small(), .revision = 2});
  EXPECT_TRUE(settle(painter).painted);
}

TEST(Painter, TimesLabelsAndMaps) {
  const Document document = tests::square_document();
  Painter painter({});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1, .timed = true});
  const PainterNews timed = settle(painter);
  ASSERT_TRUE(timed.painted);
  EXPECT_GT(timed.painted->picture.statistics.passes.size(), 3u);

  painter.wish({.scene = document.scene, .settings = small(), .revision = 1, .labels = true});
  const PainterNews labelled = settle(painter);
  ASSERT_TRUE(labelled.painted && labelled.painted->labels);
  EXPECT_EQ(labelled.painted->labels->instance.size(), 48u * 40u);
  EXPECT_EQ(labelled.painted->picture.display_rgba, timed.painted->picture.display_rgba);

  EXPECT_FALSE(labelled.painted->light);
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1, .labels = true, .light = true});
  const PainterNews lit = settle(painter);
  ASSERT_TRUE(lit.painted && lit.painted->light);
  EXPECT_EQ(lit.painted->picture.display_rgba, timed.painted->picture.display_rgba);
  const std::optional<PixelValues> middle = pixel_at(*lit.painted, 0.5f, 0.5f);
  ASSERT_TRUE(middle && middle->irradiance);
  EXPECT_GT(middle->irradiance->at(0), 0);
  // It is light, so it does not depend on the exposure of the picture.
  RenderSettings bright = small();
  bright.output.exposure_ev = 2;
  painter.wish({.scene = document.scene, .settings = bright, .revision = 2, .labels = true, .light = true});
  const PainterNews exposed = settle(painter);
  ASSERT_TRUE(exposed.painted);
  const std::optional<PixelValues> brighter = pixel_at(*exposed.painted, 0.5f, 0.5f);
  ASSERT_TRUE(brighter && brighter->irradiance);
  EXPECT_NEAR(brighter->irradiance->at(0) / middle->irradiance->at(0), 1, 1e-3);

  // Techniques without light maps have none.
  RenderSettings plain = small();
  plain.technique = "lambert";
  painter.wish({.scene = document.scene, .settings = plain, .revision = 3, .labels = true, .light = true});
  const PainterNews without = settle(painter);
  ASSERT_TRUE(without.painted && without.painted->labels);
  EXPECT_FALSE(without.painted->light);
  EXPECT_TRUE(without.errors.empty());

  RenderSettings map = small();
  map.output.show = "irradiance";
  painter.wish({.scene = document.scene, .settings = map, .revision = 1});
  EXPECT_TRUE(settle(painter).painted);
}

TEST(Painter, SavesWhatTheRendererDraws) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "dermis-painter-test.png";
  const Document document = tests::square_document();
  Painter painter({});
  painter.save({.scene = document.scene, .settings = small(), .file = file});
  EXPECT_EQ(settle(painter).saved, (std::vector<std::string>{file.string()}));
  EXPECT_GT(std::filesystem::file_size(file), 100u);
  std::filesystem::remove(file);
  painter.save({.scene = document.scene,
                .settings = small(),
                .file = std::filesystem::path("no-such-folder") / "a.png"});
  EXPECT_EQ(settle(painter).errors.size(), 1u);
}

TEST(Painter, Stops) {
  const Document document = tests::square_document();
  Painter painter({});
  painter.wish({.scene = document.scene, .settings = small(), .revision = 1});
  EXPECT_TRUE(painter.stop(20));
}

}  // namespace
}  // namespace dermis::viewer
