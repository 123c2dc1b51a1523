// SPDX-License-Identifier: MIT
#include "truth/reference/film.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/core/assert.h"
#include "truth/reference/random.h"

namespace dermis::reference {

Film::Film(int width, int height)
    : width_(width),
      height_(height),
      sums_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      squares_(sums_.size()),
      block_(sums_.size()) {}

void Film::add(const std::vector<Tracer::Sample>& pass) {
  DERMIS_ASSERT_EQ(4 * pass.size(), sums_.size());
  for (std::size_t i = 0; i < pass.size(); ++i) {
    const double values[] = {pass[i].radiance.x, pass[i].radiance.y, pass[i].radiance.z, pass[i].skin};
    for (std::size_t c = 0; c < 4; ++c) {
      sums_[4 * i + c] += values[c];
      block_[4 * i + c] += values[c];
    }
  }
  if (++samples_ % samples_a_block != 0) return;
  for (std::size_t i = 0; i < block_.size(); ++i) squares_[i] += block_[i] * block_[i];
  std::fill(block_.begin(), block_.end(), 0.0);
}

// Samples beyond the last complete block enter the mean; their scatter is taken to be that of the others.
double Film::variance_of_mean(std::size_t value) const {
  const double blocks = samples_ / samples_a_block, mean = (sums_[value] - block_[value]) / blocks;
  const double of_a_block = std::max(0.0, squares_[value] / blocks - mean * mean) * blocks / (blocks - 1);
  return of_a_block / (static_cast<double>(samples_a_block) * samples_);
}

image::ImageF Film::picture() const {
  image::ImageF out{.width = width_, .height = height_, .channels = 4, .values = {}};
  out.values.reserve(sums_.size());
  for (const double sum : sums_) out.values.push_back(static_cast<float>(samples_ ? sum / samples_ : 0));
  return out;
}

image::ImageF Film::variance() const {
  image::ImageF out{
      .width = width_, .height = height_, .channels = 4, .values = std::vector<float>(sums_.size())};
  if (samples_ < 2 * samples_a_block) return out;
  for (std::size_t i = 0; i < sums_.size(); ++i) out.values[i] = static_cast<float>(variance_of_mean(i));
  return out;
}

double Film::noise_percent() const {
  if (samples_ < 2 * samples_a_block) return 100;
  double error = 0, mean = 0;
  for (const bool only_skin : {true, false}) {
    for (std::size_t i = 0; i < sums_.size(); i += 4) {
      if (only_skin && sums_[i + 3] < 0.5 * samples_) continue;
      for (std::size_t c = i; c < i + 3; ++c) {
        mean += sums_[c] / samples_;
        error += std::sqrt(variance_of_mean(c));
      }
    }
    if (mean > 0) return 100 * error / mean;
  }
  return 0;
}

std::vector<std::byte> Film::state() const {
  const std::size_t bytes = sums_.size() * sizeof(double);
  std::vector<std::byte> state(sizeof samples_ + 3 * bytes);
  std::memcpy(state.data(), &samples_, sizeof samples_);
  std::byte* at = state.data() + sizeof samples_;
  for (const std::vector<double>* values : {&sums_, &squares_, &block_})
    std::memcpy(at, values->data(), bytes), at += bytes;
  return state;
}

bool Film::restore(std::span<const std::byte> state) {
  const std::size_t bytes = sums_.size() * sizeof(double);
  if (state.size() != sizeof samples_ + 3 * bytes) return false;
  std::memcpy(&samples_, state.data(), sizeof samples_);
  const std::byte* at = state.data() + sizeof samples_;
  for (std::vector<double>* values : {&sums_, &squares_, &block_})
    std::memcpy(values->data(), at, bytes), at += bytes;
  return true;
}

}  // namespace dermis::reference
