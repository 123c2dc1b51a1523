// SPDX-License-Identifier: MIT
// "key=1,2,3 other=4": how options of the command line give values per colour channel.
#pragma once

#include <initializer_list>
#include <map>
#include <string>

#include "optics/media.h"

namespace dermis::optics {

/// One number stands for all three channels. InputError (place `where`): a word that is not KEY=VALUE, a key
/// not among `known` (lists them) or given twice, a value that is not one or three finite numbers.
std::map<std::string, Rgb> parse_key_values(const std::string& text, std::initializer_list<const char*> known,
                                            const std::string& where);

}  // namespace dermis::optics
