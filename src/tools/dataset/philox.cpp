// SPDX-License-Identifier: MIT
#include "tools/dataset/philox.h"

namespace dermis::dataset {

Counter philox(Counter c, Key k) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53u} * c[0], b = std::uint64_t{0xCD9E8D57u} * c[2];
    c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ k[0], static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ k[1], static_cast<std::uint32_t>(a)};
    k[0] += 0x9E3779B9u;
    k[1] += 0xBB67AE85u;
  }
  return c;
}

std::uint64_t hash_of(std::string_view path) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char c : path) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
  return hash;
}

Stream::Stream(std::uint32_t seed, std::string_view path, std::uint64_t number) {
  const std::uint64_t hash = hash_of(path);
  key_ = {seed, static_cast<std::uint32_t>(hash)};
  counter_ = {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32), 0,
              static_cast<std::uint32_t>(hash >> 32)};
}

double Stream::next() {
  const Counter words = philox(counter_, key_);
  ++counter_[2];
  const std::uint64_t bits = std::uint64_t{words[0]} << 21 | words[1] >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace dermis::dataset
