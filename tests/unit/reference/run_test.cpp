// SPDX-License-Identifier: MIT
// Equal bits, whatever happens to a run: threads, stops, checkpoints.
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>

#include "base/core/error.h"
#include "base/core/file.h"
#include "base/core/hooks.h"
#include "head/scene/import/shapes.h"
#include "truth/reference/checkpoint.h"
#include "unit/reference/scenes.h"

namespace dermis::reference {
namespace {

class Run : public testing::TestWithParam<ReferenceModel> {
 protected:
  Job job() const {
    Job s = tests::furnace(scene_, 40);
    s.model = GetParam();
    s.medium.fill({.sigma_a_per_mm = 0.05, .sigma_s_per_mm = 1, .g = 0, .eta = 1.4});
    s.setup.lights.push_back({.name = "sun", .colour = {3, 2, 1}, .direction = {-0.6f, 0, -0.8f}});
    return s;
  }
  scene::AssetData scene_ = scene::sphere(0.01, 16);
};

TEST_P(Run, HasTheSameBitsOnAnyNumberOfThreads) {
  const Tracer tracer(scene_, job());
  const Film one = tests::rendered(tracer, 3, 7, 1), many = tests::rendered(tracer, 3, 7, 5);
  EXPECT_EQ(one.state(), many.state());
  EXPECT_NE(one.state(), tests::rendered(tracer, 3, 8, 1).state()) << "the seed makes no difference";
}

TEST_P(Run, GoesOnFromACheckpointAsIfItHadNotStopped) {
  const Job s = job();
  const Tracer tracer(scene_, s);
  const auto path = std::filesystem::path(testing::TempDir()) / "dermis_run.resume";
  const std::uint64_t mark = fingerprint(scene_, s, 7);
  Film film(40, 40);
  {
    std::atomic<bool> stop{false};
    const HookScope scope(Hooks{.stop = &stop});
    EXPECT_FALSE(render(tracer, film, {.samples = 6, .noise_percent = {}, .seed = 7},
                        [&](const Film& f) { stop = f.samples() == 2; }));
  }
  ASSERT_EQ(film.samples(), 2u);
  save_checkpoint(path, film, mark);

  Film again(40, 40);
  ASSERT_TRUE(load_checkpoint(path, again, mark));
  EXPECT_EQ(again.state(), film.state());
  EXPECT_TRUE(render(tracer, again, {.samples = 6, .noise_percent = {}, .seed = 7}));
  EXPECT_EQ(again.state(), tests::rendered(tracer, 6, 7).state());

  EXPECT_NE(fingerprint(scene_, s, 8), mark);
  Job other = s;
  other.setup.ambient = 0.5;
  EXPECT_NE(fingerprint(scene_, other, 7), mark);
  EXPECT_THROW(load_checkpoint(path, again, fingerprint(scene_, other, 7)), InputError);
  std::vector<std::byte> bytes = read_file(path);
  bytes[bytes.size() / 2] ^= std::byte{1};
  write_file(path, bytes);
  EXPECT_THROW(load_checkpoint(path, again, mark), InputError);
  bytes.resize(bytes.size() / 2);
  write_file(path, bytes);
  EXPECT_THROW(load_checkpoint(path, again, mark), InputError);
  write_file(path, std::string_view("something else"));
  EXPECT_THROW(load_checkpoint(path, again, mark), InputError);
  std::filesystem::remove(path);
  EXPECT_FALSE(load_checkpoint(path, again, mark));
}

TEST_P(Run, EndsWhenTheNoiseIsLowAndTheVarianceIsHonest) {
  const Tracer tracer(scene_, job());
  Film film(40, 40);
  const double noise_percent = GetParam() == ReferenceModel::bssrdf ? 1.5 : 5;  // walks scatter more
  EXPECT_TRUE(render(tracer, film, {.samples = 4096, .noise_percent = noise_percent, .seed = 3}));
  EXPECT_LT(film.samples(), 4096u);
  EXPECT_GT(film.samples(), 128u) << "variances of too few blocks scatter themselves";
  EXPECT_LE(film.noise_percent(), noise_percent);

  // Against an independent run: differences scatter as both variances say. Over pixels that are all skin the
  // mean square of z is 1.
  const Film other = tests::rendered(tracer, film.samples(), 4);
  const image::ImageF a = film.picture(), b = other.picture(), va = film.variance(), vb = other.variance();

  double sum = 0;
  int count = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      for (int c = 0; c < 3; ++c) {
        const double variance = double(va.at(x, y)[c]) + vb.at(x, y)[c];
        if (a.at(x, y)[3] < 1 || variance <= 0) continue;
        const double d = a.at(x, y)[c] - b.at(x, y)[c];
        sum += d * d / variance;
        ++count;
      }

  ASSERT_GT(count, 1000);
  EXPECT_NEAR(sum / count, 1, 0.25);
}

INSTANTIATE_TEST_SUITE_P(Models, Run, testing::Values(ReferenceModel::bssrdf, ReferenceModel::volume),
                         [](const auto& parameter) {
                           return parameter.param == ReferenceModel::bssrdf ? "bssrdf" : "volume";
                         });

}  // namespace
}  // namespace dermis::reference
