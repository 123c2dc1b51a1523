// SPDX-License-Identifier: MIT
// All levels of a texture at once.
#pragma once

#include <vector>

#include "image/resize.h"

namespace dermis::image {

inline std::vector<Image8> mip_chain(const Image8& base, bool srgb) {
  std::vector<Image8> chain;
  for_each_mip(base, srgb, [&](const Image8& mip) { chain.push_back(mip); });
  return chain;
}

}  // namespace dermis::image
