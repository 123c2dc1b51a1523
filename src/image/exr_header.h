// SPDX-License-Identifier: MIT
// A look at the header of an OpenEXR file before the library sees it: the library takes memory for whatever a
// header declares.
#pragma once

#include "image/formats.h"

namespace dermis::image::formats {

/// InputError unless every part of the file declares windows within the limits, buffers that fit in memory,
/// and no more chunks than the file has room for. Deep pictures are refused. Says nothing about the pixels.
void check_exr_header(Bytes bytes, const std::string& where, const DecodeLimits& limits);

}  // namespace dermis::image::formats
