// SPDX-License-Identifier: MIT
#include "render/setup/preparation.h"

#include "base/core/error.h"

// Weak: null where nothing defines it. dermis_api, which does, asks the linker for it
// (src/api/CMakeLists.txt).
extern "C" [[gnu::weak]] const dermis::setup::Preparation* dermis_preparation();

namespace dermis::setup {

const Preparation& preparation(std::string_view wanted) {
  if (!dermis_preparation)
    throw input_error("", "{}: dermis::dermis finds it, and this program links dermis::draw alone", wanted);
  return *dermis_preparation();
}

}  // namespace dermis::setup
