// SPDX-License-Identifier: MIT
// Results of Monte-Carlo in files: one changed digit must not become a wrong skin.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "support/full_disk.h"
#include "support/log_lines.h"
#include "tissue/profile/dipole.h"
#include "tissue/profile/monte_carlo.h"
#include "tissue/profile/noise.h"
#include "tissue/profile/spectral.h"

namespace dermis {
namespace {

const profile::ScatterScene scene = profile::scene_of(optics::Medium{2, 1, 0, 1.4});

std::string text_of(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// Results of 64 others push every earlier one out of memory.
void forget() {
  static std::uint64_t seed = 1000;
  for (int i = 0; i < 64; ++i) profile::monte_carlo(scene, {.photons = 1000, .seed = ++seed, .cache = {}});
}

TEST(MonteCarloCache, AChangedDigitIsNoticed) {
  const auto folder = std::filesystem::temp_directory_path() / "dermis_cache_digits";
  std::filesystem::remove_all(folder);
  const profile::MonteCarloOptions options{.photons = 2000, .seed = 5, .cache = folder};
  const double total = profile::monte_carlo(scene, options)->reflected_total;

  const std::filesystem::path file = std::filesystem::directory_iterator(folder)->path();
  const std::string whole = text_of(file);
  const std::size_t totals = whole.find('\n') + 1;

  // The first total, a ring in the middle, the checksum itself; then a file that ends early, and one that
  // goes on.
  std::vector<std::string> damaged;
  for (const std::size_t from :
       {whole.find('.', totals) + 1, whole.find('.', whole.size() / 2) + 1, whole.size() - 3}) {
    damaged.push_back(whole);
    damaged.back()[from] = damaged.back()[from] == '7' ? '8' : '7';
  }
  damaged.push_back(whole.substr(0, whole.size() / 2));
  damaged.push_back(whole + "1\n");
  damaged.emplace_back("7");

  for (const std::string& text : damaged) {
    forget();
    std::ofstream(file) << text;
    EXPECT_EQ(profile::monte_carlo(scene, options)->reflected_total, total);
    EXPECT_EQ(text_of(file), whole) << "it is made again";
  }
  std::filesystem::remove_all(folder);
}

TEST(MonteCarloCache, AWholeFileIsUsed) {
  const auto folder = std::filesystem::temp_directory_path() / "dermis_cache_whole";
  std::filesystem::remove_all(folder);
  profile::MonteCarloOptions options{.photons = 2000, .seed = 6, .cache = folder};
  const auto first = profile::monte_carlo(scene, options);
  forget();
  int steps = 0;
  const HookScope scope({.progress = [&](const WorkProgress&) { return ++steps > 0; }});
  const auto second = profile::monte_carlo(scene, options);
  EXPECT_EQ(steps, 0) << "it was computed";
  EXPECT_NE(first.get(), second.get());
  EXPECT_EQ(first->reflected.energies(), second->reflected.energies());
  EXPECT_EQ(first->cut, second->cut);
  std::filesystem::remove_all(folder);
}

TEST(MonteCarloCache, AFullDiskCostsNoResult) {
  const auto folder = std::filesystem::temp_directory_path() / "dermis_cache_full";
  std::filesystem::remove_all(folder);
  const profile::MonteCarloOptions options{.photons = 2000, .seed = 9, .cache = folder};
  tests::LogLines said;
  double total = 0;
  {
    const tests::FullDisk full;
    total = profile::monte_carlo(scene, options)->reflected_total;
  }
  EXPECT_GT(total, 0);
  EXPECT_EQ(said.warnings.size(), 1u);
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  forget();
  EXPECT_EQ(profile::monte_carlo(scene, options)->reflected_total, total);
  EXPECT_FALSE(std::filesystem::is_empty(folder)) << "there is room again";
  std::filesystem::remove_all(folder);
}

TEST(MonteCarloProgress, RisesToOneAndChangesNothing) {
  std::vector<double> parts;
  const profile::MonteCarloOptions options{.photons = 1000, .seed = 77, .cache = {}};
  const HookScope scope({.progress = [&](const WorkProgress& work) {
    parts.push_back(work.share);
    return true;
  }});
  const auto watched = profile::monte_carlo(scene, options);
  ASSERT_EQ(parts.size(), 64u);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_EQ(parts.back(), 1);

  forget();
  const HookScope nobody({.progress = [](const WorkProgress&) { return true; }});
  EXPECT_EQ(profile::monte_carlo(scene, options)->reflected.energies(), watched->reflected.energies());
}

TEST(MonteCarloProgress, ARunThatIsEndedKeepsNothing) {
  const profile::MonteCarloOptions options{.photons = 1000, .seed = 78, .cache = {}};
  {
    const HookScope scope({.progress = [](const WorkProgress& work) { return work.share < 0.3; }});
    EXPECT_THROW(profile::monte_carlo(scene, options), Cancelled);
  }
  int steps = 0;
  const HookScope scope({.progress = [&](const WorkProgress&) { return ++steps > 0; }});
  EXPECT_GT(profile::monte_carlo(scene, options)->reflected_total, 0);
  EXPECT_EQ(steps, 64) << "the run began anew";
}

TEST(MonteCarloNoise, FallsWithPhotonsAlsoInMixtures) {
  EXPECT_FALSE(profile::sampled(profile::Dipole({.1, 1, 0, 1.4})).has_value());
  const SpectralSkin dark{.melanin = 0.3};
  const auto made = [&](std::uint64_t photons) {
    return profile::make_profiles(dark, profile::Model::monte_carlo,
                                  {.photons = photons, .seed = 1, .cache = {}}, "test");
  };
  const auto few = profile::sampled(*made(32'000).profiles[0]),
             many = profile::sampled(*made(320'000).profiles[0]);
  ASSERT_TRUE(few && many);
  EXPECT_GT(many->noise_percent, 0);
  EXPECT_NEAR(few->noise_percent / many->noise_percent, std::sqrt(10.0), 1);  // noise of noise: 64 batches
  EXPECT_EQ(few->cut, 0);
}

TEST(MonteCarloNoise, WhatIsCutIsCounted) {
  // Light that is never absorbed walks for ever: some of it is given up.
  const auto r = profile::monte_carlo(profile::scene_of(optics::Medium{0, 1, 0, 1.4}),
                                      {.photons = 1000, .seed = 1, .cache = {}});
  EXPECT_GT(r->cut, 0);
  EXPECT_LT(r->cut, 0.02);
  EXPECT_NEAR(r->reflected_total + r->cut, 1, 5 * r->reflected_total_error + 1e-9);
  EXPECT_NEAR(r->cut, r->absorbed[0], 1e-12);
}

TEST(MonteCarloOptions, PhotonsAreCheckedBeforeTheyAreShared) {
  for (const std::uint64_t photons :
       {std::uint64_t{0}, std::uint64_t{10}, std::uint64_t{100'000'000'000'000'000}}) {
    try {
      profile::make_profiles(SpectralSkin{}, profile::Model::automatic,
                             {.photons = photons, .seed = 1, .cache = {}}, "test");
      ADD_FAILURE() << photons;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(fmt::format("got {}", photons)), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace dermis
