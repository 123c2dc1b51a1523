// SPDX-License-Identifier: MIT
// A document without a file: a square of skin as large as a head, half a metre above the origin.
#pragma once

#include "viewer/model/document.h"

namespace dermis::tests {

viewer::Document square_document();

}  // namespace dermis::tests
