// SPDX-License-Identifier: MIT
// Condenses bytes to 64 bits, which tell whether inputs are the same. No protection against forgery.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace dermis {

/// 64 bits that depend on every byte and their order (the mixer of splitmix64 over words).
class Hash {
 public:
  void bytes(const void* data, std::size_t size) {
    const char* p = static_cast<const char*>(data);
    word(size);
    for (; size >= 8; p += 8, size -= 8) {
      std::uint64_t w = 0;
      std::memcpy(&w, p, 8);
      word(w);
    }
    std::uint64_t rest = 0;
    std::memcpy(&rest, p, size);
    word(rest);
  }
  void word(std::uint64_t w) {
    state_ = (state_ ^ w) * 0x9E3779B97F4A7C15u;
    state_ ^= state_ >> 29;
  }
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void add(const T& value) {
    std::uint64_t w = 0;
    std::memcpy(&w, &value, sizeof value);
    word(w);
  }
  void add(std::string_view text) { bytes(text.data(), text.size()); }
  std::uint64_t value() const { return state_; }

 private:
  std::uint64_t state_ = 0x632BE59BD9B4E019u;
};

}  // namespace dermis
