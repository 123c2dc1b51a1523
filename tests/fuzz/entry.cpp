// SPDX-License-Identifier: MIT
// What libFuzzer calls. DERMIS_FUZZ_TARGET is the name of one of the functions of targets.h.
#include <cstdint>

#include "base/core/hooks.h"
#include "targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Warnings about hostile files would be all that one sees, and most of what is done. Hooks belong to the
  // thread, which ends before what is static: they are of one input.
  const dermis::HookScope quiet({.log = [](dermis::LogLevel, const std::string&) {}});
  dermis::fuzz::DERMIS_FUZZ_TARGET({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}
