// SPDX-License-Identifier: MIT
#include "tools/dataset/worker.h"

#include <array>
#include <chrono>
#include <deque>
#include <optional>
#include <utility>

#include "base/core/error.h"
#include "base/core/hooks.h"
#include "base/core/log.h"
#include "tools/dataset/shard_file.h"
#include "tools/dataset/tar.h"

namespace dermis::dataset {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time until its end to a sum.
class Measured {
 public:
  explicit Measured(double& sum_s) : sum_s_(sum_s) {}
  ~Measured() { sum_s_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Measured(const Measured&) = delete;
  Measured& operator=(const Measured&) = delete;

 private:
  double& sum_s_;
  Clock::time_point start_ = Clock::now();
};

void write_zeros(ShardFile& file, std::size_t count) {
  constexpr std::array<std::byte, tar_end> zeros{};
  file.write(std::span(zeros).first(count));
}

void write_members(ShardFile& file, const std::string& stem, const Encoded& sample) {
  for (const Member& member : sample.members) {
    file.write(tar_header(stem + "." + member.ending, member.bytes.size()));
    file.write(member.bytes);
    write_zeros(file, tar_padding(member.bytes.size()));
  }
}

}  // namespace

Worker::Worker(const Lock& lock, std::filesystem::path folder, const Options& options)
    : lock_(lock),
      recipe_(recipe_of(lock)),
      folder_(std::move(folder)),
      hooks_(options.hooks),
      encoders_(*lock.recipe, options.threads),
      studio_(lock.recipe, options.device, Hooks{.log = options.hooks.log, .stop = options.hooks.stop}) {
  if (lock.one_device && studio_.device_class() != lock.device)
    throw input_error(folder_.string(), "is drawn on one class of device, {}, and this is {}",
                      lock.device.text(), studio_.device_class().text());
}

bool Worker::draw_again_if_lost(std::uint64_t shard) {
  try {
    return draw(shard);
  } catch (const DeviceError& error) {
    if (was_lost_) throw TryAgain(fmt::format("shard {}: {}", shard, error.what()));
    warn("shard {}: {}; the device is opened anew", shard, error.what());
  }
  was_lost_ = true;
  try {
    studio_.reopen();
    return draw(shard);
  } catch (const DeviceError& error) { throw TryAgain(fmt::format("shard {}: {}", shard, error.what())); }
}

bool Worker::draw(std::uint64_t shard) {
  const std::filesystem::path path = shard_path(folder_, recipe_, shard);
  ShardFile file(path);
  Manifest manifest{.shard = shard,
                    .file = path.filename().string(),
                    .sha256 = {},
                    .dermis = DERMIS_VERSION,
                    .recipe_sha256 = lock_.recipe->sha256,
                    .inputs_sha256 = lock_.inputs_sha256,
                    .device = {},
                    .samples = {},
                    .host = host_name()};
  draw_samples(recipe_.samples_of(shard), manifest.file, [&](const Encoded& sample) {
    const Measured measured(times_.writing);
    write_members(file, stem_of(*lock_.recipe, sample.sample), sample);
    manifest.samples.push_back({sample.sample, sample.json_sha256, sample.pictures_sha256});
  });

  const Measured measured(times_.writing);
  write_zeros(file, tar_end);
  manifest.sha256 = file.finish();
  manifest.bytes = file.bytes();
  manifest.device = studio_.device_class();
  bytes_ += file.bytes();
  return file.publish(manifest_path(path), text_of(manifest, *lock_.recipe)) == ShardFile::Published::by_us;
}

void Worker::draw_samples(Recipe::Range range, const std::string& name,
                          const std::function<void(const Encoded&)>& take) {
  Steps steps(name, range.count);
  std::deque<std::future<Encoded>> encoding;  // in the order of the samples
  const std::size_t most_encoding = 2 * encoders_.threads();
  const auto take_first = [&] {
    Encoded sample;
    {
      const Measured measured(times_.waiting);
      sample = encoding.front().get();
    }
    encoding.pop_front();
    take(sample);
  };

  std::optional<Ordered> before;
  const auto finish_before = [&] {
    if (!before) return;
    {
      const Measured measured(times_.drawing);
      encoding.push_back(encoders_.encode(studio_.finish(std::move(*before))));
    }
    before.reset();
    if (encoding.size() > most_encoding) take_first();
    steps.done();
  };

  for (std::uint64_t i = range.first; i < range.first + range.count; ++i) {
    std::optional<Ordered> now;
    {
      const Measured measured(times_.setting);
      now = studio_.begin(i);
    }
    finish_before();
    before = std::move(now);
  }
  finish_before();
  while (!encoding.empty()) take_first();
}

}  // namespace dermis::dataset
