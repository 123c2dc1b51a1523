// SPDX-License-Identifier: MIT
/// Reads the command line where CLI11 by itself would read it otherwise.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dermis::cli {

/// Joins the values of a list that are given one by one: `--distances 6 15` becomes `--distances 6,15`.
/// CLI11 would take every further word, the scene included; here only what can be a value of the list belongs
/// to it: a number after --heads and --distances, a known name after --optimise.
std::vector<std::string> join_lists(const std::vector<std::string>& arguments);

/// Returns a word as a shell takes it.
std::string quoted(std::string_view word);

/// Adds an option for a whole number. CLI11 reads -1 as 2^64 - 1, and takes what is too large for something
/// else; here both cannot be parsed, and the message says `range`.
CLI::Option* add_count(CLI::App& command, const std::string& name, std::uint64_t& value,
                       const std::string& help, const std::string& range);

}  // namespace dermis::cli
