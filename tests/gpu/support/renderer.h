// SPDX-License-Identifier: MIT
// One renderer for a program of tests. Where there is no device, all tests of a program that uses it are
// skipped; a device that lacks something is a failure, or it would turn every test off unseen.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "dermis/renderer.h"

namespace dermis::tests {

/// The renderer of the whole process: pipelines are made once. The validation layer watches it where it is
/// installed: a test in which it says something fails.
Renderer& renderer();

/// Does the validation layer watch renderer()?
bool is_validated();

/// Calls this with the last test, for other devices that it watches: later the validation layer has ended
/// itself.
void with_the_last_test(std::function<void()> end);

/// Is the device of renderer() a software driver? GPUs round otherwise, and keep corners in other places.
bool on_software();

}  // namespace dermis::tests
