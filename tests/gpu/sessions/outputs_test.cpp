// SPDX-License-Identifier: MIT
// A session gives what is wanted of it, and draws, reads back and copies nothing else.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "dermis/session.h"
#include "gpu/sessions/poses.h"
#include "gpu/support/pictures.h"
#include "gpu/support/renderer.h"
#include "gpu/support/scenes.h"
#include "gpu/support/settings.h"
#include "support/thrown.h"

namespace dermis::tests {
namespace {

constexpr int width = 36, height = 20;

RenderSettings settings_of(int of_width = width, int of_height = height) {
  RenderSettings s = small_settings("lambert", of_width, 64);
  s.output.width = of_width;
  s.output.height = of_height;
  s.output.exposure_ev = 0;
  s.output.bloom = 0.05;
  return s;
}

/// In its second frame a ball has moved: then no output is empty, motion neither.
struct MovingBall {
  explicit MovingBall(const Session::Options& options, const RenderSettings& of = settings_of())
      : settings(of), session(renderer(), options) {
    draw(0);
    ticket = draw(0.01);
  }
  Ticket draw(double x_m) {
    scene.set_transform(scene.instances()[0], turned(0.2, x_m));
    return session.draw(scene, settings);
  }
  Results results() const { return session.results(ticket); }
  Statistics statistics() const { return session.statistics(ticket); }

