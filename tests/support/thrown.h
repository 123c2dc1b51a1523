// SPDX-License-Identifier: MIT
// What is thrown, as text to compare.
#pragma once

#include <string>

namespace dermis::tests {

/// Returns what() of the Error that `work` throws; "nothing was thrown" if it ends well.
template <class Error, class Work>
std::string thrown(const Work& work) {
  try {
    work();
    return "nothing was thrown";
  } catch (const Error& error) { return error.what(); }
}

}  // namespace dermis::tests
