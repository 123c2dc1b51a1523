// SPDX-License-Identifier: MIT
// Reads what the programs of the kit have written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "kit/child.h"

namespace dermis::kit {

/// Returns the JSON of a file; an empty object if it is missing or broken: its program has failed, and said
/// why.
nlohmann::ordered_json read_json(const std::filesystem::path& path);

/// Returns whether two files hold the same bytes; false if one of them cannot be read.
bool same_bytes(const std::filesystem::path& a, const std::filesystem::path& b);

/// Adds to `note` what a run of tests reports: `cases` found, `passed`, `skipped` (with reasons, each once)
/// and `failures`, one line each. `report` is GoogleTest's.
void add_cases(nlohmann::ordered_json& note, const nlohmann::ordered_json& report);

/// Returns what tests have shown: "holds", "skipped" (every case says why), or "failed", also if none ran.
std::string result_of(const nlohmann::ordered_json& note, const Ended& ended);
/// Returns why it failed, one line.
std::string why_not(const nlohmann::ordered_json& note, const Ended& ended);

/// Returns the reads of texels that were never lit, in all variants of a cell of `dermis bench` but the one
/// that is clipped without a margin.
std::uint64_t unshaded_reads(const nlohmann::ordered_json& cell);

/// Keeps of the statistics of many similar pictures what differs: times, counts and memory.
void drop_repeated_statistics(nlohmann::ordered_json& note);

/// "NVIDIA H100 PCIe" as part of a file name: "nvidia-h100-pcie".
std::string file_part(const std::string& device);

}  // namespace dermis::kit
