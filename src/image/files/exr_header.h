// SPDX-License-Identifier: MIT
// Checks the header of an OpenEXR file before the library reads it, because the library takes as much memory
// as a header declares.
#pragma once

#include "image/files/formats.h"

namespace dermis::image::formats {

/// Throws InputError unless every part declares windows within the limits, buffers that fit in memory, and no
/// more chunks than the file has room for. Rejects deep pictures. Says nothing about the pixels.
void check_exr_header(Bytes bytes, const std::string& where, const DecodeLimits& limits);

}  // namespace dermis::image::formats