  RenderSettings settings;
  Scene scene = sphere(0.06);
  Session session;
  Ticket ticket{};
};

void expect_same(const Results& wanted, const Results& found, Outputs outputs) {
  for (const OutputRow& row : output_rows()) {
    if (outputs.has(row.output)) {
      EXPECT_FALSE(found.bytes(row.output).empty()) << row.name;
      EXPECT_TRUE(std::ranges::equal(wanted.bytes(row.output), found.bytes(row.output))) << row.name;
    } else {
      EXPECT_TRUE(found.bytes(row.output).empty()) << row.name;
    }
  }
}

TEST(Outputs, AreNamedByTheirRows) {
  std::vector<std::string> names;
  for (const OutputRow& row : output_rows()) {
    EXPECT_EQ(std::count(names.begin(), names.end(), row.name), 0);
    names.emplace_back(row.name);
    EXPECT_EQ(&row - output_rows().data(), static_cast<int>(row.output));
    EXPECT_TRUE(Outputs::all().has(row.output));
  }
  EXPECT_EQ(names.size(), 16u);
}

TEST(Outputs, OnlyWhatIsWantedIsReadBack) {
  const MovingBall all({.wanted = Outputs::all()});
  for (const OutputRow& row : output_rows()) {
    SCOPED_TRACE(row.name);
    const MovingBall one({.wanted = {row.output}});
    expect_same(all.results(), one.results(), {row.output});
    EXPECT_EQ(one.statistics().read_back_bytes, std::uint64_t{width} * height * row.bytes_per_pixel());
    EXPECT_EQ(one.statistics().copied_bytes, 0u);
    // A ball has nothing blended before it: front_layer_test.cpp.
    if (row.output == Output::front || row.output == Output::front_part) continue;
    const auto bytes = all.results().bytes(row.output);
    EXPECT_TRUE(std::ranges::any_of(bytes, [&](std::byte b) { return b != bytes[0]; }));
  }

  std::uint64_t per_pixel = 0;
  for (const OutputRow& row : output_rows()) per_pixel += row.bytes_per_pixel();
  EXPECT_EQ(all.statistics().read_back_bytes, per_pixel * width * height);
}

// Whatever words of a pixel share a target of the pass.
TEST(Outputs, OfAnySetAreThoseOfAll) {
  const MovingBall all({.wanted = Outputs::all()});
  const Outputs sets[] = {
      {Output::depth, Output::region},
      {Output::normal, Output::uv, Output::thickness, Output::display},
      {Output::uv, Output::motion, Output::unwrap},
      {Output::front},
      {Output::front_part, Output::region},
      {Output::part, Output::normal, Output::front},
      {Output::instance, Output::material, Output::skin_mesh, Output::region, Output::linear},
      Outputs::labels(),
      Outputs::picture()};
  for (const Outputs& set : sets) {
    const MovingBall some({.wanted = set});
    expect_same(all.results(), some.results(), set);
  }
}

// Planes follow each other without padding: none may be off by the bytes of a region.
TEST(Outputs, OfOddSizes) {
  const RenderSettings odd = settings_of(7, 5);
  const MovingBall all({.wanted = Outputs::all()}, odd);
  const MovingBall regions({.wanted = {Output::region}}, odd);
  expect_same(all.results(), regions.results(), {Output::region});
  EXPECT_EQ(regions.results().region.size(), 35u);
  EXPECT_EQ(regions.statistics().read_back_bytes, 36u) << "whole words";
  const Results found = all.results();
  for (std::size_t i = 0; i < 35; ++i)
    EXPECT_EQ(found.region[i], found.instance[i] == 0 ? Results::no_region : Results::other_skin) << i;
}

TEST(Outputs, WithoutAPictureNothingIsLit) {
  MovingBall labels({.statistics = true, .wanted = Outputs::labels()});
  MovingBall all({.statistics = true, .wanted = Outputs::all()});
  const Statistics without = labels.statistics(), with = all.statistics();
  EXPECT_EQ(without.recorded.dispatches, 2u) << "the planes of the labels, and of the layer before";
  EXPECT_GT(with.recorded.dispatches, without.recorded.dispatches);
  EXPECT_EQ(without.skin_pixels, 0u);
  EXPECT_GT(with.skin_pixels, 0u);

  labels.settings.technique = all.settings.technique = "texture-space";
  const Results lit = all.session.results(all.draw(0.02)), unlit = labels.session.results(labels.draw(0.02));
  expect_same(lit, unlit, Outputs::labels());
  labels.settings.technique = "wax";
  EXPECT_NE(thrown<InputError>([&] { labels.draw(0); }), "") << "settings are checked all the same";
}

TEST(Outputs, OfTheRendererAreEqualToTheBit) {
  MovingBall film({});
  const Picture picture = renderer().render(film.scene, film.settings);
  const Results found = film.results();
  EXPECT_TRUE(std::ranges::equal(picture.linear_rgba, found.linear));
  EXPECT_TRUE(std::ranges::equal(picture.display_rgba, found.display));
  const Picture copy = film.session.picture(film.ticket);
  expect_equal_bits(picture, copy);
  EXPECT_EQ(copy.statistics.copied_bytes, std::uint64_t{20} * width * height);
}

// Whatever shades the skin, and whatever stands behind: light behind the heads comes through where they are
// open. Of skin alone the matte is the share of skin.
TEST(Outputs, TheMatteLetsLightThrough) {
  for (const char* technique : {"lambert", "published"})
    for (const bool head : {false, true}) {
      SCOPED_TRACE(fmt::format("{}, {}", technique, head ? "a head" : "a ball"));
      const Scene scene = head ? Scene::built_in() : sphere(0.06);
      RenderSettings s = small_settings(technique, 48, 64);
      s.output.exposure_ev = 0;
      s.output.bloom = 0;
      s.output.tone_map = ToneMap::linear;
      Session session(renderer(), {.wanted = {Output::linear, Output::matte}});
      Session alone(renderer(), {.wanted = {Output::matte}});
      const Results black = session.results(session.draw(scene, s));
      EXPECT_TRUE(std::ranges::equal(black.matte, alone.results(alone.draw(scene, s)).matte));
      s.output.background = "#ffffff";
      const Results white = session.results(session.draw(scene, s));
      EXPECT_TRUE(std::ranges::equal(black.matte, white.matte));

      std::size_t partly = 0, blended = 0;
      for (std::size_t i = 0; i < black.matte.size(); ++i) {
        const float matte = black.matte[i], skin = black.linear[4 * i + 3];
        EXPECT_GE(matte, skin - 1e-3f) << i;
        EXPECT_LE(matte, 1) << i;
        for (std::size_t c = 0; c < 3; ++c) {
          const float through = white.linear[4 * i + c] - black.linear[4 * i + c];
          EXPECT_NEAR(through, 1 - matte, 1e-3 * (1 + white.linear[4 * i + c])) << i;
        }
        partly += matte > 0 && matte < 1;
        blended += std::abs(matte - skin) > 0.01f;
      }
      EXPECT_GT(partly, 20u);
      EXPECT_EQ(blended > 0, head);
    }
}

TEST(Outputs, OfNoneAreRefused) {
  EXPECT_EQ(thrown<InputError>([&] { Session(renderer(), {.wanted = {}}); }),
            "a session must want at least one output");
  const MovingBall film({.wanted = {Output::depth}});
  EXPECT_EQ(thrown<InputError>([&] { film.session.picture(film.ticket); }),
            "a copy of the picture needs a session that wants display and linear");
}

TEST(Outputs, StayWhileTheyAreLeased) {
  MovingBall film({.frames_in_flight = 1, .wanted = {Output::display, Output::depth}});
  std::vector<Results> held;
  std::vector<std::vector<float>> copies;
  for (int i = 0; i < 5; ++i) {
    held.push_back(film.session.results(film.draw(0.01 * i)));
    copies.emplace_back(held.back().depth_m.begin(), held.back().depth_m.end());
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    EXPECT_TRUE(std::ranges::equal(held[i].depth_m, copies[i])) << i;
    if (i > 0) { EXPECT_FALSE(std::ranges::equal(held[i].depth_m, copies[i - 1])) << i; }
  }

  // Of what is released, the session takes its next ones.
  held.erase(held.begin(), held.begin() + 3);
  const std::uint64_t before = renderer().counters().buffers;
  for (int i = 0; i < 10; ++i) film.session.results(film.draw(0.01 * i));
  EXPECT_EQ(renderer().counters().buffers, before);
}

// Two copies, of which another thread releases the last one, after session and renderer.
TEST(Outputs, OutliveTheSessionAndItsRenderer) {
  std::optional<Renderer> other(std::in_place);
  Results results;
  std::vector<float> copy;
  {
    Session session(*other, {.wanted = {Output::depth}});
    results = session.results(session.draw(sphere(0.06), settings_of()));
    copy.assign(results.depth_m.begin(), results.depth_m.end());
  }
  other.reset();
  EXPECT_TRUE(std::ranges::equal(results.depth_m, copy));
  std::thread([last = std::move(results)]() mutable { last = {}; }).join();
}

// A driver that compiles a shader for each draw keeps it: then each frame takes a megabyte.
TEST(Outputs, TakeNoMemoryPerFrame) {
  const auto resident_bytes = [] {
    std::ifstream file("/proc/self/statm");
    std::uint64_t size = 0, resident = 0;
    file >> size >> resident;
    return 4096 * resident;
  };
  MovingBall ball({.wanted = Outputs::all()});
  const auto draw = [&](int frames) {
    for (int i = 0; i < frames; ++i) ball.session.results(ball.draw(1e-4 * i));
    return resident_bytes();
  };
  const std::uint64_t before = draw(20);
  EXPECT_LT(draw(100), before + (4u << 20));
}

TEST(Outputs, AreTheMemoryItself) {
  const MovingBall film({.wanted = {Output::depth}});
  film.results().depth_m[3] = 42;
  EXPECT_EQ(film.results().depth_m[3], 42);
  EXPECT_EQ(film.results().depth_m.data(), film.results().depth_m.data());
}

}  // namespace
}  // namespace dermis::tests
