// SPDX-License-Identifier: MIT
// What libFuzzer calls. DERMIS_FUZZ_TARGET is the name of one of the functions of targets.h.
#include <cstdint>

#include "core/hooks.h"
#include "targets.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  // Warnings about hostile files would be all that one sees, and most of what is done.
  static const dermis::HookScope quiet({.log = [](dermis::LogLevel, const std::string&) {}});
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  dermis::fuzz::DERMIS_FUZZ_TARGET({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}
