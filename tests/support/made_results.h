// SPDX-License-Identifier: MIT
// Results made by hand: their memory is that of vectors.
#pragma once

#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "dermis/outputs.h"

namespace dermis::tests {

/// Gives an output of `results` these values, and keeps them as long as the lease.
template <class T>
void give(Results& results, std::span<T>& output, std::type_identity_t<std::vector<T>> values) {
  using Kept = std::pair<std::shared_ptr<const void>, std::vector<T>>;
  const auto kept = std::make_shared<Kept>(results.lease, std::move(values));
  output = kept->second;
  results.lease = kept;
}

}  // namespace dermis::tests
