// SPDX-License-Identifier: MIT
// What a test leaves behind when two pictures are further apart than they may be.
#pragma once

#include <string>

#include "image/image.h"

namespace dermis::tests {

/// Writes both pictures and found - wanted (all linear, .exr) into the folder `failures` beside the program
/// of the test that runs now. Returns where they are and the command that repeats the test:
///
///   EXPECT_GE(psnr_db, 40) << write_failure(linear(wanted), linear(found));
///
/// `name` tells apart what one test compares; numbered where it is empty.
std::string write_failure(const image::ImageF& wanted, const image::ImageF& found,
                          const std::string& name = "");

}  // namespace dermis::tests
