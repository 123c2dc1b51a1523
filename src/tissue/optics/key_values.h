// SPDX-License-Identifier: MIT
// Parses "key=1,2,3 other=4": values per colour channel as options of the command line give them.
#pragma once

#include <initializer_list>
#include <map>
#include <string>

#include "tissue/optics/media.h"

namespace dermis::optics {

/// Returns the values by key; one number stands for all three channels. Throws InputError (place `where`) for
/// a word that is not KEY=VALUE, a key not among `known` (lists them) or given twice, a value that is not one
/// or three finite numbers.
std::map<std::string, Rgb> parse_key_values(const std::string& text, std::initializer_list<const char*> known,
                                            const std::string& where);

}  // namespace dermis::optics
